//! A Voronoi diagram from the Delaunay triangulation of its sites, cell by cell.

use super::{named, numbered, opened};
use crate::figure::SketchFilm;
use crate::figure::sketch::{Backdrop, Role, Sketch};
use crate::ids::VertexId;
use crate::plane::{Point, Subdivision, Voronoi, VoronoiEdge, VoronoiError, Window};

/// The film of a Voronoi diagram: a frame for each site, with the edges of its cell and the triangles round it, at most
/// `most` of them.
///
/// # Errors
/// [`VoronoiError`]: `delaunay` is no Delaunay triangulation of its convex hull, or has no vertex.
///
/// ```
/// use dcel_kit::figure::algorithms;
/// use dcel_kit::plane::{Point, Subdivision};
/// let sites = [(0., 0.), (3., 1.), (1., 4.)].map(Point::from);
/// let film = algorithms::voronoi(&Subdivision::delaunay(&sites)?.subdivision, 40)?;
/// assert_eq!(film.len(), 3 + 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn voronoi(delaunay: &Subdivision, most: usize) -> Result<SketchFilm, VoronoiError> {
    let diagram = delaunay.voronoi()?;
    let sites: Vec<VertexId> = delaunay.vertices().collect();
    let places: Vec<Point> = sites.iter().map(|&v| delaunay.point(v)).collect();
    let window = Window::around(&places);
    // The edges round each site.
    let mut round = vec![Vec::new(); delaunay.vertex_bound()];
    for edge in diagram.edges() {
        edge.sites.iter().for_each(|v| round[v.index()].push(edge));
    }
    let mut start = sites_of(delaunay, None);
    named(&mut start, delaunay, &[]);
    let text = "the Voronoi diagram is its dual: a vertex for each triangle, an edge across each edge";
    let mut film = opened("A Delaunay triangulation", text, delaunay, Backdrop::Dimmed, start);

    let mut drawn = vec![false; delaunay.edge_bound()];
    let mut next = 0;
    for (i, number) in numbered(sites.len(), most) {
        for v in &sites[next..i] {
            round[v.index()].iter().for_each(|edge| drawn[edge.dual.index()] = true);
        }
        next = i;
        let v = sites[i];
        let mut sketch = sites_of(delaunay, Some(v));
        for edge in diagram.edges().iter().filter(|edge| drawn[edge.dual.index()] && !edge.sites.contains(&v)) {
            add(&mut sketch, &diagram, edge, &window, (Role::Main, "edge of a cell that is done"));
        }
        let triangles = delaunay.outgoing_half_edges(v).map(|h| delaunay.face(h));
        let triangles: Vec<_> = triangles.filter(|&f| f != delaunay.outer_face()).collect();
        for &f in &triangles {
            let corners: Vec<Point> = delaunay.incident_vertices(f).map(|v| delaunay.point(v)).collect();
            sketch.region(Role::Dimmed, [corners.clone()]).key("triangle round the site");
            if let [a, b, c] = corners[..]
                && triangles.len() <= 12
            {
                sketch.circumcircle(Role::Secondary, [a, b, c]).key("its circle; the centre is a Voronoi vertex");
            }
        }
        for edge in &round[v.index()] {
            add(&mut sketch, &diagram, edge, &window, (Role::Right, "edge of the cell"));
        }
        for f in &triangles {
            if let Some(corner) = diagram.corner_of(*f) {
                let p = diagram.corners()[corner as usize];
                if window.contains(p) {
                    sketch.point(Role::Event, p).key("Voronoi vertex");
                }
            }
        }
        named(&mut sketch, delaunay, &[v]);
        let text = match (round[v.index()].len(), round[v.index()].iter().any(|edge| edge.ends.contains(&None))) {
            (0, _) => "there is no other site: the cell is the whole plane".to_owned(),
            (1, _) => "one edge, across the only edge of the triangulation there".to_owned(),
            (sides, false) => format!("{sides} edges: each crosses its edge of the triangulation at a right angle"),
            (sides, true) => format!("{sides} edges; {v} is a corner of the hull, so the cell has no end"),
        };
        film.over(&format!("Cell {number}: {v}"), &text, delaunay, Backdrop::Dimmed, sketch);
    }
    let mut end = sites_of(delaunay, None);
    for edge in diagram.edges() {
        add(&mut end, &diagram, edge, &window, (Role::Main, "Voronoi edge"));
    }
    named(&mut end, delaunay, &[]);
    let text = format!("{} vertices and {} edges", diagram.corners().len(), diagram.edges().len());
    film.frame("The Voronoi diagram", &text, end);
    Ok(film)
}

fn sites_of(delaunay: &Subdivision, now: Option<VertexId>) -> Sketch {
    let mut sketch = Sketch::new();
    for v in delaunay.vertices().filter(|&v| Some(v) != now) {
        sketch.point(Role::Plain, delaunay.point(v)).title(format!("site {v}")).key("site");
    }
    if let Some(v) = now {
        sketch.point(Role::Main, delaunay.point(v)).title(format!("site {v}")).key("the site of the cell");
    }
    sketch
}

fn add(sketch: &mut Sketch, diagram: &Voronoi<'_>, edge: &VoronoiEdge, window: &Window, (role, key): (Role, &str)) {
    if let Some(piece) = diagram.piece(edge, window) {
        let [left, right] = edge.sites;
        sketch.path(role, piece).solid().title(format!("between {left} and {right}")).key(key);
    }
}
