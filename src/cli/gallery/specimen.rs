//! The reference figures of the drawing vocabulary.

use super::Made;
use super::chart::Chart;
use super::lesson;
use dcel_kit::figure::navmesh::Floor;
use dcel_kit::figure::sketch::{Backdrop, Multiples, Role, Sketch};
use dcel_kit::figure::{self, Detail, FigureOptions, NearlyCollinear};
use dcel_kit::io::Grid;
use dcel_kit::navmesh::{NavMesh, PathAlgorithm, Planner};
use dcel_kit::plane::{Point, TriangulationMethod};

/// One room with two pillars and a notch, for all panels: so that one can compare them.
const ROOM: [[f64; 2]; 8] =
    [[0.0, 0.0], [12.0, 0.0], [12.0, 9.0], [7.0, 9.0], [7.0, 6.5], [5.5, 6.5], [5.5, 9.0], [0.0, 9.0]];
const PILLAR: [[f64; 2]; 4] = [[3.0, 2.0], [5.0, 2.0], [5.0, 4.5], [3.0, 4.5]];
const WEDGE: [[f64; 2]; 3] = [[7.5, 2.0], [10.0, 3.0], [8.0, 5.0]];

fn room() -> Sketch {
    let mut sketch = Sketch::new();
    sketch.region(Role::Plain, [ROOM.to_vec(), PILLAR.to_vec(), WEDGE.to_vec()]);
    sketch
}

/// The sheet: every element and every role in a panel where it is at home.
pub(super) fn vocabulary(options: &FigureOptions) -> Made<String> {
    let mut sheet = Multiples::new();
    sheet.sketch("Regions, paths, portals", "the corridor in blue, its portals in the order of the way", corridor());
    sheet.sketch("Cones and rays", "what is seen from the start, cut by the frame or by an end", cones());
    sheet.sketch("Circles and arcs", "an empty circle, one that is not, a clearance", circles());
    sheet.sketch("A sweep", "events by their marks; the line runs from frame to frame", sweep());
    sheet.sketch("Roles", "lines differ by dash and width, points by their marks, too", roles());
    sheet.sketch("Badges and labels", "badges are explained in the legend; labels cover nothing", badges());
    Ok(sheet.figure(options)?.to_svg())
}

fn corridor() -> Sketch {
    let mut sketch = room();
    let corridor = [[1.0, 1.0], [5.0, 2.0], [5.0, 4.5], [7.0, 6.5], [10.5, 8.0], [8.0, 5.0], [7.5, 2.0]];
    sketch.region(Role::Main, [corridor]).plain().key("corridor");
    sketch.portal(Role::Secondary, [5.0, 2.0], [7.5, 2.0]).key("portal: its left end a square, its right end a ring");
    sketch.portal(Role::Secondary, [5.0, 4.5], [8.0, 5.0]);
    sketch.portal(Role::Secondary, [7.0, 6.5], [8.0, 5.0]).label("portal");
    sketch.path(Role::Main, [[1.0, 1.0], [5.0, 2.0], [10.5, 8.0]]).arrow().key("shortest path");
    sketch.path(Role::Goal, [[1.0, 1.0], [2.0, 5.5], [5.0, 5.5], [10.5, 8.0]]).key("the other way round");
    sketch.point(Role::Start, [1.0, 1.0]).label("start");
    sketch.point(Role::Goal, [10.5, 8.0]).label("goal");
    sketch
}

fn cones() -> Sketch {
    let mut sketch = room();
    sketch.cone(Role::Start, [1.0, 1.0], [7.5, 2.0], [5.0, 2.0]).label("to the frame");
    sketch.cone(Role::Event, [10.5, 8.0], [7.0, 6.5], [8.0, 5.0]).until([7.0, 6.5], [8.0, 5.0]).label("to an end");
    sketch.ray(Role::Secondary, [3.0, 4.5], [2.0, 6.5]).label("ray");
    sketch.point(Role::Start, [1.0, 1.0]);
    sketch.point(Role::Event, [10.5, 8.0]).label("apex");
    sketch
}

fn circles() -> Sketch {
    let mut sketch = room();
    sketch.circumcircle(Role::Right, [[0.0, 0.0], [3.0, 2.0], [3.0, 4.5]]).label("empty");
    sketch.circumcircle(Role::Wrong, [[5.0, 2.0], [12.0, 0.0], [10.0, 3.0]]).label("not empty");
    sketch.circle(Role::Main, [5.0, 6.5], 1.6).filled().label("clearance");
    sketch.arc(Role::Goal, [12.0, 9.0], [9.6, 9.0], [12.0, 5.0]).label("arc");
    sketch.point(Role::Plain, [5.0, 6.5]);
    sketch
}

fn sweep() -> Sketch {
    let mut sketch = room();
    sketch.line(Role::Main, [6.25, 0.0], [6.25, 1.0]).label("sweep line");
    for (role, p) in
        [(Role::Dimmed, [3.0, 2.0]), (Role::Dimmed, [5.0, 4.5]), (Role::Event, [7.0, 6.5]), (Role::Event, [8.0, 5.0])]
    {
        sketch.point(role, p);
    }
    sketch.point(Role::Event, [7.5, 2.0]).label("next event");
    sketch.path(Role::Secondary, [[0.0, 3.2], [3.0, 3.2]]).double_arrow().solid().label("gap");
    sketch
}

fn roles() -> Sketch {
    let mut sketch = Sketch::new();
    for (i, role) in Role::ALL.into_iter().enumerate() {
        let y = 8.6 - i as f64;
        sketch.path(role, [[0.5, y], [7.0, y]]);
        sketch.point(role, [8.0, y]).label(format!("{role:?}"));
    }
    sketch
}

fn badges() -> Sketch {
    let mut sketch = room();
    sketch.badge(Role::Main, [1.5, 7.5], "a badge stands as near to its point as there is room");
    sketch.badge(Role::Wrong, [5.0, 4.5], "at a corner it steps aside");
    sketch.point(Role::Wrong, [8.0, 5.0]).label("a wrong corner");
    sketch.point(Role::Right, [10.0, 3.0]).label("a right one");
    sketch.region(Role::Plain, [PILLAR.to_vec()]).hatched().label("pillar").key("blocked");
    sketch.text(Role::Plain, [9.0, 1.0], "text");
    sketch
}

/// The three examples of the source, and how many of the first n × n points doubles get wrong.
pub(super) fn wrong_signs(options: &FigureOptions) -> Made<String> {
    let step = 0.5 * f64::EPSILON;
    let examples = [
        ("a", NearlyCollinear::default()),
        ("b", NearlyCollinear::new([0.5; 2], [8.8; 2], [12.1; 2], step)?),
        (
            "c",
            NearlyCollinear::new(
                [0.500_000_000_000_025_3, 0.500_000_000_000_017_1],
                [17.3; 2],
                [24.000_000_000_000_05, 24.000_000_000_000_052],
                step,
            )?,
        ),
    ];
    let mut chart = Chart::new(["side n of the grid (points)", "wrong signs"], [5.0, 50.0], [500.0, 20_000.0]);
    for (name, points) in examples {
        let counts = [8, 16, 32, 64, 128, 256].map(|n| [n as f64, points.wrong_within(n) as f64]);
        chart.series(&format!("example {name}"), counts);
    }
    chart.growth("n²", [8.0, 64.0], [140.0, 140.0 * 140.0]);
    chart.growth("n", [50.0, 50.0], [500.0, 500.0]);
    Ok(chart.sketch.figure(options)?.to_svg())
}

/// How many bytes a figure takes for each edge of a grid, and how much it shows. Counted, not measured: the same on
/// every machine.
pub(super) fn figure_sizes(options: &FigureOptions) -> Made<String> {
    let levels = [
        (Detail::Full, "everything"),
        (Detail::Arrows, "half-edges without labels"),
        (Detail::Edges, "edges"),
        (Detail::Tiles, "edges in tiles"),
    ];
    let mut samples: Vec<(Detail, [f64; 2])> = Vec::new();
    for side in [1, 2, 3, 5, 7, 9, 11, 14, 20, 28, 40, 57, 80, 113] {
        let grid = lesson::grid(side)?;
        let figure = figure::structure(&grid, &FigureOptions::new("Grid").width(640.0))?;
        let edges = grid.edge_count() as f64;
        samples.push((figure.detail(), [edges, figure.to_svg().len() as f64 / edges]));
    }
    let titles = ["edges of a square grid", "bytes of the figure for each edge"];
    let mut chart = Chart::new(titles, [2.0, 10.0], [50_000.0, 2_000.0]);
    for (level, name) in levels {
        chart.series(name, samples.iter().filter(|sample| sample.0 == level).map(|sample| sample.1));
    }
    Ok(chart.sketch.figure(options)?.to_svg())
}

/// A straight walk through a subdivision: what a point location does, over the structure it does it in.
pub(super) fn walk(options: &FigureOptions) -> Made<String> {
    let cube = lesson::cube()?;
    let mut sketch = Sketch::new();
    let (from, to) = ([0.9, 3.6], [5.3, 2.3]);
    sketch.ray(Role::Dimmed, from, to).dashed();
    sketch.path(Role::Main, [from, to]).arrow().key("the way from the start to the point in question");
    for (side, words) in [(1.8, "the first edge on the way: on to its twin's face"), (4.2, "the second edge")] {
        let y = from[1] + (side - from[0]) * (to[1] - from[1]) / (to[0] - from[0]);
        sketch.point(Role::Event, [side, y]).key("where it passes an edge");
        sketch.badge(Role::Event, [side, y], words);
    }
    sketch.portal(Role::Secondary, [1.8, 3.9], [1.8, 2.1]).key("the edge seen on the way: left a square, right a ring");
    sketch.portal(Role::Secondary, [4.2, 3.9], [4.2, 2.1]);
    sketch.point(Role::Start, from).label("start");
    sketch.point(Role::Goal, to).label("query");
    let options = options.clone().half_edge_labels(false);
    Ok(sketch.over(&cube, Backdrop::Dimmed, &options)?.to_svg())
}

/// A map, and two places in it between which no two algorithms take the same path.
const BLOCKS: &str = "\
type octile
height 16
width 26
map
..........................
...........@@@............
..@@@@.....@@@............
...........@@@............
.............@@@@@@...@@@.
....@@@......@@@@@@...@@@.
....@@@......@@@@@@...@@@.
....@@@......@@@@@@...@@@.
....@@@......@@@@@@...@@@.
.......@@@@@@@@@@......@@.
.......@@@@@@@@@@......@@.
..........@@@@@@@......@@.
..@@@@@@..................
............@@@@@@@.......
...@@@@@@@..@@@@@@@.......
..........................
";

/// Every algorithm of the ladder between two places of a map, cut into triangles.
pub(super) fn ladder(options: &FigureOptions) -> Made<String> {
    let mut map = Grid::parse(BLOCKS.as_bytes(), "blocks.map")?.regions()?;
    let borders = map.edge_bound();
    map.triangulate(TriangulationMethod::default())?;
    map.make_delaunay(|edge| edge.index() < borders);
    let mesh = NavMesh::new(&map)?;
    let (start, goal) = (Point::new(9.5, -0.5), Point::new(12.5, -15.5));
    let mut planner = Planner::new();
    let mut routes = Vec::new();
    for algorithm in PathAlgorithm::ALL {
        routes.push((algorithm, planner.route_between(&mesh, algorithm, start, goal)?));
    }
    Ok(Floor::new(&map, &mesh).ladder(&routes, options)?.to_svg())
}
