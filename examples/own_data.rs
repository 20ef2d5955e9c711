//! Data of your own on vertices, edges and faces, which follow the edits and the renumbering.
//!
//! Run it: `cargo run --example own_data`
//!
//! It prints:
//!
//! ```text
//! all walls together: 1600
//! f2 is nameless
//! f1 is nameless again
//! f1 is the store, of 37500 square units
//! f2 is the kitchen, of 112500 square units
//! ```

use dcel_kit::plane::{PlaneJournal, Subdivision};
use dcel_kit::topology::Followed;
use dcel_kit::{EdgeMap, FaceId, HalfEdgeId};

/// Rooms with names, and walls with lengths.
pub(crate) fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut s = Subdivision::lab_rectangle();

    // A plain array beside the structure, as long as the structure stays as it is.
    let mut length = EdgeMap::filled(s.edge_bound(), 0.0);
    for e in s.edges() {
        let [p, q] = e.half_edges().map(|h| s.point(s.origin(h)));
        length[e] = (p.x - q.x).hypot(p.y - q.y);
    }
    println!("all walls together: {}", length.as_slice().iter().sum::<f64>());

    // A map that is told of every edit: give it to the edit as its recorder, alone or beside a journal.
    let mut name: Followed<FaceId, String> = Followed::new("nameless".to_owned());
    name[FaceId::new(1)] = "hall".to_owned();
    let mut journal = PlaneJournal::new();
    let (wall, kitchen) = s.split_face_with(HalfEdgeId::new(2), HalfEdgeId::new(8), &mut (&mut name, &mut journal))?;
    println!("{kitchen} is {}", name[kitchen]);
    name[kitchen] = "kitchen".to_owned();
    let (_, store) = s.split_face_with(wall, s.next(s.next(wall)), &mut name)?;
    name[store] = "store".to_owned();

    // The wall goes, and with it the hall; the numbers close up.
    let gone = s.join_faces_with(s.twin(wall), &mut name)?;
    println!("{gone} is {} again", name[gone]);
    let map = s.compact();
    name.renumber(&map);
    for f in s.faces().skip(1) {
        println!("{f} is the {}, of {} square units", name[f], s.area(f));
    }
    Ok(())
}
