//! `dcel walk`: what is incident to an element, and what is adjacent.
//!
//! ```text
//!   --face f3       its cycles along next      --vertex v2     the half-edges that start there, counter-clockwise
//!   --face-name X   the same, by name          --half-edge h5  its links
//! ```
//!
//! Broken tables are walked as far as the pointers lead; a walk that does not come back says so.
//!
//! ```text
//!   faces.rs   Round faces
//!   around.rs  Round a vertex, and the links of a half-edge
//!   names.rs   Ids, names and positions as answers have them
//!   which.rs   The element that is meant, or a helpful refusal
//! ```

mod around;
mod faces;
mod names;
mod which;

use super::subject::Subject;
use super::{Answer, Failure, InputOptions, Output};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use std::path::PathBuf;

/// Walk round a face or a vertex, or follow a half-edge
///
/// A face: its half-edges cycle by cycle, with what lies across. A vertex: the half-edges that start
/// there, counter-clockwise, with the faces on their left. A half-edge: its links.
#[derive(clap::Args, Debug)]
#[command(override_usage = "dcel walk <FILE> <ELEMENT> [OPTIONS]")]
#[command(after_help = "\
Examples:
  dcel walk square.obj --face f1
  dcel walk square.obj --vertex v2
  dcel walk square.dcel --half-edge h5 --json
  dcel walk states.json \\
    --y-down --drop-degenerate-rings \\
    --face-name Tennessee")]
pub(crate) struct Args {
    /// The file, or - for standard input
    file: PathBuf,
    #[command(flatten)]
    element: Which,
    /// Answer in JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    input: InputOptions,
}

/// The element to start from.
#[derive(clap::Args, Debug)]
#[group(required = true, multiple = false)]
#[command(next_help_heading = "Element (one of these)")]
struct Which {
    /// A face by its id
    #[arg(long, value_name = "f3")]
    face: Option<FaceId>,
    /// All faces of a name; capitals do not matter
    #[arg(long, value_name = "NAME")]
    face_name: Option<String>,
    /// A vertex by its id
    #[arg(long, value_name = "v2")]
    vertex: Option<VertexId>,
    /// A half-edge by its id
    #[arg(long, value_name = "h5")]
    half_edge: Option<HalfEdgeId>,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let subject = args.input.open(&args.file)?;
    let view = subject.view();
    let Which { face, face_name, vertex, half_edge } = &args.element;
    if let Some(v) = vertex {
        which::check(&subject, *v, view.vertex_bound(), |v| view.has_vertex(v))?;
        return around::star(&subject, *v, args.json, out);
    }
    if let Some(h) = half_edge {
        which::check(&subject, *h, view.half_edge_bound(), |h| view.has_half_edge(h))?;
        return around::links(&subject, *h, args.json, out);
    }
    let faces = which::faces(&subject, *face, face_name.as_deref())?;
    faces::run(&subject, &faces, args.json, out)
}
