//! The rooms of the kit and which uses which, read from the sources that the program carries: the picture cannot be
//! older than the code.
//!
//! ```text
//!   use crate::plane::{Point, edit};     in src/solid/…      solid ──> plane
//!   use dcel_kit::figure;                in src/lab/…        lab   ──> figure
//! ```

use super::Made;
use crate::lab::program_sources;
use dcel_kit::figure::FigureOptions;
use dcel_kit::figure::sketch::{Role, Sketch};
use std::collections::{BTreeMap, BTreeSet};

/// What stands in each room, and the column that it has in the picture. A room that is not here gets a column of its own.
const ROOMS: [(&str, &str, f64); 17] = [
    ("cli", "the command", 1.0),
    ("lab", "exercises, graded", 1.0),
    ("compare", "are drawings alike?", 0.0),
    ("play", "the playground", 1.0),
    ("figure", "drawings", 0.0),
    ("script", "texts of edits", 1.0),
    ("edits", "the table of edits", 1.0),
    ("io", "formats", 2.0),
    ("solid", "surfaces in space", 1.0),
    ("navmesh", "paths on a map", 0.0),
    ("plane", "positions, exactly", 1.0),
    ("topology", "the bare structure", 1.0),
    ("geometry", "points, exact signs", 0.0),
    ("ids", "v3 h7 e3 f0", 1.0),
    ("files", "whole or not at all", 2.0),
    ("progress", "how far it is", 3.0),
    ("interop", "types of others", 3.0),
];

/// How far boxes are apart, and how large they are.
const PITCH: [f64; 2] = [11.0, 5.2];
const SIZE: [f64; 2] = [9.6, 3.0];

/// Which rooms each room uses.
type Uses = BTreeMap<String, BTreeSet<String>>;

/// The picture: one box a room, one arrow from a room to each that it uses; what follows from other arrows is left out.
pub(super) fn picture(options: &FigureOptions) -> Made<String> {
    let uses = uses(program_sources().iter().map(|(path, text)| (path.as_str(), *text)));
    let mut sketch = Sketch::new();
    let place = |room: &str| {
        let column = ROOMS.iter().find(|(name, ..)| *name == room).map_or(3.0, |(.., column)| *column);
        [column * PITCH[0], height(&uses, room) as f64 * PITCH[1]]
    };
    for room in uses.keys() {
        let ([x, y], [w, h]) = (place(room), SIZE.map(|size| size / 2.0));
        sketch.region(Role::Dimmed, [[[x - w, y - h], [x + w, y - h], [x + w, y + h], [x - w, y + h]]]).title(room);
        sketch.text(Role::Main, [x, y + 0.6], room);
        if let Some((_, about, _)) = ROOMS.iter().find(|(name, ..)| name == room) {
            sketch.text(Role::Plain, [x, y - 0.6], about);
        }
    }
    for (room, below) in reduced(&uses) {
        let others = uses.keys().filter(|other| **other != room && **other != below);
        let boxes: Vec<[f64; 2]> = others.map(|other| place(other)).collect();
        let path = route(place(&room), place(&below), &boxes);
        sketch.path(Role::Main, path).solid().arrow().title(format!("{room} uses {below}"));
    }
    Ok(sketch.figure(options)?.to_svg())
}

/// A path from a box down to another that crosses no third one: straight, else to the side and down.
fn route([x, y]: [f64; 2], [u, v]: [f64; 2], boxes: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let [w, h] = SIZE.map(|size| size / 2.0);
    let (side, top) = ([x + w, y], [u, v + h]);
    let lane = x + PITCH[0] / 2.0;
    let paths =
        [vec![[x, y - h], top], vec![side, [u, y], top], vec![side, [lane, y], [lane, v + PITCH[1] / 2.0], top]];
    let is_free = |path: &Vec<[f64; 2]>| {
        let points = path.windows(2).flat_map(|ends| {
            (0..=100).map(|i| [0, 1].map(|k| ends[0][k] + (ends[1][k] - ends[0][k]) * f64::from(i) / 100.0))
        });
        points.into_iter().all(|[a, b]| boxes.iter().all(|[x, y]| (a - x).abs() > w || (b - y).abs() > h))
    };
    let [straight, ..] = &paths;
    paths.iter().find(|path| is_free(path)).unwrap_or(straight).clone()
}

/// Which room uses which, from paths and texts of source files.
fn uses<'a>(sources: impl Iterator<Item = (&'a str, &'a str)>) -> Uses {
    let files: Vec<(&str, &str)> = sources
        .filter_map(|(path, text)| Some((room_of(path)?, text)))
        .filter(|(room, _)| !["sources", "old_words", "lib", "main"].contains(room))
        .collect();
    let mut uses: Uses = files.iter().map(|(room, _)| ((*room).to_owned(), BTreeSet::new())).collect();
    let rooms: BTreeSet<String> = uses.keys().cloned().collect();
    for (room, text) in files {
        let starts: &[&str] = match room {
            "lab" | "cli" => &["dcel_kit::"],
            _ => &["crate::"],
        };
        let mut found: BTreeSet<String> = starts.iter().flat_map(|start| named_after(text, start)).collect();
        if room == "cli" && text.contains("dcel_lab::") {
            found.insert("lab".to_owned());
        }
        found.remove(room);
        uses.entry(room.to_owned()).or_default().extend(found.intersection(&rooms).cloned());
    }
    uses
}

/// The room of a source: `src/plane/check.rs` is in `plane`, `src/ids.rs` is `ids`.
fn room_of(path: &str) -> Option<&str> {
    let inside = path.strip_prefix("src/").filter(|_| path.ends_with(".rs"))?;
    Some(inside.split('/').next().unwrap_or(inside).trim_end_matches(".rs"))
}

/// The first names of all paths that begin so: `plane` and `ids` for `crate::{plane::Point, ids::FaceId}`. Comments do not
/// count, nor what follows `#[cfg(test)]` on a line of its own.
fn named_after(text: &str, start: &str) -> Vec<String> {
    let lines = text.lines().take_while(|line| *line != "#[cfg(test)]");
    let code: String = lines.filter_map(|line| line.split("//").next()).collect::<Vec<_>>().join(" ");
    let name =
        |text: &str| text.trim_start().split(|c: char| !c.is_alphanumeric() && c != '_').next().map(str::to_owned);
    let mut names = Vec::new();
    for rest in code.split(start).skip(1) {
        let Some(group) = rest.trim_start().strip_prefix('{') else {
            names.extend(name(rest));
            continue;
        };
        let mut depth = 0;
        let mut at = 0;
        for (i, c) in group.char_indices() {
            match c {
                '{' => depth += 1,
                '}' if depth == 0 => {
                    names.extend(name(&group[at..i]));
                    break;
                }
                '}' => depth -= 1,
                ',' if depth == 0 => {
                    names.extend(name(&group[at..i]));
                    at = i + 1;
                }
                _ => {}
            }
        }
    }
    names
}

/// How many rooms are below each other under a room. Rooms never use each other in a circle; a test of the house says so.
fn height(uses: &Uses, room: &str) -> usize {
    uses.get(room).into_iter().flatten().map(|below| height(uses, below) + 1).max().unwrap_or(0)
}

/// Whether one room uses another through others.
fn reaches(uses: &Uses, from: &str, to: &str) -> bool {
    uses.get(from).into_iter().flatten().any(|room| room == to || reaches(uses, room, to))
}

/// The arrows that follow from no others.
fn reduced(uses: &Uses) -> Vec<(String, String)> {
    let all = uses.iter().flat_map(|(room, below)| below.iter().map(move |other| (room.clone(), other.clone())));
    all.filter(|(room, below)| !uses[room].iter().any(|between| between != below && reaches(uses, between, below)))
        .collect()
}
