//! The picture of the map: its corridor and the path, as the student's program should draw them.

use super::answers::path;
use super::mesh::{Spot, build, corners, corridor, place, triangles_of};
use crate::cases::handouts::{GOAL, MAP, MAP_TRIANGLES, START};
use crate::protocol::{Start, Structure};
use dcel_kit::HalfEdgeId;
use dcel_kit::topology::{Table, View};
use std::fmt::Write;
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
    let mut out = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-270 -170 540 340\">\n".to_owned();
    let words = |[x, y]: Spot| (x, 0.0 - y);
    let [from, to] = [START, GOAL].map(|p| triangles_of(&table, p)[0]);
    for f in corridor(&table, from, to).unwrap_or_default() {
        let list = corners(&table, f).unwrap_or_default().map(words).map(|(x, y)| format!("{x},{y}")).join(" ");
        let _ = writeln!(out, "<polygon points=\"{list}\" fill=\"#dddddd\"/>");
    }
    let mut line = |a: Spot, b: Spot| {
        let ((x1, y1), (x2, y2)) = (words(a), words(b));
        let _ = writeln!(out, "<line x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\" stroke=\"#000000\"/>");
    };
    for h in (0..table.half_edges.len() as u32).step_by(2).map(HalfEdgeId::new) {
        let ends = table.origin(h).zip(table.next(h).and_then(|next| table.origin(next)));
        if let Some((a, b)) = ends {
            line(place(&table, a), place(&table, b));
        }
    }
    let path = path(&table, START, GOAL).unwrap_or_default();
    path.windows(2).for_each(|pair| line(pair[0], pair[1]));
    for (x, y) in path.into_iter().map(words) {
        let _ = writeln!(out, "<circle cx=\"{x}\" cy=\"{y}\" r=\"4\"/>");
    }
    out + "</svg>\n"
}

#[cfg(test)]
mod tests {
    use super::*;
    use dcel_kit::compare::{Options, compare};

    #[test]
    fn the_figure_of_the_handout_shows_the_same() {
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../figures/lab-06-corridor.svg");
        let figure = std::fs::read_to_string(file).unwrap();
        let comparison = compare(&reference(), &figure, &Options::new()).unwrap();
        assert_eq!(comparison.differences().len(), 0, "{:?}", comparison.differences());
    }

    #[test]
    fn the_path_of_the_map_turns_round_both_partitions_and_the_pillar() {
        let path = path(&map(), START, GOAL).unwrap();
        assert_eq!(path, [START, MAP[2], MAP[7], MAP[12], GOAL]);
        let corridor = corridor(&map(), 1, 7).unwrap();
        assert_eq!(corridor, [1, 2, 5, 4, 3, 6, 8, 9, 7]);
    }
}
