//! Small multiples: one panel for each family of pointers, all on one layout.
//!
//! ```text
//!   half-edge.next          half-edge.twin         A reader compares panels place by place: every line, disc
//!   ┌──────────────┐        ┌──────────────┐       and label stands at the same spot in all of them, the
//!   │  ⟲    ⟲      │        │  ↕    ↕      │       half-edges are grey, and one family has its colour.
//!   └──────────────┘        └──────────────┘
//! ```

use crate::figure::canvas::crop;
use crate::figure::layout::grid::{Panel, arrange, columns};
use crate::figure::structure::look::{Look, Mark};
use crate::figure::structure::notes::Notes;
use crate::figure::structure::part::Part;
use crate::figure::structure::plate::Plate;
use crate::figure::structure::pointer::Pointers;
use crate::figure::structure::pointer_style;
use crate::figure::{Detail, Figure, FigureError, FigureOptions};
use crate::plane::PlanarView;

/// Draws the pointers of some families, each in a panel of its own: at most one family a picture can be read.
///
/// The panels share one layout, in which labels keep clear of the arrows of every family. Everything but the
/// family is grey. Ids read `FIG-next-h5` in the panel of `next`, and `FIG-next-h5-next` for the arrow; with
/// one family `FIG-h5` and `FIG-h5-next`. A family named twice is drawn once. `width` is that of one panel
/// (default 408, two on a page of 830 px; more until the median edge has 110 px, and no more than the page). Wrong pointers are drawn as they are; those without
/// room for an arrow, and those that lead to what is not drawn, are noted.
///
/// Cost: O(n log n) for each family.
///
/// # Errors
/// Those of [`structure`](crate::figure::structure()), and [`FigureError::NoRoom`] if half-edges would be too short to
/// draw.
///
/// ```
/// use dcel_kit::figure::{self, FigureOptions, Pointers};
/// use dcel_kit::plane::Subdivision;
/// let lab = Subdivision::lab_rectangle();
/// let svg = figure::pointers(&lab, &[Pointers::Next, Pointers::Twin], &FigureOptions::new("Lab"))?.to_svg();
/// assert!(svg.contains("id=\"lab-next-h0-next\"") && svg.contains("id=\"lab-twin-h0-twin\""));
/// # Ok::<(), figure::FigureError>(())
/// ```
pub fn pointers(view: &dyn PlanarView, families: &[Pointers], options: &FigureOptions) -> Result<Figure, FigureError> {
    let view: &dyn PlanarView = &Part::of(view, options)?;
    let mut options = options.of_panels();
    // Smaller than in other figures: face arrows need the room.
    options.style.face_text = options.style.face_text.min(14.0);
    let options = &options;
    let mut families = families.to_vec();
    families.sort_unstable();
    families.dedup();
    let plate = Plate::new(view, options, true)?;
    if plate.picture.detail < Detail::Arrows {
        return Err(FigureError::NoRoom { detail: plate.picture.detail });
    }
    let mut notes = Notes(plate.notes.0.clone());
    let mut scene = plate.picture.scene(Vec::new());
    let mut panels = Vec::new();
    for &family in &families {
        let look = if families.len() == 1 { Look::default() } else { Look::instance(family.class()) };
        let look = look.rest(Mark::Dim);
        let arrows = plate.pointers(view, &Plate::<dyn PlanarView>::family(view, family), &look, 0.5, &mut notes);
        panels.push(Panel {
            heading: family.name().to_owned(),
            text: family.sentence().to_owned(),
            id: (families.len() > 1).then(|| family.class().to_owned()),
            nodes: crop::framed(plate.nodes(view, &look, arrows), plate.picture.fit.size, options),
        });
    }
    let columns = options.columns.unwrap_or_else(|| columns(panels.len(), scene.size.x));
    (scene.nodes, scene.size) = arrange(panels, scene.size, columns);
    scene.css.push_str(&pointer_style::css(&options.style, &scene.prefix));
    if families.len() > 1 {
        scene.attributes[0].1 = "dcel-pointers".to_owned();
    }
    if options.description.is_none() {
        let words = families.iter().map(|family| format!("{}: {}", family.name(), family.sentence()));
        scene.description = format!("Panels of one structure. {}.", words.collect::<Vec<_>>().join(". "));
    }
    Ok(Figure { scene, detail: plate.picture.detail, notes: notes.0 })
}

impl Pointers {
    /// What the panel is called: the record and its field.
    const fn name(self) -> &'static str {
        match self {
            Self::Next => "half-edge.next",
            Self::Twin => "half-edge.twin",
            Self::Outgoing => "vertex.outgoing",
            Self::Boundary => "face.half_edge",
            Self::Face => "half-edge.face",
        }
    }

    /// What there is to see.
    const fn sentence(self) -> &'static str {
        match self {
            Self::Next => "follow next and the face closes on its left; prev is the way back",
            Self::Twin => "the same edge from the other side: twin(twin(h)) = h",
            Self::Outgoing => "every vertex knows one half-edge that leaves it",
            Self::Boundary => "every face, the outer one too, knows one of its half-edges",
            Self::Face => "every half-edge knows the face on its left",
        }
    }
}
