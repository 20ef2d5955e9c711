//! What a session plays with, and where it comes from.
//!
//! ```text
//!   rectangle, polygon, script, file ──▶ Plane     a Subdivision with its history
//!   cube, dodecahedron …  (Schlegel) ──▶ Plane
//!   torus, a script without places   ──▶ Kernel    a Dcel with its history
//!   points                           ──▶ Points    their triangulation, made anew for every place
//! ```

use super::edits::Workshop;
use super::points::Points;
use crate::figure::{Figure, FigureError, FigureOptions, Film};
use crate::ids::FaceMap;
use crate::io::{Format, LoadOptions, Model, ReadOptions, Structure, assemble, points_from_text, read_bytes, write};
use crate::plane::{Point, Subdivision};
use crate::script::{Ground, Script};
use crate::solid::{Platonic, Polyhedron};
use crate::topology::{Dcel, Table, View};
use std::path::Path;

/// Larger files are not read.
const LARGEST: usize = 5 << 20;
/// Larger structures are not taken.
const EDGES: usize = 20_000;
/// Between the parts of a kept scene.
const PART: char = '\u{1e}';

/// What a session plays with.
#[derive(Clone, Debug)]
pub(super) enum Scene {
    Plane { work: Box<Workshop<Subdivision>>, names: FaceMap<Option<String>> },
    Kernel(Box<Workshop<Dcel>>),
    Points(Box<Points>),
}

/// A scene, and what there is to say about how it was made.
pub(super) type Made = (Scene, Vec<String>);

impl Scene {
    /// The lab's rectangle.
    pub(super) fn rectangle() -> Self {
        Self::plane("rectangle", Subdivision::lab_rectangle())
    }

    fn plane(line: impl Into<String>, start: Subdivision) -> Self {
        Self::Plane { work: Box::new(Workshop::new(line, start)), names: FaceMap::default() }
    }

    /// A structure of the plane, whose start is said by a line of the script if one can say it.
    pub(super) fn of_plane(start: Subdivision, source: &str) -> Self {
        let line = start_line(&start).unwrap_or_else(|| {
            format!("# the start is {source}: no line of a script says it, so save the scene as .dcel or as a link")
        });
        Self::plane(line, start)
    }

    /// A scene to begin with.
    pub(super) fn start(what: &str) -> Result<Made, String> {
        if let Some(solid) = Platonic::ALL.into_iter().find(|solid| solid.name() == what) {
            let polyhedron = Polyhedron::platonic(solid);
            return schlegel(&polyhedron, what)
                .map(|scene| (scene, vec![format!("the {what} seen through one of its faces: its Schlegel diagram")]));
        }
        let scene = match what {
            "rectangle" => Self::rectangle(),
            "torus" => Self::Kernel(Box::new(Workshop::new("torus", Dcel::torus()))),
            "points" => {
                let places = [(0., 0.), (5., -1.), (8., 3.), (6., 6.), (1., 5.), (3., 2.), (5., 3.5)];
                Self::Points(Box::new(Points::new(places.map(Point::from).to_vec())?))
            }
            _ => {
                return Err(format!(
                    "there is no start `{what}`; known: rectangle, torus, points, cube and the other regular solids"
                ));
            }
        };
        Ok((scene, Vec::new()))
    }

    /// A polygon whose corners were clicked, either way round.
    pub(super) fn polygon(corners: &[Point]) -> Result<Self, String> {
        let mut turned = corners.to_vec();
        turned.reverse();
        let (corners, built) = match Subdivision::polygon(corners) {
            Ok(built) => (corners.to_vec(), built),
            Err(error) => (turned.clone(), Subdivision::polygon(&turned).map_err(|_| error.to_string())?),
        };
        let line: String = corners.iter().map(|p| format!(" {} {}", p.x, p.y)).collect();
        Ok(Self::plane(format!("polygon{line}"), built))
    }

    /// A whole script.
    pub(super) fn script(text: &str, source: &str) -> Result<Made, String> {
        let first = text.lines().map(|line| line.split('#').next().unwrap_or("").trim()).find(|line| !line.is_empty());
        let first = first.unwrap_or_default();
        let (scene, refused) = match Ground::of(text) {
            Ground::Plane => {
                let script = Script::parse(text, source).map_err(|error| error.to_string())?;
                let (work, refused) = Workshop::of_script(first, &script);
                (Self::Plane { work: Box::new(work), names: FaceMap::default() }, refused)
            }
            Ground::Kernel => {
                let script = Script::parse_kernel(text, source).map_err(|error| error.to_string())?;
                let (work, refused) = Workshop::of_script(first, &script);
                (Self::Kernel(Box::new(work)), refused)
            }
            Ground::Space => {
                let script = Script::parse_solid(text, source).map_err(|error| error.to_string())?;
                let end = script.run().end;
                let note = "a script in space: its result is shown as a Schlegel diagram".to_owned();
                (schlegel(&end, source)?, vec![note])
            }
        };
        scene.small_enough()?;
        let refused = refused.into_iter().map(|line| format!("refused, and left out: {line}"));
        Ok((scene, refused.collect()))
    }

    /// A file of any format, told by its name, else by its contents.
    pub(super) fn file(name: &str, bytes: &[u8]) -> Result<Made, String> {
        if bytes.len() > LARGEST {
            return Err(format!(
                "{name} has {:.1} MB: the playground takes files up to {} MB; `dcel figure` draws any size",
                bytes.len() as f64 / f64::from(1 << 20),
                LARGEST >> 20
            ));
        }
        let text = std::str::from_utf8(bytes).ok();
        let path = Path::new(name);
        let ends_in = |end: &str| path.extension().is_some_and(|known| known.eq_ignore_ascii_case(end));
        if let Some(text) = text
            && (ends_in("dcels") || Ground::begun(text).is_some())
        {
            return Self::script(text, name);
        }
        let format = Format::from_path(path).filter(|format| format.can_read()).or_else(|| Format::from_content(bytes));
        let Some(format) = format else {
            if let Ok(list) = points_from_text(bytes, name)
                && !list.points.is_empty()
            {
                return Ok((Self::Points(Box::new(Points::new(list.points)?)), list.notes));
            }
            return Err(format!(
                "{name}: this is no drawing that the kit can read; it reads .dcel, .obj, .off, .ply, .stl, .geojson, .topojson, .wkt, .poly and .mesh files, points as `x y` lines, and scripts"
            ));
        };
        let options = LoadOptions {
            read: ReadOptions { format: Some(format), ..ReadOptions::default() },
            ..LoadOptions::default()
        };
        let read = read_bytes(bytes, format, name, &options.read).map_err(|error| error.to_string())?;
        let loaded = assemble(read, name, &options).map_err(|error| error.to_string())?;
        let mut notes = loaded.notes;
        let scene = match loaded.structure {
            Structure::Plane(subdivision) => {
                let mut scene = Self::of_plane(subdivision, name);
                if let Self::Plane { names, .. } = &mut scene {
                    *names = loaded.names;
                }
                scene
            }
            Structure::Surface(surface) => match schlegel(&surface, name) {
                Ok(scene) => {
                    notes.push("a surface in space: shown as a Schlegel diagram".to_owned());
                    scene
                }
                Err(reason) => {
                    notes.push(format!("a surface in space, without its places: {reason}"));
                    Self::of_kernel(surface.topology().clone(), name)
                }
            },
        };
        scene.small_enough()?;
        Ok((scene, notes))
    }

    fn of_kernel(start: Dcel, source: &str) -> Self {
        let line =
            format!("# the start is {source}: no line of a script says it, so save the scene as .dcel or as a link");
        Self::Kernel(Box::new(Workshop::new(line, start)))
    }

    fn small_enough(&self) -> Result<(), String> {
        let edges = match self {
            Self::Plane { work, .. } => work.now().edge_count(),
            Self::Kernel(work) => work.now().edge_count(),
            Self::Points(_) => 0,
        };
        if edges > EDGES {
            return Err(format!("{edges} edges: the playground takes up to {EDGES}; `dcel figure` draws any number"));
        }
        Ok(())
    }

    /// All pointers, with positions and names where there are some.
    pub(super) fn table(&self) -> Table {
        match self {
            Self::Plane { work, names } => {
                let mut table = Table::from_planar_view(work.now());
                if !names.is_empty() {
                    let gone = work.removed_faces();
                    for (f, row) in table.faces.iter_mut().enumerate() {
                        let f = crate::ids::FaceId::new(f as u32);
                        let name = names.get(f).cloned().flatten().filter(|_| !gone.contains(&f));
                        row.iter_mut().for_each(|row| row.name.clone_from(&name));
                    }
                }
                table
            }
            Self::Kernel(work) => Table::from_view(work.now()),
            Self::Points(points) => Table::from_planar_view(points.delaunay()),
        }
    }

    /// The subdivision, if there is one.
    pub(super) fn subdivision(&self) -> Option<&Subdivision> {
        match self {
            Self::Plane { work, .. } => Some(work.now()),
            Self::Kernel(_) => None,
            Self::Points(points) => Some(points.delaunay()),
        }
    }

    /// The scene as a text that [`remade`](Self::remade) reads.
    pub(super) fn kept(&self) -> String {
        let parts = |kind: &str, start: String, edits: Vec<String>| {
            [kind.to_owned(), start, edits.join("\n")].join(&PART.to_string())
        };
        match self {
            Self::Plane { work, .. } if work.is_script() => parts("plane", work.start_line().to_owned(), work.kept()),
            Self::Plane { work, names } => {
                let model = Model::planar(work.start()).with_names(|f| names.get(f)?.as_deref());
                parts("dcel", format!("{}\n{}", work.start_line(), dcel_text(&model)), work.kept())
            }
            Self::Kernel(work) if work.is_script() => parts("kernel", work.start_line().to_owned(), work.kept()),
            Self::Kernel(work) => {
                let table = Table::from_view(work.start());
                parts("surface", format!("{}\n{}", work.start_line(), dcel_text(&Model::table(&table))), work.kept())
            }
            Self::Points(points) => {
                let lines: Vec<String> = points.points().iter().map(|p| format!("{} {}", p.x, p.y)).collect();
                parts("points", lines.join("\n"), vec![points.layer.word().to_owned()])
            }
        }
    }

    /// The scene that a text keeps.
    pub(super) fn remade(text: &str) -> Result<Self, String> {
        let strange = || "the link holds no scene that this playground knows; copy it again".to_owned();
        let mut parts = text.split(PART);
        let (Some(kind), Some(start), Some(edits)) = (parts.next(), parts.next(), parts.next()) else {
            return Err(strange());
        };
        let mut edits = edits.lines().filter(|line| !line.is_empty());
        let scene = match kind {
            "plane" => {
                let script = Script::parse(start, "link").map_err(|error| error.to_string())?;
                let work = Workshop::new(start, script.start().clone()).remade(edits).ok_or_else(strange)?;
                Self::Plane { work: Box::new(work), names: FaceMap::default() }
            }
            "kernel" => {
                let script = Script::parse_kernel(start, "link").map_err(|error| error.to_string())?;
                Self::Kernel(Box::new(Workshop::new(start, script.start().clone()).remade(edits).ok_or_else(strange)?))
            }
            "dcel" | "surface" => {
                let (line, text) = start.split_once('\n').ok_or_else(strange)?;
                let read = read_bytes(text.as_bytes(), Format::Dcel, "link", &ReadOptions::default());
                let read = read.map_err(|error| error.to_string())?;
                if kind == "surface" {
                    let crate::io::Document::Table(table) = read.document else { return Err(strange()) };
                    let dcel = dcel_of(&table).ok_or_else(strange)?;
                    Self::Kernel(Box::new(Workshop::new(line, dcel).remade(edits).ok_or_else(strange)?))
                } else {
                    let loaded = assemble(read, "link", &LoadOptions::default()).map_err(|error| error.to_string())?;
                    let Structure::Plane(start) = loaded.structure else { return Err(strange()) };
                    let work = Workshop::new(line, start).remade(edits).ok_or_else(strange)?;
                    Self::Plane { work: Box::new(work), names: loaded.names }
                }
            }
            "points" => {
                let point = |line: &str| {
                    let (x, y) = line.split_once(' ')?;
                    Some(Point::new(x.parse().ok()?, y.parse().ok()?))
                };
                let places: Option<Vec<Point>> = start.lines().map(point).collect();
                let mut points = Points::new(places.ok_or_else(strange)?)?;
                points.layer = edits.next_back().and_then(super::points::Layer::of).unwrap_or_default();
                Self::Points(Box::new(points))
            }
            _ => return Err(strange()),
        };
        scene.small_enough()?;
        Ok(scene)
    }
}

/// The structure without positions of a table that has every invariant, with the same numbers.
fn dcel_of(table: &Table) -> Option<Dcel> {
    let faces = (0..table.face_bound() as u32).map(crate::ids::FaceId::new);
    let mut polygons = crate::topology::PolygonList::new();
    for f in faces {
        let first = table.half_edge(f)?;
        let corners: Option<Vec<u32>> = crate::topology::bounded_cycle(table, first)
            .map(|h| table.origin(h).map(crate::ids::VertexId::number))
            .collect();
        polygons.push_face(&corners?);
    }
    let built = Dcel::from_polygons(table.vertex_bound(), &polygons).ok()?.dcel;
    (Table::from_view(&built) == *table).then_some(built)
}

/// The text of a `.dcel` file.
pub(super) fn dcel_text(model: &Model<'_>) -> String {
    let mut out = Vec::new();
    // Writing to memory cannot fail, and the format holds every structure.
    let _ = write(&mut out, model, Format::Dcel);
    String::from_utf8(out).unwrap_or_default()
}

/// A structure without coordinates, as films draw it.
pub(super) fn draw_kernel(dcel: &Dcel, options: &FigureOptions) -> Result<Figure, FigureError> {
    Film::of_kernel(dcel).strip(options)
}

fn schlegel(solid: &Polyhedron, source: &str) -> Result<Scene, String> {
    let face = solid.polygon_faces().next().ok_or("the surface has no face")?;
    let seen = solid.schlegel(face).map_err(|error| error.to_string())?;
    Ok(Scene::of_plane(seen.diagram, source))
}

/// The line that makes exactly this structure, if there is one.
fn start_line(s: &Subdivision) -> Option<String> {
    if *s == Subdivision::lab_rectangle() {
        return Some("rectangle".to_owned());
    }
    let points = |vertices: &mut dyn Iterator<Item = crate::ids::VertexId>| -> String {
        vertices.map(|v| s.point(v)).map(|p| format!(" {} {}", p.x, p.y)).collect()
    };
    let bounded = || s.faces().filter(|&f| f != s.outer_face());
    let polygon = || {
        let f = bounded().next()?;
        Some(format!("polygon{}", points(&mut s.incident_vertices(f))))
    };
    let triangles = || {
        let corners: String = bounded()
            .map(|f| s.incident_vertices(f).map(|v| v.to_string().replacen('v', " ", 1)).collect::<String>())
            .collect();
        format!("triangles{} /{corners}", points(&mut s.vertices()))
    };
    let is_it = |line: &String| Script::parse(line, "start").is_ok_and(|script| script.start() == s);
    let polygon = if bounded().count() == 1 { polygon() } else { None };
    polygon.filter(is_it).or_else(|| {
        let all = bounded().next().is_some() && bounded().all(|f| s.incident_vertices(f).count() == 3);
        all.then(triangles).filter(is_it)
    })
}
