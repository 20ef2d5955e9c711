//! `dcel solid make`: regular solids, grown ones, and convex hulls.

use super::common::{Target, check_size, points_in_space};
use crate::{Answer, Failure, Output};
use dcel_kit::io::{closest, source_name};
use dcel_kit::solid::grow::Shape;
use dcel_kit::solid::{Archimedean, HullFaces, Platonic, Polyhedron};
use std::path::PathBuf;

/// Make a solid
///
/// SHAPE is one of:
///   tetrahedron cube octahedron dodecahedron icosahedron      the regular solids
///   truncated-cube (and so on), cuboctahedron, icosidodecahedron, rhombicuboctahedron,
///   rhombicosidodecahedron, truncated-cuboctahedron, truncated-icosidodecahedron,
///   snub-cube-left, snub-cube-right, snub-dodecahedron-left, snub-dodecahedron-right
///   ring N, grid N M, box X Y Z, cylinder N M, cone N M, sphere N M, flat-sphere N M, torus N M
///                                      grown from a ring or a torus seed by two splits alone
///   hull FILE                          the convex hull of the points of a file
#[derive(clap::Args, Debug)]
#[command(
    verbatim_doc_comment,
    after_help = "\
Examples:
  dcel solid make torus 7 5 -o t.off
  dcel solid make dodecahedron -o d.stl
  dcel solid make snub-cube-left -o s.stl --to stl-binary
  dcel solid make hull cloud.obj --triangles -o hull.ply --json"
)]
pub(crate) struct Args {
    /// What to make
    shape: String,
    /// Its numbers, or the file
    #[arg(value_name = "N")]
    numbers: Vec<String>,
    /// Cut the sides of a hull into triangles
    #[arg(long)]
    triangles: bool,
    #[command(flatten)]
    target: Target,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let name = [args.shape.clone()].into_iter().chain(args.numbers.clone()).collect::<Vec<_>>().join(" ");
    if args.shape == "hull" {
        return hull(args, &name, out);
    }
    args.target.check(None)?;
    if args.triangles {
        return Err(Failure::input("--triangles is for hulls", "other shapes have the faces they have"));
    }
    let regular = Platonic::ALL.into_iter().find(|solid| solid.name() == args.shape);
    let archimedean = Archimedean::ALL.into_iter().find(|solid| solid.to_string() == args.shape);
    let solid = match (regular, archimedean) {
        (Some(_), _) | (_, Some(_)) if !args.numbers.is_empty() => {
            return Err(Failure::input(format!("{} takes no numbers", args.shape), "for a cut cube: box 3 3 3"));
        }
        (Some(solid), _) => Polyhedron::platonic(solid),
        (_, Some(solid)) => Polyhedron::archimedean(solid),
        _ => grown(&name, shape(args)?)?.build().map_err(|error| Failure::input(error, ""))?.polyhedron,
    };
    args.target.put(&name, &solid, None, out)
}

fn grown(name: &str, shape: Shape) -> Result<Shape, Failure> {
    let [vertices, edges, faces] = shape.counts();
    check_size(name, vertices.max(edges).max(faces), "take smaller numbers")?;
    Ok(shape)
}

/// The shapes that grow, with the names of their numbers.
const GROWN: [(&str, &str); 8] = [
    ("ring", "N"),
    ("grid", "N M"),
    ("box", "X Y Z"),
    ("cylinder", "N M"),
    ("cone", "N M"),
    ("sphere", "N M"),
    ("flat-sphere", "N M"),
    ("torus", "N M"),
];

fn shape(args: &Args) -> Result<Shape, Failure> {
    let Some(&(_, wanted)) = GROWN.iter().find(|(name, _)| *name == args.shape) else {
        let known: Vec<String> = Platonic::ALL.iter().map(ToString::to_string).collect();
        let others: Vec<String> = Archimedean::ALL.iter().map(ToString::to_string).collect();
        let grown: Vec<&str> = GROWN.iter().map(|(name, _)| *name).collect();
        let what = format!("`{}` is no shape", args.shape);
        let names = || known.iter().chain(&others).map(String::as_str).chain(grown.iter().copied()).chain(["hull"]);
        let begun = names().find(|name| !args.shape.is_empty() && name.starts_with(&args.shape));
        let close = begun.or_else(|| closest(&args.shape, names()));
        let close = close.map_or(String::new(), |close| format!("did you mean {close}? "));
        let all = [known.join(", "), others.join(", "), grown.join(", ")].join(", ");
        return Err(Failure::input(what, format!("{close}choose one of {all}, hull")));
    };
    let numbers: Option<Vec<usize>> = args.numbers.iter().map(|word| word.parse().ok()).collect();
    let usage = || {
        let what = format!("{} takes {} whole numbers: {wanted}", args.shape, wanted.split(' ').count());
        Failure::input(what, "for example: dcel solid make torus 7 5")
    };
    let numbers = numbers.ok_or_else(usage)?;
    Ok(match (args.shape.as_str(), &numbers[..]) {
        ("ring", &[sides]) => Shape::Ring { sides },
        ("grid", &[n, m]) => Shape::Grid { n, m },
        ("box", &[x, y, z]) => Shape::Cuboid { x, y, z },
        ("cylinder", &[sides, layers]) => Shape::Cylinder { sides, layers },
        ("cone", &[sides, layers]) => Shape::Cone { sides, layers },
        ("sphere", &[sides, bands]) => Shape::Sphere { sides, bands },
        ("flat-sphere", &[sides, bands]) => Shape::FlatSphere { sides, bands },
        ("torus", &[n, m]) => Shape::Torus { n, m },
        _ => return Err(usage()),
    })
}

fn hull(args: &Args, name: &str, out: &mut Output) -> Result<Answer, Failure> {
    let [file] = &args.numbers[..] else {
        return Err(Failure::input("hull takes one file", "for example: dcel solid make hull cloud.obj -o hull.off"));
    };
    let file = PathBuf::from(file);
    args.target.check(Some(&file))?;
    let points = points_in_space(&file)?;
    let source = source_name(&file);
    let faces = if args.triangles { HullFaces::Triangles } else { HullFaces::Whole };
    let hull = Polyhedron::convex_hull(&points, faces)
        .map_err(|error| Failure::input(format!("{source}: {error}"), "points are counted from 0"))?;
    let note = format!("{} of {} points are corners", hull.points.len(), points.len());
    args.target.put(name, &hull.solid, Some(&note), out)
}
