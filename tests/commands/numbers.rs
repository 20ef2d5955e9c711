//! Numbers of the command line that are none: refused in the words of the kit.

use crate::shell::Folder;

#[test]
fn what_is_no_number_is_told_what_is_expected() {
    let folder = Folder::new();
    let (whole, number) =
        ("write a whole number, 0 or more, for example 3", "this is no finite number: write it like 1.5");
    let cases = [
        ("navmesh random square.obj --count=-3", whole),
        ("navmesh random square.obj --count 1.5", whole),
        ("navmesh random square.obj --seed x", whole),
        ("navmesh info square.obj --up z --layer q", whole),
        ("navmesh scenario square.obj q.scen --tolerance q", number),
        ("locate square.obj - -", number),
        ("locate square.obj 1 inf", "y is inf"),
        ("overlay square.obj square.obj --grid x", number),
        ("build square.segments --mend --grid x", number),
        ("voronoi square.obj --box 0 0 1 x", number),
        ("figure square.obj --scale x", number),
        ("film ears square.obj --most x", whole),
        ("film ears square.obj --steps x", "write a whole number from 1 to 5"),
        ("film ears square.obj --steps 9", "write a whole number from 1 to 5"),
        ("figure square.obj --columns x", "write a whole number from 1 to 100"),
        ("solid figure cube.off --distance x", number),
        ("solid subdivide cube.off --sharper x", number),
        ("solid subdivide cube.off --loop --steps x", "write a whole number from 1 to 8"),
        ("lab hint x", whole),
        ("lab hint --level x", "write a whole number from 1 to 3"),
        ("lab check --seed x", whole),
        ("grade lab --seed x", whole),
        ("grade lab --similar x", "write a whole number from 1 to 100"),
        ("grade lab --fail-under x", number),
        ("grade lab --workers 0", "write a whole number, 1 or more, for example 4"),
        ("grade lab --workers x", "write a whole number, 1 or more, for example 4"),
    ];
    let mut wrong = Vec::new();
    for (call, words) in cases {
        let told = folder.dcel(call);
        let rusts = ["invalid digit", "invalid float", "number would be", "empty string"];
        if told.code != Some(2) || !told.err.contains(words) || rusts.iter().any(|word| told.err.contains(word)) {
            wrong.push(format!("{call}: {told:?}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
