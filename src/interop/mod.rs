//! The kit's types in the terms of other crates: serde, geo-types, mint, glam. Each is a feature of the same name, off
//! by default.
//!
//! | feature | what it brings |
//! |---|---|
//! | `serde` | `Serialize` and `Deserialize` for ids, maps by id, points, `Dcel`, `Subdivision`, `Polyhedron`; what is read is checked |
//! | `geo-types` (`geo_types.rs`) | polygons and lines into a subdivision, faces and edges out of it |
//! | `mint` | points to and from `mint::Point2` and `mint::Vector2` of `f64` |
//! | `glam` | points to and from `glam::DVec2`, and from `glam::Vec2` |
//!
//! Points in space are `[f64; 3]`, which `mint` and `glam` convert themselves.
//!
//! Coordinates are copied as they are. Whether they can be computed with is checked where a structure is made of them:
//! [`Point::check`](crate::plane::Point::check).
#![cfg_attr(
    feature = "serde",
    doc = r##"
# The format of serde

Version 1. An id is its number. A map by ids is the list of its values. A [`Point`](crate::plane::Point) is `[x, y]`.
A structure is a record of columns, whose places are the numbers of the elements:

| field | of | what it is |
|---|---|---|
| `dcel` | | the version: 1 |
| `origin`, `next`, `prev`, `face` | half-edges | a number, or null where there is no such half-edge; the twin of h is h ^ 1 |
| `outgoing` | vertices | a half-edge that starts there, or null |
| `half_edge` | faces | a half-edge of the first boundary cycle, or null |
| `free_vertices`, `free_faces` | | numbers that name no element |

A `Subdivision` is `subdivision` (the version, 1), `structure` (as above), `points` by vertex, `inner_components` (pairs of a
face and its list of `{"cycle": h}` and `{"vertex": v}`), and `holes` (hole faces). A `Polyhedron` is `polyhedron` (1),
`structure`, `points`, `boundary_faces`.

What is read obeys all laws, or is refused with the error of the readers of files: [`TableError`](crate::plane::TableError)
for a `Dcel` and a `Subdivision`, `PartsError` for a `Polyhedron`. Numbers that name no element are given out from the
lowest one on afterwards. A `NavMesh` is made of its `Subdivision` anew; its ids can be written and read. Numbers
of another version are refused. JSON brings the same coordinates back, to the last bit, since the feature switches on
`float_roundtrip` of `serde_json`; if you build without default features, do that yourself.

```
use dcel_kit::Subdivision;
let room = Subdivision::lab_rectangle();
let text = serde_json::to_string(&room)?;
assert!(text.starts_with(r#"{"subdivision":1,"structure":{"dcel":1,"origin":[0,1,"#));
assert_eq!(serde_json::from_str::<Subdivision>(&text)?, room);

// h0 comes after h0, so h2 has none before it.
let broken = text.replace(r#""next":[2,"#, r#""next":[0,"#);
let error = serde_json::from_str::<Subdivision>(&broken).unwrap_err();
assert!(error.to_string().contains("h0.next = h0"), "{error}");
# Ok::<(), serde_json::Error>(())
```
"##
)]

/// Types with x and y, both ways.
#[cfg(any(feature = "geo-types", feature = "glam", feature = "mint"))]
macro_rules! as_xy {
    ($($theirs:ty),*) => {$(
        impl From<$theirs> for crate::plane::Point {
            fn from(p: $theirs) -> Self {
                Self::new(p.x, p.y)
            }
        }

        impl From<crate::plane::Point> for $theirs {
            fn from(p: crate::plane::Point) -> Self {
                Self { x: p.x, y: p.y }
            }
        }
    )*};
}

#[cfg(feature = "geo-types")]
mod geo_types;
#[cfg(feature = "glam")]
mod glam;
#[cfg(feature = "mint")]
mod mint;
#[cfg(feature = "serde")]
mod serde;

#[cfg(feature = "geo-types")]
pub use geo_types::GeoError;
