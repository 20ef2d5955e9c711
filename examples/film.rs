//! Records the pointers that an edit writes, and draws them step by step.
//!
//! Run it: `cargo run --example film`
//!
//! It prints:
//!
//! ```text
//! split_face h2 h8: 0 pointers
//! 1 Create a new face for the second half of the split.: 0 pointers
//! 2 Create two new half-edges for the splitting edge.: 2 pointers
//! 3 Insert the new half-edges into the cyclic lists.: 12 pointers
//! 4 Make all half-edges point to the right face.: 8 pointers
//! 5 Make both faces point to one of their half-edges.: 3 pointers
//! after: 0 pointers
//! as before: true
//! ```

use dcel_kit::figure::{FigureOptions, Film};
use dcel_kit::plane::PlaneJournal;
use dcel_kit::topology::Journal;
use dcel_kit::{HalfEdgeId, Subdivision};

/// Films one split of a face, and takes it back.
pub(crate) fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut s = Subdivision::lab_rectangle();
    let before = s.clone();
    let mut film = Film::new(&s);

    let [h2, h8] = [2, 8].map(HalfEdgeId::new);
    // Two recorders at once: the pointers, for the film, and everything that undoing needs.
    let (mut pointers, mut journal) = (Journal::new(), PlaneJournal::new());
    s.split_face_with(h2, h8, &mut (&mut pointers, &mut journal))?;
    film.edit("split_face h2 h8", "A wall through the room.", &[], &pointers, &s);

    for frame in film.frames() {
        println!("{}: {} pointers", frame.heading, frame.written.len());
    }
    let path = std::env::temp_dir().join("dcel-film.svg");
    std::fs::write(&path, film.strip(&FigureOptions::new("Split a face"))?.to_svg())?;
    eprintln!("look at {}", path.display());

    // What was recorded can be undone, to the last pointer.
    s.undo(&mut journal, 0);
    println!("as before: {}", s == before);
    Ok(())
}
