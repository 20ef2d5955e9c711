//! `dcel navmesh info`: what a map is, and what is wrong with it.

use super::super::{Answer, Failure, Output, tell};
use super::drawing::{Drawing, save};
use super::map::Map;
use super::reading::{Input, MapArgs};
use super::space;
use super::tell::{Told, sizes, tell_helps};
use clap::ValueEnum;
use dcel_kit::figure;
use dcel_kit::figure::navmesh::Floor;
use dcel_kit::io::{Number, counted};
use dcel_kit::navmesh::double_corners_of;
use serde::Serialize;
use std::io::{self, Write};

/// Count faces, components, dead ends and junctions of a map, and name everything that is wrong with it
///
/// A junction is a face with three or more exits that are no dead ends; between junctions lie
/// reduced corridors, rows of faces without a choice.
///
/// Wrong are faces that run clockwise, that are not convex or have no area, that overlap, T-junctions
/// and vertices at the same place. Double corners, where holes touch, are told as a warning. Exit code
/// 1 if something is wrong.
///
/// Of a floor in space whose heights differ (--up) it tells the heights, the steepest slope and the layers:
/// parts of which none lies over itself; and it warns of vertices that are on another face's side, at one place,
/// or close to it: nobody can pass there (--weld joins them).
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Examples:
  dcel navmesh info rooms.map
  dcel navmesh info rooms.map --json
  dcel navmesh info rooms.map --triangles \\
    --draw dead-ends -o dead-ends.svg
  dcel navmesh info house.obj --up z -o house.svg")]
pub(super) struct Args {
    #[command(flatten)]
    map: MapArgs,
    /// Answer in JSON
    #[arg(long)]
    json: bool,
    /// What to draw
    #[arg(long, value_name = "WHAT", default_value = "map", requires = "output", help_heading = "Figure")]
    draw: Draw,
    #[command(flatten)]
    drawing: Drawing,
}

/// What to draw of a map.
#[derive(ValueEnum, Clone, Copy, Debug)]
enum Draw {
    /// The faces
    Map,
    /// A node for each face, a line for each pair of neighbours
    Dual,
    /// The faces that lead nowhere else, and the way out of them
    DeadEnds,
}

/// The answer. The names are those of the JSON form.
#[derive(Default, Serialize)]
struct Info {
    source: String,
    format: &'static str,
    valid: bool,
    faces: usize,
    triangles: usize,
    vertices: usize,
    portals: usize,
    hole_faces: usize,
    components: Vec<usize>,
    dead_ends: usize,
    junctions: usize,
    reduced_corridors: usize,
    area: f64,
    /// Faces that nobody may enter.
    blocked_faces: usize,
    blocked_area: f64,
    walkable_area: f64,
    double_corners: usize,
    faults: Vec<Told>,
}

pub(super) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    let target = args.drawing.target(&args.map.file)?;
    let draft = match args.map.look(matches!(args.draw, Draw::Map) && !args.map.obstacles.are_given())? {
        Input::Plane(draft) => *draft,
        Input::Space(ground) => {
            let title = args.map.title();
            return space::info::run(&ground, args.json, target.as_ref(), &title, out);
        }
    };
    let mut told = Vec::new();
    if let Some((soup, format)) = draft.polygons() {
        let frame = args.map.frame(format);
        told.extend(draft.faults.iter().map(|fault| Told::of(fault, soup, frame)));
        // What is not convex can be cut up; the rest keeps a map from being made.
        let cut_up = |kind| args.map.cuts_up() && kind == "not-convex";
        if told.iter().any(|fault| !fault.warning && !cut_up(fault.kind)) {
            return refuse(args, format.name(), told, out);
        }
        told.retain(|fault| !cut_up(fault.kind));
    }
    let map = args.map.finish(draft, &[])?;
    if let Some(target) = &target {
        let floor = Floor::new(&map.subdivision, &map.mesh);
        let title = args.map.title();
        let drawn = match args.draw {
            Draw::Map => figure::structure(&map.subdivision, &target.options(&map, &title)).map_err(Into::into),
            Draw::Dual => floor.dual(&target.options(&map, &format!("Dual graph of {title}"))),
            Draw::DeadEnds => floor.dead_ends(&target.options(&map, &format!("Dead ends of {title}"))),
        };
        save(target, drawn, out)?;
    }
    let info = Info::of(&map, told);
    tell(&info, args.json, out, |out| info.print(out))
}

/// The answer for what is no map.
fn refuse(args: &Args, format: &'static str, faults: Vec<Told>, out: &mut Output) -> Result<Answer, Failure> {
    if args.json {
        let info = Info { source: args.map.source(), format, faults, ..Info::default() };
        out.json(&info)?;
    } else {
        faults.iter().try_for_each(|fault| fault.print(out))?;
        tell_helps(&faults);
        let wrong = faults.iter().filter(|fault| !fault.warning).count();
        writeln!(out, "{}: not a navmesh, {}", args.map.source(), counted(wrong, "fault", "faults"))?;
    }
    Ok(Answer::No)
}

impl Info {
    fn of(map: &Map, faults: Vec<Told>) -> Self {
        let mesh = &map.mesh;
        let mut components: Vec<usize> = mesh.components().map(|(_, faces)| faces).collect();
        components.sort_unstable_by(|a, b| b.cmp(a));
        let area = |blocked| mesh.area(mesh.faces().filter(|&f| mesh.is_blocked(f) == blocked));
        Self {
            source: map.source.clone(),
            format: map.format.name(),
            valid: true,
            faces: mesh.face_count(),
            triangles: mesh.faces().filter(|&f| mesh.corners(f).len() == 3).count(),
            vertices: map.subdivision.vertex_count(),
            portals: mesh.faces().map(|f| mesh.neighbours(f).filter(|&g| f < g).count()).sum(),
            hole_faces: map.subdivision.hole_faces().count(),
            components,
            dead_ends: mesh.faces().filter(|&f| mesh.is_dead_end(f)).count(),
            junctions: mesh.junctions().len(),
            reduced_corridors: mesh.reduced_corridors().len(),
            area: mesh.area(mesh.faces()),
            blocked_faces: mesh.faces().filter(|&f| mesh.is_blocked(f)).count(),
            blocked_area: area(true),
            walkable_area: area(false),
            double_corners: double_corners_of(&map.subdivision).len(),
            faults,
        }
    }

    fn print(&self, out: &mut Output) -> io::Result<()> {
        writeln!(out, "{}: {}, a navmesh", self.source, self.format)?;
        let mut line = |what: &str, value: String| writeln!(out, "  {what:<16}{value}");
        line("faces", format!("{} ({})", self.faces, counted(self.triangles, "triangle", "triangles")))?;
        line("vertices", self.vertices.to_string())?;
        line("portals", self.portals.to_string())?;
        line("hole faces", self.hole_faces.to_string())?;
        let nothing = self.components.is_empty();
        line("components", if nothing { "0, nothing is walkable".to_owned() } else { sizes(&self.components) })?;
        let (peeled, left) =
            (counted(self.dead_ends, "face", "faces"), self.faces - self.dead_ends - self.blocked_faces);
        line("dead ends", format!("{peeled} peeled, {left} left"))?;
        let reduced = counted(self.reduced_corridors, "reduced corridor", "reduced corridors");
        line("junctions", format!("{}, and {reduced}", self.junctions))?;
        line("area", Number(self.area).to_string())?;
        if self.blocked_faces > 0 {
            let blocked = counted(self.blocked_faces, "face", "faces");
            line("blocked", format!("{blocked}, area {}", Number(self.blocked_area)))?;
            line("walkable area", Number(self.walkable_area).to_string())?;
        }
        line("double corners", self.double_corners.to_string())?;
        self.faults.iter().try_for_each(|fault| fault.print(out))
    }
}
