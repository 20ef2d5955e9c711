//! Paths as they are told, of maps and of floors in space: one by one, compared, over links.

use super::super::output::{names, point, table};
use super::super::{Answer, Failure, Output, fields, say};
use super::tell::faces;
use dcel_kit::io::counted;
use dcel_kit::navmesh::{PathAlgorithm, Work};
use dcel_kit::{FaceId, VertexId};
use serde::Serialize;
use std::io::{self, Write};

/// A path, or a leg of one. The names are those of the JSON form.
#[derive(Serialize)]
pub(super) struct Row {
    pub(super) algorithm: &'static str,
    /// On a floor in space along the surface.
    pub(super) length: f64,
    /// With the costs of areas, if there are any.
    pub(super) cost: Option<f64>,
    /// How much longer than the exact path, if that was asked for.
    pub(super) ratio: Option<f64>,
    pub(super) points: Vec<Vec<f64>>,
    /// The layer of each piece between two points, on a floor in space.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) layers: Option<Vec<usize>>,
    pub(super) corners: Vec<String>,
    pub(super) faces: Vec<String>,
    /// On a map.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) portals: Option<Vec<String>>,
    pub(super) pops: u64,
    pub(super) pushes: u64,
    pub(super) expansions: u64,
}

impl Row {
    /// What paths of all kinds have.
    pub(super) fn new(
        algorithm: PathAlgorithm,
        length: f64,
        (corners, faces): (&[VertexId], &[FaceId]),
        work: Work,
    ) -> Self {
        Self {
            algorithm: algorithm.name(),
            length,
            cost: None,
            ratio: None,
            points: Vec::new(),
            layers: None,
            corners: names(corners),
            faces: names(faces),
            portals: None,
            pops: work.pops,
            pushes: work.pushes,
            expansions: work.expansions,
        }
    }

    fn print(&self, out: &mut Output) -> io::Result<()> {
        let cost = self.cost.map(|cost| format!(", costs {cost}")).unwrap_or_default();
        let (along, path) = if self.layers.is_some() { (" along the surface", "path") } else { ("", "way") };
        writeln!(out, "{}: {}{along}{cost}, through {}", self.algorithm, self.length, faces(self.faces.len()))?;
        let points: Vec<String> = self.points.iter().map(|p| point(p)).collect();
        let mut layers: Vec<String> = self.layers.iter().flatten().map(ToString::to_string).collect();
        layers.dedup();
        let portals = self.portals.as_deref().unwrap_or_default();
        for (what, words) in [
            (path, &points[..]),
            ("layers", &layers),
            ("corners", &self.corners),
            ("faces", &self.faces),
            ("portals", portals),
        ] {
            if !words.is_empty() {
                writeln!(out, "  {what:<8}{}", words.join(" "))?;
            }
        }
        let entered = if self.layers.is_some() {
            format!("{} looked behind", self.expansions)
        } else {
            format!("{} entered", faces(self.expansions as usize))
        };
        writeln!(out, "  {:<8}{} taken from the queue, {entered}", "work", self.pops)?;
        Ok(())
    }
}

/// These paths, each with how much longer it is than the exact one, if that is among them.
pub(super) fn compared(mut rows: Vec<Row>) -> Vec<Row> {
    let exact = rows.iter().find(|row| row.algorithm == PathAlgorithm::Exact.name()).map(|row| row.length);
    for row in &mut rows {
        row.ratio = exact.filter(|&exact| exact > 0.0).map(|exact| row.length / exact);
    }
    rows
}

/// Tells the paths: one in full, several as a table.
pub(super) fn print(rows: &[Row], out: &mut Output) -> io::Result<()> {
    if let [row] = rows {
        return row.print(out);
    }
    let is_map = rows.iter().any(|row| row.layers.is_none());
    let head = ["algorithm", "length", "of the exact", "faces", "corners", "from queue", "entered"];
    let mut lines = vec![head.map(str::to_owned)];
    for row in rows {
        lines.push([
            row.algorithm.to_owned(),
            format!("{:.6}", row.length),
            row.ratio.map_or_else(|| "-".to_owned(), |ratio| format!("{ratio:.6}")),
            row.faces.len().to_string(),
            row.corners.len().to_string(),
            row.pops.to_string(),
            row.expansions.to_string(),
        ]);
    }
    // A search over a surface enters no faces.
    lines.iter_mut().filter(|_| !is_map).for_each(|line| line[6].clear());
    table(out, &lines)
}

/// The answer with these paths; if there are none, what lies apart. Agents on a floor in space have no radius.
pub(super) fn answer<S: Serialize, A: Serialize>(
    source: &str,
    radius: Option<Option<f64>>,
    [start, goal]: [S; 2],
    [start_moved, goal_moved]: [Option<f64>; 2],
    apart: Option<A>,
    routes: &[Row],
) -> impl Serialize {
    fields! {
        source,
        #[serde(flatten)]
        radius: radius.map(|radius| fields! { radius }),
        start,
        goal,
        // How far the start was moved to stand on the mesh, and the goal.
        start_moved,
        goal_moved,
        found: apart.is_none(),
        apart,
        routes,
    }
}

/// Of the answers from several places at a start the one that reaches furthest, the first of equal ones, with its place.
/// Tells which.
pub(super) fn furthest<P, A>(
    (start, why): (&str, &str),
    answers: Vec<(P, A)>,
    face: impl Fn(&P) -> FaceId,
    reach: impl Fn(&A) -> f64,
) -> Option<(P, A)> {
    let faces = names(answers.iter().map(|(place, _)| face(place)));
    let further = |best: (P, A), other: (P, A)| if reach(&other.1) > reach(&best.1) { other } else { best };
    let best = answers.into_iter().reduce(further)?;
    if faces.len() > 1 {
        let (all, face) = (faces.join(", "), face(&best.0));
        say(
            "note",
            format_args!(
                "the start {start} is {why}, in {all}: the line gets furthest in {face}; --start-face chooses"
            ),
        );
    }
    Some(best)
}

/// Tells that distances count from each of several places at a start.
pub(super) fn from_each(start: &str, why: &str, faces: impl ExactSizeIterator<Item = FaceId>) {
    if faces.len() > 1 {
        let all = names(faces).join(", ");
        say(
            "note",
            format_args!("the start {start} is {why}, in {all}: the nearest of them counts; --start-face chooses one"),
        );
    }
}

/// Why a point of a map is several places, and one of a surface.
pub(super) const ON_SIDES: &str = "on several sides of a border";
pub(super) const WHERE_FACES_TOUCH: &str = "where faces touch in a vertex";

/// Of several places at the ends of a path those of the shortest one. Tells which, and why there are several.
pub(super) fn choose<P: Copy>(
    ends: &[(&str, String, &[P]); 2],
    why: &str,
    face: impl Fn(&P) -> FaceId,
    shortest: impl FnOnce() -> Option<[usize; 2]>,
) -> [P; 2] {
    let [starts, goals] = [ends[0].2, ends[1].2];
    if starts.len() == 1 && goals.len() == 1 {
        return [starts[0], goals[0]];
    }
    let found = shortest();
    let [i, k] = found.unwrap_or_default();
    for ((what, at, places), chosen) in ends.iter().zip([i, k]).filter(|((.., places), _)| places.len() > 1) {
        let (others, face) = (names(places.iter().map(&face)).join(", "), face(&places[chosen]));
        let told = match found {
            Some(_) => format!("the shortest path is that of {face}; --{what}-face chooses"),
            None => "no path begins or ends in any of them".to_owned(),
        };
        say("note", format_args!("the {what} {at} is {why}, in {others}: {told}"));
    }
    [starts[i], goals[k]]
}

/// The links of the command line. One whose ends are at points of several sides is a link from each side to each side.
pub(super) struct Links<L> {
    pub(super) sides: Vec<L>,
    /// For each of them which link of the command line it is, from 0.
    numbers: Vec<usize>,
}

impl<L> Links<L> {
    pub(super) fn new() -> Self {
        Self { sides: Vec::new(), numbers: Vec::new() }
    }

    /// Adds the next link of the command line, from side to side.
    pub(super) fn add<P>(&mut self, [from, to]: [&[P]; 2], link: impl Fn(&P, &P) -> L) {
        let number = self.numbers.last().map_or(0, |last| last + 1);
        for side in from.iter().flat_map(|a| to.iter().map(move |b| (a, b))) {
            self.sides.push(link(side.0, side.1));
            self.numbers.push(number);
        }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.sides.is_empty()
    }

    /// Which links of the command line these are.
    pub(super) fn numbers(&self, sides: &[usize]) -> Vec<usize> {
        sides.iter().map(|&side| self.numbers[side]).collect()
    }

    /// The first of the sides of a link of the command line.
    pub(super) fn first_side(&self, number: usize) -> Option<&L> {
        self.sides.get(self.numbers.partition_point(|&of| of < number))
    }
}

/// What the legs and links of a path cost, the legs, each in words, too, and the links by their sides.
type Linked<'a, L> = (f64, Vec<(L, String)>, &'a [usize]);

/// Tells a path over links, if there is one. `ends` are those of a link, `between` those of the path, `ground` is what was
/// searched.
pub(super) fn tell_linked<L: Serialize, S: Serialize, K>(
    (source, json): (&str, bool),
    algorithm: PathAlgorithm,
    ([start, goal], [start_moved, goal_moved]): ([S; 2], [Option<f64>; 2]),
    path: Option<Linked<'_, L>>,
    (links, ends): (&Links<K>, impl Fn(&K) -> ([String; 2], f64)),
    (ground, between): (&str, [String; 2]),
    out: &mut Output,
) -> Result<Answer, Failure> {
    let found = path.is_some();
    let answer = if found { Answer::Yes } else { Answer::No };
    let numbers = path.as_ref().map_or_else(Vec::new, |&(.., sides)| links.numbers(sides));
    let cost = path.as_ref().map(|&(cost, ..)| cost);
    let (legs, words): (Vec<L>, Vec<String>) = path.into_iter().flat_map(|(_, legs, _)| legs).unzip();
    if json {
        let (algorithm, links) = (algorithm.name(), numbers);
        out.json(&fields! { source, algorithm, start, goal, start_moved, goal_moved, found, cost, legs, links })?;
        return Ok(answer);
    }
    let Some(cost) = cost else {
        let [from, to] = between;
        writeln!(out, "no path: neither the {ground} nor the links lead from {from} to {to}")?;
        return Ok(answer);
    };
    writeln!(out, "{algorithm}: {cost}, over {}", counted(numbers.len(), "link", "links"))?;
    for (i, leg) in words.iter().enumerate() {
        let before = i.checked_sub(1).and_then(|before| links.first_side(*numbers.get(before)?));
        if let Some(([from, to], cost)) = before.map(&ends) {
            writeln!(out, "  link    {from} -> {to}, costs {cost}")?;
        }
        writeln!(out, "  leg     {leg}")?;
    }
    Ok(answer)
}
