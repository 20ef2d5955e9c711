//! The structure figure: every element of a view, or as much as there is room for.
//!
//! ```text
//!   painted in this order:  paper, faces (hatch, tints, labels), edges, half-edges, vertices
//! ```
//!
//! The groups carry the pointers as the view has them: `<g class="he" id="FIG-h5" data-origin data-twin
//! data-next data-prev data-face>`, `<g class="v" id="FIG-v3" data-x data-y data-he>`, `<g class="f" id="FIG-f1"
//! data-he data-rings data-outer data-hole data-name>`. A pointer that is missing has no attribute.

use crate::figure::kinds::interactive;
use crate::figure::structure::look::Look;
use crate::figure::structure::part::Part;
use crate::figure::structure::picture::Picture;
use crate::figure::structure::plate::Plate;
use crate::figure::{Detail, Figure, FigureError, FigureOptions};
use crate::plane::PlanarView;

/// Draws a structure: all of it where the edges are long enough, less where they are short (see [`Detail`]).
///
/// The half-edges lie on the left of their edges, bounded faces are tinted so that neighbours differ, the outer
/// face is hatched, hole faces are hatched the other way. Ids, `data-*` attributes and tooltips name every
/// element that is drawn one by one. The view may be broken: what cannot be drawn is skipped and noted.
///
/// Cost: O(n log n) for n half-edges; 10^6 edges take about a second.
///
/// # Errors
/// [`FigureError`] if no vertex has a position, or a coordinate cannot be computed with. An empty plane is no
/// error: it shows its outer face.
pub fn structure(view: &dyn PlanarView, options: &FigureOptions) -> Result<Figure, FigureError> {
    let options = &options.checked();
    let view: &dyn PlanarView = &Part::of(view, options)?;
    let (picture, mut notes) = Picture::new(view, options)?;
    let detail = picture.detail;
    if detail >= Detail::Edges {
        let plate = Plate::place(picture, notes, &[]);
        if options.interactive && detail >= Detail::Arrows {
            return Ok(interactive::figure(plate));
        }
        let scene = plate.picture.scene(plate.nodes(view, &Look::default(), Vec::new()));
        return Ok(Figure { scene, detail, notes: plate.notes.0 });
    }
    let nodes = picture.by_tiles(&mut notes, &Look::default());
    Ok(Figure { scene: picture.scene(nodes), detail, notes: notes.0 })
}
