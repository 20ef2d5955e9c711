//! The reference figures: what stands in `figures/`, and how each is made.
//!
//! ```text
//!   lesson     the structures that figures and tour begin with
//!   chart      logarithmic axes
//!   page       the page that shows them all
//!   specimen  primitives  plane  delaunay  films  labs/  rooms    a function for each figure that takes more than a line
//! ```

mod chart;
mod delaunay;
mod films;
mod labs;
pub(crate) mod lesson;
mod page;
mod plane;
mod primitives;
mod rooms;
mod specimen;

use crate::{Failure, save};
use dcel_kit::figure::{self, Camera, FigureOptions, Film, HiddenLines, NearlyCollinear, Pointers};
use dcel_kit::ids::{FaceId, HalfEdgeId};
use dcel_kit::plane::Subdivision;
use dcel_kit::script::Script;
use dcel_kit::solid::grow::Shape;
use dcel_kit::solid::{Platonic, Polyhedron};
use dcel_kit::sources;
use dcel_kit::topology::Table;
use std::path::Path;

/// What a figure of the project comes to. None of it depends on the user's input, so that a failure is the kit's own.
pub(crate) type Made<T> = Result<T, Box<dyn std::error::Error>>;

/// A figure of the project, regenerated and compared by `dcel figures`.
struct Reference {
    /// The file in `figures/`.
    file: &'static str,
    /// What it shows.
    about: &'static str,
    /// Its title, the prefix of its ids, its width.
    options: fn() -> FigureOptions,
    /// Draws it.
    draw: fn(&FigureOptions) -> Made<String>,
}

/// Rows of figures: the file, the title, if they are not the usual ones the prefix of ids and the width, how it is drawn,
/// what it shows.
macro_rules! references {
    ($($file:literal, $title:literal $(, $prefix:literal $(, $width:literal)?)? => $draw:expr, $about:literal;)*) => {
        &[$(Reference {
            file: $file,
            about: $about,
            options: || FigureOptions::new($title)$(.id_prefix($prefix)$(.width($width))?)?,
            draw: $draw,
        }),*]
    };
}

/// All reference figures, in the order of their files.
static REFERENCES: &[Reference] = references! {
    "cube.svg", "A half-edge structure" => |options| Ok(figure::structure(&lesson::cube()?, options)?.to_svg()),
        "a half-edge structure of 8 vertices, 12 edges and 6 faces, the outer one counted";
    "figure-sizes.svg", "Level of detail and size of a figure", "figure-sizes" => specimen::figure_sizes,
        "how much a figure shows, and how many bytes it takes for each edge, as a grid grows";
    "difference.svg", "What differs", "difference", 450.0 => difference,
        "what a comparison shows: an edge is missing, one is too much, a pointer is wrong, a vertex is elsewhere";
    "dual.svg", "The dual graph", "dual" => |options| Ok(figure::dual(&lesson::lab_subdivision()?, options)?.to_svg()),
        "the dual graph over its subdivision: a point in each face, a line across each edge";
    "film-catmull-clark.svg", "A film of subdivision", "catmull-clark" => films::catmull_clark,
        "two steps of Catmull–Clark subdivision: vertices in faces, those of edges, those that move";
    "film-climb.svg", "A film of hill climbing", "climb" => films::climb,
        "hill climbing over a convex solid, seen so that the direction points up";
    "film-ears.svg", "A film of ear clipping", "ears" => films::ears,
        "ear clipping, corner by corner: why one is an ear, and why another is none";
    "film-face-walk.svg", "A walk round a face", "face-walk" => films::face_walk,
        "a walk round a face, half-edge by half-edge, along next";
    "film-flips.svg", "A film of Lawson's flips", "flips" => films::flips,
        "Lawson's flips: the circle that forces each of them, and the edge that takes its place";
    "film-funnel.svg", "A film of the funnel", "funnel" => films::funnel,
        "the funnel through a corridor, portal by portal";
    "film-hull.svg", "A film of a convex hull", "hull" => films::hull,
        "a convex hull from left to right and back: corners come, and go again";
    "film-join-faces.svg", "A film of join_faces", "join-faces" =>
        |options| Ok(film(sources::JOIN_FACES)?.strip(options)?.to_svg()),
        "join_faces step by step: the inverse of split_face";
    "film-matching.svg", "A film of matching", "matching-film" => labs::lab_05::film,
        "the half-edges of a list of faces find their twins, face by face; the border is left";
    "film-merge-faces.svg", "A film of merged faces", "merge" => labs::lab_10::film,
        "edge by edge goes until one face is left: V - E + F stays 2";
    "film-pole.svg", "A film of a pole", "pole" => labs::lab_09::film,
        "a pole: a spur to a new vertex, then a face split for each further corner";
    "film-slip.svg", "A split with a slip", "slip" => films::slip,
        "split_face beside the same with one pointer written wrongly, and what does not hold in the end";
    "film-locate.svg", "A walk to a point", "location" => films::locate,
        "a walk to a point, face by face";
    "film-monotone.svg", "A film of triangulation by monotone pieces", "monotone" => films::monotone,
        "a sweep that cuts a face into monotone pieces, and the triangles of these";
    "film-solid-hull.svg", "A film of a convex hull in space", "solid-hull" => films::solid_hull,
        "a convex hull in space: what each point sees, the horizon, the new triangles";
    "film-split-face.svg", "A film of split_face", "split" =>
        |options| Ok(film(sources::SPLIT_FACE)?.strip(options)?.to_svg()),
        "split_face step by step: what each step of the handout links";
    "film-split-in-half.svg", "A film of split_in_half", "split-in-half" =>
        |options| Ok(film(sources::SPLIT_IN_HALF)?.strip(options)?.to_svg()),
        "split_in_half step by step";
    "film-sweep.svg", "A film of the sweep over segments", "sweep" => films::sweep,
        "the sweep that finds where segments cross, event by event";
    "film-voronoi.svg", "A film of a Voronoi diagram", "voronoi-film" => films::voronoi,
        "a Voronoi diagram as the dual of a Delaunay triangulation, cell by cell";
    "focus.svg", "One half-edge, five pointers", "focus" =>
        |options| Ok(figure::focus(&lesson::cube()?, HalfEdgeId::new(23), options)?.to_svg()),
        "one half-edge, its five pointers named, and its row of the table";
    "inset.svg", "A small face, enlarged", "inset" => plane::inset,
        "a face that is 250 times smaller than its neighbours, enlarged below";
    "interactive.svg", "A half-edge structure to point at", "cube" =>
        |options| Ok(figure::structure(&lesson::cube()?, &options.clone().interactive(true))?.to_svg()),
        "point at a half-edge, or write its name behind the address, to see its pointers";
    "lab-01-map.svg", "The map of lab 01" => labs::lab_01::map,
        "the map of lab 01: the cells close to a line where doubles say the wrong side";
    "lab-02-triangulation.svg", "A polygon cut into triangles", "lab-02-triangulation", 620.0 =>
        labs::lab_02::triangulation,
        "the polygon of lab 02 in its only triangulation";
    "lab-03-hull.svg", "A convex hull and two tangents", "lab-03-hull" => labs::lab_03::picture,
        "the picture that lab 03 asks for: a convex hull, and two tangents from a point";
    "lab-03-ways.svg", "Three ways to a convex hull", "three-ways", 420.0 => labs::lab_03::three_ways,
        "three ways to a convex hull: gift wrapping, Graham's scan, merging two halves";
    "lab-04-drawing.svg", "The drawing of lab 04", "drawing" => labs::lab_04::drawing,
        "the drawing of lab 04, made of the rectangle with split_face and split_in_half alone";
    "lab-04-two-nexts.svg", "Why an edge is cut along its length", "two-nexts", 408.0 => labs::lab_04::two_nexts,
        "an edge of two faces has two next edges; two half-edges have one each";
    "lab-05-matching.svg", "From a list of faces to half-edges", "matching", 405.0 => labs::lab_05::matching,
        "a list of faces, each alone, and the half-edge structure that it becomes";
    "lab-05-structure.svg", "The structure of lab 05", "triangle-list" => labs::lab_05::structure,
        "the list of faces of lab 05 as a half-edge structure";
    "lab-06-corridor.svg", "A corridor and the path in it", "lab-06-corridor", 620.0 => labs::lab_06::corridor,
        "the picture of lab 06: a corridor of triangles from start to goal, and the shortest path in it";
    "lab-06-portals.svg", "Portals of a corridor", "lab-06-portals", 620.0 => labs::lab_06::portals,
        "the portals of a corridor, each with its left and its right end";
    "lab-07-circles.svg", "A Delaunay triangulation and its empty circles", "lab-07-circles" => labs::lab_07::circles,
        "the picture that lab 07 asks for: a Delaunay triangulation and the circles of its triangles";
    "lab-07-flip.svg", "A flip", "lab-07-flip", 405.0 => labs::lab_07::flip,
        "a flip: the same records before and after it";
    "lab-08-voronoi.svg", "The Voronoi diagram of twelve sites", "lab-08-voronoi" => labs::lab_08::picture,
        "the picture that lab 08 asks for: the Voronoi diagram of twelve sites";
    "lab-09-growth.svg", "Primitives as they grow", "lab-09-growth", 1100.0 => labs::lab_09::growth,
        "the picture that lab 09 asks for: a ring grows to cylinders, a cone and a sphere, and a torus beside them";
    "lab-10-cube.svg", "A cube and its dual, the octahedron", "lab-10-cube", 480.0 => labs::lab_10::cube,
        "the picture that lab 10 asks for: a cube and its dual, the octahedron";
    "lab-10-duals.svg", "Three pairs of duals", "lab-10-duals", 290.0 => labs::lab_10::duals,
        "the regular solids and their duals: three pairs";
    "lab-11-climb.svg", "A climb over a polyhedron", "lab-11-climb", 520.0 => labs::lab_11::climb,
        "the picture of lab 11: a climb over a polyhedron to its highest vertex";
    "lab-11-stuck.svg", "Where a climb ends", "lab-11-stuck", 420.0 => labs::lab_11::stuck,
        "where a climb ends: at the top, at a lower peak, on a plateau";
    "lawson.svg", "Delaunay by flips", "lawson", 408.0 => delaunay::lawson,
        "a triangulation becomes Delaunay by flips";
    "lab-subdivision.svg", "The lab's subdivision" =>
        |options| Ok(figure::structure(&lesson::lab_subdivision()?, options)?.to_svg()),
        "what the tour makes of the rectangle with split_face and split_in_half alone";
    "navmesh-ladder.svg", "Six ways round blocks", "ladder" => specimen::ladder,
        "six paths through one map: how much longer each is than the shortest";
    "pointers.svg", "Pointers of the lab's subdivision", "ptr", 408.0 =>
        |options| Ok(figure::pointers(&lesson::lab_subdivision()?, &Pointers::ALL, options)?.to_svg()),
        "the five families of pointers in the lab's subdivision, one panel each";
    "primitives.svg", "The two primitives", "primitives", 408.0 => primitives::figure,
        "vertex split and face split: from these two, and two seeds, all shapes grow";
    "records.svg", "The records of a half-edge structure", "records" => |options| Ok(figure::records(options).to_svg()),
        "the records of a half-edge structure, their fields and what these refer to";
    "rectangle.svg", "The lab's rectangle" =>
        |options| Ok(figure::structure(&Subdivision::lab_rectangle(), options)?.to_svg()),
        "the six-vertex rectangle that the half-edge lab starts from";
    "rings.svg", "Rings and holes", "rings-and-holes", 830.0 =>
        |options| Ok(figure::structure(&lesson::rings()?, options)?.to_svg()),
        "a face with two holes, an island in one of them, a second component";
    "robustness.svg", "Where doubles are wrong" =>
        |options| Ok(figure::robustness(&NearlyCollinear::default(), options).to_svg()),
        "where plain doubles tell the wrong side of a line";
    "rooms.svg", "The rooms of the kit", "rooms", 560.0 => rooms::picture,
        "the rooms of the kit, and which uses which: read from the sources, so never older than they are";
    "schlegel.svg", "A dodecahedron seen through a face", "schlegel", 720.0 => schlegel,
        "the dodecahedron seen through one of its faces, which is f0: a Schlegel diagram";
    "solid-torus.svg", "A torus", "torus", 830.0 => solid_torus,
        "a torus of 20 by 10 faces: those that are seen whole have half-edges, hidden lines are left out";
    "solid.svg", "A dodecahedron", "solid", 720.0 => solid,
        "a dodecahedron: the half-edges of the faces that are seen, and the hidden edges dashed";
    "states.svg", "The states of the USA", "the-states-of-the-usa", 830.0 => states,
        "the states of the USA as one subdivision: 198 faces, 143 components";
    "stepper-split-face.svg", "Steps of split_face", "steps" =>
        |options| Ok(film(sources::SPLIT_FACE)?.stepper(options)?.to_svg()),
        "the film of split_face one frame at a time, by links, without a script";
    "tables.svg", "Tables of the lab's subdivision", "tables" =>
        |options| Ok(figure::tables(&lesson::lab_subdivision()?, Some(HalfEdgeId::new(13).into()), options)?.to_svg()),
        "the lab's subdivision beside its tables, one half-edge marked in both";
    "triangulation.svg", "Triangulation", "triangulation", 408.0 => plane::triangulation,
        "a face with a hole and a vertex inside: its monotone pieces, their triangles, and those of the ears";
    "vocabulary.svg", "The drawing vocabulary", "vocabulary" => specimen::vocabulary,
        "what other parts of the kit draw themselves with: one layout, six panels";
    "voronoi.svg", "Voronoi diagram and Delaunay triangulation", "voronoi", 760.0 => delaunay::voronoi,
        "the Voronoi diagram of some sites, and its dual, their Delaunay triangulation";
    "walk.svg", "A walk to a point", "walk", 620.0 => specimen::walk,
        "a sketch over a structure: a straight walk from face to face";
    "wrong-signs.svg", "Wrong signs of plain doubles", "wrong-signs" => specimen::wrong_signs,
        "how many signs plain doubles get wrong near a line, over the size of the grid";
};

fn difference(options: &FigureOptions) -> Made<String> {
    let (right, wrong) = (Table::from_planar_view(&lesson::cube()?), lesson::wrong_cube()?);
    Ok(dcel_kit::compare::diff_figure(&right, &wrong, options)?.to_svg())
}

fn schlegel(options: &FigureOptions) -> Made<String> {
    let seen = Polyhedron::platonic(Platonic::Dodecahedron).schlegel(FaceId::new(0))?;
    Ok(figure::structure(&seen.diagram, options)?.to_svg())
}

fn solid_torus(options: &FigureOptions) -> Made<String> {
    let torus = Shape::Torus { n: 20, m: 10 }.build()?.polyhedron;
    Ok(figure::solid(&torus, &Camera::default(), HiddenLines::LeftOut, options)?.to_svg())
}

fn solid(options: &FigureOptions) -> Made<String> {
    let solid = Polyhedron::platonic(Platonic::Dodecahedron);
    Ok(figure::solid(&solid, &Camera::default(), HiddenLines::Dashed, options)?.to_svg())
}

fn states(options: &FigureOptions) -> Made<String> {
    let states = lesson::states()?;
    // Room for names beside the small states of the east.
    let options = options.clone().reach([[1030.0, -300.0]]).face_names(states.named_faces());
    Ok(figure::structure(&states.subdivision, &options)?.to_svg())
}

/// The film of a script.
fn film(script: &str) -> Made<Film> {
    Ok(Film::of_script(&Script::parse(script, "an edit")?))
}

/// The files of the folder: all figures, and the page that shows them.
pub(crate) fn draw_all() -> Result<Vec<Drawn>, Failure> {
    let mut files = Vec::new();
    for &Reference { file, about, options, draw } in REFERENCES {
        files.push(Drawn { file, about, text: draw(&options()).map_err(Failure::kit)? });
    }
    let about = "this folder as a page";
    let text = page::text(REFERENCES).map_err(Failure::kit)?;
    files.push(Drawn { file: page::FILE, about, text });
    Ok(files)
}

/// A file as it should be.
pub(crate) struct Drawn {
    /// Its name in the folder.
    pub(crate) file: &'static str,
    /// What it shows.
    pub(crate) about: &'static str,
    /// Its contents.
    pub(crate) text: String,
}

/// Writes files into a folder, which is made if need be. A file that is right already is left alone.
pub(crate) fn write_all(dir: &Path, files: &[Drawn]) -> Result<(), Failure> {
    std::fs::create_dir_all(dir).map_err(|error| Failure::writing(dir.display(), &error))?;
    for Drawn { file, text, .. } in files {
        let path = dir.join(file);
        if std::fs::read(&path).is_ok_and(|bytes| bytes == text.as_bytes()) {
            continue;
        }
        save::put(&path, text)?;
    }
    Ok(())
}
