//! What is done, by whom. The first program of a row is ours.

use crate::Random;
use crate::inputs::{Triangles, delaunay, ordered, shuffled};
use crate::shapes::{Ring, coast, ragged, round, spiral, squares};
use crate::{segments, surfaces};
use dcel_kit::plane::{Operation, Parts, Point, PointIndex, Subdivision, TriangulationMethod};
use dcel_kit::topology::Dcel;
use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::float::single::SingleFloatOverlay;
use i_triangle::float::unchecked::UncheckedTriangulatable;
use lox::core::{DirectedEdgeMesh, HalfEdgeMesh, half_edge::TriConfig};
use lox::prelude::*;
use spade::{DelaunayTriangulation, HierarchyHintGenerator, Point2, Triangulation as _};
use std::any::Any;

/// Something that is done.
pub struct Row {
    pub name: &'static str,
    pub programs: &'static [Program],
}

/// The number of elements, and what is measured; it hands back what it made, so that dropping it is not measured.
pub type Prepared = (usize, Box<dyn FnMut() -> Box<dyn Any>>);

/// One who does it.
pub struct Program {
    pub name: &'static str,
    pub package: &'static str,
    pub prepare: fn() -> Prepared,
}

/// Shorter to read: `program!("name" of "package", elements and work)`.
macro_rules! program {
    ($name:literal of $package:literal, $prepare:expr) => {
        Program { name: $name, package: $package, prepare: || $prepare }
    };
}

macro_rules! rows {
    ($($row:literal: $($name:literal of $package:literal => $prepare:expr),*;)+) => {
        /// All rows.
        pub static ROWS: &[Row] = &[$(Row { name: $row, programs: &[$(program!($name of $package, $prepare)),*] }),+];
    };
}

rows! {
    "triangle list, ordered":
        "dcel-kit" of "dcel-kit" => ours_of(ordered(1_000_000)),
        "lox half-edge" of "lox" => lox_of::<HalfEdgeMesh<TriConfig>>(ordered(1_000_000)),
        "lox directed edge" of "lox" => lox_of::<DirectedEdgeMesh>(ordered(1_000_000));
    "triangle list, Delaunay order":
        "dcel-kit" of "dcel-kit" => ours_of(delaunay(1_000_000)),
        "lox half-edge" of "lox" => lox_of::<HalfEdgeMesh<TriConfig>>(delaunay(1_000_000));
    "triangle list, shuffled":
        "dcel-kit" of "dcel-kit" => ours_of(shuffled(1_000_000)),
        "lox half-edge" of "lox" => lox_of::<HalfEdgeMesh<TriConfig>>(shuffled(1_000_000));
    "intersection of coasts":
        "dcel-kit" of "dcel-kit" => our_intersection(&coasts()),
        "dcel-kit from rings" of "dcel-kit" => our_intersection_of_rings(coasts()),
        "i_overlay" of "i_overlay" => their_intersection(coasts());
    "intersection of squares":
        "dcel-kit" of "dcel-kit" => our_intersection(&two_rows()),
        "dcel-kit from rings" of "dcel-kit" => our_intersection_of_rings(two_rows()),
        "i_overlay" of "i_overlay" => their_intersection(two_rows());
    "overlay of coasts":
        "dcel-kit" of "dcel-kit" => segments::our_overlay();
    "segments that meet at ends":
        "dcel-kit" of "dcel-kit" => segments::our_segments();
    "crossing segments":
        "dcel-kit" of "dcel-kit" => segments::our_crossings(),
        "geo" of "geo" => segments::geo_crossings();
    "splits":
        "dcel-kit" of "dcel-kit" => surfaces::our_splits(),
        "alum" of "alum" => surfaces::alum_splits();
    "Catmull-Clark":
        "dcel-kit" of "dcel-kit" => surfaces::our_subdivision(false),
        "alum" of "alum" => surfaces::alum_subdivision(false);
    "Loop":
        "dcel-kit" of "dcel-kit" => surfaces::our_subdivision(true),
        "alum" of "alum" => surfaces::alum_subdivision(true);
    "Delaunay, random":
        "dcel-kit" of "dcel-kit" => our_delaunay(&random(500_000)),
        "delaunator" of "delaunator" => delaunator_of(&random(500_000)),
        "spade" of "spade" => spade_of(&random(500_000));
    "Delaunay, lattice":
        "dcel-kit" of "dcel-kit" => our_delaunay(&lattice(500_000)),
        "delaunator" of "delaunator" => delaunator_of(&lattice(500_000)),
        "spade" of "spade" => spade_of(&lattice(500_000));
    "Delaunay, clusters":
        "dcel-kit" of "dcel-kit" => our_delaunay(&clusters(500_000)),
        "delaunator" of "delaunator" => delaunator_of(&clusters(500_000)),
        "spade" of "spade" => spade_of(&clusters(500_000));
    "constrained Delaunay":
        "dcel-kit" of "dcel-kit" => our_constrained(street_map(100_000)),
        "dcel-kit from points" of "dcel-kit" => our_constrained_of_points(street_map(100_000)),
        "spade" of "spade" => spade_constrained(street_map(100_000));
    // All who take part are in a program of another package: see native.rs.
    "ways, caves":;
    "ways, blocks":;
    "places, caves":;
    "places, blocks":;
    "hull, random":
        "dcel-kit" of "dcel-kit" => our_hull(&random(1_000_000)),
        "geo" of "geo" => geo_hull(&random(1_000_000));
    "hull, circle":
        "dcel-kit" of "dcel-kit" => our_hull(&on_a_circle(1_000_000)),
        "geo" of "geo" => geo_hull(&on_a_circle(1_000_000));
    "hull, clusters":
        "dcel-kit" of "dcel-kit" => our_hull(&clusters(1_000_000)),
        "geo" of "geo" => geo_hull(&clusters(1_000_000));
    "hull in space, ball":
        "dcel-kit" of "dcel-kit" => our_hull_in_space(ball(1_000_000));
    "hull in space, sphere":
        "dcel-kit" of "dcel-kit" => our_hull_in_space(sphere(100_000));
    "Voronoi cells in a square":
        "dcel-kit" of "dcel-kit" => our_cells(&random(200_000)),
        "voronoice" of "voronoice" => voronoice_cells(&random(200_000));
    "polygon, circle":
        "dcel-kit" of "dcel-kit" => our_triangles(&circle(100_000)),
        "dcel-kit from points" of "dcel-kit" => our_triangles_of_points(circle(100_000)),
        "earcut" of "earcut" => earcut_of(circle(100_000)),
        "i_triangle" of "i_triangle" => i_triangle_of(circle(100_000));
    "polygon, ragged star":
        "dcel-kit" of "dcel-kit" => our_triangles(&ragged(100_000)),
        "dcel-kit from points" of "dcel-kit" => our_triangles_of_points(ragged(100_000)),
        "earcut" of "earcut" => earcut_of(ragged(100_000)),
        "i_triangle" of "i_triangle" => i_triangle_of(ragged(100_000));
    "polygon, spiral":
        "dcel-kit" of "dcel-kit" => our_triangles(&spiral(30_000)),
        "dcel-kit from points" of "dcel-kit" => our_triangles_of_points(spiral(30_000)),
        "i_triangle" of "i_triangle" => i_triangle_of(spiral(30_000));
    "location, one by one":
        "dcel-kit" of "dcel-kit" => our_location(500_000),
        "spade" of "spade" => spade_location(500_000);
    "round vertices, ordered":
        "dcel-kit" of "dcel-kit" => our_walk(&ordered(1_000_000)),
        "dcel-kit, neighbours" of "dcel-kit" => our_neighbours(&ordered(1_000_000)),
        "lox half-edge" of "lox" => lox_walk(&ordered(1_000_000));
    "round vertices, shuffled":
        "dcel-kit" of "dcel-kit" => our_walk(&shuffled(1_000_000)),
        "dcel-kit, neighbours" of "dcel-kit" => our_neighbours(&shuffled(1_000_000)),
        "lox half-edge" of "lox" => lox_walk(&shuffled(1_000_000));
}

pub fn work<T: 'static>(elements: usize, mut work: impl FnMut() -> T + 'static) -> Prepared {
    (elements, Box::new(move || Box::new(work())))
}

fn ours_of(input: Triangles) -> Prepared {
    let build = move || Dcel::from_triangles(input.vertices, &input.triangles).expect("a surface").dcel;
    work(1_000_000, build)
}

fn lox_of<M: MeshMut + 'static>(input: Triangles) -> Prepared {
    work(1_000_000, move || {
        let mut mesh = M::empty();
        mesh.reserve_for_vertices(input.vertices as u32);
        mesh.reserve_for_faces(input.triangles.len() as u32);
        (0..input.vertices).for_each(|_| {
            mesh.add_vertex();
        });
        for t in &input.triangles {
            mesh.add_triangle(t.map(lox::VertexHandle::new));
        }
        mesh
    })
}

fn surface(input: &Triangles) -> Dcel {
    Dcel::from_triangles(input.vertices, &input.triangles).expect("a surface").dcel
}

/// The half-edges round all vertices.
fn our_walk(input: &Triangles) -> Prepared {
    let d = surface(input);
    work(d.half_edge_count(), move || {
        d.vertices().flat_map(|v| d.outgoing_half_edges(v)).fold(0_u32, |sum, h| sum ^ h.number())
    })
}

fn our_neighbours(input: &Triangles) -> Prepared {
    let d = surface(input);
    work(d.half_edge_count(), move || {
        d.vertices().flat_map(|v| d.adjacent_vertices(v)).fold(0_u32, |sum, v| sum ^ v.number())
    })
}

/// The peer reads the vertex at the other end always.
fn lox_walk(input: &Triangles) -> Prepared {
    let mut mesh = HalfEdgeMesh::<TriConfig>::empty();
    (0..input.vertices).for_each(|_| {
        mesh.add_vertex();
    });
    for t in &input.triangles {
        mesh.add_triangle(t.map(lox::VertexHandle::new));
    }
    work(2 * mesh.num_edges() as usize, move || {
        let around = mesh.vertex_handles().flat_map(|v| mesh.vertices_around_vertex(v));
        around.fold(0_u32, |sum, v| sum ^ v.idx())
    })
}

pub fn coasts() -> [Vec<Ring>; 2] {
    [vec![coast(1 << 18, [0.0, 0.0], 3)], vec![coast(1 << 17, [0.9, 0.3], 4)]]
}

pub fn two_rows() -> [Vec<Ring>; 2] {
    [squares(204, 0.0), squares(204, 0.35)]
}

pub fn rings(shape: &[Ring]) -> Subdivision {
    let mut points = Vec::new();
    let mut edges = Vec::new();
    for ring in shape {
        let (first, n) = (points.len() as u32, ring.len() as u32);
        points.extend(ring.iter().map(|&p| Point::from(p)));
        edges.extend((0..n).map(|i| [first + i, first + (i + 1) % n]));
    }
    Subdivision::from_graph(&points, &edges).expect("simple polygons")
}

fn common(a: &Subdivision, b: &Subdivision) -> Subdivision {
    let both = a.overlay(b).expect("not too many");
    both.region(Operation::Intersection, Parts::Joined).expect("not too many")
}

pub fn edges(of: &[Vec<Ring>; 2]) -> usize {
    of.iter().flatten().map(Vec::len).sum()
}

fn our_intersection(of: &[Vec<Ring>; 2]) -> Prepared {
    let [a, b] = [rings(&of[0]), rings(&of[1])];
    work(edges(of), move || common(&a, &b))
}

fn our_intersection_of_rings(of: [Vec<Ring>; 2]) -> Prepared {
    work(edges(&of), move || common(&rings(&of[0]), &rings(&of[1])))
}

fn their_intersection(of: [Vec<Ring>; 2]) -> Prepared {
    work(edges(&of), move || of[0].overlay(&of[1], OverlayRule::Intersect, FillRule::EvenOdd))
}

pub fn random(count: usize) -> Vec<[f64; 2]> {
    let mut random = Random::new(5);
    (0..count).map(|_| [random.unit(), random.unit()]).collect()
}

pub fn lattice(count: usize) -> Vec<[f64; 2]> {
    let side = (count as f64).sqrt() as usize;
    (0..count).map(|i| [(i % side) as f64, (i / side) as f64]).collect()
}

pub fn clusters(count: usize) -> Vec<[f64; 2]> {
    let mut random = Random::new(5);
    let centres: Vec<[f64; 2]> = (0..30).map(|_| [random.unit(), random.unit()]).collect();
    let mut one = || {
        let [x, y] = centres[random.below(centres.len())];
        let (radius, angle) = (1e-3 * random.unit() * random.unit(), std::f64::consts::TAU * random.unit());
        [x + radius * angle.cos(), y + radius * angle.sin()]
    };
    (0..count).map(|_| one()).collect()
}

fn our_delaunay(points: &[[f64; 2]]) -> Prepared {
    let points: Vec<Point> = points.iter().map(|&p| Point::from(p)).collect();
    work(points.len(), move || Subdivision::delaunay(&points).expect("good points").subdivision)
}

fn delaunator_of(points: &[[f64; 2]]) -> Prepared {
    let points: Vec<_> = points.iter().map(|&[x, y]| delaunator::Point { x, y }).collect();
    work(points.len(), move || delaunator::triangulate(&points))
}

fn spade_of(points: &[[f64; 2]]) -> Prepared {
    let points: Vec<_> = points.iter().map(|&[x, y]| Point2::new(x, y)).collect();
    work(points.len(), move || DelaunayTriangulation::<Point2<f64>>::bulk_load(points.clone()).expect("finite points"))
}

fn circle(corners: usize) -> Ring {
    round(corners, [0.0; 2], |_, _| 1.0)
}

fn our_triangles(ring: &Ring) -> Prepared {
    // What is triangulated is a copy, and copying is measured with it.
    let s = rings(std::slice::from_ref(ring));
    work(ring.len(), move || {
        let mut copy = s.clone();
        copy.triangulate(TriangulationMethod::Monotone).expect("a simple polygon");
        copy
    })
}

fn our_triangles_of_points(ring: Ring) -> Prepared {
    work(ring.len(), move || {
        let mut s = rings(std::slice::from_ref(&ring));
        s.triangulate(TriangulationMethod::Monotone).expect("a simple polygon");
        s
    })
}

fn earcut_of(ring: Ring) -> Prepared {
    work(ring.len(), move || {
        let mut triangles: Vec<u32> = Vec::new();
        earcut::Earcut::new().earcut(ring.iter().copied(), &[], &mut triangles);
        triangles
    })
}

fn i_triangle_of(ring: Ring) -> Prepared {
    let rings = [ring];
    work(rings[0].len(), move || rings.unchecked_triangulate().to_triangulation::<u32>().indices)
}

fn asked() -> Vec<[f64; 2]> {
    let mut random = Random::new(7);
    (0..1_000_000).map(|_| [random.unit(), random.unit()]).collect()
}

fn our_location(sites: usize) -> Prepared {
    let points: Vec<Point> = random(sites).into_iter().map(Point::from).collect();
    let s: &'static Subdivision = Box::leak(Box::new(Subdivision::delaunay(&points).expect("good points").subdivision));
    let index = PointIndex::new(s);
    let asked: Vec<Point> = asked().into_iter().map(Point::from).collect();
    work(asked.len(), move || asked.iter().map(|&p| index.locate(p)).collect::<Vec<_>>())
}

fn spade_location(sites: usize) -> Prepared {
    type Hierarchy = DelaunayTriangulation<Point2<f64>, (), (), (), HierarchyHintGenerator<f64>>;
    let points = random(sites).into_iter().map(|[x, y]| Point2::new(x, y)).collect();
    let made = Hierarchy::bulk_load(points).expect("finite points");
    let asked: Vec<Point2<f64>> = asked().into_iter().map(|[x, y]| Point2::new(x, y)).collect();
    work(asked.len(), move || asked.iter().map(|&p| made.locate(p)).collect::<Vec<_>>())
}

/// Points in the unit square, and the sides of small triangles between some of them: none crosses another.
pub fn street_map(count: usize) -> (Vec<[f64; 2]>, Vec<[u32; 2]>) {
    let mut random = Random::new(11);
    let side = ((count / 4) as f64).sqrt() as usize;
    let (mut points, mut edges) = (Vec::new(), Vec::new());
    for cell in 0..side * side {
        let (x, y) = ((cell % side) as f64, (cell / side) as f64);
        let first = points.len() as u32;
        let mut at = |fx: f64, fy: f64| [x + fx + 0.3 * random.unit(), y + fy + 0.3 * random.unit()];
        points.extend([at(0.05, 0.05), at(0.6, 0.05), at(0.05, 0.6), at(0.6, 0.6)]);
        edges.extend([[first, first + 1], [first + 1, first + 3], [first + 3, first + 2], [first + 2, first]]);
    }
    (points, edges)
}

fn our_constrained((points, edges): (Vec<[f64; 2]>, Vec<[u32; 2]>)) -> Prepared {
    let points: Vec<Point> = points.into_iter().map(Point::from).collect();
    let s = Subdivision::from_graph(&points, &edges).expect("no two sides cross");
    work(points.len(), move || s.constrained_delaunay().expect("not too many").subdivision)
}

fn our_constrained_of_points((points, edges): (Vec<[f64; 2]>, Vec<[u32; 2]>)) -> Prepared {
    let points: Vec<Point> = points.into_iter().map(Point::from).collect();
    work(points.len(), move || {
        let s = Subdivision::from_graph(&points, &edges).expect("no two sides cross");
        s.constrained_delaunay().expect("not too many").subdivision
    })
}

fn spade_constrained((points, edges): (Vec<[f64; 2]>, Vec<[u32; 2]>)) -> Prepared {
    let points: Vec<_> = points.into_iter().map(|[x, y]| Point2::new(x, y)).collect();
    let edges: Vec<[usize; 2]> = edges.into_iter().map(|e| e.map(|i| i as usize)).collect();
    work(points.len(), move || {
        spade::ConstrainedDelaunayTriangulation::<Point2<f64>>::bulk_load_cdt(points.clone(), edges.clone())
            .expect("no two sides cross")
    })
}

pub fn on_a_circle(count: usize) -> Vec<[f64; 2]> {
    let mut random = Random::new(13);
    let angle = |random: &mut Random| std::f64::consts::TAU * random.unit();
    (0..count).map(|_| angle(&mut random)).map(|a| [a.cos(), a.sin()]).collect()
}

fn our_hull(points: &[[f64; 2]]) -> Prepared {
    let points: Vec<Point> = points.iter().map(|&p| Point::from(p)).collect();
    work(points.len(), move || dcel_kit::plane::convex_hull(&points).expect("good points"))
}

fn geo_hull(points: &[[f64; 2]]) -> Prepared {
    use geo::ConvexHull as _;
    let points: geo::MultiPoint<f64> = points.iter().map(|&[x, y]| geo::Point::new(x, y)).collect();
    work(points.0.len(), move || points.convex_hull())
}

pub fn sphere(count: usize) -> Vec<[f64; 3]> {
    let mut random = Random::new(17);
    let mut one = || loop {
        let p = [(); 3].map(|()| 2.0 * random.unit() - 1.0);
        let square: f64 = p.iter().map(|x| x * x).sum();
        if (1e-4..=1.0).contains(&square) {
            return p.map(|x| x / square.sqrt());
        }
    };
    (0..count).map(|_| one()).collect()
}

pub fn ball(count: usize) -> Vec<[f64; 3]> {
    let mut random = Random::new(19);
    let mut one = || loop {
        let p = [(); 3].map(|()| 2.0 * random.unit() - 1.0);
        if p.iter().map(|x| x * x).sum::<f64>() <= 1.0 {
            return p;
        }
    };
    (0..count).map(|_| one()).collect()
}

fn our_hull_in_space(points: Vec<[f64; 3]>) -> Prepared {
    use dcel_kit::solid::{HullFaces, Polyhedron};
    work(points.len(), move || Polyhedron::convex_hull(&points, HullFaces::Triangles).expect("a solid"))
}

fn our_cells(points: &[[f64; 2]]) -> Prepared {
    use dcel_kit::plane::Window;
    let points: Vec<Point> = points.iter().map(|&p| Point::from(p)).collect();
    let window = Window { low: Point::new(0.0, 0.0), high: Point::new(1.0, 1.0) };
    work(points.len(), move || {
        let delaunay = Subdivision::delaunay(&points).expect("good points").subdivision;
        delaunay.voronoi().expect("Delaunay").cells(window).expect("no two sites too close").subdivision
    })
}

fn voronoice_cells(points: &[[f64; 2]]) -> Prepared {
    let points: Vec<_> = points.iter().map(|&[x, y]| voronoice::Point { x, y }).collect();
    let window = voronoice::BoundingBox::new(voronoice::Point { x: 0.5, y: 0.5 }, 1.0, 1.0);
    work(points.len(), move || {
        let builder = voronoice::VoronoiBuilder::default().set_sites(points.clone()).set_bounding_box(window.clone());
        builder.build().expect("a diagram")
    })
}
