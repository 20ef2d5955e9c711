//! `dcel navmesh random` on a floor whose heights differ.

use super::super::super::{Answer, Failure, Output};
use super::super::random::nothing_walkable;
use super::{Ground, Spot};
use std::io::Write;

pub(in super::super) fn run(
    ground: &Ground,
    (seed, count): (u64, usize),
    json: bool,
    out: &mut Output,
) -> Result<Answer, Failure> {
    let mut places = ground.surface.random_places(seed).take(count).peekable();
    if count > 0 && places.peek().is_none() {
        return Err(nothing_walkable(&ground.source));
    }
    if json {
        return out.json(&places.map(|place| ground.spot(&place)).collect::<Vec<Spot>>());
    }
    for place in places {
        let [x, y, z] = ground.in_file(place.point);
        writeln!(out, "{x} {y} {z}")?;
    }
    Ok(Answer::Yes)
}
