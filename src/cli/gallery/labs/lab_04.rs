//! The reference figures of lab 04.

use super::{Made, dots};
use dcel_kit::figure::sketch::{Multiples, Role, Sketch};
use dcel_kit::figure::{self, Detail, FigureOptions, Overrides};
use dcel_kit::script::Script;
use dcel_kit::sources;

/// The drawing that lab 04 asks for.
pub(in crate::gallery) fn drawing(options: &FigureOptions) -> Made<String> {
    let script = sources::LAB_04_DRAWING;
    let drawing = Script::parse(script, "lab-04-drawing.dcels")?.run().end;
    let colours = Overrides::parse(sources::LAB_04_COLOURS)?;
    let options = options.clone().detail(Detail::Edges).overrides(colours);
    Ok(figure::structure(&drawing, &options.id_prefix("drawing"))?.to_svg())
}

/// Two faces that share an edge: the corners round both.
const TWO_FACES: [[f64; 2]; 6] = [[0.0, 0.5], [4.0, 0.0], [8.0, 0.7], [7.4, 4.2], [4.3, 4.6], [0.4, 4.0]];

/// Why an edge is cut along its length: as a link of a list it would need two nexts.
pub(in crate::gallery) fn two_nexts(options: &FigureOptions) -> Made<String> {
    let [a, b, c, d, e, f] = TWO_FACES;
    let mut list = Sketch::new();
    list.region(Role::Main, [[a, b, e, f]]).plain();
    list.region(Role::Secondary, [[b, c, d, e]]).plain();
    list.path(Role::Dimmed, [a, b, c, d, e, f, a]).solid();
    list.path(Role::Plain, [b, e]).label("one edge");
    list.path(Role::Main, [[4.1, 4.45], [0.7, 3.86]]).arrow().label("next, in the left face");
    list.path(Role::Secondary, [[4.2, 0.2], [7.7, 0.82]]).arrow().solid().label("next, in the right face");
    dots(&mut list, Role::Plain, TWO_FACES);
    let corners = TWO_FACES.map(|[x, y]| format!("{x} {y}")).join(" ");
    let halves = Script::parse(&format!("polygon {corners}\nsplit_face h2 h8"), "two faces")?.run().end;
    let mut panels = Multiples::new();
    panels.sketch("One record for an edge", "counter-clockwise, it runs up for one face and down for the other", list);
    panels.structure("Two half-edges", "one for each face, each with one next; they are twins", &halves);
    Ok(panels.figure(options)?.to_svg())
}
