//! The page of the gallery: all figures in the order of a lesson, each with the command that draws one of its kind.

use super::{Made, Reference};

/// The page.
pub(super) const FILE: &str = "README.md";

/// The chapters, in the order in which one learns. What is measured, and cards that show what a drawing can look like, are
/// not in it.
const CHAPTERS: [(&str, &[&str]); 9] = [
    (
        "The structure",
        &[
            "cube.svg",
            "focus.svg",
            "records.svg",
            "pointers.svg",
            "tables.svg",
            "interactive.svg",
            "film-face-walk.svg",
            "lab-04-two-nexts.svg",
            "rings.svg",
            "inset.svg",
            "dual.svg",
            "states.svg",
        ],
    ),
    (
        "Edits, step by step",
        &[
            "rectangle.svg",
            "film-split-face.svg",
            "stepper-split-face.svg",
            "film-split-in-half.svg",
            "film-join-faces.svg",
            "film-slip.svg",
            "lab-subdivision.svg",
            "lab-04-drawing.svg",
            "difference.svg",
        ],
    ),
    ("Signs", &["robustness.svg", "wrong-signs.svg", "lab-01-map.svg", "film-locate.svg", "walk.svg"]),
    (
        "Triangles",
        &["film-ears.svg", "film-monotone.svg", "triangulation.svg", "lab-02-triangulation.svg", "film-sweep.svg"],
    ),
    ("Convex hulls", &["lab-03-ways.svg", "film-hull.svg", "lab-03-hull.svg", "film-solid-hull.svg"]),
    ("From a list of faces", &["lab-05-matching.svg", "film-matching.svg", "lab-05-structure.svg"]),
    ("Paths", &["lab-06-portals.svg", "film-funnel.svg", "lab-06-corridor.svg", "navmesh-ladder.svg"]),
    (
        "Delaunay and Voronoi",
        &[
            "lawson.svg",
            "lab-07-flip.svg",
            "film-flips.svg",
            "lab-07-circles.svg",
            "voronoi.svg",
            "film-voronoi.svg",
            "lab-08-voronoi.svg",
        ],
    ),
    (
        "Surfaces in space",
        &[
            "primitives.svg",
            "film-pole.svg",
            "lab-09-growth.svg",
            "solid.svg",
            "schlegel.svg",
            "lab-10-duals.svg",
            "lab-10-cube.svg",
            "film-merge-faces.svg",
            "solid-torus.svg",
            "film-catmull-clark.svg",
            "film-climb.svg",
            "lab-11-climb.svg",
            "lab-11-stuck.svg",
        ],
    ),
];

/// What the chapters leave out: measurements, cards of what a drawing can look like, the kit's own rooms.
const NOT_SHOWN: [&str; 3] = ["figure-sizes.svg", "rooms.svg", "vocabulary.svg"];

/// The page as Markdown.
pub(super) fn text(references: &[Reference]) -> Made<String> {
    let mut page = String::from(
        "# What the kit draws of itself\n\n\
         `dcel figures` draws all of this anew, this page included, and `dcel figures --check` compares. Below each\n\
         picture is the command that draws the same kind of picture of a file of yours. To play with a structure, open\n\
         [the playground](playground.html).\n",
    );
    let mut left: Vec<&str> = references.iter().map(|reference| reference.file).collect();
    left.retain(|file| !NOT_SHOWN.contains(file));
    for (title, files) in CHAPTERS {
        page.push_str(&format!("\n## {title}\n"));
        for file in files {
            let reference = references.iter().find(|reference| reference.file == *file);
            let Reference { about, .. } = reference.ok_or_else(|| format!("there is no figure {file}"))?;
            page.push_str(&format!("\n### {file}\n\n![{about}]({file})\n\n{about}\n\n```sh\n{}\n```\n", command(file)));
            let count = left.len();
            left.retain(|known| known != file);
            if left.len() == count {
                return Err(format!("{file} stands in two chapters").into());
            }
        }
    }
    if left.is_empty() { Ok(page) } else { Err(format!("in no chapter: {}", left.join(", ")).into()) }
}

/// Figures of labs that show a structure as any file is shown.
const OF_A_FILE: [&str; 2] = ["lab-04-two-nexts.svg", "lab-subdivision.svg"];

/// How to draw such a picture of one's own.
fn command(file: &str) -> &'static str {
    match file {
        "lab-04-drawing.svg" => {
            "dcel script figures/scripts/lab-04-drawing.dcels --dump\n\
             dcel figure FILE --detail edges --colours figures/scripts/lab-04-drawing.colours -o OUT.svg"
        }
        "difference.svg" => "dcel compare EXPECTED.svg MINE.svg --diff OUT.svg",
        "dual.svg" => "dcel figure FILE --dual -o OUT.svg",
        "triangulation.svg" => {
            "dcel triangulate FILE --pieces --figure PIECES.svg\n\
             dcel triangulate FILE --figure OUT.svg\n\
             dcel triangulate FILE --method ears --figure EARS.svg"
        }
        "focus.svg" => "dcel figure FILE --focus h5 -o OUT.svg",
        "inset.svg" => "dcel figure FILE --inset auto -o OUT.svg",
        "interactive.svg" => "dcel figure FILE --interactive -o OUT.svg",
        "pointers.svg" => "dcel figure FILE --pointers all -o OUT.svg",
        "records.svg" => "dcel figure --records -o OUT.svg",
        "film-matching.svg" | "film-merge-faces.svg" | "film-pole.svg" => "dcel figures",
        "primitives.svg" | "robustness.svg" | "walk.svg" | "wrong-signs.svg" => "dcel figures",
        file if file.starts_with("lab-") && !OF_A_FILE.contains(&file) => "dcel figures",
        "navmesh-ladder.svg" => {
            "dcel navmesh path figures/data/rooms.map 21.5 5.5 0.5 4.5 --triangles --algorithm all -o OUT.svg"
        }
        "schlegel.svg" => "dcel solid schlegel FILE --through f0 --figure OUT.svg",
        "solid-torus.svg" => "dcel solid figure FILE --no-hidden -o OUT.svg",
        "solid.svg" => "dcel solid figure FILE -o OUT.svg",
        "lawson.svg" => "dcel delaunay FILE --flips --circles --figure OUT.svg",
        "voronoi.svg" => "dcel voronoi FILE --delaunay --figure OUT.svg",
        "states.svg" => "dcel figure FILE --width 960 -o OUT.svg",
        "tables.svg" => "dcel figure FILE --tables --highlight h5 -o OUT.svg",
        "stepper-split-face.svg" => "dcel script figures/scripts/split-face.dcels --film OUT.svg --stepper",
        "film-join-faces.svg" => "dcel script figures/scripts/join-faces.dcels --film OUT.svg",
        "film-split-face.svg" => "dcel script figures/scripts/split-face.dcels --film OUT.svg",
        "film-slip.svg" => "dcel script figures/scripts/split-face.dcels --slip \"h13.next = h8\" --film OUT.svg",
        "film-split-in-half.svg" => "dcel script figures/scripts/split-in-half.dcels --film OUT.svg",
        "film-catmull-clark.svg" => "dcel film catmull-clark FILE --steps 2 -o OUT.svg",
        "film-climb.svg" => "dcel film climb FILE --direction 1,2,5 -o OUT.svg",
        "film-ears.svg" => "dcel film ears FILE -o OUT.svg",
        "film-face-walk.svg" => "dcel film walk FILE --face f1 -o OUT.svg",
        "film-flips.svg" => "dcel film flips FILE -o OUT.svg",
        "film-funnel.svg" => "dcel film funnel FILE --from 1,1 --to 22,12 -o OUT.svg",
        "film-hull.svg" => "dcel film hull FILE -o OUT.svg",
        "film-locate.svg" => "dcel film locate FILE --start v0 --point 1,2 -o OUT.svg",
        "film-monotone.svg" => "dcel film monotone FILE -o OUT.svg",
        "film-solid-hull.svg" => "dcel film solid-hull FILE -o OUT.svg",
        "film-sweep.svg" => "dcel film sweep FILE -o OUT.svg",
        "film-voronoi.svg" => "dcel film voronoi FILE -o OUT.svg",
        _ => "dcel figure FILE -o OUT.svg",
    }
}
