//! Room for tests of your own. They are not graded, and nobody counts them.
//!
//! `cargo test --test own` runs them. The modules below are the files of `src/`, so all their functions are at hand.

#![allow(dead_code)]

#[path = "../../04-half-edge/src/dcel.rs"]
mod dcel;
#[path = "../../harness/mod.rs"]
mod harness;
#[path = "../src/lab.rs"]
mod lab;
#[path = "../src/map.rs"]
mod map;
#[path = "../../04-half-edge/src/svg.rs"]
mod svg;
#[path = "../src/turn.rs"]
mod turn;

/// An example: half-edges of triangles have the triangle on their left.
#[test]
fn the_triangles_of_the_map_turn_left() {
    let map = map::map(&[]).unwrap();
    for h in (0..map.half_edges.len()).filter(|&h| map.face(h) != map.outer_face) {
        let corners = [h, map.next(h), map.prev(h)].map(|h| map.position(map.origin(h)));
        assert_eq!(turn::turn(corners[0], corners[1], corners[2]), turn::Turn::Left);
    }
}
