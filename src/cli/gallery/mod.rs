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
use std::path::Path;

/// What a figure of the project comes to. None of it depends on the user's input, so that a failure is the kit's own.
pub(crate) type Made<T> = Result<T, Box<dyn std::error::Error>>;

/// A figure of the project, regenerated and compared by `dcel figures`.
struct Reference {
    /// The file in `figures/`.
    file: &'static str,
    /// What it shows.
    about: &'static str,
    /// Draws it.
    draw: fn() -> Made<String>,
}

/// All reference figures, in the order of their files.
static REFERENCES: &[Reference] = &[
    Reference {
        file: "cube.svg",
        about: "a half-edge structure of 8 vertices, 12 edges and 6 faces, the outer one counted",
        draw: || structure(&lesson::cube()?, "A half-edge structure"),
    },
    Reference {
        file: "figure-sizes.svg",
        about: "how much a figure shows, and how many bytes it takes for each edge, as a grid grows",
        draw: specimen::figure_sizes,
    },
    Reference {
        file: "difference.svg",
        about: "what a comparison shows: an edge is missing, one is too much, a pointer is wrong, a vertex is elsewhere",
        draw: || {
            let (right, wrong) = (lesson::table(&lesson::cube()?), lesson::wrong_cube()?);
            let options = FigureOptions::new("What differs").id_prefix("difference").width(450.0);
            Ok(dcel_kit::compare::diff_figure(&right, &wrong, &options)?.to_svg())
        },
    },
    Reference {
        file: "dual.svg",
        about: "the dual graph over its subdivision: a point in each face, a line across each edge",
        draw: plane::dual,
    },
    Reference {
        file: "film-catmull-clark.svg",
        about: "two steps of Catmull–Clark subdivision: vertices in faces, those of edges, those that move",
        draw: films::catmull_clark,
    },
    Reference {
        file: "film-climb.svg",
        about: "hill climbing over a convex solid, seen so that the direction points up",
        draw: films::climb,
    },
    Reference {
        file: "film-ears.svg",
        about: "ear clipping, corner by corner: why one is an ear, and why another is none",
        draw: films::ears,
    },
    Reference {
        file: "film-face-walk.svg",
        about: "a walk round a face, half-edge by half-edge, along next",
        draw: films::face_walk,
    },
    Reference {
        file: "film-flips.svg",
        about: "Lawson's flips: the circle that forces each of them, and the edge that takes its place",
        draw: films::flips,
    },
    Reference {
        file: "film-funnel.svg",
        about: "the funnel through a corridor, portal by portal",
        draw: films::funnel,
    },
    Reference {
        file: "film-hull.svg",
        about: "a convex hull from left to right and back: corners come, and go again",
        draw: films::hull,
    },
    Reference {
        file: "film-join-faces.svg",
        about: "join_faces step by step: the inverse of split_face",
        draw: || strip(sources::JOIN_FACES, "A film of join_faces", "join-faces"),
    },
    Reference {
        file: "film-matching.svg",
        about: "the half-edges of a list of faces find their twins, face by face; the border is left",
        draw: labs::lab_05::film,
    },
    Reference {
        file: "film-merge-faces.svg",
        about: "edge by edge goes until one face is left: V - E + F stays 2",
        draw: labs::lab_10::film,
    },
    Reference {
        file: "film-pole.svg",
        about: "a pole: a spur to a new vertex, then a face split for each further corner",
        draw: labs::lab_09::film,
    },
    Reference {
        file: "film-slip.svg",
        about: "split_face beside the same with one pointer written wrongly, and what does not hold in the end",
        draw: films::slip,
    },
    Reference { file: "film-locate.svg", about: "a walk to a point, face by face", draw: films::locate },
    Reference {
        file: "film-monotone.svg",
        about: "a sweep that cuts a face into monotone pieces, and the triangles of these",
        draw: films::monotone,
    },
    Reference {
        file: "film-solid-hull.svg",
        about: "a convex hull in space: what each point sees, the horizon, the new triangles",
        draw: films::solid_hull,
    },
    Reference {
        file: "film-split-face.svg",
        about: "split_face step by step: what each step of the handout links",
        draw: || strip(sources::SPLIT_FACE, "A film of split_face", "split"),
    },
    Reference {
        file: "film-split-in-half.svg",
        about: "split_in_half step by step",
        draw: || strip(sources::SPLIT_IN_HALF, "A film of split_in_half", "split-in-half"),
    },
    Reference {
        file: "film-sweep.svg",
        about: "the sweep that finds where segments cross, event by event",
        draw: films::sweep,
    },
    Reference {
        file: "film-voronoi.svg",
        about: "a Voronoi diagram as the dual of a Delaunay triangulation, cell by cell",
        draw: films::voronoi,
    },
    Reference {
        file: "focus.svg",
        about: "one half-edge, its five pointers named, and its row of the table",
        draw: || {
            let options = FigureOptions::new("One half-edge, five pointers").id_prefix("focus");
            Ok(figure::focus(&lesson::cube()?, HalfEdgeId::new(23), &options)?.to_svg())
        },
    },
    Reference {
        file: "inset.svg",
        about: "a face that is 250 times smaller than its neighbours, enlarged below",
        draw: plane::inset,
    },
    Reference {
        file: "interactive.svg",
        about: "point at a half-edge, or write its name behind the address, to see its pointers",
        draw: || {
            let options = FigureOptions::new("A half-edge structure to point at").interactive(true);
            Ok(figure::structure(&lesson::cube()?, &options.id_prefix("cube"))?.to_svg())
        },
    },
    Reference {
        file: "lab-01-map.svg",
        about: "the map of lab 01: the cells close to a line where doubles say the wrong side",
        draw: labs::lab_01::map,
    },
    Reference {
        file: "lab-02-triangulation.svg",
        about: "the polygon of lab 02 in its only triangulation",
        draw: labs::lab_02::triangulation,
    },
    Reference {
        file: "lab-03-hull.svg",
        about: "the picture that lab 03 asks for: a convex hull, and two tangents from a point",
        draw: labs::lab_03::picture,
    },
    Reference {
        file: "lab-03-ways.svg",
        about: "three ways to a convex hull: gift wrapping, Graham's scan, merging two halves",
        draw: labs::lab_03::three_ways,
    },
    Reference {
        file: "lab-04-drawing.svg",
        about: "the drawing of lab 04, made of the rectangle with split_face and split_in_half alone",
        draw: labs::lab_04::drawing,
    },
    Reference {
        file: "lab-04-two-nexts.svg",
        about: "an edge of two faces has two next edges; two half-edges have one each",
        draw: labs::lab_04::two_nexts,
    },
    Reference {
        file: "lab-05-matching.svg",
        about: "a list of faces, each alone, and the half-edge structure that it becomes",
        draw: labs::lab_05::matching,
    },
    Reference {
        file: "lab-05-structure.svg",
        about: "the list of faces of lab 05 as a half-edge structure",
        draw: labs::lab_05::structure,
    },
    Reference {
        file: "lab-06-corridor.svg",
        about: "the picture of lab 06: a corridor of triangles from start to goal, and the shortest path in it",
        draw: labs::lab_06::corridor,
    },
    Reference {
        file: "lab-06-portals.svg",
        about: "the portals of a corridor, each with its left and its right end",
        draw: labs::lab_06::portals,
    },
    Reference {
        file: "lab-07-circles.svg",
        about: "the picture that lab 07 asks for: a Delaunay triangulation and the circles of its triangles",
        draw: labs::lab_07::circles,
    },
    Reference {
        file: "lab-07-flip.svg",
        about: "a flip: the same records before and after it",
        draw: labs::lab_07::flip,
    },
    Reference {
        file: "lab-08-voronoi.svg",
        about: "the picture that lab 08 asks for: the Voronoi diagram of twelve sites",
        draw: labs::lab_08::picture,
    },
    Reference {
        file: "lab-09-growth.svg",
        about: "the picture that lab 09 asks for: a ring grows to cylinders, a cone and a sphere, and a torus beside them",
        draw: labs::lab_09::growth,
    },
    Reference {
        file: "lab-10-cube.svg",
        about: "the picture that lab 10 asks for: a cube and its dual, the octahedron",
        draw: labs::lab_10::cube,
    },
    Reference {
        file: "lab-10-duals.svg",
        about: "the regular solids and their duals: three pairs",
        draw: labs::lab_10::duals,
    },
    Reference {
        file: "lab-11-climb.svg",
        about: "the picture of lab 11: a climb over a polyhedron to its highest vertex",
        draw: labs::lab_11::climb,
    },
    Reference {
        file: "lab-11-stuck.svg",
        about: "where a climb ends: at the top, at a lower peak, on a plateau",
        draw: labs::lab_11::stuck,
    },
    Reference { file: "lawson.svg", about: "a triangulation becomes Delaunay by flips", draw: delaunay::lawson },
    Reference {
        file: "lab-subdivision.svg",
        about: "what the tour makes of the rectangle with split_face and split_in_half alone",
        draw: || structure(&lesson::lab_subdivision()?, "The lab's subdivision"),
    },
    Reference {
        file: "navmesh-ladder.svg",
        about: "six paths through one map: how much longer each is than the shortest",
        draw: specimen::ladder,
    },
    Reference {
        file: "pointers.svg",
        about: "the five families of pointers in the lab's subdivision, one panel each",
        draw: || {
            let options = FigureOptions::new("Pointers of the lab's subdivision").id_prefix("ptr").width(408.0);
            Ok(figure::pointers(&lesson::lab_subdivision()?, &Pointers::ALL, &options)?.to_svg())
        },
    },
    Reference {
        file: "primitives.svg",
        about: "vertex split and face split: from these two, and two seeds, all shapes grow",
        draw: primitives::figure,
    },
    Reference {
        file: "records.svg",
        about: "the records of a half-edge structure, their fields and what these refer to",
        draw: || {
            let options = FigureOptions::new("The records of a half-edge structure").id_prefix("records");
            Ok(figure::records(&options).to_svg())
        },
    },
    Reference {
        file: "rectangle.svg",
        about: "the six-vertex rectangle that the half-edge lab starts from",
        draw: || structure(&Subdivision::lab_rectangle(), "The lab's rectangle"),
    },
    Reference {
        file: "rings.svg",
        about: "a face with two holes, an island in one of them, a second component",
        draw: || {
            let options = FigureOptions::new("Rings and holes").width(830.0);
            Ok(figure::structure(&lesson::rings()?, &options)?.to_svg())
        },
    },
    Reference {
        file: "robustness.svg",
        about: "where plain doubles tell the wrong side of a line",
        draw: || {
            let options = FigureOptions::new("Where doubles are wrong");
            Ok(figure::robustness(&NearlyCollinear::default(), &options).to_svg())
        },
    },
    Reference {
        file: "rooms.svg",
        about: "the rooms of the kit, and which uses which: read from the sources, so never older than they are",
        draw: rooms::picture,
    },
    Reference {
        file: "schlegel.svg",
        about: "the dodecahedron seen through one of its faces, which is f0: a Schlegel diagram",
        draw: || {
            let seen = Polyhedron::platonic(Platonic::Dodecahedron).schlegel(FaceId::new(0))?;
            let options = FigureOptions::new("A dodecahedron seen through a face").id_prefix("schlegel").width(720.0);
            Ok(figure::structure(&seen.diagram, &options)?.to_svg())
        },
    },
    Reference {
        file: "solid-torus.svg",
        about: "a torus of 20 by 10 faces: those that are seen whole have half-edges, hidden lines are left out",
        draw: || {
            let torus = Shape::Torus { n: 20, m: 10 }.build()?.polyhedron;
            let options = FigureOptions::new("A torus").id_prefix("torus").width(830.0);
            Ok(figure::solid(&torus, &Camera::default(), HiddenLines::LeftOut, &options)?.to_svg())
        },
    },
    Reference {
        file: "solid.svg",
        about: "a dodecahedron: the half-edges of the faces that are seen, and the hidden edges dashed",
        draw: || {
            let solid = Polyhedron::platonic(Platonic::Dodecahedron);
            let options = FigureOptions::new("A dodecahedron").id_prefix("solid").width(720.0);
            Ok(figure::solid(&solid, &Camera::default(), HiddenLines::Dashed, &options)?.to_svg())
        },
    },
    Reference {
        file: "states.svg",
        about: "the states of the USA as one subdivision: 198 faces, 143 components",
        draw: || {
            let states = lesson::states()?;
            // Room for names beside the small states of the east.
            let options = FigureOptions::new("The states of the USA").width(830.0).reach([[1030.0, -300.0]]);
            let options = options.face_names(states.named_faces());
            Ok(figure::structure(&states.subdivision, &options)?.to_svg())
        },
    },
    Reference {
        file: "stepper-split-face.svg",
        about: "the film of split_face one frame at a time, by links, without a script",
        draw: || {
            let script = Script::parse(sources::SPLIT_FACE, "split-face.dcels")?;
            Ok(Film::of_script(&script)
                .stepper(&FigureOptions::new("Steps of split_face").id_prefix("steps"))?
                .to_svg())
        },
    },
    Reference {
        file: "tables.svg",
        about: "the lab's subdivision beside its tables, one half-edge marked in both",
        draw: || {
            let options = FigureOptions::new("Tables of the lab's subdivision").id_prefix("tables");
            Ok(figure::tables(&lesson::lab_subdivision()?, Some(HalfEdgeId::new(13).into()), &options)?.to_svg())
        },
    },
    Reference {
        file: "triangulation.svg",
        about: "a face with a hole and a vertex inside: its monotone pieces, their triangles, and those of the ears",
        draw: plane::triangulation,
    },
    Reference {
        file: "vocabulary.svg",
        about: "what other parts of the kit draw themselves with: one layout, six panels",
        draw: specimen::vocabulary,
    },
    Reference {
        file: "voronoi.svg",
        about: "the Voronoi diagram of some sites, and its dual, their Delaunay triangulation",
        draw: delaunay::voronoi,
    },
    Reference {
        file: "walk.svg",
        about: "a sketch over a structure: a straight walk from face to face",
        draw: specimen::walk,
    },
    Reference {
        file: "wrong-signs.svg",
        about: "how many signs plain doubles get wrong near a line, over the size of the grid",
        draw: specimen::wrong_signs,
    },
];

fn strip(script: &str, title: &str, prefix: &str) -> Made<String> {
    let script = Script::parse(script, title)?;
    Ok(Film::of_script(&script).strip(&FigureOptions::new(title).id_prefix(prefix))?.to_svg())
}

fn structure(subdivision: &Subdivision, title: &str) -> Made<String> {
    Ok(figure::structure(subdivision, &FigureOptions::new(title))?.to_svg())
}

/// The files of the folder: all figures, and the page that shows them.
pub(crate) fn draw_all() -> Result<Vec<Drawn>, Failure> {
    let mut files = Vec::new();
    for &Reference { file, about, draw } in REFERENCES {
        files.push(Drawn { file, about, text: draw().map_err(Failure::kit)? });
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
