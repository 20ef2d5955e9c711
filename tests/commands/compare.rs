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
    let told = folder.dcel_with(&LINE.replace("H90V60H0Z", "H90V60H0"), "compare right.svg -");
    let said = "differs in its drawn geometry: 1 difference, 4 of 5 edges agree\n   \
                1. edge between (0, 0) and (0, 60) is missing\n";
    assert_eq!((told.code, told.out.as_str()), (Some(1), said), "{told:?}");
    let told = folder.dcel("compare right.svg wrong.svg --json --diff diff.svg");
    assert_eq!(told.code, Some(1), "{told:?}");
    let answer: serde_json::Value = serde_json::from_str(&told.out).expect("JSON");
    assert_eq!((&answer["equal"], &answer["layer"]), (&false.into(), &"drawn".into()));
    assert_eq!(answer["differences"][0]["kind"], "drawing", "{answer}");
    assert!(folder.read("diff.svg").starts_with("<svg"));
    folder.dcel("compare right.svg zip.svg").fails(2, "zip.svg: this is a compressed file", "--help");
    folder.dcel("compare zip.svg right.svg").fails(2, "zip.svg: this is a compressed file", "--help");
    folder.dcel("compare right.svg none.svg").fails(2, "none.svg: cannot be read", "");
    folder.dcel("compare right.svg wrong.svg --diff right.svg").fails(2, "right.svg: this is one of the drawings", "");
    folder.dcel("compare right.svg wrong.svg --tolerance no").fails(2, "invalid value 'no'", "0.05");
}
