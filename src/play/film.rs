//! Edits as a film: the pages that `dcel script --film` writes.

use super::edits::Workshop;
use crate::figure::{FigureOptions, Film, Filmed};

/// A film has no more edits than this.
const LONGEST: usize = 60;
/// Of larger structures there is no film: every frame draws all of it.
const EDGES: usize = 400;

/// The page that plays the last edits; says so if there were more.
pub(super) fn page<S: Filmed>(
    workshop: &Workshop<S>,
    last: usize,
    title: &str,
) -> Result<(String, Option<String>), String> {
    if workshop.edit_count() == 0 {
        return Err("there is no edit to play yet: make one".to_owned());
    }
    let edges = workshop.now().topology().edge_count();
    if edges > EDGES {
        return Err(format!("{edges} edges: films are made of at most {EDGES}, for each frame draws all of them"));
    }
    let last = last.min(LONGEST);
    let (before, shots) = workshop.replay(last);
    let mut film = Film::starting(&before);
    for (call, journal, after) in &shots {
        film.filmed(&call.to_string(), &call.elements(), journal, after);
    }
    let page = film.page(&FigureOptions::new(title)).map_err(|error| error.to_string())?;
    let left_out = workshop.edit_count() - shots.len();
    let note = || format!("the last {} of {} edits are in the film", shots.len(), workshop.edit_count());
    Ok((page, (left_out > 0 && last == LONGEST).then(note)))
}
