//! Two structures: equal up to ids, or what differs, by element and place.
//!
//! ```text
//!   vertices by place ──> edges by the places of their ends ──> faces, their states, all pointers ──> names
//!   which are in one of the two only                            the first difference, if these agree
//! ```

use super::Args;
use crate::output::point;
use crate::subject::Subject;
use crate::{Answer, Failure, Output, fields};
use dcel_kit::ids::{Element, HalfEdgeId, VertexId};
use dcel_kit::io::counted;
use dcel_kit::topology::{Difference, IsomorphismOptions, Matching, View, Which, first_violation, isomorphic_with};
use std::io::Write;

/// So many differences are told.
const TOLD: usize = 20;

pub(super) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let expected = args.input.open_one_of(&args.reference, true)?;
    let mine = args.input.open_one_of(&args.student, true)?;
    for subject in [&expected, &mine] {
        if let Some(violation) = first_violation(subject.view()) {
            let what = format!("{}: {violation}", subject.source);
            return Err(Failure::input(what, "only sound structures are compared; dcel validate says more"));
        }
    }
    let found = differences(args, &mine, &expected);
    let agreed = if found.is_empty() { counts(&expected) } else { String::new() };
    if args.json {
        let line = |of: &Found| fields! { kind: of.kind, layer: "structure", text: of.text.clone() };
        out.json(&fields! {
            reference: &expected.source,
            student: &mine.source,
            equal: found.is_empty(),
            layer: "structure",
            agreed: &agreed,
            differences: found.iter().map(line).collect::<Vec<_>>(),
            notes: [(); 0],
        })?;
    } else if found.is_empty() {
        let what = match (args.built.no_positions, args.built.ids) {
            (false, false) => "same structure and positions, up to ids",
            (true, false) => "same structure, up to ids and positions",
            (false, true) => "same structure, positions and ids",
            (true, true) => "same structure and ids, up to positions",
        };
        writeln!(out, "equal ({what}): {agreed}")?;
    } else {
        writeln!(out, "differs: {}", counted(found.len(), "difference", "differences"))?;
        for (i, Found { text, .. }) in found.iter().take(TOLD).enumerate() {
            writeln!(out, "{:>4}. {text}", i + 1)?;
        }
        if found.len() > TOLD {
            writeln!(out, "      and {} more", found.len() - TOLD)?;
        }
    }
    Ok(if found.is_empty() { Answer::Yes } else { Answer::No })
}

fn counts(subject: &Subject) -> String {
    let edges = half_edges(subject.view()).count() / 2;
    crate::output::counts([subject.vertices().count(), edges, subject.faces().count()])
}

/// A difference, and what it is about.
struct Found {
    kind: &'static str,
    text: String,
}

fn differences(args: &Args, mine: &Subject, expected: &Subject) -> Vec<Found> {
    if mine.mode() != expected.mode() {
        let kind = |subject: &Subject| match subject.mode_name() {
            "plane" => "a subdivision of the plane",
            _ => "a surface in space",
        };
        let (is, should) = (kind(mine), kind(expected));
        let text = format!("{} is {is}, {} is {should} (--plane and --surface choose)", mine.source, expected.source);
        return vec![Found { kind: "structure", text }];
    }
    let places = Places::of(mine, expected);
    if !args.built.no_positions {
        let mut found = places.vertices_apart(mine, expected);
        found.extend(places.edges_apart(mine, expected));
        if !found.is_empty() {
            return found;
        }
    }
    let keys = [&places.mine, &places.expected].map(|ranks| move |v: VertexId| [u64::from(ranks[v.index()]), 0]);
    let mut options = IsomorphismOptions::new();
    if !args.built.no_positions {
        options = options.keys(&keys[0], &keys[1]);
    }
    let stays = |_: Element| true;
    if args.built.ids {
        options = options.fixed(&stays);
    }
    match isomorphic_with(mine.view(), expected.view(), &options) {
        Ok(matching) if args.names => names_apart(mine, expected, &matching),
        Ok(_) => Vec::new(),
        Err(difference) => vec![told(&difference, mine, expected)],
    }
}

/// The number of the place of each vertex, the same for equal positions in both structures.
struct Places {
    mine: Vec<u32>,
    expected: Vec<u32>,
}

impl Places {
    fn of(mine: &Subject, expected: &Subject) -> Self {
        let keys = |subject: &Subject| -> Vec<_> { subject.vertices().map(|v| (v, key(subject, v))).collect() };
        let [a, b] = [mine, expected].map(keys);
        let mut all: Vec<[u64; 4]> = a.iter().chain(&b).map(|&(_, key)| key).collect();
        all.sort_unstable();
        all.dedup();
        let ranks = |subject: &Subject, keys: &[(VertexId, [u64; 4])]| {
            let mut ranks = vec![0; subject.view().vertex_bound()];
            for (v, key) in keys {
                ranks[v.index()] = all.partition_point(|other| other < key) as u32;
            }
            ranks
        };
        Self { mine: ranks(mine, &a), expected: ranks(expected, &b) }
    }

    fn vertices_apart(&self, mine: &Subject, expected: &Subject) -> Vec<Found> {
        let all = |subject: &Subject, ranks: &[u32]| -> Vec<_> {
            subject.vertices().map(|v| ([ranks[v.index()]; 2], v)).collect()
        };
        let text = |subject: &Subject, v: VertexId| format!("{v}{} of {}", at(subject, Some(v)), subject.source);
        self.apart(mine, expected, "vertex", all, text)
    }

    fn edges_apart(&self, mine: &Subject, expected: &Subject) -> Vec<Found> {
        let all = |subject: &Subject, ranks: &[u32]| -> Vec<([u32; 2], HalfEdgeId)> {
            let view = subject.view();
            let edge = |h: HalfEdgeId| {
                let twin = view.twin(h).filter(|twin| h < *twin)?;
                let mut ends = [view.origin(h)?, view.origin(twin)?].map(|v| ranks[v.index()]);
                ends.sort_unstable();
                Some((ends, h))
            };
            half_edges(view).filter_map(edge).collect()
        };
        let text = |subject: &Subject, h: HalfEdgeId| {
            let view = subject.view();
            let ends = [view.origin(h), view.twin(h).and_then(|twin| view.origin(twin))];
            let [from, to] =
                ends.map(|v| format!("{}{}", v.map_or_else(String::new, |v| v.to_string()), at(subject, v)));
            format!("the edge of {h} from {from} to {to} of {}", subject.source)
        };
        self.apart(mine, expected, "edge", all, text)
    }

    /// What only one of them has, among all that each has by its places.
    fn apart<T: Ord + Copy>(
        &self,
        mine: &Subject,
        expected: &Subject,
        kind: &'static str,
        all: impl Fn(&Subject, &[u32]) -> Vec<([u32; 2], T)>,
        text: impl Fn(&Subject, T) -> String,
    ) -> Vec<Found> {
        let (missing, too_much) = apart(all(expected, &self.expected), all(mine, &self.mine));
        let missing = missing.into_iter().map(|one| format!("{} is missing", text(expected, one)));
        let too_much = too_much.into_iter().map(|one| format!("{} is too much", text(mine, one)));
        missing.chain(too_much).map(|text| Found { kind, text }).collect()
    }
}

/// A position as a key: equal exactly for equal coordinates. The last number tells positions from none.
fn key(subject: &Subject, v: VertexId) -> [u64; 4] {
    // Adding 0 turns -0 into 0 and leaves every other number alone.
    let bits = |x: Option<&f64>| x.map_or(0, |x| (x + 0.0).to_bits());
    match subject.position(v) {
        Some(p) => [bits(p.first()), bits(p.get(1)), bits(p.get(2)), 1],
        None => [0; 4],
    }
}

/// What only the first list has, and what only the second, one by one where a key comes several times. In the order of
/// the ids.
fn apart<T: Ord + Copy>(mut a: Vec<([u32; 2], T)>, mut b: Vec<([u32; 2], T)>) -> (Vec<T>, Vec<T>) {
    a.sort_unstable();
    b.sort_unstable();
    let (mut only_a, mut only_b) = (Vec::new(), Vec::new());
    let (mut i, mut j) = (0, 0);
    while i < a.len() || j < b.len() {
        match (a.get(i), b.get(j)) {
            (Some(x), Some(y)) if x.0 == y.0 => (i, j) = (i + 1, j + 1),
            (Some(x), y) if y.is_none_or(|y| x.0 < y.0) => {
                only_a.push(x.1);
                i += 1;
            }
            (_, Some(y)) => {
                only_b.push(y.1);
                j += 1;
            }
            (_, None) => break,
        }
    }
    only_a.sort_unstable();
    only_b.sort_unstable();
    (only_a, only_b)
}

fn half_edges(view: &dyn View) -> impl Iterator<Item = HalfEdgeId> + '_ {
    (0..view.half_edge_bound() as u32).map(HalfEdgeId::new).filter(|&h| view.has_half_edge(h))
}

/// ` (4, 0)`, if there is a position.
fn at(subject: &Subject, v: Option<VertexId>) -> String {
    v.and_then(|v| subject.position(v)).map_or_else(String::new, |p| format!(" {}", point(&p)))
}

fn names_apart(mine: &Subject, expected: &Subject, matching: &Matching) -> Vec<Found> {
    let say = |name: Option<&str>| name.map_or_else(|| "no name".to_owned(), |name| format!("the name {name:?}"));
    let pairs = mine.faces().filter_map(|f| Some((f, *matching.faces.get(f)?.as_ref()?)));
    let apart = pairs.filter(|&(f, g)| mine.name(f) != expected.name(g));
    apart
        .map(|(f, g)| {
            let (has, should) = (say(mine.name(f)), say(expected.name(g)));
            let text = format!("{f} of {} has {has}, {g} of {} has {should}", mine.source, expected.source);
            Found { kind: "face", text }
        })
        .collect()
}

/// A difference with the names of the files and a place.
fn told(difference: &Difference, mine: &Subject, expected: &Subject) -> Found {
    let subject = |which: Which| if which == Which::First { mine } else { expected };
    let kind = |element: Element| match element {
        Element::Vertex(_) => "vertex",
        Element::Face(_) => "face",
        Element::HalfEdge(_) | Element::Edge(_) => "half-edge",
    };
    let near = |subject: &Subject, element: Element| {
        let view = subject.view();
        let v = match element {
            Element::Vertex(v) => Some(v),
            Element::HalfEdge(h) => view.origin(h),
            Element::Edge(e) => view.origin(e.half_edges()[0]),
            Element::Face(f) => view.half_edge(f).and_then(|h| view.origin(h)),
        };
        match element {
            Element::Vertex(_) => at(subject, v),
            _ => v.map_or_else(String::new, |v| format!(" at {v}{}", at(subject, Some(v)))),
        }
    };
    let state = |subject: &Subject, element: Element| match element {
        Element::Face(f) if subject.view().outer_face() == Some(f) => ", the outer face,",
        Element::Face(f) if subject.view().is_hole(f) => ", a hole face,",
        _ => "",
    };
    match difference {
        &Difference::Unpaired { element, which, fixed } => {
            let (here, other) =
                (subject(which), subject(if which == Which::First { Which::Second } else { Which::First }));
            let (near, state, what) = (near(here, element), state(here, element), kind(element));
            let text = if fixed {
                format!("{element}{near}{state} of {} is another {what} in {}", here.source, other.source)
            } else {
                format!("{element}{near}{state} of {} has no {what} like it in {}", here.source, other.source)
            };
            Found { kind: what, text }
        }
        Difference::Component { h, half_edges } => {
            let near = near(mine, Element::HalfEdge(*h));
            let size = counted(*half_edges, "half-edge", "half-edges");
            let text = format!(
                "the part of {} with {h}{near} ({size}) and what lies in its faces is not so in {}",
                mine.source, expected.source
            );
            Found { kind: "half-edge", text }
        }
        Difference::Content { face } => {
            let near = near(mine, Element::Face(*face));
            let text = format!("what lies in {face}{near} of {} is not so in {}", mine.source, expected.source);
            Found { kind: "face", text }
        }
        Difference::Count { what, found, expected: should } if what.starts_with("hole face") => {
            let holes = |subject: &Subject| {
                let all = subject.faces().filter(|&f| subject.view().is_hole(f));
                let all: Vec<String> =
                    all.map(|f| format!("{f}{}", near(subject, Element::Face(f)))).take(TOLD).collect();
                if all.is_empty() { String::new() } else { format!(": {}", all.join(", ")) }
            };
            let text = format!(
                "{} has {found} {what}{}; {} has {should}{}",
                mine.source,
                holes(mine),
                expected.source,
                holes(expected)
            );
            Found { kind: "face", text }
        }
        other => Found { kind: "structure", text: format!("{}: {other}", mine.source) },
    }
}
