//! From a file to a map with its navmesh.

use super::super::failure::{Failure, say};
use super::super::picture::title;
use super::areas::{Area, Names, cut_along};
use super::map::{Frame, Level, Map};
use super::numbers::above;
use super::obstacles::ObstacleArgs;
use super::space::{Ground, surface_failure};
use super::tell::Told;
use clap::ValueEnum;
use dcel_kit::FaceId;
use dcel_kit::io::{
    Axis, Document, Format, Grid, LoadOptions, Number, PolygonSoup, Read, ReadOptions, Structure, assemble, counted,
    read_path, read_whole, source_name,
};
use dcel_kit::navmesh::{MeshFault, NavMesh, NavMeshError, NavSurface, Planner, Welded, mesh_faults, weld_in_space};
use dcel_kit::plane::predicates::orientation;
use dcel_kit::plane::{Point, Subdivision, TriangulateError, TriangulationMethod};
use dcel_kit::topology::{Mode, PolygonList};
use std::borrow::Cow;
use std::path::{Path, PathBuf};

/// The map, and how to read it.
#[derive(clap::Args, Debug, Default)]
pub(super) struct MapArgs {
    /// The map, or - for standard input
    #[arg(value_name = "MAP")]
    pub(super) file: PathBuf,
    /// The format, if the file name does not say
    #[arg(long, value_name = "FORMAT", help_heading = "Reading")]
    format: Option<Format>,
    /// y points down in the file, as on screens; of a .map that is known
    #[arg(long, help_heading = "Reading")]
    y_down: bool,
    /// The axis that points up, of a floor in space. Where heights differ, `path`, `distances`, `locate`,
    /// `raycast`, `random` and `info` measure along the surface and know storeys over each other; `neighbours`
    /// and `scenario` look at the plan, and so does whatever gets a --radius, --wall or --obstacle. Of storeys
    /// over each other the plan shows one: --layer says which
    #[arg(long, value_name = "AXIS", conflicts_with = "y_down", help_heading = "Reading")]
    up: Option<Up>,
    /// Leave out faces that are steeper than this, and those that face down: of a whole house that leaves
    /// its floors
    #[arg(long, value_name = "DEGREES", value_parser = super::numbers::number, requires = "up", help_heading = "Reading")]
    max_slope: Option<f64>,
    /// Look at the plan of one layer alone, where storeys lie over each other; dcel navmesh info tells the
    /// layers
    #[arg(long, value_name = "N", value_parser = crate::choice::whole::<usize>, requires = "up", help_heading = "Reading")]
    layer: Option<usize>,
    /// Turn round faces that run clockwise
    #[arg(long, help_heading = "Reading")]
    orient: bool,
    /// Split polygons and segments where they cross, touch or overlap; reports what was done
    #[arg(long, help_heading = "Reading")]
    mend: bool,
    /// Join vertices that are no further apart than this, and put vertices into sides that they are on or
    /// no further beside; faces that are not convex then are cut into triangles. Tells what was done. 0
    /// joins what lies at the same place, and mends T-junctions. With --up it is measured in space: storeys
    /// stay apart
    #[arg(long, value_name = "D", value_parser = super::numbers::number, allow_negative_numbers = true, help_heading = "Reading")]
    weld: Option<f64>,
    /// Cut all faces into triangles without needless slivers (constrained Delaunay); a .map is cut along the
    /// borders of its regions. Where very many long walls stand side by side, the time grows with their square,
    /// and more
    #[arg(long, help_heading = "Reading")]
    triangles: bool,
    #[command(flatten)]
    pub(super) obstacles: ObstacleArgs,
}

/// What a search runs over.
#[derive(clap::Args, Debug)]
pub(super) struct Preparation {
    /// Search the faces of the map one by one, and not larger faces that are merged from them and whole
    /// reduced corridors: as good an answer, with more work; to compare
    #[arg(long)]
    face_by_face: bool,
    /// Once asked for what is done by itself now
    #[arg(long, hide = true, conflicts_with = "face_by_face")]
    merged: bool,
}

impl Preparation {
    /// A planner that searches so.
    pub(super) fn planner(&self) -> Planner {
        if self.merged {
            say("note", "--merged is not needed any more: faces are merged, and junctions found, by themselves");
        }
        if self.face_by_face { Planner::face_by_face() } else { Planner::new() }
    }
}

/// Which axis points up.
#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Debug)]
enum Up {
    X,
    Y,
    Z,
}

/// What a file is: a map of the plane, or a surface in space.
pub(super) enum Input {
    Plane(Box<Draft>),
    Space(Box<Ground>),
}

/// What was read, before it is a map.
pub(super) struct Draft {
    source: Source,
    /// What is wrong with the polygons as a navmesh.
    pub(super) faults: Vec<MeshFault>,
    /// How high the polygons lie in space, if all of them are level.
    level: Option<Level>,
}

enum Source {
    /// The regions of a grid map.
    Regions(Subdivision),
    /// Anything else. Polygons are not joined yet.
    Read(Read),
}

impl Draft {
    fn new(source: Source) -> Self {
        Self { source, faults: Vec::new(), level: None }
    }

    /// The polygons of the file, if it has such, and its format.
    pub(super) fn polygons(&self) -> Option<(&PolygonSoup, Format)> {
        match &self.source {
            Source::Read(Read { document: Document::Polygons(soup), format, .. }) => Some((soup, *format)),
            _ => None,
        }
    }
}

impl MapArgs {
    /// The map of a file, read without any option.
    pub(super) fn of(file: &Path) -> Self {
        Self { file: file.to_owned(), ..Self::default() }
    }

    /// How the file has its coordinates.
    pub(super) fn frame(&self, format: Format) -> Frame {
        Frame { down: format == Format::Map || self.y_down || self.up == Some(Up::Y) }
    }

    /// What figures and messages call the map.
    pub(super) fn title(&self) -> String {
        title(&self.file, "the map")
    }

    pub(super) fn source(&self) -> String {
        source_name(&self.file)
    }

    /// Whether faces are cut into triangles, all or those that are not convex, so that they need not be.
    pub(super) fn cuts_up(&self) -> bool {
        self.triangles || self.weld.is_some()
    }

    /// How many cells the map is wide and high, if it was read from a grid map that can be read again.
    pub(super) fn cells(&self, map: &Map) -> Option<[u32; 2]> {
        let again = map.format == Format::Map && self.file != Path::new("-");
        let grid = again.then(|| read_whole(&self.file).ok()).flatten();
        grid.and_then(|bytes| Grid::parse(&bytes, &map.source).ok()).map(|grid| [grid.width(), grid.height()])
    }

    fn is_grid(&self) -> bool {
        self.format.or_else(|| Format::from_path(&self.file)) == Some(Format::Map)
    }

    /// Reads the file as a map of the plane. Tells the notes.
    pub(super) fn read(&self) -> Result<Draft, Failure> {
        match self.read_as(false)? {
            Input::Plane(draft) => Ok(*draft),
            Input::Space(ground) => Err(Failure::kit(format!("{} was asked for as a map of the plane", ground.source))),
        }
    }

    /// Reads the file. With `space`, a floor whose heights differ is read as a surface. Tells the notes, and what nearly
    /// meets on a surface.
    pub(super) fn read_as(&self, space: bool) -> Result<Input, Failure> {
        let input = self.look(space)?;
        if let Input::Space(ground) = &input {
            let near = ground.faults.iter();
            warn_of(&near.map(|(place, fault)| (Told::at(place.clone(), fault), fault)).collect::<Vec<_>>());
        }
        Ok(input)
    }

    /// The same without a word about what nearly meets.
    pub(super) fn look(&self, space: bool) -> Result<Input, Failure> {
        let plane = |draft| Ok(Input::Plane(Box::new(draft)));
        if self.is_grid() {
            self.refuse_on_grid()?;
        }
        if self.is_grid() && self.triangles {
            let grid = Grid::parse(&read_whole(&self.file)?, &self.source())?;
            let regions = grid.regions().map_err(|error| Failure::about(self.source(), error))?;
            return plane(Draft::new(Source::Regions(regions)));
        }
        let options = ReadOptions {
            y_down: self.y_down,
            format: self.format,
            drop_degenerate_rings: self.mend,
            keep_inner_rings: self.mend,
            close_rings: self.mend,
            ..ReadOptions::default()
        };
        let mut read = read_path(&self.file, &options)?;
        if read.format == Format::Map {
            self.refuse_on_grid()?;
        }
        if self.mend && matches!(read.document, Document::Table(_)) {
            let what =
                format!("{}: --mend cannot be used on {}: it is for polygons and segments", self.source(), read.format);
            return Err(Failure::input(what, "leave --mend out; dcel validate names what is broken"));
        }
        let Document::Polygons(soup) = &mut read.document else {
            let given = [("--weld", self.weld.is_some()), ("--orient", self.orient), ("--up", self.up.is_some())];
            if let Some((flag, _)) = given.into_iter().find(|&(_, is_given)| is_given) {
                let what = format!("{}: {flag} cannot be used on {}: it is for polygons", self.source(), read.format);
                return Err(Failure::input(what, format!("leave {flag} out")));
            }
            return plane(Draft::new(Source::Read(read)));
        };
        let in_space = soup.has_z;
        let mut level = None;
        match self.up() {
            Some(up) => {
                soup.stand_up(up);
                level = level_of(soup, up);
                if let Some(distance) = self.weld.filter(|_| soup.has_z) {
                    self.join(soup, distance)?;
                }
                if soup.has_z && space && self.layer.is_none() {
                    return self.ground(read, up).map(|ground| Input::Space(Box::new(ground)));
                }
                if soup.has_z {
                    self.look_at_plan(soup)?;
                } else if let Some(layer) = self.layer.filter(|&layer| layer > 0) {
                    return Err(no_layer(&self.source(), layer, 1));
                }
                soup.lay_flat(Axis::Z);
                soup.places.set_y_down(up == Axis::Y);
            }
            None if soup.has_z => {
                let what = format!("{}: this is a surface in space", self.source());
                return Err(Failure::input(
                    what,
                    "say which axis points up: --up y in many drawing programs, else --up z",
                ));
            }
            None => {}
        }
        if let Some(distance) = self.weld.filter(|_| !in_space) {
            self.join(soup, distance)?;
        }
        // What is mended is judged afterwards.
        let faults = if self.mend { Vec::new() } else { faults_of(&with_touching_corners(soup), self.orient) };
        plane(Draft { source: Source::Read(read), faults, level })
    }

    /// Refuses what can do nothing with the cells of a grid map.
    fn refuse_on_grid(&self) -> Result<(), Failure> {
        let fit = "cells always fit together";
        let flags = [
            ("--mend", self.mend, fit),
            ("--weld", self.weld.is_some(), fit),
            ("--orient", self.orient, "cells always run counter-clockwise"),
            ("--up", self.up.is_some(), "cells lie in the plane and have no heights"),
        ];
        let Some((flag, _, why)) = flags.into_iter().find(|&(_, is_given, _)| is_given) else { return Ok(()) };
        // What cannot be given without it goes with it.
        let with_it = [("--max-slope", self.max_slope.is_some()), ("--layer", self.layer.is_some())];
        let with_it = with_it.into_iter().filter(|&(_, is_given)| flag == "--up" && is_given);
        let all: Vec<&str> = std::iter::once(flag).chain(with_it.map(|(other, _)| other)).collect();
        let what = format!("{}: {flag} cannot be used on a grid map: {why}", self.source());
        Err(Failure::input(what, format!("leave {} out", all.join(" and "))))
    }

    /// Welds polygons. Tells what was done.
    fn join(&self, soup: &mut PolygonSoup, distance: f64) -> Result<(), Failure> {
        if distance < 0.0 {
            return Err(Failure::input(format!("a distance of {distance}"), "give a number such as --weld 0.001"));
        }
        let welded = weld_in_space(&soup.points, &soup.faces, distance);
        let Welded { joined, inserted, collapsed, farthest, .. } = welded;
        if joined + inserted == 0 {
            say("note", format_args!("nothing to weld: nothing is closer than {} without being one", Number(distance)));
            return Ok(());
        }
        let joined = counted(joined, "vertex was joined with another", "vertices were joined with others");
        let inserted = counted(inserted, "corner was put into a side", "corners were put into sides");
        let how_far = if farthest > 0.0 { format!("{farthest:.2e} apart at most") } else { "all in place".to_owned() };
        say("note", format_args!("welded: {joined}, {inserted}, {how_far}"));
        if collapsed > 0 {
            let gone = counted(collapsed, "face is gone: it was", "faces are gone: they were");
            say("note", format_args!("{gone} no wider than that"));
        }
        *soup = soup.with_faces(welded.faces, &welded.origins);
        Ok(())
    }

    /// The axis that points up.
    fn up(&self) -> Option<Axis> {
        self.up.map(|up| match up {
            Up::X => Axis::X,
            Up::Y => Axis::Y,
            Up::Z => Axis::Z,
        })
    }

    /// A floor whose heights differ, as a surface.
    fn ground(&self, mut read: Read, up: Axis) -> Result<Ground, Failure> {
        let source = self.source();
        if self.mend {
            let why = "it is for polygons and segments of the plane";
            let what = format!("{source}: --mend cannot be used on a floor whose heights differ: {why}");
            return Err(Failure::input(what, "leave --mend out; --weld 0.001 joins what nearly meets"));
        }
        read.notes.iter().for_each(|note| say("note", note));
        let Document::Polygons(soup) = &mut read.document else {
            return Err(Failure::kit(format!("{source}: a surface is made of polygons")));
        };
        if self.orient {
            soup.turn_up();
        }
        let surface = NavSurface::new(&soup.points, &soup.faces, self.max_slope)
            .map_err(|error| surface_failure(&source, soup, &error))?;
        let near = surface.near_misses();
        let faults = near.iter().map(|fault| (near_place(soup, fault), fault.clone())).collect();
        Ok(Ground { source, format: read.format, up, surface, names: Names::of(soup), faults })
    }

    /// Makes the plan of a floor whose heights differ, or of one of its layers. What is too steep is left out.
    fn look_at_plan(&self, soup: &mut PolygonSoup) -> Result<(), Failure> {
        let source = self.source();
        let surface = match NavSurface::new(&soup.points, &soup.faces, self.max_slope) {
            Ok(surface) => surface,
            // What the plan says of it is as good.
            Err(_) if self.max_slope.is_none() && self.layer.is_none() => return Ok(()),
            Err(error) => return Err(surface_failure(&source, soup, &error)),
        };
        let layers = surface.layer_count();
        if let Some(layer) = self.layer.filter(|&layer| layer >= layers) {
            return Err(no_layer(&source, layer, layers));
        }
        if layers > 1 && self.layer.is_none() {
            let what = format!("{source}: {layers} storeys lie over each other: this looks at the plan");
            let help = format!(
                "choose one with --layer 0 to --layer {}, which dcel navmesh info tells; without --radius, --wall and \
                 --obstacle, dcel navmesh path, distances, locate, raycast, random and info measure along the surface",
                layers - 1
            );
            return Err(Failure::input(what, help));
        }
        say("note", "heights differ: what is told here is measured in the plan, and not along the surface");
        let layer = |f: u32| surface.layer(FaceId::new(f + 1));
        let is_kept = |&f: &u32| layer(f).is_some_and(|own| self.layer.is_none_or(|layer| layer == own));
        let count = soup.faces.face_count();
        let kept: Vec<u32> = (0..count as u32).filter(is_kept).collect();
        if kept.len() < count {
            // They may stand upright, or lie over what is kept: in the plan they have no place.
            let mut faces = PolygonList::new();
            kept.iter().for_each(|&f| faces.push_face(soup.faces.cycle(soup.faces.cycle_range(f as usize).start)));
            *soup = soup.with_faces(faces, &kept);
            let left_out = counted(count - kept.len(), "face is left out", "faces are left out");
            say(
                "note",
                format_args!("{left_out} of {count}: f1, f2 and so on are the others, in the order of the file"),
            );
        }
        Ok(())
    }

    /// Reads the file and makes a map of it. Tells what nearly meets.
    pub(super) fn open(&self) -> Result<Map, Failure> {
        self.open_draft(self.read()?, &[])
    }

    /// Makes a map of what was read, cut along the sides of areas. Tells what nearly meets.
    pub(super) fn open_draft(&self, draft: Draft, areas: &[Area]) -> Result<Map, Failure> {
        if let Some((soup, format)) = draft.polygons() {
            let faults = &draft.faults;
            let near = faults.iter().filter(|fault| fault.kind() == "nearly-welded");
            let frame = self.frame(format);
            let told = |fault| Told::of(fault, soup, frame);
            warn_of(&near.map(|fault| (told(fault), fault)).collect::<Vec<_>>());
            // The same advice as dcel navmesh info has for it.
            if let Some(help) = faults.iter().filter(|fault| is_unwelded(fault)).find_map(|f| told(f).help) {
                let mended = |failure: Failure| match failure.help() {
                    own if own.contains("--mend") => {
                        failure.helped_by(&format!("{help}; --mend cuts the polygons where they meet"))
                    }
                    _ => failure,
                };
                return self.finish(draft, areas).map_err(mended);
            }
        }
        self.finish(draft, areas)
    }

    /// Makes a map of what was read, cut along the sides of areas.
    pub(super) fn finish(&self, draft: Draft, areas: &[Area]) -> Result<Map, Failure> {
        let source = self.source();
        // Polygons that are mended are no faces of the file any more.
        let polygons = draft.polygons().filter(|_| !self.mend);
        let mut names = polygons.map_or_else(Names::default, |(soup, _)| Names::of(soup));
        let level = draft.level;
        let (mut subdivision, format) = match draft.source {
            Source::Regions(regions) => (regions, Format::Map),
            Source::Read(read) => {
                let format = read.format;
                let mode = Some(Mode::Plane);
                let options = LoadOptions { mode, orient: self.orient, mend: self.mend, ..LoadOptions::default() };
                let loaded = assemble(read, &source, &options)?;
                loaded.notes.iter().for_each(|note| say("note", note));
                match loaded.structure {
                    Structure::Plane(subdivision) => (subdivision, format),
                    other => return Err(Failure::kit(format!("{source}: {other:?} is no plane"))),
                }
            }
        };
        if !names.is_empty() && !areas.is_empty() {
            names.remember(&subdivision);
        }
        if self.weld.is_some() && !self.triangles {
            cut_bent_faces(&mut subdivision).map_err(|error| Failure::about(&source, error))?;
        }
        if self.triangles {
            // Slivers lead astray whoever goes from portal to portal.
            let cut = subdivision.triangulate(TriangulationMethod::Delaunay);
            cut.map_err(|error| Failure::about(&source, error))?;
        }
        let frame = self.frame(format);
        cut_along(areas, &source, &mut subdivision, |p| frame.point(p))?;
        let mesh = NavMesh::new(&subdivision).map_err(|error| {
            let failure = Failure::refused(&source, error);
            match error {
                NavMeshError::Concave { .. } | NavMeshError::Rings { .. } => {
                    failure.helped_by("cut the faces up with --triangles")
                }
                _ => failure,
            }
        })?;
        let map = Map { source, format, subdivision, mesh, names, known_costs: None, frame, level };
        if !self.obstacles.are_given() {
            return Ok(map);
        }
        let costs = map.costs(areas)?;
        let Map { source, subdivision, names, .. } = map;
        let put = self.obstacles.put_in(&source, subdivision, costs.as_ref(), frame);
        let (subdivision, mesh, known_costs) = put?;
        Ok(Map { source, format, subdivision, mesh, names, known_costs, frame, level })
    }
}

/// How high polygons lie that stand upright with their third coordinate as the height, if all of them are level.
fn level_of(soup: &PolygonSoup, up: Axis) -> Option<Level> {
    let &[_, _, height] = soup.points.first().filter(|_| !soup.has_z)?;
    let size = soup.points.iter().flatten().fold(0.0f64, |most, x| most.max(x.abs()));
    Some(Level { up, height, slack: 1e-9 * size })
}

fn no_layer(source: &str, layer: usize, layers: usize) -> Failure {
    let count = counted(layers, "layer", "layers");
    let are = if layers == 1 { "is" } else { "are" };
    let what = format!("{source}: there is no layer {layer}: there {are} {count}, counted from 0");
    Failure::input(what, "dcel navmesh info tells the layers")
}

/// Cuts faces into triangles that are not convex any more, since a corner was put into a side.
fn cut_bent_faces(map: &mut Subdivision) -> Result<(), TriangulateError> {
    let is_bent = |f: &FaceId| {
        let corners: Vec<Point> = map.incident_vertices(*f).map(|v| map.point(v)).collect();
        let n = corners.len();
        (0..n).any(|k| orientation(corners[k], corners[(k + 1) % n], corners[(k + 2) % n]).is_lt())
    };
    let domain =
        map.faces().filter(|&f| f != map.outer_face() && !map.is_hole(f) && map.inner_components(f).is_empty());
    let bent: Vec<FaceId> = domain.filter(is_bent).collect();
    for &f in &bent {
        map.triangulate_face(f, TriangulationMethod::default())?;
    }
    if !bent.is_empty() {
        let faces = counted(bent.len(), "face is not convex and was", "faces are not convex and were");
        say("note", format_args!("{faces} cut into triangles"));
    }
    Ok(())
}

/// Where in its file the later vertex of two that nearly meet stands.
fn near_place(soup: &PolygonSoup, fault: &MeshFault) -> String {
    fault.vertices().last().map(|&v| soup.places.vertex(v as usize)).unwrap_or_default()
}

/// Whether welding mends a fault.
fn is_unwelded(fault: &MeshFault) -> bool {
    matches!(fault, MeshFault::TJunction { .. } | MeshFault::SamePlace { .. })
}

/// Warns of what nearly meets.
fn warn_of(near: &[(Told, &MeshFault)]) {
    const SHOWN: usize = 3;
    for (Told { place, message, .. }, _) in near.iter().take(SHOWN) {
        say("warning", format_args!("{place}: {message}"));
    }
    if near.len() > SHOWN {
        say("warning", format_args!("{} more are nearly welded; dcel navmesh info names them", near.len() - SHOWN));
    }
    let distance = |(_, fault): &(Told, &MeshFault)| match fault {
        MeshFault::NearVertices { distance, .. } | MeshFault::NearSide { distance, .. } => *distance,
        _ => 0.0,
    };
    if let Some(widest) = near.iter().map(distance).reduce(f64::max) {
        say("help", format_args!("--weld {} joins them", Number(above(widest))));
    }
}

/// The polygons with a corner wherever a vertex of another one lies inside a side, in formats with coordinates only:
/// these cannot say so, and the converter puts it there, with a note.
fn with_touching_corners(soup: &PolygonSoup) -> Cow<'_, PolygonSoup> {
    if !soup.any_direction {
        return Cow::Borrowed(soup);
    }
    let Welded { inserted, collapsed, faces, origins, .. } = weld_in_space(&soup.points, &soup.faces, 0.0);
    if inserted > 0 && collapsed == 0 { Cow::Owned(soup.with_faces(faces, &origins)) } else { Cow::Borrowed(soup) }
}

/// What is wrong with polygons as a navmesh; clockwise ones are no fault if they are to be turned.
fn faults_of(soup: &PolygonSoup, orient: bool) -> Vec<MeshFault> {
    let points: Vec<Point> = soup.points.iter().map(|&[x, y, _]| Point::new(x, y)).collect();
    let may_turn = orient || soup.any_direction;
    let faults = mesh_faults(&points, &soup.faces, &soup.blocked);
    if !may_turn || !faults.iter().any(|fault| matches!(fault, MeshFault::Clockwise { .. })) {
        return faults;
    }
    let mut turned = soup.faces.clone();
    for fault in &faults {
        if let MeshFault::Clockwise { face } = fault {
            let outline = turned.cycle_range(*face as usize).start;
            turned.cycle_mut(outline).reverse();
        }
    }
    mesh_faults(&points, &turned, &soup.blocked)
}
