//! The visible parts of faces that are partly hidden.
//!
//! ```text
//!   ●─────────●             The seen pieces of edges cut the paper into cells: each shows one face, the nearest one at a
//!   │   ●━━━━━┿━━━●         point inside the cell. A piece that ends behind an outline is made a little longer, so that it
//!   │ ▒ ┃ ▒▒▒▒│▒▒▒┃         reaches the outline in spite of rounding.
//!   ●───╂─────●   ┃
//!       ┗━━━━━━━━━┛
//! ```

use crate::figure::canvas::vector::{Xy, xy};
use crate::figure::kinds::solid::hidden::{Index, Look, Stretches};
use crate::figure::layout::pole::pole;
use crate::ids::{EdgeId, FaceId, FaceMap};
use crate::plane::{ArrangeOptions, Point, Subdivision};

/// By how much a piece is made longer, in sizes of the solid.
const LONGER: f64 = 1e-7;
/// The size of the solid while a point inside a cell is looked for, and how well inside is enough.
const SCALE: f64 = 1000.0;
const ENOUGH: f64 = 8.0;

/// Outlines of cells that show a face that is not seen whole, each with its holes. `cut` has the parts of every edge.
///
/// Cost: O(k log k) for k pieces of edges of such faces, and a look into the tree for each cell.
pub(super) fn parts(
    look: &Look<'_>,
    index: &Index,
    whole: &FaceMap<bool>,
    cut: &[(EdgeId, Stretches)],
) -> Vec<Vec<Vec<Point>>> {
    let mut segments: Vec<[Point; 2]> = Vec::new();
    for (e, stretches) in cut.iter().filter(|(e, _)| look.sides(*e).iter().any(|&f| !whole[f])) {
        let [a, b] = look.ends(*e).map(|p| look.picture.place(p));
        let more = LONGER * look.picture.size / ((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y)).sqrt();
        for &(from, to, _) in stretches.iter().filter(|&&(.., is_hidden)| !is_hidden) {
            // Edges that share a vertex end in exactly one point.
            let at = |t: f64| look.picture.place(look.along(*e, t));
            segments.push([if from > 0.0 { at(from - more) } else { a }, if to < 1.0 { at(to + more) } else { b }]);
        }
    }
    let options = ArrangeOptions { merge: true, split: true, ..ArrangeOptions::default() };
    let Ok(arranged) = Subdivision::arrange_segments(&segments, &options) else { return Vec::new() };
    let cells = arranged.subdivision;
    let outlines = cells.faces().skip(1).map(|cell| {
        let ring = |start| cells.cycle(start).map(|h| cells.point(cells.origin(h))).collect();
        cells.cycles(cell).map(ring).collect::<Vec<Vec<Point>>>()
    });
    let shows_a_part = |rings: &Vec<Vec<Point>>| {
        inside(rings, look.picture.size).and_then(|at| nearest(look, index, at)).is_some_and(|f| !whole[f])
    };
    outlines.filter(shows_a_part).collect()
}

/// A point well inside a cell; none for cells too thin to be seen.
fn inside(rings: &[Vec<Point>], size: f64) -> Option<Point> {
    let scale = SCALE / size;
    let ring = |ring: &Vec<Point>| ring.iter().map(|p| xy(p.x * scale, p.y * scale)).collect();
    let rings: Vec<Vec<Xy>> = rings.iter().map(ring).collect();
    let pole = pole(&rings, &[], 1.0, ENOUGH)?;
    Some(Point::new(pole.at.x / scale, pole.at.y / scale))
}

/// The face that is seen at a place of the paper.
fn nearest(look: &Look<'_>, index: &Index, at: Point) -> Option<FaceId> {
    let behind = look.picture.lifted(at);
    let mut best: Option<(f64, FaceId)> = None;
    index.faces.any(
        |bounds| bounds.holds(at),
        |i| {
            let f = index.polygons[i];
            let near = look.picture.nearness_on(behind, look.planes[f]);
            if look.shapes[f].0.contains(at) && best.is_none_or(|(nearest, _)| near > nearest) {
                best = Some((near, f));
            }
            false
        },
    );
    best.map(|(_, f)| f)
}
