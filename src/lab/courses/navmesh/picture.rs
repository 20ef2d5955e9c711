//! The picture of the map: its corridor and the path, as the student's program should draw them.

use super::answers::path;
use super::mesh::{build, corners, corridor, place, triangles_of};
use crate::cases::handouts::{GOAL, MAP, MAP_TRIANGLES, START};
use crate::pictures::Plain;
use crate::protocol::{Start, Structure};
use dcel_kit::HalfEdgeId;
use dcel_kit::topology::{Table, View};
use std::sync::Arc;

/// The map of the handout.
pub(super) fn map() -> Table {
    build(&MAP, &MAP_TRIANGLES)
}

/// The start of cases on it.
pub(super) fn start() -> Start {
    Start::known("map", Structure::HalfEdges(Arc::new(map())))
}

/// The picture with the coordinates that the student's program writes: y points down in a file.
pub(super) fn reference() -> String {
    let table = map();
    let mut out = Plain::new("-270 -170 540 340");
    let [from, to] = [START, GOAL].map(|p| triangles_of(&table, p)[0]);
    for f in corridor(&table, from, to).unwrap_or_default() {
        out.face(corners(&table, f).unwrap_or_default());
    }
    for h in (0..table.half_edges.len() as u32).step_by(2).map(HalfEdgeId::new) {
        let ends = table.origin(h).zip(table.next(h).and_then(|next| table.origin(next)));
        if let Some((a, b)) = ends {
            out.edge(place(&table, a), place(&table, b));
        }
    }
    let path = path(&table, START, GOAL).unwrap_or_default();
    path.windows(2).for_each(|pair| out.edge(pair[0], pair[1]));
    path.into_iter().for_each(|p| out.vertex(p));
    out.svg()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pictures::assert_shown;

    #[test]
    fn the_figure_of_the_handout_shows_the_same() {
        assert_shown("lab-06-corridor.svg", &reference());
    }

    #[test]
    fn the_path_of_the_map_turns_round_both_partitions_and_the_pillar() {
        let path = path(&map(), START, GOAL).unwrap();
        assert_eq!(path, [START, MAP[2], MAP[7], MAP[12], GOAL]);
        let corridor = corridor(&map(), 1, 7).unwrap();
        assert_eq!(corridor, [1, 2, 5, 4, 3, 6, 8, 9, 7]);
    }
}
