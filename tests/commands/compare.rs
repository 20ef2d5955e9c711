//! `dcel compare` in a shell: exit codes, the answer as text and JSON, the picture.

use crate::shell::Folder;

const LINE: &str = "<svg xmlns='http://www.w3.org/2000/svg'>\n<g stroke='black' fill='none'>\n\
                    <path d='M0 0H90V60H0Z'/>\n<line x2='90' y2='60'/>\n</g>\n</svg>\n";

#[test]
fn equal_is_0_different_is_1_unreadable_is_2() {
    let folder = Folder::new();
    folder.write("right.svg", LINE);
    folder.write("same.svg", &LINE.replace("H90V60H0Z", "v60h90v-60z"));
    folder.write("wrong.svg", &LINE.replace("x2='90'", "x1='90' x2='0'"));
    folder.write("zip.svg", "");
    std::fs::write(folder.path("zip.svg"), [0x1f, 0x8b, 8, 0]).expect("a file");
    assert_eq!(folder.dcel("compare right.svg right.svg").fine(), "equal (same bytes)\n");
    assert_eq!(folder.dcel("compare right.svg same.svg").fine(), "equal (same drawn geometry)\n");
    folder.write("marked.svg", &format!("\u{feff}{LINE}"));
    assert_eq!(folder.dcel("compare right.svg marked.svg").fine(), "equal (same drawn geometry)\n");
    assert_eq!(folder.dcel("compare marked.svg marked.svg").fine(), "equal (same bytes)\n");
    let told = folder.dcel_with(&LINE.replace("H90V60H0Z", "H90V60H0"), "compare right.svg -");
    let said = "differs in its drawn geometry: 1 difference, 4 of 5 edges agree\n   \
                1. edge between (0, 0) and (0, 60) is missing\n";
    assert_eq!((told.code, told.out.as_str()), (Some(1), said), "{told:?}");
    let told = folder.dcel("compare right.svg wrong.svg --json --diff diff.svg");
    assert_eq!(told.code, Some(1), "{told:?}");
    let answer: serde_json::Value = serde_json::from_str(&told.out).expect("JSON");
    assert_eq!((&answer["equal"], &answer["layer"]), (&false.into(), &"drawn".into()));
    // The other diagonal, and not the drawing in a mirror.
    let told: Vec<[&str; 2]> = answer["differences"]
        .as_array()
        .expect("a list")
        .iter()
        .map(|difference| ["kind", "text"].map(|key| difference[key].as_str().expect("words")))
        .collect();
    let edges =
        ["edge between (0, 0) and (90, 60) is missing", "edge between (90, 0) and (0, 60) is not in the reference"];
    assert_eq!(told, edges.map(|text| ["edge", text]), "{answer}");
    assert!(folder.read("diff.svg").starts_with("<svg"));
    folder.dcel("compare right.svg zip.svg").fails(2, "zip.svg: this is a compressed file", "--help");
    folder.dcel("compare zip.svg right.svg").fails(2, "zip.svg: this is a compressed file", "--help");
    folder.dcel("compare right.svg none.svg").fails(2, "none.svg: cannot be read", "");
    folder.dcel("compare right.svg wrong.svg --diff right.svg").fails(2, "right.svg: this is the input itself", "");
    folder.dcel("compare right.svg wrong.svg --tolerance no").fails(2, "invalid value 'no'", "0.05");
}

#[test]
fn structures_are_compared_up_to_their_ids() {
    let folder = Folder::new();
    folder.dcel("convert square.obj a.dcel").fine();
    // The same two triangles in another order, another start and other numbers.
    folder.write("b.obj", "v 0 3\nv 4 3\nv 4 0\nv 0 0\nf 2 1 4\nf 3 2 4\n");
    let equal = "equal (same structure and positions, up to ids): 4 vertices, 5 edges, 3 faces\n";
    for call in ["compare a.dcel b.obj", "compare b.obj a.dcel", "compare square.obj b.obj", "compare b.obj b.obj"] {
        assert_eq!(folder.dcel(call).fine(), equal, "{call}");
    }
    folder.dcel("compare a.dcel square.obj --ids").fine();
    let told = folder.dcel("compare a.dcel b.obj --ids");
    assert_eq!(
        (told.code, told.out.starts_with("differs: 1 difference\n   1. v0 (0, 3) of b.obj")),
        (Some(1), true),
        "{told:?}"
    );
    // Which half-edge of its own a face names is free, and the help says so.
    let mine = folder.read("a.dcel");
    let named = mine.lines().find(|line| line.starts_with("f1 half_edge h")).expect("a face");
    let first = named.split(' ').nth(2).expect("a half-edge");
    let next = mine.lines().find(|line| line.starts_with(&format!("{first} "))).expect("its line");
    let next = next.split(" next ").nth(1).and_then(|rest| rest.split(' ').next()).expect("another one");
    folder.write("other-start.dcel", &mine.replace(named, &named.replace(first, next)));
    folder.dcel("compare a.dcel other-start.dcel --ids").fine();
    let help = folder.dcel("compare --help").fine().split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(help.contains("Which of its half-edges a vertex or a face names is free, and never counts"), "{help}");
    let stdin = folder.read("a.dcel");
    assert_eq!(folder.dcel_with(&stdin, "compare square.obj -").fine(), equal);
    assert_eq!(folder.dcel_with(&stdin, "compare - square.obj").fine(), equal);

    // The other diagonal: the same vertices, two edges apart, each told by its ends.
    folder.write("other.obj", "v 0 0\nv 4 0\nv 4 3\nv 0 3\nf 1 2 4\nf 2 3 4\n");
    let told = folder.dcel("compare square.obj other.obj");
    assert_eq!(told.code, Some(1), "{told:?}");
    let lines: Vec<&str> = told.out.lines().collect();
    assert!(
        lines[1].ends_with("from v0 (0, 0) to v2 (4, 3) of square.obj is missing")
            || lines[1].ends_with("from v2 (4, 3) to v0 (0, 0) of square.obj is missing"),
        "{told:?}"
    );
    assert!(
        lines[2].contains("v1 (4, 0)") && lines[2].contains("v3 (0, 3)") && lines[2].ends_with("other.obj is too much")
    );
    assert_eq!((lines[0], lines.len()), ("differs: 2 differences", 3));
    folder.dcel("compare square.obj other.obj --no-positions").fine();
    // A vertex that is elsewhere by the last bit.
    folder.write("near.obj", &crate::shell::SQUARE.replace("v 4 3", "v 4 3.0000000000000004"));
    let answer = folder.dcel("compare square.obj near.obj --json");
    let answer: serde_json::Value = serde_json::from_str(&answer.out).expect("JSON");
    assert_eq!((&answer["equal"], &answer["layer"]), (&false.into(), &"structure".into()));
    assert_eq!(answer["differences"][0]["kind"], "vertex");
    assert_eq!(answer["differences"][0]["text"], "v2 (4, 3) of square.obj is missing");
    assert_eq!(answer["differences"][1]["text"], "v2 (4, 3.0000000000000004) of near.obj is too much");

    // States and names of faces, and what lies in them.
    folder.write(
        "triangle2.dcel",
        &crate::shell::TRIANGLE.replace("f1 half_edge h0 inner v3", "f1 half_edge h0 inner v3 hole"),
    );
    let told = folder.dcel("compare triangle.dcel triangle2.dcel");
    assert!(
        told.code == Some(1)
            && told.out.contains("triangle2.dcel has 1 hole face: f1 at v0 (0, 0); triangle.dcel has 0"),
        "{told:?}"
    );
    folder.write("named.dcel", &crate::shell::TRIANGLE.replace("Ohio", "Utah"));
    folder.dcel("compare triangle.dcel named.dcel").fine();
    let told = folder.dcel("compare triangle.dcel named.dcel --names");
    assert!(
        told.out.contains("f1 of named.dcel has the name \"Utah\", f1 of triangle.dcel has the name \"Ohio\""),
        "{told:?}"
    );
    let told = folder.dcel("compare triangle.dcel square.obj --no-positions");
    assert!(told.code == Some(1) && told.out.contains("differs"), "{told:?}");
    let told = folder.dcel("compare square.obj cube.off");
    assert!(told.code == Some(1) && told.out.contains("cube.off is a surface in space"), "{told:?}");
    assert_eq!(folder.dcel("compare cube.off cube.off").code, Some(0));
}

#[test]
fn comparisons_that_make_no_sense_are_refused() {
    let folder = Folder::new();
    folder.write("line.svg", LINE);
    folder.write("broken.dcel", &crate::shell::TRIANGLE.replace("next h2", "next h4"));
    folder.write("a.dcel", crate::shell::TRIANGLE);
    for (call, error, help) in [
        (
            "compare line.svg square.obj",
            "line.svg is a drawing and square.obj a structure",
            "dcel figure square.obj -o",
        ),
        (
            "compare square.obj line.svg",
            "line.svg is a drawing and square.obj a structure",
            "dcel figure square.obj -o",
        ),
        ("compare a.dcel broken.dcel", "broken.dcel: ", "dcel validate says more"),
        ("compare broken.dcel a.dcel", "broken.dcel: ", "dcel validate says more"),
        ("compare a.dcel a.dcel --diff x.svg", "--diff cannot be used: these are structures", "leave --diff out"),
        ("compare a.dcel a.dcel --tolerance 1", "--tolerance cannot be used", "leave"),
        ("compare line.svg line.svg --ids", "--ids cannot be used: these are drawings", "leave --ids out"),
        ("compare line.svg line.svg --y-down", "--y-down cannot be used: these are drawings", "leave"),
        ("compare a.dcel a.dcel --names --no-positions", "cannot be used with", ""),
        ("compare a.dcel none.obj", "none.obj: cannot be read", "check the name"),
    ] {
        folder.dcel(call).fails(2, error, help);
    }
}
