//! The page of the gallery: all figures in the order of a lesson, each with the command that draws one of its kind.

use super::{Made, Reference};

/// The page.
pub(super) const FILE: &str = "README.md";

/// The chapters, in the order in which one learns, each with its files without `.svg`. What is measured, and cards that
/// show what a drawing can look like, are not in it.
const CHAPTERS: [(&str, &str); 9] = [
    (
        "The structure",
        "cube focus records pointers tables interactive film-face-walk lab-04-two-nexts rings inset dual states",
    ),
    (
        "Edits, step by step",
        "rectangle film-split-face stepper-split-face film-split-in-half film-join-faces film-slip \
         lab-subdivision lab-04-drawing difference",
    ),
    ("Signs", "robustness wrong-signs lab-01-map film-locate walk"),
    ("Triangles", "film-ears film-monotone triangulation lab-02-triangulation film-sweep"),
    ("Convex hulls", "lab-03-ways film-hull lab-03-hull film-solid-hull"),
    ("From a list of faces", "lab-05-matching film-matching lab-05-structure"),
    ("Paths", "lab-06-portals film-funnel lab-06-corridor navmesh-ladder"),
    ("Delaunay and Voronoi", "lawson lab-07-flip film-flips lab-07-circles voronoi film-voronoi lab-08-voronoi"),
    (
        "Surfaces in space",
        "primitives film-pole lab-09-growth solid schlegel lab-10-duals lab-10-cube film-merge-faces solid-torus \
         film-catmull-clark film-climb lab-11-climb lab-11-stuck",
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
    let mut left: Vec<&Reference> = references.iter().filter(|of| !NOT_SHOWN.contains(&of.file)).collect();
    for (title, names) in CHAPTERS {
        page.push_str(&format!("\n## {title}\n"));
        for name in names.split(' ') {
            let file = format!("{name}.svg");
            let at = left.iter().position(|of| of.file == file);
            let at = at.ok_or_else(|| format!("there is no figure {file}, or it stands in two chapters"))?;
            let (about, command) = (left.remove(at).about, command(&file));
            page.push_str(&format!("\n### {file}\n\n![{about}]({file})\n\n{about}\n\n```sh\n{command}\n```\n"));
        }
    }
    match left[..] {
        [] => Ok(page),
        [Reference { file, .. }, ..] => Err(format!("in no chapter: {file}").into()),
    }
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
