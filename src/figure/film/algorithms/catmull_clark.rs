//! Catmull–Clark subdivision: vertices in faces, vertices of edges, vertices that move, new faces.

use super::space::{Moment, film};
use crate::figure::SketchFilm;
use crate::figure::kinds::solid::UP;
use crate::figure::sketch::Role;
use crate::ids::EdgeId;
use crate::solid::{Polyhedron, Selection, SubdivideError, SubdivideEvent};

/// Of a finer surface with so many edges at most the steps in between are drawn.
const MOST_EDGES: usize = 400;

/// The film of some steps of Catmull–Clark subdivision: for each of them a frame with the vertices in faces, one with those
/// of edges, one with the vertices that move, and the finer surface. Of surfaces with more than 400 edges the finer surface
/// alone is a frame.
///
/// # Errors
/// [`SubdivideError::TooMany`].
///
/// ```
/// use dcel_kit::figure::algorithms;
/// use dcel_kit::solid::{Platonic, Polyhedron, Selection};
/// let cube = Polyhedron::platonic(Platonic::Cube);
/// let film = algorithms::catmull_clark(&cube, &Selection::new(), 1)?;
/// assert!(film.captions().any(|(heading, _)| heading == "Step 1: 6 vertices in faces"));
/// # Ok::<(), dcel_kit::solid::SubdivideError>(())
/// ```
pub fn catmull_clark(
    solid: &Polyhedron,
    creases: &Selection<EdgeId>,
    steps: usize,
) -> Result<SketchFilm, SubdivideError> {
    let mut solids = vec![solid.clone()];
    let mut creases = creases.clone();
    let counts = |solid: &Polyhedron| {
        format!("{} vertices, {} edges, {} faces", solid.vertex_count(), solid.edge_count(), solid.face_count())
    };
    let mut moments = vec![Moment::new("The surface that is given".to_owned(), counts(solid), 0)];
    for step in 1..=steps {
        let mut events = Vec::new();
        let coarse = solids[step - 1].clone();
        let fine = coarse.catmull_clark_observed(&creases, &mut events)?;
        let surface = fine.polyhedron;
        creases = fine.creases;
        if surface.edge_count() <= MOST_EDGES {
            between(&mut moments, step, &surface, &coarse, &events);
        }
        let text = counts(&surface);
        moments.push(Moment::new(format!("Step {step}: the finer surface"), text, step));
        solids.push(surface);
    }
    Ok(film(&solids, &moments, UP, false))
}

/// The frames between a surface and the next finer one.
fn between(moments: &mut Vec<Moment>, step: usize, fine: &Polyhedron, coarse: &Polyhedron, events: &[SubdivideEvent]) {
    let mut in_faces = Vec::new();
    let mut of_edges = Vec::new();
    let mut moved = Vec::new();
    for event in events {
        match *event {
            SubdivideEvent::Face { vertex, .. } => in_faces.push(vertex),
            SubdivideEvent::Edge { vertex, .. } => of_edges.push(vertex),
            SubdivideEvent::Vertex(vertex) => moved.push(vertex),
        }
    }
    let faces = in_faces.iter().map(|&v| (Role::Main, fine.point(v), "vertex in a face", None));
    let edges = of_edges.iter().map(|&v| (Role::Secondary, fine.point(v), "vertex of an edge", None));
    let old = moved.iter().map(|&v| (Role::Event, fine.point(v), "new place of a vertex", None));
    let moment = |what: String, text: &str, points: Vec<_>| {
        let moment = Moment::new(format!("Step {step}: {what}"), text.to_owned(), step - 1);
        Moment { points, ..moment }
    };
    let what = format!("{} vertices in faces", in_faces.len());
    moments.push(moment(what, "each is the mean of the corners", faces.clone().collect()));
    let what = format!("{} vertices of edges", of_edges.len());
    let text = "each is the mean of the two ends and the two vertices in the faces beside it";
    moments.push(moment(what, text, faces.clone().chain(edges.clone()).collect()));
    let what = format!("{} vertices move", moved.len());
    let points = faces.chain(edges).chain(old).collect();
    let mut last = moment(what, "by the means of the faces and edges round them", points);
    // Numbers stay only in a surface without gaps.
    if coarse.vertex_bound() == coarse.vertex_count() {
        let way = |&v| (Role::Event, vec![coarse.point(v), fine.point(v)], "how a vertex moves");
        last.lines.extend(moved.iter().map(way));
    }
    moments.push(last);
}
