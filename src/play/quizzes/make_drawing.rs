//! Make this drawing, with the two splits alone.
//!
//! The drawings are kept as polygons, so that no moves are told. Each split adds one edge and none takes one away, so the
//! fewest moves are the edges that the drawing has more than the rectangle.

use super::Verdict;
use crate::figure::{Detail, FigureOptions, structure};
use crate::io::{Format, LoadOptions, ReadOptions, Structure, assemble, counted, read_bytes};
use crate::plane::Subdivision;
use crate::topology::{IsomorphismOptions, isomorphic_with, position_key};

/// Name, level and polygons of each drawing.
const DRAWINGS: [(&str, u32, &str); 6] = [
    ("two rooms", 1, include_str!("drawings/rooms.obj")),
    ("a tent", 1, include_str!("drawings/tent.obj")),
    ("a door", 1, include_str!("drawings/door.obj")),
    ("a kite", 2, include_str!("drawings/kite.obj")),
    ("a window", 2, include_str!("drawings/window.obj")),
    ("the ship of lab 04", 3, include_str!("drawings/ship.obj")),
];

/// A drawing to be made.
#[derive(Clone, Debug)]
pub(super) struct MakeDrawing {
    name: &'static str,
    target: Subdivision,
    moves: usize,
}

/// How many drawings a level has.
pub(super) fn count(level: u32) -> usize {
    DRAWINGS.iter().filter(|(_, of, _)| *of == level).count()
}

/// The drawing of a file in this package.
fn read(text: &str) -> Option<Subdivision> {
    let read = read_bytes(text.as_bytes(), Format::Obj, "drawing", &ReadOptions::default()).ok()?;
    match assemble(read, "drawing", &LoadOptions::default()).ok()?.structure {
        Structure::Plane(drawing) => Some(drawing),
        Structure::Surface(_) => None,
    }
}

impl MakeDrawing {
    /// One of a level, by its number.
    pub(super) fn new(level: u32, number: usize) -> Self {
        let of_level: Vec<_> = DRAWINGS.iter().filter(|(_, of, _)| *of == level).collect();
        let &&(name, _, text) = of_level.get(number % of_level.len().max(1)).unwrap_or(&&DRAWINGS[0]);
        // Each is read by a test.
        let target = read(text).unwrap_or_else(Subdivision::lab_rectangle);
        Self { name, target, moves: 0 }
    }

    pub(super) fn fewest(&self) -> usize {
        self.target.edge_count() - Subdivision::lab_rectangle().edge_count()
    }

    pub(super) fn text(&self) -> String {
        let (name, moves, fewest) = (self.name, self.moves, self.fewest());
        format!("Draw {name} with split_face and split_in_half alone. Moves so far: {moves}; the fewest: {fewest}.")
    }

    /// The picture of what is to be made.
    pub(super) fn picture(&self) -> String {
        let options = FigureOptions::new(format!("What is to be drawn: {}", self.name))
            .id_prefix("target")
            .width(360.0)
            .detail(Detail::Edges)
            .vertex_labels(false)
            .face_labels(crate::figure::FaceLabels::Off);
        structure(&self.target, &options).map_or_else(|_| String::new(), |figure| figure.to_svg())
    }

    /// Whether an edit may be used.
    pub(super) fn allows(word: &str) -> bool {
        ["split_face", "split_in_half"].contains(&word)
    }

    /// A move was made, also one that is taken back later.
    pub(super) fn moved(&mut self) {
        self.moves += 1;
    }

    /// Whether the drawing is made; what differs is told by `why`.
    pub(super) fn judge(&self, drawn: &Subdivision) -> Result<Verdict, String> {
        let key = |s: &Subdivision, v| {
            let p = s.point(v);
            position_key([p.x, p.y])
        };
        let (mine, target) = (|v| key(drawn, v), |v| key(&self.target, v));
        let options = IsomorphismOptions::new().keys(&mine, &target);
        match isomorphic_with(drawn, &self.target, &options) {
            Ok(_) => {
                let fewest = self.fewest();
                let text = if self.moves == fewest {
                    format!("right, in {}, the fewest", counted(self.moves, "move", "moves"))
                } else {
                    format!("right, in {}; {fewest} are the fewest", counted(self.moves, "move", "moves"))
                };
                Ok(Verdict { right: true, over: true, text, trail: Vec::new() })
            }
            Err(difference) => Err(format!("not yet: {difference}")),
        }
    }

    /// The drawing: for tests.
    #[cfg(test)]
    pub(super) fn target(&self) -> &Subdivision {
        &self.target
    }
}
