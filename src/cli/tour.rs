//! `dcel tour`: the whole kit in one run, from the lab's rectangle to a real map.

use super::gallery::lesson::{self, LAB_STEPS, STATES_FILE};
use super::gallery::{draw_all, write_all};
use super::output::names;
use super::{Answer, Failure, Output};
use dcel_kit::ids::{FaceId, VertexId};
use dcel_kit::plane::Subdivision;
use dcel_kit::topology::{measure, violations};
use std::collections::BTreeSet;
use std::io::Write;
use std::path::PathBuf;

/// Take the tour: the half-edge lab, a real map, all figures
///
/// Builds the lab's subdivision from a rectangle with the two splits alone, walks it, checks it; converts a map of
/// the USA and asks it about neighbours; writes the reference figures.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel tour
  dcel tour --out pictures")]
pub(crate) struct Args {
    /// The folder to write the figures into
    #[arg(long, value_name = "DIR", default_value = "figures")]
    out: PathBuf,
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let laws_hold = lab(out)? & map(out)?;
    writeln!(out, "\n3. Figures")?;
    let figures = draw_all()?;
    write_all(&args.out, &figures)?;
    for figure in &figures {
        writeln!(out, "   {}: {}", args.out.join(figure.file).display(), figure.about)?;
    }
    Ok(if laws_hold { Answer::Yes } else { Answer::No })
}

fn lab(out: &mut Output) -> Result<bool, Failure> {
    let mut lab = Subdivision::lab_rectangle();
    writeln!(out, "1. The half-edge lab")?;
    writeln!(out, "   The rectangle to start from: {}.", counts(&lab))?;
    for step in LAB_STEPS {
        writeln!(out, "   {}", lesson::take_step(&mut lab, step).map_err(Failure::kit)?)?;
    }
    writeln!(out, "   The result: {}.", counts(&lab))?;
    let laws_hold = euler(out, &lab)?;

    writeln!(out, "\n   Walks round the faces, along next from half_edge(f):")?;
    for f in lab.faces() {
        let half_edges = names(lab.incident_half_edges(f)).join(", ");
        let vertices = names(lab.incident_vertices(f)).join(", ");
        writeln!(out, "   {f}: half-edges {half_edges}; vertices {vertices}")?;
    }
    let v = VertexId::new(6);
    writeln!(out, "   Round {v}, counter-clockwise by twin(prev(h)):")?;
    writeln!(
        out,
        "   half-edges {}; faces {}; vertices {}",
        names(lab.outgoing_half_edges(v)).join(", "),
        names(lab.incident_faces(v)).join(", "),
        names(lab.adjacent_vertices(v)).join(", ")
    )?;
    Ok(laws_hold)
}

fn map(out: &mut Output) -> Result<bool, Failure> {
    let states = lesson::states().map_err(Failure::kit)?;
    let map = &states.subdivision;
    writeln!(out, "\n2. A real map: {STATES_FILE}, y down, rings without area dropped")?;
    for note in &states.notes {
        writeln!(out, "   note: {note}")?;
    }
    writeln!(out, "   {}, {} components.", counts(map), measure(map).components.len())?;
    let laws_hold = euler(out, map)?;

    let neighbours = states.neighbours("Tennessee");
    writeln!(out, "   Tennessee borders {} states: {}.", neighbours.len(), names(&neighbours).join(", "))?;
    let four = BTreeSet::from(["Arizona", "Colorado", "New Mexico", "Utah"]);
    for v in states.meeting_points(&four) {
        let around = map.incident_faces(v).map(|f: FaceId| states.name(f).unwrap_or("outside"));
        writeln!(out, "   The Four Corners: {v}, degree {}: {}.", map.degree(v), names(around).join(", "))?;
    }
    Ok(laws_hold)
}

fn counts(s: &Subdivision) -> String {
    format!("{} vertices, {} edges, {} faces", s.vertex_count(), s.edge_count(), s.face_count())
}

/// Says what Euler's relation gives and how many invariants are broken. Whether all is well.
fn euler(out: &mut Output, s: &Subdivision) -> Result<bool, Failure> {
    let counts = measure(s);
    let expected = 1 + counts.components.len() as i64;
    let faults = violations(s).len() + s.geometry_violations().len();
    let sign = if counts.euler() == expected { "=" } else { "is not" };
    writeln!(
        out,
        "   V - E + F = {} - {} + {} = {} {sign} 1 + {} components; invariants broken: {faults}.",
        counts.vertices,
        counts.edges,
        counts.faces,
        counts.euler(),
        counts.components.len()
    )?;
    Ok(faults == 0 && counts.euler() == expected)
}
