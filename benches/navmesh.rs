//! Ways over maps, against crate polyanya.
//!
//! `cargo bench --bench navmesh` makes three maps of more than 30,000 triangles: caves on a grid, the same kind of
//! caves with rough walls, whose notches are dead ends, and a plain with convex blocks, which has none. If the folder
//! `../shared/data` is there, it reads the map O15, too. All are cut into constrained Delaunay triangles, as navmeshes
//! are. On each it locates random points and answers queries by every algorithm. Of each query the
//! programs take turns, four times, and the least time of each counts. The peer searches the same triangles, and its own merged polygons; so does the kit, which also
//! goes from crossing to crossing.
//!
//! `-- live` puts obstacles into a map, moves them, and takes them out. `-- blocked` compares maps that list blocked
//! triangles with the same maps without them.
//!
//! `-- surfaces` shows how floors with heights grow: making one, and locating, nearest places, rays and paths on it.
//!
//! `-- linear` shows how making a mesh and its index grows with pillars that stand in a row: most triangles are slivers
//! from their tips to one corner; with one face of many corners; and with storeys over each other; and how a wall grows
//! with the squares it crosses.

use cpu_time::ProcessTime;
use dcel_kit::io::{Grid, Scenario};
use dcel_kit::navmesh::{
    Floor, LiveMesh, Location, NavMesh, NavSurface, ObstacleId, PathAlgorithm, Planner, SurfacePlanner, SurfacePoint,
    mesh_faults,
};
use dcel_kit::plane::{Point, Subdivision, TriangulationMethod};
use dcel_kit::topology::PolygonList;
use dcel_kit::{HalfEdgeId, VertexId};
use dcel_kit_benches::maps::{Ends, anywhere, blocks, caves, merged_peer, pairs, peer, triangles, vec};
use dcel_kit_benches::{DOUBLED, Random, growth};
use std::hint::black_box;
use std::time::Instant;

const ROUNDS: usize = 4;

fn main() {
    if std::env::args().any(|arg| arg == "linear") {
        return linear();
    }
    if std::env::args().any(|arg| arg == "live") {
        return live();
    }
    if std::env::args().any(|arg| arg == "blocked") {
        return blocked();
    }
    if std::env::args().any(|arg| arg == "surfaces") {
        return surfaces();
    }
    let mut random = Random::new(5);
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../shared/data/O15-gppc-acrossthecape/AcrosstheCape.map");
    if let (Ok(map), Ok(queries)) = (std::fs::read(folder), std::fs::read(format!("{folder}.scen"))) {
        let grid = Grid::parse(&map, "O15").expect("a map");
        let scenario = Scenario::parse(&queries, "O15").expect("its queries");
        let up = |p: Point| Point::new(p.x, -p.y);
        let queries = scenario.queries.iter().map(|query| (up(query.start), up(query.goal))).collect();
        measure("O15", triangles(grid.regions().expect("regions")), Some(queries), &mut random);
    }
    for (name, size, rough) in [("caves", 400, false), ("rough caves", 180, true)] {
        measure(name, triangles(caves(size, rough, &mut random).regions().expect("regions")), None, &mut random);
    }
    measure("blocks", blocks(75, &mut random), None, &mut random);
}

/// A corridor with triangular pillars in a row, cut into about `count` triangles.
fn pillars(count: usize) -> Subdivision {
    let pillars = count / 3;
    let width = 3.0 * pillars as f64 + 1.0;
    let mut points: Vec<Point> = [(-1., -1.), (width, -1.), (width, 3.), (-1., 3.)].map(Point::from).to_vec();
    let mut edges = vec![[0, 1], [1, 2], [2, 3], [3, 0]];
    for i in 0..pillars {
        let (x, first) = (3.0 * i as f64, points.len() as u32);
        points.extend([(x, 0.), (x + 1., 0.), (x, 1.)].map(Point::from));
        edges.extend((0..3).map(|k| [first + k, first + (k + 1) % 3]));
    }
    let mut map = Subdivision::from_graph(&points, &edges).expect("pillars stand apart");
    for i in (4..edges.len() as u32).step_by(3) {
        let inside = map.face(HalfEdgeId::new(2 * i));
        map.set_hole(inside, true);
    }
    triangles(map)
}

fn linear() {
    growth("NavMesh::new, pillars in a row, by triangles", &DOUBLED, |count| {
        let map = pillars(count);
        move || NavMesh::new(&map).expect("triangles").memory()
    });
    growth("location of as many points there", &DOUBLED, |count| {
        let mesh = NavMesh::new(&pillars(count)).expect("triangles");
        let mut random = Random::new(3);
        let mut point = || Point::new(random.unit() * count as f64, 4.0 * random.unit() - 1.0);
        let points: Vec<Point> = (0..count).map(|_| point()).collect();
        move || points.iter().filter(|&&p| matches!(mesh.locate(p), Location::Face(_))).count()
    });
    growth("all lengths there from its left end, by triangles", &DOUBLED, |count| {
        let mesh = NavMesh::new(&pillars(count)).expect("triangles");
        let start = mesh.place(Point::new(-0.5, -0.5)).expect("on the map");
        let planner = std::cell::RefCell::new(Planner::new());
        move || planner.borrow_mut().distance_field(&mesh, &start, f64::INFINITY).work.pushes
    });
    growth("NavMesh::new and its faults, one face, by corners", &DOUBLED, |count| {
        let points = parabola(count);
        let mut face = PolygonList::new();
        face.push_face(&(0..count as u32).collect::<Vec<_>>());
        let map = Subdivision::polygon(&points).expect("a convex face");
        move || NavMesh::new(&map).expect("convex").memory() + mesh_faults(&points, &face, &[]).len()
    });
    growth("the map of an agent in one face, by corners", &DOUBLED, |count| {
        let mesh = NavMesh::new(&Subdivision::polygon(&parabola(count)).expect("a convex face")).expect("convex");
        move || mesh.inset(0.001).expect("room").mesh().memory()
    });
    growth("insert_wall along a strip, by squares", &DOUBLED, |count| {
        let points: Vec<Point> = (0..=count).flat_map(|i| [0.0, 1.0].map(|y| Point::new(i as f64, y))).collect();
        let ends = (0..=count as u32).map(|i| [2 * i, 2 * i + 1]);
        let edges: Vec<[u32; 2]> = ends.chain((0..2 * count as u32).map(|i| [i, i + 2])).collect();
        let live = LiveMesh::new(Subdivision::from_graph(&points, &edges).expect("a strip")).expect("squares");
        move || {
            let mut live = live.clone();
            live.insert_wall(Point::new(0.5, 0.4), Point::new(count as f64 - 2.5, 0.6)).expect("it fits");
            live.last_edit().links
        }
    });
    for storeys in [2, 50] {
        growth(&format!("NavSurface::new, {storeys} storeys of loose squares, by squares"), &DOUBLED, |count| {
            let (points, faces) = building(count, storeys);
            move || NavSurface::new(&points, &faces, None).expect("storeys").layer_count()
        });
    }
}

/// A convex polygon of whole numbers: corners on a parabola, which is closed by its chord.
fn parabola(corners: usize) -> Vec<Point> {
    (0..corners).map(|i| i as f64 - (corners / 2) as f64).map(|x| Point::new(x, x * x)).collect()
}

/// Unit squares that share no corner, on so many storeys over each other.
fn building(squares: usize, storeys: usize) -> (Vec<[f64; 3]>, PolygonList) {
    let side = (squares / storeys).isqrt().max(1);
    let (mut points, mut faces) = (Vec::new(), PolygonList::new());
    for i in 0..side * side * storeys {
        let [x, y, z] = [i % side, i / side % side, i / (side * side)].map(|c| c as f64);
        let first = points.len() as u32;
        points.extend([[x, y, z], [x + 1.0, y, z], [x + 1.0, y + 1.0, z], [x, y + 1.0, z]]);
        faces.push_face(&[first, first + 1, first + 2, first + 3]);
    }
    (points, faces)
}

/// A floor of about `count` triangles with a gentle height in every point.
fn hills(count: usize) -> NavSurface {
    let side = ((count / 2) as f64).sqrt() as usize;
    let mut random = Random::new(8);
    let points: Vec<[f64; 3]> = (0..(side + 1) * (side + 1))
        .map(|i| [(i % (side + 1)) as f64, (i / (side + 1)) as f64, 0.3 * random.unit()])
        .collect();
    let mut triangles = PolygonList::new();
    for i in (0..side * side).map(|i| (i + i / side) as u32) {
        let [a, b, c, d] = [i, i + 1, i + side as u32 + 2, i + side as u32 + 1];
        triangles.push_face(&[a, b, c]);
        triangles.push_face(&[a, c, d]);
    }
    NavSurface::new(&points, &triangles, None).expect("a floor")
}

fn surfaces() {
    growth("NavSurface::new, hills, by triangles", &DOUBLED, |count| move || hills(count).triangle_count());
    let points = |surface: &NavSurface, spread: f64| {
        let mut random = Random::new(3);
        let width = (surface.triangle_count() as f64 / 2.0).sqrt();
        (0..1000).map(|_| [(); 2].map(|()| (random.unit() * spread - (spread - 1.0) / 2.0) * width)).collect::<Vec<_>>()
    };
    growth("1000 places on it", &DOUBLED, |count| {
        let surface = hills(count);
        let points = points(&surface, 1.0);
        move || points.iter().filter(|&&p| surface.place(p, Floor::Any).is_ok()).count()
    });
    growth("1000 nearest places, three of four points beside it", &DOUBLED, |count| {
        let surface = hills(count);
        let points = points(&surface, 2.0);
        move || points.iter().filter(|&&p| surface.nearest(p, Floor::Any).is_some()).count()
    });
    growth("1000 rays of 10 units", &DOUBLED, |count| {
        let surface = hills(count);
        let starts: Vec<_> = surface.random_places(4).take(1000).collect();
        move || {
            let cast = |place: &SurfacePoint| surface.raycast(place, [place.point[0] + 8.0, place.point[1] + 6.0]);
            starts.iter().filter_map(|place| cast(place).ok()).map(|cast| cast.faces.len()).sum::<usize>()
        }
    });
    for (name, algorithm) in [("closest", PathAlgorithm::Closest), ("exact", PathAlgorithm::Exact)] {
        growth(&format!("10 paths of 10 units, {name}"), &DOUBLED, |count| {
            let surface = hills(count);
            let ends: Vec<_> = surface
                .random_places(4)
                .filter_map(|from| {
                    let goal = [from.point[0] + 8.0, from.point[1] + 6.0];
                    Some((from, surface.place(goal, Floor::Any).ok()?))
                })
                .take(10)
                .collect();
            let planner = std::cell::RefCell::new(SurfacePlanner::new());
            move || {
                let mut planner = planner.borrow_mut();
                let routes = ends.iter().filter_map(|(from, to)| planner.route(&surface, algorithm, from, to).ok());
                routes.map(|route| route.points.len()).sum::<usize>()
            }
        });
    }
}

/// Maps that list blocked triangles as well, beside the same maps without them: location and memory.
fn blocked() {
    let mut random = Random::new(5);
    let maps = [
        ("caves", triangles(caves(400, false, &mut random).regions().expect("regions"))),
        ("rough caves", triangles(caves(180, true, &mut random).regions().expect("regions"))),
        ("blocks", blocks(75, &mut random)),
    ];
    for (name, whole) in maps {
        let mut cut = whole;
        cut.triangulate_all(TriangulationMethod::Monotone).expect("holes are simple");
        let listed = NavMesh::new(&cut).expect("triangles");
        // The same triangles alone: the holes are what is left.
        let corners = |f| <[u32; 3]>::try_from(listed.corners(f).map(|v| v.number()).collect::<Vec<_>>());
        let walkable: Vec<[u32; 3]> = listed.faces().map(|f| corners(f).expect("a triangle")).collect();
        let points = (0..listed.vertex_bound() as u32).map(|v| listed.point(VertexId::new(v))).collect();
        let map = Subdivision::from_triangles(points, &walkable).expect("they do not overlap");
        let alone = NavMesh::new(&map).expect("triangles");
        let peer = peer(&map, &alone);
        println!("{name}: {} triangles and {} blocked ones", alone.face_count(), cut.hole_faces().count());
        for (what, mesh) in [("without the blocked", &alone), ("with them", &listed)] {
            println!("  {:.1} bytes a walkable triangle {what}", mesh.memory() as f64 / mesh.face_count() as f64);
        }
        let anywhere = anywhere(&alone, &mut random);
        let inside: Vec<Point> =
            anywhere.iter().copied().filter(|&p| matches!(alone.locate(p), Location::Face(_))).collect();
        let beside: Vec<Point> =
            anywhere.iter().copied().filter(|&p| !matches!(alone.locate(p), Location::Face(_))).collect();
        for (what, points) in [("anywhere", &anywhere), ("inside", &inside), ("in no face", &beside)] {
            let count =
                |mesh: &NavMesh| points.iter().filter(|&&p| matches!(mesh.locate(p), Location::Face(_))).count();
            assert_eq!(count(&alone), count(&listed), "the same triangles");
            let mut least = [f64::INFINITY; 3];
            for _ in 0..4 * ROUNDS {
                spent(&mut least[0], || count(&alone));
                spent(&mut least[1], || count(&listed));
                spent(&mut least[2], || points.iter().filter(|p| peer.point_in_mesh(vec(**p))).count());
            }
            let [alone, listed, peer] = least.map(|time| time * 1e9 / points.len() as f64);
            println!(
                "  points {what}: {alone:.0} ns without, {listed:.0} ns with them, {:.2} times; peer (without) {peer:.0} ns, share {:.3}",
                listed / alone,
                listed / peer
            );
        }
    }
}

/// Obstacles into and out of a map of 33,000 triangles: what each costs, without and with merged faces and junctions
/// that are mended.
fn live() {
    let mut random = Random::new(5);
    for size in [53, 75, 106] {
        let map = blocks(size, &mut random);
        for prepared in [false, true] {
            obstacles(&map, 4.0 * size as f64, prepared);
        }
    }
}

fn obstacles(map: &Subdivision, width: f64, prepared: bool) {
    let mut live = LiveMesh::new(map.clone()).expect("triangles");
    let triangles = live.mesh().face_count();
    if prepared {
        live.merge_faces();
        live.link_junctions();
    }
    let (mut random, mut planner) = (Random::new(9), Planner::new());
    let mut inside: Vec<ObstacleId> = Vec::new();
    let (mut times, mut refused) = ([const { Vec::new() }; 4], 0);
    let mut measure = |what: usize, run: &mut dyn FnMut()| {
        let start = ProcessTime::now();
        run();
        times[what].push(start.elapsed().as_secs_f64() * 1e6);
    };
    for i in 0..1000 {
        let [x, y] = [(); 2].map(|()| random.unit() * (width - 3.0) + 1.5);
        let (corners, radius, turn) = (2 + i % 4, 0.3 + random.unit(), random.unit());
        let corner = |k: usize| (turn + std::f64::consts::TAU * k as f64 / corners as f64).sin_cos();
        let corners: Vec<Point> =
            (0..corners).map(corner).map(|(sin, cos)| Point::new(x + radius * cos, y + radius * sin)).collect();
        measure(0, &mut || {
            let put = if let [p, q] = corners[..] { live.insert_wall(p, q) } else { live.insert_obstacle(&corners) };
            match put {
                Ok(id) => inside.push(id),
                Err(_) => refused += 1,
            }
        });
    }
    for &id in &inside {
        let by = [(); 2].map(|()| random.unit() - 0.5);
        measure(1, &mut || refused += usize::from(live.move_obstacle(id, by).is_err()));
    }
    random.shuffle(&mut inside);
    for &id in &inside {
        let near = live.corners(id).map_or(Point::default(), |corners| corners[0]);
        measure(2, &mut || live.remove(id).expect("in the map"));
        // A short way nearby: what was not mended has to be made anew for it.
        let goal = Point::new(near.x + 0.5, near.y + 0.5);
        if prepared {
            measure(3, &mut || {
                for algorithm in [PathAlgorithm::Exact, PathAlgorithm::Breadth] {
                    let _ = black_box(planner.route_between(live.mesh(), algorithm, near, goal));
                }
            });
        }
    }
    let counts = |map: &Subdivision| [map.vertex_count(), map.edge_count(), map.face_count()];
    assert_eq!(counts(live.map()), counts(map), "the map is what it was");
    println!(
        "{triangles} triangles, 1000 obstacles of 2 to 5 corners{}; {refused} refused",
        if prepared { ", merged faces and junctions mended" } else { "" }
    );
    for (what, mut times) in ["in", "moved", "out", "way"].into_iter().zip(times).filter(|(_, times)| !times.is_empty())
    {
        times.sort_by(f64::total_cmp);
        let at = |share: f64| times[((times.len() - 1) as f64 * share) as usize];
        let mean = times.iter().sum::<f64>() / times.len() as f64;
        println!(
            "  {what:5}  mean {mean:7.1} us, median {:7.1}, 9 of 10 below {:7.1}, 99 of 100 {:7.1}, all {:7.1}",
            at(0.5),
            at(0.9),
            at(0.99),
            at(1.0)
        );
    }
}

/// The seconds a call takes, if they are less than `least`.
fn timed<T>(least: &mut f64, run: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let answer = black_box(run());
    *least = least.min(start.elapsed().as_secs_f64());
    answer
}

/// The seconds of processor time a call takes, if they are less than `least`.
fn spent<T>(least: &mut f64, run: impl FnOnce() -> T) {
    let start = ProcessTime::now();
    black_box(run());
    *least = least.min(start.elapsed().as_secs_f64());
}

fn measure(name: &str, map: Subdivision, queries: Option<Vec<Ends>>, random: &mut Random) {
    let mesh = NavMesh::new(&map).expect("triangles");
    let whole = peer(&map, &mesh);
    let merged = merged_peer(&map, &mesh);
    let dead_ends = mesh.faces().filter(|&f| mesh.is_dead_end(f)).count();
    println!(
        "{name}: {} vertices, {} triangles, {:.0} % dead ends, {:.1} bytes a triangle; merged by the peer: {} polygons",
        map.vertex_count(),
        mesh.face_count(),
        dead_ends as f64 * 100.0 / mesh.face_count() as f64,
        mesh.memory() as f64 / mesh.face_count() as f64,
        merged.layers[0].polygons.len()
    );
    let inside = locate(&mesh, &whole, random);
    let queries = queries.unwrap_or_else(|| pairs(&mesh, &inside));
    routes(&mesh, &[whole, merged], &queries);
}

/// Locates random points; returns those inside.
fn locate(mesh: &NavMesh, peer: &polyanya::Mesh, random: &mut Random) -> Vec<Point> {
    let points = anywhere(mesh, random);
    let is_inside = |p: &Point| matches!(mesh.locate(*p), Location::Face(_));
    let inside: Vec<Point> = points.iter().copied().filter(is_inside).collect();
    for (what, points) in [("anywhere", &points), ("inside", &inside)] {
        let mut least = [f64::INFINITY; 2];
        for _ in 0..ROUNDS {
            timed(&mut least[0], || points.iter().filter(|p| is_inside(p)).count());
            timed(&mut least[1], || points.iter().filter(|p| peer.point_in_mesh(vec(**p))).count());
        }
        let [ours, theirs] = least.map(|time| time * 1e9 / points.len() as f64);
        println!("  points {what}: {ours:.0} ns, peer {theirs:.0} ns, share {:.3}", ours / theirs);
    }
    inside
}

/// What is measured: an algorithm on the mesh as it is, or on the one that was prepared, or a peer.
#[derive(Clone, Copy)]
enum Program {
    Plain(PathAlgorithm),
    Prepared(PathAlgorithm),
    Peer(usize),
}

fn routes(mesh: &NavMesh, peers: &[polyanya::Mesh; 2], queries: &[Ends]) {
    let prepared = mesh.clone();
    let per_triangle = |bytes: usize| bytes as f64 / mesh.face_count() as f64;
    let count = prepared.merge_faces();
    let bytes = prepared.memory();
    println!("  merged by the kit: {count} faces, {:.1} bytes a triangle more", per_triangle(bytes - mesh.memory()));
    let count = prepared.link_junctions();
    println!("  crossings: {count}, {:.1} bytes a triangle more", per_triangle(prepared.memory() - bytes));

    let prepared_rungs = [
        PathAlgorithm::Breadth,
        PathAlgorithm::Midpoint,
        PathAlgorithm::Closest,
        PathAlgorithm::Aimed,
        PathAlgorithm::Exact,
    ]
    .map(Program::Prepared);
    let programs: Vec<Program> = PathAlgorithm::ALL
        .map(Program::Plain)
        .into_iter()
        .chain(prepared_rungs)
        .chain([0, 1].map(Program::Peer))
        .collect();
    let (mut planner, mut plain) = (Planner::new(), Planner::face_by_face());
    let mut least = vec![vec![f64::INFINITY; queries.len()]; programs.len()];
    let mut lengths = vec![vec![0.0; queries.len()]; programs.len()];
    for (i, &(start, goal)) in queries.iter().enumerate() {
        for (k, &program) in (0..ROUNDS).flat_map(|_| programs.iter().enumerate()) {
            let least = &mut least[k][i];
            let mut find = |planner: &mut Planner, algorithm| {
                timed(least, || planner.route_between(&prepared, algorithm, start, goal))
            };
            lengths[k][i] = match program {
                Program::Plain(algorithm) => find(&mut plain, algorithm).expect("one component").length,
                Program::Prepared(algorithm) => find(&mut planner, algorithm).expect("one component").length,
                Program::Peer(p) => {
                    timed(least, || peers[p].path(vec(start), vec(goal))).map_or(0.0, |path| path.length.into())
                }
            };
        }
    }
    let mean = |k: usize| least[k].iter().sum::<f64>() * 1e6 / queries.len() as f64;
    let [peer, merged] = [2, 1].map(|back| mean(programs.len() - back));
    println!("  {} routes; peer {peer:.0} us, merged {merged:.0} us", queries.len());
    let exact = &lengths[PathAlgorithm::ALL.len() - 1];
    for (k, program) in programs.iter().enumerate() {
        let (algorithm, how) = match program {
            Program::Plain(algorithm) => (algorithm, ""),
            Program::Prepared(PathAlgorithm::Exact) => (&PathAlgorithm::Exact, ", merged"),
            Program::Prepared(algorithm) => (algorithm, ", crossings"),
            Program::Peer(_) => continue,
        };
        let ratio = lengths[k].iter().zip(exact).map(|(a, b)| a / b).sum::<f64>() / queries.len() as f64;
        assert!(*algorithm != PathAlgorithm::Exact || (ratio - 1.0).abs() < 1e-9, "two exact lengths");
        println!(
            "  {:20} {:8.1} us, share {:.3}, of merged {:.3}, mean length ratio {ratio:.4}",
            format!("{algorithm}{how}"),
            mean(k),
            mean(k) / peer,
            mean(k) / merged
        );
    }
}
