//! The cases of lab 10, test by test: small surfaces whose every element is asked for, large ones, random ones.

use super::starts::{
    Given, of_faces, of_solid, of_table, platonic, random_solid, sharp, solids, with_others, with_removed,
};
use super::surface::SCHEMA;
use super::{angles, costs, counts, dual, features, merging, picture, regular, shapes, walks};
use crate::answers::{self, Function};
use crate::cases::random::Random;
use crate::fault::Fault;
use crate::judge::{Asked, Judge, Suite};
use crate::plan::Plan;
use crate::protocol::{Case, CaseAnswer, Schema, Start, Step};
use crate::{many, pictures};

/// How many random surfaces each test has.
const RANDOM: usize = 8;
/// For how many elements of a surface a function is asked.
const ELEMENTS: usize = 36;
/// The test of the picture, and that of the costs.
const PICTURE: &str = "picture";
const LARGE: &str = "vertices_around_large";

/// The functions of the lab, each with the test that it decides.
const FUNCTIONS: &[Function] = &[
    Function { word: "euler", test: "euler", wrong: counts::euler },
    Function { word: "missing_edges", test: "missing_edges", wrong: counts::missing_edges },
    Function { word: "vertices_around", test: "vertices_around", wrong: walks::vertices_around },
    Function { word: "regular", test: "regular", wrong: counts::regular },
    Function { word: "winged_edges", test: "winged_edges", wrong: walks::winged_edges },
    Function { word: "dual", test: "dual", wrong: dual::wrong },
    Function { word: "deficit_angle", test: "deficit_angle", wrong: angles::wrong_deficit },
    Function { word: "dihedral_angle", test: "dihedral_angle", wrong: angles::wrong_dihedral },
    Function { word: "genus", test: "genus", wrong: counts::genus },
    Function { word: "merge_faces", test: "merge_faces", wrong: merging::wrong },
    Function { word: "is_genus_0", test: "is_genus_0", wrong: merging::wrong_all },
];
/// The same questions in the large surface.
const IN_LARGE: &[Function] = &[Function { word: "vertices_around", test: LARGE, wrong: walks::vertices_around }];

/// The judge of lab 10.
pub struct Polyhedra;

/// What the surfaces of a test are like.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Kinds {
    /// With points in space; else all points are at one place.
    in_space: bool,
    /// Also surfaces from which something was removed.
    removed: bool,
    /// Also surfaces of several parts.
    parts: bool,
    /// Also large ones.
    large: bool,
}

/// What the surfaces of the test of a function are like.
fn kinds(function: &str) -> Kinds {
    let in_space = matches!(function, "deficit_angle" | "dihedral_angle");
    Kinds {
        in_space,
        removed: !in_space && function != "dual",
        parts: !in_space && function != "is_genus_0",
        large: !in_space && !matches!(function, "merge_faces" | "is_genus_0"),
    }
}

impl Judge for Polyhedra {
    fn schema(&self) -> Schema {
        Schema::Records(&SCHEMA)
    }

    fn suites(&self, plan: &Plan) -> Vec<Suite> {
        let suite = |function: &'static Function| {
            let mut given = fixed(kinds(function.word));
            if function.word == "dual" {
                // The middles of faces show where they are in space only.
                let others = solids().into_iter().skip(regular::NAMES.len());
                given.extend(others.map(|(name, surface)| of_solid(&name, &surface)));
            }
            if function.word == "regular" {
                given.extend(shapes::unlike().iter().map(|(name, faces)| of_faces(name, faces)));
                given.extend(shapes::unlike_one().iter().map(|(name, surface)| of_table(name, surface)));
            }
            let mut fixed: Vec<Case> = given.iter().map(|of| case(function.word, of)).collect();
            if function.word == "genus" {
                let large = Case::new("genus.torus_of_22500", costs::LARGE_TORUS.clone());
                fixed.push(large.step(Step::Changes).step(Step::of_line("genus")));
            }
            let asked = Asked::fixed_and_seeded(fixed, plan, RANDOM, |seed, count| random(function.word, seed, count));
            // Each suite decides the one test that has the function's name.
            Suite::of(std::slice::from_ref(&function.test), asked)
        };
        let mut suites: Vec<Suite> = FUNCTIONS.iter().map(suite).collect();
        suites.insert(3, Suite::of(&[LARGE], Asked::fixed([costs::questions()])));
        let drawn = picture::DRAWN.map(|solid| {
            let case = Case::new(format!("picture.{solid}"), Start::line(format!("platonic {solid}")));
            case.step(Step::Dump).step(Step::Svg)
        });
        suites.push(Suite::of(&[PICTURE], Asked::fixed(drawn)));
        suites
    }

    fn judge(&self, suite: &Suite, case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
        match suite.name {
            PICTURE => {
                let solid = picture::DRAWN.into_iter().find(|solid| case.name.ends_with(solid));
                pictures::told_apart(PICTURE, case, answer, || picture::plain(solid.unwrap_or("cube")))
            }
            LARGE => many::judge(IN_LARGE, LARGE, &costs::LARGE, case, answer),
            _ => answers::judge(FUNCTIONS, case, answer),
        }
    }

    crate::features_of!(features);

    fn promise(&self, fault: &Fault) -> &'static str {
        fault.kind.unfinished().unwrap_or(match fault.test {
            "euler" => "euler is the number of vertices minus that of edges plus that of faces",
            "missing_edges" => "missing_edges is how many edges cut all faces into triangles",
            "vertices_around" | LARGE => "vertices_around lists the neighbours of a vertex counter-clockwise",
            "regular" => "regular tells the corners of each face and the edges of each vertex, if they are alike",
            "winged_edges" => "winged_edges has a row for each edge, with its ends, faces and wings",
            "dual" => "the dual has a vertex for each face, a face for each vertex, and crosses each half-edge",
            "deficit_angle" => "deficit_angle is 2 pi minus the angles of the faces at the vertex",
            "dihedral_angle" => "dihedral_angle is the angle inside the solid between two faces",
            "genus" => "genus counts the handles of a connected surface and refuses others by a vertex",
            "merge_faces" => "merge_faces removes one edge and one face, and refuses if there is only one face",
            "is_genus_0" => "is_genus_0 leaves one face, and tells whether there is no handle",
            _ => "the picture shows the edges and vertices of the solid and of its dual",
        })
    }
}

/// The surfaces that are always asked, the simplest first.
fn fixed(kinds: Kinds) -> Vec<Given> {
    let mut random = Random::new(10, "fixed");
    let mut all: Vec<Given> = regular::NAMES.map(platonic).into();
    if kinds.in_space {
        all.push(Given { start: Start::line("frame"), ..of_solid("frame", &frame()) });
        let others = solids().into_iter().skip(regular::NAMES.len()).filter(|(name, _)| name != "frame").chain(sharp());
        all.extend(others.map(|(name, surface)| of_solid(&name, &surface)));
        let (name, surface) = &solids()[1];
        all.push(of_table(&format!("{name}_other"), &with_others(surface, &mut random)));
        return all;
    }
    let shapes = shapes::all();
    all.extend(shapes.iter().map(|(name, faces)| of_faces(name, faces)));
    if kinds.parts {
        all.extend(shapes::parts().iter().map(|(name, faces)| of_faces(name, faces)));
    }
    for (name, faces) in &shapes {
        all.push(of_table(&format!("{name}.other"), &with_others(&shapes::blind(faces), &mut random)));
    }
    if kinds.removed {
        for (i, (name, faces)) in shapes.iter().enumerate() {
            let left = with_removed(&shapes::blind(faces), 1 + i % 4, &mut random);
            all.push(of_table(&format!("{name}.removed"), &left));
            // Here so many that one face may come to a vertex twice, or lie on both sides of an edge.
            let left = with_removed(&shapes::blind(faces), 40, &mut random);
            all.push(of_table(&format!("{name}.few_left"), &left));
        }
    }
    if kinds.large {
        all.extend(shapes::large().iter().map(|(name, faces)| of_faces(name, faces)));
    }
    all
}

fn frame() -> super::surface::Surface {
    solids().into_iter().find(|(name, _)| name == "frame").map_or_else(Default::default, |(_, surface)| surface)
}

fn random(function: &str, seed: u64, count: usize) -> Vec<Case> {
    let kinds = kinds(function);
    let mut random = Random::new(seed, function);
    let given = |i: usize| {
        let name = format!("random.{i}");
        if kinds.in_space {
            return of_solid(&name, &random_solid(&mut random));
        }
        let surface = shapes::blind(&shapes::random(&mut random, kinds.parts));
        match i % 3 {
            2 if kinds.removed => {
                let merges = 1 + random.below(8);
                of_table(&name, &with_removed(&surface, merges, &mut random))
            }
            1 => of_table(&name, &with_others(&surface, &mut random)),
            _ => of_solid(&name, &surface),
        }
    };
    (0..count).map(given).map(|given| case(function, &given)).collect()
}

/// A function, asked for the elements of a surface: of a small one for all of them.
fn case(function: &str, given: &Given) -> Case {
    let case = Case::new(format!("{function}.{}", given.name), given.start.clone()).step(Step::Dump);
    let surface = &given.surface;
    let elements: Vec<String> = match function {
        "vertices_around" | "deficit_angle" => (0..surface.points.len()).map(|v| format!("v{v}")).collect(),
        "dihedral_angle" | "merge_faces" => surface.half_edges().map(|h| h.to_string()).collect(),
        _ => return once(case, function),
    };
    let some = elements.iter().step_by(elements.len().div_ceil(ELEMENTS));
    let calls = some.map(|element| Step::call(function, [element]));
    if function == "merge_faces" { case.each_alone(calls) } else { case.calls(calls, &[]) }
}

/// A function of the whole surface.
fn once(case: Case, function: &str) -> Case {
    let case = case.step(Step::of_line(function));
    if function == "is_genus_0" { case.step(Step::Dump) } else { case }
}
