//! Reads what an algorithm works on, and films it.

use super::algorithm::Algorithm;
use super::{Args, Refused};
use crate::Failure;
use crate::input::refuse_object;
use crate::navmesh::{PathFilm, path_film};
use crate::solid::{check_finer, direction, open_solid, points_in_space};
use crate::subject::{Kind, Subject};
use dcel_kit::VertexId;
use dcel_kit::figure::{SketchFilm, algorithms};
use dcel_kit::io::{Document, ReadOptions, read_path, source_name};
use dcel_kit::plane::{Point, Subdivision, TriangulateError};
use dcel_kit::solid::Selection;
use std::fmt::Display;

/// The film that is asked for.
pub(super) fn film(args: &Args) -> Result<SketchFilm, Refused> {
    match args.what {
        Algorithm::Hull | Algorithm::Voronoi => Ok(of_points(args)?),
        Algorithm::Sweep => Ok(of_segments(args)?),
        Algorithm::Funnel | Algorithm::Cones => of_a_path(args),
        Algorithm::Climb | Algorithm::SolidHull | Algorithm::CatmullClark => in_space(args),
        Algorithm::Ears | Algorithm::Flips | Algorithm::Monotone | Algorithm::Walk | Algorithm::Locate => {
            of_a_subdivision(args)
        }
    }
}

fn of_points(args: &Args) -> Result<SketchFilm, Failure> {
    let list = args.input.points(&args.file)?;
    let refused = |error: &dyn Display| Failure::about(&list.source, error);
    if args.what == Algorithm::Hull {
        return algorithms::convex_hull(&list.points, args.most).map_err(|error| refused(&error));
    }
    let delaunay = Subdivision::delaunay(&list.points).map_err(|error| refused(&error))?;
    algorithms::voronoi(&delaunay.subdivision, args.most).map_err(|error| refused(&error))
}

fn of_segments(args: &Args) -> Result<SketchFilm, Failure> {
    let given = args.input.for_raw("the sweep looks at the segments as they are, and shows where they meet")?;
    let options = ReadOptions { outlines: true, close_rings: true, ..given };
    let read = read_path(&args.file, &options)?;
    let source = source_name(&args.file);
    refuse_object(options.object.as_deref(), Some(read.format), &source)?;
    let Document::Segments(soup) = &read.document else {
        let what = format!("{source}: {} holds no segments", read.format);
        return Err(Failure::input(what, "the sweep takes wkt, poly, segments, geojson and topojson"));
    };
    let segments: Vec<[Point; 2]> = soup.segments.iter().map(|ends| ends.map(|p| soup.points[p as usize])).collect();
    algorithms::segment_sweep(&segments, args.most).map_err(|error| Failure::about(&source, error))
}

fn of_a_path(args: &Args) -> Result<SketchFilm, Refused> {
    let what = if args.what == Algorithm::Cones { PathFilm::Cones } else { PathFilm::Funnel };
    let ends = [args.about.from.unwrap_or_default(), args.about.to.unwrap_or_default()];
    path_film(&args.file, ends, what, args.most)
}

fn of_a_subdivision(args: &Args) -> Result<SketchFilm, Refused> {
    let Subject { source, kind, .. } = args.input.open_as(&args.file, false)?;
    let Kind::Plane(given) = kind else {
        let what = format!("{source}: this film is of the plane, and the file is a surface in space");
        return Err(Failure::input(what, "--plane drops z: good for a terrain seen from above").into());
    };
    let refused = |error: &dyn Display| Refused::from(Failure::about(&source, error));
    let faulty = |error: TriangulateError| Refused {
        film: Some(algorithms::refusal(&given, &error.to_string(), &error.elements(), &[])),
        ..refused(&error)
    };
    let about = &args.about;
    match args.what {
        Algorithm::Flips => Ok(algorithms::lawson_flips(&given, |_| false, args.most)),
        Algorithm::Monotone => algorithms::monotone(&given, args.most).map_err(faulty),
        Algorithm::Walk => match (about.face, about.vertex) {
            (Some(f), _) => algorithms::face_walk(&given, f, args.most),
            (None, v) => algorithms::vertex_walk(&given, v.unwrap_or(VertexId::new(0)), args.most),
        }
        .map_err(|error| refused(&error)),
        Algorithm::Locate => {
            let start = start(args, given.vertices().next())?;
            let [x, y] = about.point.unwrap_or_default();
            let p = Point::new(x, if args.input.y_down { 0.0 - y } else { y });
            algorithms::location_walk(&given, start, p, args.most).map_err(|error| refused(&error))
        }
        _ => algorithms::ear_clipping(&given, args.most).map_err(faulty),
    }
}

fn in_space(args: &Args) -> Result<SketchFilm, Refused> {
    let source = source_name(&args.file);
    if args.what == Algorithm::SolidHull {
        let points = points_in_space(&args.file)?;
        return Ok(algorithms::convex_hull_in_space(&points, args.most)
            .map_err(|error| Failure::input(format!("{source}: {error}"), "points are counted from 0"))?);
    }
    let solid = open_solid(&args.file, &args.input)?;
    if args.what == Algorithm::CatmullClark {
        let steps = args.about.steps.unwrap_or(1);
        check_finer(&solid, steps)?;
        return Ok(algorithms::catmull_clark(&solid, &Selection::new(), usize::from(steps))
            .map_err(|error| Failure::about(&source, error))?);
    }
    let direction = direction(args.about.direction.unwrap_or_default())?;
    let start = start(args, solid.vertices().next())?;
    solid.check(start).map_err(|error| Failure::input(format!("--start: {error}"), ""))?;
    let convex = solid.check_convex().map_err(|error| Refused {
        film: Some(algorithms::refusal_in_space(&solid, &error.to_string(), &error.elements())),
        failure: Box::new(Failure::refused(args.file.display(), error)),
    })?;
    Ok(algorithms::hill_climbing(&solid, &convex, direction, start, args.most))
}

/// The vertex to start from: the first one, unless another one is given.
fn start(args: &Args, first: Option<VertexId>) -> Result<VertexId, Failure> {
    let none = || Failure::input(format!("{}: there is no vertex to start from", source_name(&args.file)), "");
    args.about.start.or(first).ok_or_else(none)
}
