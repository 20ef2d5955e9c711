//! `dcel info`: what a structure consists of.

use super::answer::{InWords, tell};
use super::input::InputOptions;
use super::subject::{Kind, Subject};
use super::{Answer, Failure, Output};
use dcel_kit::io::{Covering, Number, counted};
use dcel_kit::plane::{Subdivision, TableError};
use dcel_kit::topology::{Counts, InnerComponent, first_violation, measure_with};
use dcel_kit::{FaceId, FaceMap, HalfEdgeId, VertexMap};
use serde::Serialize;
use std::collections::BTreeMap;
use std::io::{self, Write};
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

/// The answer. The names are those of the JSON form.
#[derive(Serialize)]
struct Info {
    source: String,
    format: &'static str,
    mode: &'static str,
    /// Nothing if the plane was not checked.
    valid: Option<bool>,
    vertices: usize,
    edges: usize,
    half_edges: usize,
    faces: usize,
    components: usize,
    boundary_cycles: usize,
    euler: i64,
    genus: i64,
    /// Cycles of faces.
    cycles: usize,
    hole_faces: usize,
    /// Cycles of the outer face, further cycles of others, isolated vertices.
    inner_components: usize,
    inner_components_of_outer_face: usize,
    isolated_vertices: usize,
    /// Over the faces of the domain.
    sides: Spread,
    degrees: Spread,
    faces_by_sides: BTreeMap<usize, usize>,
    bounding_box: Option<BoundingBox>,
    named_faces: usize,
    names: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    mended: Option<Mended>,
    memory_bytes: Option<usize>,
    bytes_per_half_edge: Option<f64>,
}

/// What polygons that had to be mended cover.
#[derive(Serialize)]
struct Mended {
    polygons: usize,
    /// Faces that one polygon covers, and several.
    covered_once: usize,
    covered_several_times: usize,
    overlapping_area: f64,
}

impl Mended {
    fn of(covering: &Covering, subject: &Subject) -> Self {
        let counts = || subject.faces().map(|f| covering.cover.count(f));
        Self {
            polygons: covering.polygons,
            covered_once: counts().filter(|&count| count == 1).count(),
            covered_several_times: counts().filter(|&count| count > 1).count(),
            overlapping_area: covering.overlapping,
        }
    }
}

#[derive(Serialize)]
struct BoundingBox {
    min: Vec<f64>,
    max: Vec<f64>,
}

/// The least, the mean and the greatest of some numbers.
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
    let subject = args.input.open(&args.file)?;
    let info = Info::of(&subject);
    if info.valid == Some(false) {
        super::failure::say("note", format!("{}: invariants are broken; `dcel validate` names them", subject.source));
    }
    tell(&info, args.json, out)
}

impl Info {
    /// O(n), but O(n log n) for tables, whose geometry is checked.
    fn of(subject: &Subject) -> Self {
        let view = subject.view();
        let counts: Counts = measure_with(view, |f| subject.is_boundary(f));
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
        let (valid, memory) = validity(subject);
        let valid = Some(valid).filter(|valid| !(*valid && subject.trusted));
        Self {
            source: subject.source.clone(),
            format: subject.format.name(),
            mode: subject.mode_name(),
            valid,
            vertices: counts.vertices,
            edges: counts.edges,
            half_edges: counts.half_edges,
            faces: counts.faces,
            components: counts.components.len(),
            boundary_cycles: counts.boundary_cycles,
            euler: counts.euler(),
            genus: counts.genus(),
            cycles: counts.cycles,
            hole_faces: subject.faces().filter(|&f| view.is_hole(f)).count(),
            inner_components: first_of_outer + subject.faces().map(|f| view.inner_components(f).len()).sum::<usize>(),
            inner_components_of_outer_face: first_of_outer
                + outer.map_or(0, |f| view.inner_components(f).iter().filter(outer_cycles).count()),
            isolated_vertices: counts.isolated_vertices,
            sides: Spread::of(domain.iter().map(|&f| sides[f])),
            degrees: Spread::of(subject.vertices().map(|v| degrees[v])),
            faces_by_sides,
            bounding_box: bounding_box(subject),
            named_faces,
            names: names.len(),
            mended: subject.covering.as_ref().map(|covering| Mended::of(covering, subject)),
            memory_bytes: memory,
            bytes_per_half_edge: memory
                .filter(|_| counts.half_edges > 0)
                .map(|bytes| bytes as f64 / counts.half_edges as f64),
        }
    }

    /// ` (3: 12, 4: 6)`, if there are few different numbers.
    fn histogram(&self) -> String {
        if self.faces_by_sides.is_empty() || self.faces_by_sides.len() > 8 {
            return String::new();
        }
        let each: Vec<String> = self.faces_by_sides.iter().map(|(sides, count)| format!("{count} x {sides}")).collect();
        format!(" ({})", each.join(", "))
    }
}

impl InWords for Info {
    fn print(&self, out: &mut Output) -> io::Result<()> {
        let format = self.format;
        let valid = match self.valid {
            Some(true) => "valid",
            Some(false) => "NOT valid",
            None => "not checked",
        };
        writeln!(out, "{}: {}, {format}, {valid}", self.source, self.mode)?;
        let mut line = |what: &str, value: String| writeln!(out, "  {what:<18}{value}");
        line("vertices", self.vertices.to_string())?;
        line("edges", format!("{} ({})", self.edges, counted(self.half_edges, "half-edge", "half-edges")))?;
        let holes = match self.hole_faces {
            0 => String::new(),
            1 => ", 1 of them a hole".to_owned(),
            n => format!(", {n} of them holes"),
        };
        let outer = if self.mode == "plane" { " (with the outer face" } else { "" };
        let close = if outer.is_empty() { "" } else { ")" };
        line("faces", format!("{}{outer}{holes}{close}", self.faces))?;
        line("components", self.components.to_string())?;
        line("euler", format!("V - E + F = {}", self.euler))?;
        line("boundary cycles", self.boundary_cycles.to_string())?;
        if self.mode == "surface" {
            line("genus", self.genus.to_string())?;
        } else {
            let inner = self.inner_components - self.inner_components_of_outer_face;
            line(
                "inner components",
                format!(
                    "{} of the outer face, {}",
                    self.inner_components_of_outer_face,
                    counted(inner, "other", "others")
                ),
            )?;
            line("isolated", counted(self.isolated_vertices, "vertex", "vertices"))?;
        }
        line("sides of faces", format!("{}{}", self.sides, self.histogram()))?;
        line("degrees", self.degrees.to_string())?;
        if let Some(BoundingBox { min, max }) = &self.bounding_box {
            line("bounding box", format!("{} to {}", super::output::point(min), super::output::point(max)))?;
        }
        if self.named_faces > 0 {
            line("names", format!("{} on {}", self.names, counted(self.named_faces, "face", "faces")))?;
        }
        if let Some(Mended { polygons, covered_once, covered_several_times, overlapping_area }) = &self.mended {
            let once = counted(*covered_once, "face", "faces");
            let area = Number(*overlapping_area);
            line("mended", format!("{}; {once} covered once", counted(*polygons, "polygon", "polygons")))?;
            line("overlaps", format!("{}, area {area}", counted(*covered_several_times, "face", "faces")))?;
        }
        if let Some(bytes) = self.memory_bytes {
            let each = self.bytes_per_half_edge.map_or_else(String::new, |each| format!(", {each:.1} a half-edge"));
            line("memory", format!("{bytes} bytes{each}"))?;
        }
        Ok(())
    }
}

impl std::fmt::Display for Spread {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} to {}, mean {:.2}", self.min, self.max, self.mean)
    }
}

/// Whether all invariants hold that are checked, and the bytes of the structure without positions.
fn validity(subject: &Subject) -> (bool, Option<usize>) {
    match &subject.kind {
        Kind::Plane(subdivision) => (first_violation(subdivision).is_none(), Some(subdivision.memory_bytes())),
        Kind::Surface(polyhedron) => (first_violation(polyhedron).is_none(), Some(polyhedron.memory_bytes())),
        Kind::Table(table) => match Subdivision::from_table(table) {
            Ok(subdivision) => (true, Some(subdivision.memory_bytes())),
            // The invariants of the structure hold; there is no plane, or nothing is known of its geometry.
            Err(TableError::NoOuterFace | TableError::NoPosition { .. }) => (true, None),
            Err(_) => (false, None),
        },
    }
}

fn bounding_box(subject: &Subject) -> Option<BoundingBox> {
    let mut positions = subject.vertices().filter_map(|v| subject.position(v));
    let first = positions.next()?;
    let mut found = BoundingBox { min: first.clone(), max: first };
    for position in positions {
        for (i, &x) in position.iter().enumerate() {
            found.min[i] = found.min[i].min(x);
            found.max[i] = found.max[i].max(x);
        }
    }
    Some(found)
}
