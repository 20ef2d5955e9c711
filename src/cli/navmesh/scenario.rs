//! `dcel navmesh scenario`: every query of a file against its stated length.

use super::super::choice::{Choice, one_of};
use super::super::{Answer, Failure, Output, fields, say, tell};
use super::ends::{Moves, Snap};
use super::map::Map;
use super::numbers::number;
use super::path::Which;
use super::reading::{MapArgs, Preparation};
use super::tell::no_route;
use dcel_kit::io::{Number, Optimum, Query, Scenario, counted, read_whole, source_name};
use dcel_kit::navmesh::{PathAlgorithm, Planner, QueryPointError, RouteError};
use serde::Serialize;
use std::io::Write;
use std::path::PathBuf;

/// Check every query of a scenario against the length that the file states
///
/// The last column of a .scen file is the length of the shortest path in some files, and the octile
/// cost from cell to cell in others, which is an upper bound here; the numbers of the whole file tell
/// which, and the answer says so in its first line. A length is met if it is no further away than
/// half a unit of its last printed digit. If more than half of the lengths differ from those of shortest
/// paths, the first line says that they are of neither kind, and how many times as long they are; in a file of whole numbers alone, of the sixth digit. A
/// stated -1, or 0 between two places, means that there is no path, or no clear place to start or end.
/// Exit code 1 if a query fails.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel navmesh scenario rooms.map \\
    rooms.scen
  dcel navmesh scenario rooms.map \\
    rooms.scen --face-by-face --json")]
pub(super) struct Args {
    #[command(flatten)]
    map: MapArgs,
    /// The queries
    #[arg(value_name = "SCEN")]
    scenario: PathBuf,
    /// How the paths are found
    #[arg(long, value_name = "ALGORITHM", default_value = "exact")]
    algorithm: Which,
    #[command(flatten)]
    preparation: Preparation,
    #[command(flatten)]
    snap: Snap,
    /// What the stated lengths are
    #[arg(long, value_name = "KIND", default_value = "auto", value_parser = one_of(KINDS))]
    optimum: Stated,
    /// How much of its length a path may differ from what is stated, beyond half a unit of the last
    /// digit that is stated
    #[arg(long, value_name = "PART", value_parser = number, default_value_t = 1e-9)]
    tolerance: f64,
    /// Answer in JSON
    #[arg(long)]
    json: bool,
}

/// What the stated lengths are said to be, if anything.
type Stated = Option<Optimum>;

static KINDS: &[Choice<Stated>] = &[
    ("auto", "The numbers tell", None),
    ("euclidean", "The lengths of shortest paths", Some(Optimum::Euclidean)),
    ("octile", "Costs from cell to cell: upper bounds", Some(Optimum::Octile)),
];

/// What came of the queries.
#[derive(Default)]
struct Checked {
    /// The starts and goals that were moved onto the mesh.
    moved: Moves,
    right: usize,
    pops: u64,
    expansions: u64,
    wrong: Vec<Wrong>,
    /// How many of the wrong ones have a start or goal off the mesh.
    off: usize,
    /// The stated lengths of which a path was found, but for those of 0.
    compared: Vec<Compared>,
}

/// Lengths that are of neither kind on the map, told by those of the shortest paths.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
struct Neither {
    /// How many stated lengths there are whose paths were found, but for those of length 0.
    compared: usize,
    /// How many of them are wrong.
    wrong: usize,
    /// How many times as long as the shortest path they are, those that are wrong: the median.
    factor: f64,
    /// How many of the wrong ones are that, within a millionth and what their digits say.
    alike: usize,
}

impl Neither {
    /// Of stated lengths with the lengths of the shortest paths, if more than half of them are wrong.
    fn of(lengths: &[Compared]) -> Option<Self> {
        let lengths = lengths.iter().filter(|length| length.found > 0.0);
        let compared = lengths.clone().count();
        let mut wrong: Vec<&Compared> = lengths.filter(|length| !length.agrees).collect();
        if 2 * wrong.len() <= compared {
            return None;
        }
        wrong.sort_by(|a, b| a.factor().total_cmp(&b.factor()));
        let factor = wrong[wrong.len() / 2].factor();
        let is_alike = |length: &&&Compared| {
            let Compared { stated, found, precision, .. } = **length;
            (stated - factor * found).abs() <= 2.0 * precision + 1e-6 * stated
        };
        let alike = wrong.iter().filter(is_alike).count();
        Some(Self { compared, wrong: wrong.len(), factor, alike })
    }

    /// In words; `nearly` is what the numbers alone say.
    fn words(&self, nearly: Optimum) -> String {
        let Self { compared, wrong, factor, alike } = *self;
        let name = match nearly {
            Optimum::Octile => "octile",
            Optimum::Euclidean => "Euclidean",
        };
        let factor = format!("{factor:.6}");
        let factor = factor.trim_end_matches('0').trim_end_matches('.');
        let lengths = counted(compared, "length is", "lengths are");
        let how = if alike == wrong { "" } else { " in the middle" };
        format!(
            "neither octile nor Euclidean on this map, but nearly {name}: {wrong} of {lengths} wrong, {factor} times the \
             shortest{how}"
        )
    }
}

/// A stated length and that of the path that was found.
struct Compared {
    stated: f64,
    found: f64,
    precision: f64,
    agrees: bool,
}

impl Compared {
    fn factor(&self) -> f64 {
        self.stated / self.found
    }
}

#[derive(Serialize)]
struct Wrong {
    line: u32,
    stated: Option<f64>,
    found: Option<f64>,
    why: String,
}

pub(super) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let [algorithm] = *args.algorithm.algorithms() else {
        return Err(Failure::input(
            "a scenario is checked with one algorithm",
            "choose one, for example --algorithm closest",
        ));
    };
    if !args.tolerance.is_finite() || args.tolerance < 0.0 {
        return Err(Failure::input(format!("a tolerance of {}", args.tolerance), "give a number such as 1e-9"));
    }
    args.snap.check()?;
    let scenario = Scenario::parse(&read_whole(&args.scenario)?, &source_name(&args.scenario))?;
    let map = args.map.open()?;
    tell_other_maps(args, &scenario, args.map.cells(&map));
    let verdict = scenario.verdict();
    let optimum = args.optimum.unwrap_or(verdict.optimum);
    let planner = args.preparation.planner();
    let shortfall = if optimum == Optimum::Octile { verdict.shortfall() } else { 0.0 };
    let checked = check(&map, &scenario, (planner, &args.snap), algorithm, optimum, args.tolerance + shortfall);
    // Of other algorithms, and of what was said to be otherwise, the lengths tell nothing.
    let may_tell = args.optimum.is_none() && algorithm == PathAlgorithm::Exact;
    let neither = Neither::of(&checked.compared).filter(|_| may_tell);
    let ratios: Vec<f64> = checked.compared.iter().map(|length| length.found / length.stated).collect();
    let misfits = verdict.misfits();
    let answer = fields! {
        map: &map.source,
        scenario: &scenario.source,
        algorithm: algorithm.name(),
        optimum: KINDS.iter().find(|(.., kind)| *kind == Some(optimum)).map(|(word, ..)| word),
        // What the stated lengths are, by the numbers of the whole file.
        lengths: fields! {
            verdict: neither.map_or_else(|| verdict.to_string(), |neither| neither.words(optimum)),
            stated: verdict.stated,
            // Those that do not fit what the file is or nearly is, and the line of the first of them.
            misfits: misfits.count,
            first_misfit: misfits.first_line,
            // Whether no way that is not along an axis has a diagonal step: Manhattan distances.
            straight_steps: verdict.straight_steps,
            // Set if most of them are no lengths of this map.
            neither,
        },
        queries: scenario.queries.len(),
        moved: checked.moved,
        right: checked.right,
        // Of the stated lengths.
        mean_ratio: (!ratios.is_empty()).then(|| ratios.iter().sum::<f64>() / ratios.len() as f64),
        max_ratio: ratios.iter().copied().reduce(f64::max),
        pops: checked.pops,
        expansions: checked.expansions,
        wrong: &checked.wrong,
    };
    tell(&answer, args.json, out, |out| {
        const SHOWN: usize = 10;
        writeln!(out, "stated lengths: {}", answer.lengths.verdict)?;
        for wrong in answer.wrong.iter().take(SHOWN) {
            writeln!(out, "{}:{}: {}", answer.scenario, wrong.line, wrong.why)?;
        }
        if answer.wrong.len() > SHOWN {
            writeln!(out, "and {} more", answer.wrong.len() - SHOWN)?;
        }
        let Moves { count, farthest } = answer.moved;
        if count > 0 {
            let ends = counted(count, "start or goal was", "starts and goals were");
            writeln!(out, "{ends} off the mesh and moved onto it, by {} at most", Number(farthest))?;
        }
        if let (Some(mean), Some(max)) = (answer.mean_ratio, answer.max_ratio) {
            writeln!(out, "{}: {mean:.9} of the stated length on average, {max:.9} at most", answer.algorithm)?;
        }
        let words = if optimum == Optimum::Octile { "within the octile cost" } else { "optimal" };
        writeln!(out, "{} of {} {words}", answer.right, answer.queries)
    })?;
    if checked.off > 0 && args.snap.limit().is_none() {
        let ends = counted(checked.off, "query starts or ends", "queries start or end");
        say("help", format_args!("{ends} off the mesh: --snap 0.5 moves their ends onto it, if it is so near"));
    }
    Ok(if checked.wrong.is_empty() { Answer::Yes } else { Answer::No })
}

/// Tells if the queries are about a map of another name, or of another size in cells.
fn tell_other_maps(args: &Args, scenario: &Scenario, cells: Option<[u32; 2]>) {
    let file = args.map.file.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let name = |query: &Query| query.map.rsplit(['/', '\\']).next().unwrap_or_default().to_owned();
    if let Some(query) = scenario.queries.iter().find(|query| name(query) != file) {
        say("note", format_args!("{}:{}: this query is about {}, not {file}", scenario.source, query.line, query.map));
    }
    let differs = |query: &&Query| cells.is_some_and(|cells| query.size != cells.map(u64::from));
    if let (Some(query), Some([width, height])) = (scenario.queries.iter().find(differs), cells) {
        let [w, h] = query.size;
        say(
            "warning",
            format_args!(
                "{}:{}: this query is about a map of {w} x {h} cells, and {file} has {width} x {height}: its points are \
                 taken as they stand, and not scaled",
                scenario.source, query.line
            ),
        );
    }
}

fn check(
    map: &Map,
    scenario: &Scenario,
    (mut planner, snap): (Planner, &Snap),
    algorithm: PathAlgorithm,
    optimum: Optimum,
    tolerance: f64,
) -> Checked {
    let mut checked = Checked::default();
    for query in &scenario.queries {
        let [start, goal] = [query.start, query.goal].map(|p| map.point([p.x, p.y]));
        // What is stated to have no path may have no clear place to start or end.
        let clear =
            || [start, goal].into_iter().all(|p| !matches!(map.mesh.place(p), Err(QueryPointError::Ambiguous { .. })));
        if query.length.is_none() && !clear() {
            checked.right += 1;
            continue;
        }
        let ends = [start, goal].map(|p| snap.place(map, p, &mut checked.moved));
        let route = match ends {
            [Ok(starts), Ok(goals)] => {
                planner.route_among(&map.mesh, algorithm, &starts, &goals).map(|(route, _)| route)
            }
            [Err(error), _] => Err(RouteError::Start(error)),
            [_, Err(error)] => Err(RouteError::Goal(error)),
        };
        let found = route.as_ref().ok().map(|route| route.length);
        if let Ok(route) = &route {
            checked.pops += route.work.pops;
            checked.expansions += route.work.expansions;
        }
        let agrees = query.agrees(found, optimum, tolerance);
        if let (Some(stated), Some(found)) = (query.length.filter(|&stated| stated > 0.0), found) {
            checked.compared.push(Compared { stated, found, precision: query.precision, agrees });
        }
        if agrees {
            checked.right += 1;
        } else {
            checked.off += usize::from(matches!(route, Err(RouteError::Start(_) | RouteError::Goal(_))));
            let why = why(query.length, found, route.err().map(|error| no_route(map, &error)));
            checked.wrong.push(Wrong { line: query.line, stated: query.length, found, why });
        }
    }
    checked
}

fn why(stated: Option<f64>, found: Option<f64>, error: Option<String>) -> String {
    match (stated, found, error) {
        (Some(stated), Some(found), _) => format!("{found} instead of {stated}, {:.9} of it", found / stated),
        (None, Some(found), _) => format!("a path of length {found}, and none is stated"),
        (Some(stated), None, Some(error)) => format!("no path, and {stated} is stated: {error}"),
        _ => "no path".to_owned(),
    }
}
