//! Builds a subdivision edge by edge, and walks it: round a face by `next`, round a vertex by `twin` and `next`.
//!
//! Run it: `cargo run --example build_and_walk`
//!
//! It prints:
//!
//! ```text
//! h12 is new: v2 -> v5, with f2 on its left and f1 on its right
//! corners of f2: v2 v5 v0 v1
//! faces round v5: f2 f1 f0
//! the links of h12: h2, h12, h10 and back to h2? true
//! V - E + F = 6 - 7 + 3 = 2
//! split_face: the segment between the origins of h12 and h0 passes through v1: split in two steps
//! ```

use dcel_kit::{HalfEdgeId, Subdivision};

/// Cuts the lab's rectangle in two and looks at both sides of the cut.
pub(crate) fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Six corners, v0 to v5, counter-clockwise; f1 inside, f0 outside. h0, h2, ... h10 run round the inside.
    let mut s = Subdivision::lab_rectangle();

    // From the origin of h4, v2, to the origin of h10, v5.
    let (h, f) = s.split_face(HalfEdgeId::new(4), HalfEdgeId::new(10))?;
    println!(
        "{h} is new: {} -> {}, with {f} on its left and {} on its right",
        s.origin(h),
        s.destination(h),
        s.face(s.twin(h))
    );

    let corners: Vec<String> = s.incident_vertices(f).map(|v| v.to_string()).collect();
    println!("corners of {f}: {}", corners.join(" "));
    let v = s.destination(h);
    let faces: Vec<String> = s.incident_faces(v).map(|f| f.to_string()).collect();
    println!("faces round {v}: {}", faces.join(" "));

    let (before, after) = (s.prev(h), s.next(h));
    println!("the links of {h}: {before}, {h}, {after} and back to {before}? {}", s.prev(s.prev(after)) == before);
    let (v, e, f) = (s.vertex_count(), s.edge_count(), s.face_count());
    println!("V - E + F = {v} - {e} + {f} = {}", v + f - e);

    // An edit that cannot be made changes nothing, and says why.
    let before = s.clone();
    if let Err(error) = s.split_face(h, HalfEdgeId::new(0)) {
        println!("split_face: {error}");
    }
    assert_eq!(s, before);
    Ok(())
}
