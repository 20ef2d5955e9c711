//! `dcel info`: what a structure consists of.

use super::output::point;
use super::subject::{Kind, Subject};
use super::{Answer, Failure, InputOptions, Output, fields, tell};
use dcel_kit::io::{Number, counted};
use dcel_kit::plane::{Subdivision, TableError};
use dcel_kit::topology::{InnerComponent, Mode, first_violation, measure_with};
use dcel_kit::{FaceId, FaceMap, HalfEdgeId, VertexMap};
use serde::Serialize;
use std::collections::BTreeMap;
use std::io::Write;
use std::path::PathBuf;

/// Count vertices, edges, faces, components, inner components and holes
///
/// In the plane `faces` counts the outer face and hole faces; on a surface it does not count the
/// faces that stand for borders. The Euler number is V - E + F.
///
/// `valid` says that all invariants hold, also those of the plane: nothing crosses, nothing overlaps. A file
/// of polygons that are not is refused, or cut up with --mend; with --trust it is `not checked`
/// whether polygons overlap that share no edge and no corner. A broken .dcel file is `NOT valid`.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel info square.obj
  dcel info cube.off --json
  dcel info fields.geojson --mend
  dcel info states.json \\
    --y-down --drop-degenerate-rings")]
pub(crate) struct Args {
    /// The file, or - for standard input
    file: PathBuf,
    /// Answer in JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    input: InputOptions,
}

/// The least, the mean and the greatest of some numbers. The names are those of the JSON form.
#[derive(Serialize, Default, Clone, Copy)]
struct Spread {
    min: usize,
    mean: f64,
    max: usize,
}

impl Spread {
    fn of(numbers: impl Iterator<Item = usize>) -> Self {
        let (mut count, mut sum, mut min, mut max) = (0usize, 0usize, usize::MAX, 0);
        for n in numbers {
            (count, sum, min, max) = (count + 1, sum + n, min.min(n), max.max(n));
        }
        Self { min: min.min(max), mean: sum as f64 / count.max(1) as f64, max }
    }
}

pub(crate) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let mut subject = args.input.open(&args.file)?;
    let (valid, memory) = validity(&mut subject);
    let subject = &subject;
    let (view, is_plane) = (subject.view(), subject.mode() == Mode::Plane);
    if !valid {
        super::failure::say("note", format!("{}: invariants are broken; `dcel validate` names them", subject.source));
    }
    let counts = measure_with(view, |f| subject.is_boundary(f));
    let mut degrees = VertexMap::filled(view.vertex_bound(), 0usize);
    let mut sides = FaceMap::filled(view.face_bound(), 0usize);
    for h in (0..view.half_edge_bound() as u32).map(HalfEdgeId::new) {
        if let Some(v) = view.origin(h).filter(|&v| view.has_vertex(v)) {
            degrees[v] += 1;
        }
        if let Some(f) = view.face(h).filter(|&f| view.has_face(f)) {
            sides[f] += 1;
        }
    }
    let domain: Vec<FaceId> = subject.faces().filter(|&f| !subject.is_boundary(f)).collect();
    let mut faces_by_sides = BTreeMap::new();
    for &f in &domain {
        *faces_by_sides.entry(sides[f]).or_insert(0) += 1;
    }
    let outer = view.outer_face();
    let first_of_outer = outer.and_then(|f| view.half_edge(f)).is_some() as usize;
    let outer_cycles = |ring: &&InnerComponent| matches!(ring, InnerComponent::Cycle(_));
    let mut names: Vec<&str> = subject.faces().filter_map(|f| subject.name(f)).collect();
    let named_faces = names.len();
    names.sort_unstable();
    names.dedup();
    let mended = subject.covering.as_ref().map(|covering| {
        let covered = || subject.faces().map(|f| covering.cover.count(f));
        fields! {
            polygons: covering.polygons,
            // Faces that one polygon covers, and several.
            covered_once: covered().filter(|&count| count == 1).count(),
            covered_several_times: covered().filter(|&count| count > 1).count(),
            overlapping_area: covering.overlapping,
        }
    });
    let answer = fields! {
        source: &subject.source,
        format: subject.format.name(),
        mode: subject.mode_name(),
        // Nothing if the plane was not checked.
        valid: Some(valid).filter(|valid| !(*valid && subject.trusted)),
        vertices: counts.vertices,
        edges: counts.edges,
        half_edges: counts.half_edges,
        faces: counts.faces,
        components: counts.components.len(),
        boundary_cycles: counts.boundary_cycles,
        euler: counts.euler(),
        genus: counts.genus(),
        // Cycles of faces.
        cycles: counts.cycles,
        hole_faces: subject.faces().filter(|&f| view.is_hole(f)).count(),
        // Cycles of the outer face, further cycles of others, isolated vertices.
        inner_components: first_of_outer + subject.faces().map(|f| view.inner_components(f).len()).sum::<usize>(),
        inner_components_of_outer_face: first_of_outer
            + outer.map_or(0, |f| view.inner_components(f).iter().filter(outer_cycles).count()),
        isolated_vertices: counts.isolated_vertices,
        // Over the faces of the domain.
        sides: Spread::of(domain.iter().map(|&f| sides[f])),
        degrees: Spread::of(subject.vertices().map(|v| degrees[v])),
        faces_by_sides,
        bounding_box: bounding_box(subject).map(|[min, max]| fields! { min, max }),
        named_faces,
        names: names.len(),
        #[serde(flatten)]
        mended: mended.as_ref().map(|mended| fields! { mended }),
        memory_bytes: memory,
        bytes_per_half_edge: memory
            .filter(|_| counts.half_edges > 0)
            .map(|bytes| bytes as f64 / counts.half_edges as f64),
    };
    tell(&answer, args.json, out, |out| {
        let valid = match answer.valid {
            Some(true) => "valid",
            Some(false) => "NOT valid",
            None => "not checked",
        };
        writeln!(out, "{}: {}, {}, {valid}", answer.source, answer.mode, answer.format)?;
        let mut line = |what: &str, value: String| writeln!(out, "  {what:<18}{value}");
        line("vertices", answer.vertices.to_string())?;
        line("edges", format!("{} ({})", answer.edges, counted(answer.half_edges, "half-edge", "half-edges")))?;
        let holes = match answer.hole_faces {
            0 => String::new(),
            1 => ", 1 of them a hole".to_owned(),
            n => format!(", {n} of them holes"),
        };
        line(
            "faces",
            if is_plane {
                format!("{} (with the outer face{holes})", answer.faces)
            } else {
                format!("{}{holes}", answer.faces)
            },
        )?;
        line("components", answer.components.to_string())?;
        line("euler", format!("V - E + F = {}", answer.euler))?;
        line("boundary cycles", answer.boundary_cycles.to_string())?;
        if is_plane {
            let of_outer = answer.inner_components_of_outer_face;
            let others = counted(answer.inner_components - of_outer, "other", "others");
            line("inner components", format!("{of_outer} of the outer face, {others}"))?;
            line("isolated", counted(answer.isolated_vertices, "vertex", "vertices"))?;
        } else {
            line("genus", answer.genus.to_string())?;
        }
        line("sides of faces", format!("{}{}", answer.sides, histogram(&answer.faces_by_sides)))?;
        line("degrees", answer.degrees.to_string())?;
        if let Some(of) = &answer.bounding_box {
            line("bounding box", format!("{} to {}", point(&of.min), point(&of.max)))?;
        }
        if answer.named_faces > 0 {
            line("names", format!("{} on {}", answer.names, counted(answer.named_faces, "face", "faces")))?;
        }
        if let Some(of) = &mended {
            let [once, several] = [of.covered_once, of.covered_several_times].map(|n| counted(n, "face", "faces"));
            line("mended", format!("{}; {once} covered once", counted(of.polygons, "polygon", "polygons")))?;
            line("overlaps", format!("{several}, area {}", Number(of.overlapping_area)))?;
        }
        if let Some(bytes) = memory {
            let each = answer.bytes_per_half_edge.map_or_else(String::new, |each| format!(", {each:.1} a half-edge"));
            line("memory", format!("{bytes} bytes{each}"))?;
        }
        Ok(())
    })
}

/// ` (12 x 3, 6 x 4)`, if there are few different numbers.
fn histogram(faces_by_sides: &BTreeMap<usize, usize>) -> String {
    if faces_by_sides.is_empty() || faces_by_sides.len() > 8 {
        return String::new();
    }
    let each: Vec<String> = faces_by_sides.iter().map(|(sides, count)| format!("{count} x {sides}")).collect();
    format!(" ({})", each.join(", "))
}

impl std::fmt::Display for Spread {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} to {}, mean {:.2}", self.min, self.max, self.mean)
    }
}

/// Whether all invariants hold that are checked, and the bytes of the structure without positions. A table that is a
/// subdivision of the plane becomes one: it counts the same.
fn validity(subject: &mut Subject) -> (bool, Option<usize>) {
    match &mut subject.kind {
        Kind::Plane(subdivision) => (first_violation(subdivision).is_none(), Some(subdivision.memory_bytes())),
        Kind::Surface(polyhedron) => (first_violation(polyhedron).is_none(), Some(polyhedron.memory_bytes())),
        Kind::Table(table) => match (table.names_in_plane(), Subdivision::from_columns(table)) {
            (names, Ok(subdivision)) => {
                let bytes = subdivision.memory_bytes();
                (subject.names, subject.kind) = (names, Kind::Plane(subdivision));
                (true, Some(bytes))
            }
            // The invariants of the structure hold; there is no plane, or nothing is known of its geometry.
            (_, Err(TableError::NoOuterFace | TableError::NoPosition { .. })) => (true, None),
            (_, Err(_)) => (false, None),
        },
    }
}

/// The least and the greatest coordinates.
fn bounding_box(subject: &Subject) -> Option<[Vec<f64>; 2]> {
    let mut positions = subject.vertices().filter_map(|v| subject.position(v));
    let first = positions.next()?;
    let [mut min, mut max] = [first.clone(), first];
    for position in positions {
        for (i, &x) in position.iter().enumerate() {
            (min[i], max[i]) = (min[i].min(x), max[i].max(x));
        }
    }
    Some([min, max])
}
