//! Maps to walk on, and the same maps for the peer.

use crate::Random;
use dcel_kit::io::Grid;
use dcel_kit::navmesh::NavMesh;
use dcel_kit::plane::{Point, Subdivision, TriangulationMethod};
use dcel_kit::{HalfEdgeId, VertexId};
use glam::Vec2;

const POINTS: usize = 50_000;
const QUERIES: usize = 150;

/// The start and the goal of a way.
pub type Ends = (Point, Point);

/// The constrained Delaunay triangles of a map.
pub fn triangles(mut map: Subdivision) -> Subdivision {
    let borders = map.edge_bound();
    map.triangulate(TriangulationMethod::Monotone).expect("regions are simple");
    map.make_delaunay(|edge| edge.index() < borders);
    map
}

/// A grid of random cells, smoothed twice: a cell is open if five of its neighbourhood are. For rough walls each cell
/// becomes three by three, and of those at a wall every third is closed.
pub fn caves(size: usize, rough: bool, random: &mut Random) -> Grid {
    let mut open: Vec<bool> = (0..size * size).map(|_| random.unit() < 0.55).collect();
    for _ in 0..2 {
        let before = open.clone();
        let at = |x: usize, y: usize| x > 0 && y > 0 && x <= size && y <= size && before[(y - 1) * size + x - 1];
        for y in 0..size {
            for x in 0..size {
                let around = (0..9).filter(|i| at(x + i % 3, y + i / 3)).count();
                open[y * size + x] = around >= 5;
            }
        }
    }
    let (mut open, mut size) = (open, size);
    if rough {
        let fine: Vec<bool> =
            (0..9 * size * size).map(|i| open[i / (3 * size) / 3 * size + i % (3 * size) / 3]).collect();
        size *= 3;
        let is_open = |x: usize, y: usize| x < size && y < size && fine[y * size + x];
        let inner =
            |x: usize, y: usize| (0..9).all(|i| is_open((x + i % 3).wrapping_sub(1), (y + i / 3).wrapping_sub(1)));
        open = (0..size * size)
            .map(|i| is_open(i % size, i / size) && (inner(i % size, i / size) || random.unit() < 2.0 / 3.0))
            .collect();
    }
    let mut text = format!("type octile\nheight {size}\nwidth {size}\nmap\n");
    for row in open.chunks(size) {
        text.extend(row.iter().map(|&open| if open { '.' } else { '@' }));
        text.push('\n');
    }
    Grid::parse(text.as_bytes(), "caves").expect("a map")
}

/// A square with convex blocks in three of four cells; coordinates fit into single precision.
pub fn blocks(size: usize, random: &mut Random) -> Subdivision {
    let width = 4.0 * size as f64;
    let mut points: Vec<Point> = [(0., 0.), (width, 0.), (width, width), (0., width)].map(Point::from).to_vec();
    let mut edges = vec![[0, 1], [1, 2], [2, 3], [3, 0]];
    for cell in 0..size * size {
        if random.unit() > 0.75 {
            continue;
        }
        let [x, y] = [cell % size, cell / size].map(|i| 4.0 * i as f64 + 2.0);
        let (corners, turn, radius) = (4 + random.below(5), random.unit(), 0.8 + random.unit());
        let first = points.len() as u32;
        for i in 0..corners {
            let (sin, cos) = (turn + std::f64::consts::TAU * i as f64 / corners as f64).sin_cos();
            points.push(Point::new(f64::from((x + radius * cos) as f32), f64::from((y + radius * sin) as f32)));
        }
        let corners = corners as u32;
        edges.extend((0..corners).map(|i| [first + i, first + (i + 1) % corners]));
    }
    let mut map = Subdivision::from_graph(&points, &edges).expect("blocks do not touch");
    for i in 4..edges.len() as u32 {
        let inside = map.face(HalfEdgeId::new(2 * i));
        map.set_hole(inside, true);
    }
    triangles(map)
}

/// The same triangles for the peer.
pub fn peer(map: &Subdivision, mesh: &NavMesh) -> polyanya::Mesh {
    let mut numbers = vec![u32::MAX; mesh.face_bound()];
    mesh.faces().enumerate().for_each(|(i, f)| numbers[f.index()] = i as u32);
    let vertices = (0..mesh.vertex_bound() as u32).map(VertexId::new).map(|v| {
        let p = mesh.point(v);
        let mut around: Vec<u32> = map.incident_faces(v).map(|f| numbers[f.index()]).collect();
        around.dedup();
        if around.len() > 1 && around.first() == around.last() {
            around.pop();
        }
        polyanya::Vertex::new(Vec2::new(p.x as f32, p.y as f32), around)
    });
    let polygons = mesh.faces().map(|f| {
        let one_way = mesh.neighbours(f).count() <= 1;
        polyanya::Polygon::new(mesh.corners(f).map(|v| v.number()).collect(), one_way)
    });
    let mut peer = polyanya::Mesh::new(vertices.collect(), polygons.collect()).expect("a mesh");
    peer.bake();
    peer
}

/// The same map with the polygons that the peer merges.
pub fn merged_peer(map: &Subdivision, mesh: &NavMesh) -> polyanya::Mesh {
    let mut merged = peer(map, mesh);
    for layer in &mut merged.layers {
        while layer.merge_polygons() {}
    }
    merged.bake();
    merged
}

/// A point for the peer.
pub fn vec(p: Point) -> Vec2 {
    Vec2::new(p.x as f32, p.y as f32)
}

/// Points of one component, two by two.
pub fn pairs(mesh: &NavMesh, inside: &[Point]) -> Vec<Ends> {
    let component = |p| mesh.place(p).ok().and_then(|place| mesh.component(place.face));
    let joined = inside.chunks_exact(2).filter(|pair| component(pair[0]) == component(pair[1]));
    joined.map(|pair| (pair[0], pair[1])).take(QUERIES).collect()
}

/// Random points in the box round the mesh.
pub fn anywhere(mesh: &NavMesh, random: &mut Random) -> Vec<Point> {
    let corners = || mesh.faces().flat_map(|f| mesh.corners(f)).map(|v| mesh.point(v));
    let least = |of: fn(Point) -> f64| corners().map(of).fold(f64::INFINITY, f64::min);
    let ([left, right], [low, high]) = ([least(|p| p.x), -least(|p| -p.x)], [least(|p| p.y), -least(|p| -p.y)]);
    let mut point = || Point::new(left + (right - left) * random.unit(), low + (high - low) * random.unit());
    (0..POINTS).map(|_| point()).collect()
}
