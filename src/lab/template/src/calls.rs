//! What a case of this lab can say: its starts, and a line for each function of yours.

use crate::dcel::Dcel;
use crate::harness::{Call, Start, Value};
use crate::start;

/// The lab.
pub struct Lab;

impl crate::harness::Lab for Lab {
    type Structure = Dcel;

    const STARTS: &'static [Start<Dcel>] = &[
        Start { word: "polygon", usage: "write `polygon 0 0 4 0 3 3`", make: start::polygon },
        Start { word: "triangles", usage: "write `triangles 0 0 1 0 1 1 / 0 1 2`", make: start::triangles },
        Start { word: "convex", usage: "write `convex 300`", make: start::convex },
        Start { word: "wheel", usage: "write `wheel 40`", make: start::wheel },
        Start { word: "grid", usage: "write `grid 20 15`", make: start::grid },
    ];

    const CALLS: &'static [Call<Dcel>] = &[Call {
        word: "border_edges",
        takes: &[],
        usage: "it stands alone in its line",
        run: |dcel, _, _| Value::Id(dcel.border_edges()),
    }];

    const PICTURE: Option<fn(&Dcel) -> String> = None;

    const NAMED: &'static [(&'static str, &'static str)] = &[];
}
