//! What a file does not hold of a model that is written to it, in sentences: names, hole faces, digits.

use super::format::Format;
use super::model::Model;
use super::stl::rounding;
use super::words::counted;

/// What a format loses of a model, one sentence each: for the user. O(size of the model).
///
/// ```
/// use dcel_kit::Subdivision;
/// use dcel_kit::io::{Format, Model, losses};
/// let lab = Subdivision::lab_rectangle();
/// let named = Model::planar(&lab).with_names(|f| (f.number() == 1).then_some("Garden"));
/// assert_eq!(losses(&named, Format::Obj), ["1 name of a face is lost: obj has none; geojson and dcel keep them"]);
/// assert!(losses(&named, Format::Dcel).is_empty());
/// ```
#[must_use]
pub fn losses(model: &Model<'_>, format: Format) -> Vec<String> {
    let mut told = Vec::new();
    let named = model.faces().filter(|&f| model.name(f).is_some()).count();
    if named > 0 && !matches!(format, Format::GeoJson | Format::Dcel | Format::Tables) {
        let lost = counted(named, "name of a face is lost", "names of faces are lost");
        told.push(format!("{lost}: {format} has none; geojson and dcel keep them"));
    }
    let holes = model.faces().filter(|&f| model.view.is_hole(f)).count();
    if holes > 0 && !matches!(format, Format::Dcel | Format::Tables) {
        let faces =
            counted(holes, "hole face is not written: it is a gap", "hole faces are not written: they are the gaps");
        told.push(format!("{faces} between the polygons"));
    }
    told.extend(rounding(model, format));
    told
}
