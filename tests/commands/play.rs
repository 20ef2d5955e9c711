//! `dcel play` and the page that it writes. What the page does in a browser: `figures/playground/tests/run.mjs`.

use crate::shell::Folder;
use std::fs;
use std::path::Path;

#[path = "../../figures/playground/builder/src/stamp.rs"]
mod stamp;

fn repository() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

/// Between two marks.
fn between<'a>(text: &'a str, before: &str, after: &str) -> &'a str {
    let start = text.find(before).unwrap_or_else(|| panic!("no {before}")) + before.len();
    &text[start..start + text[start..].find(after).unwrap_or_else(|| panic!("no {after}"))]
}

#[test]
fn the_page_keeps_its_promises() {
    let page = fs::read_to_string(repository().join("figures/playground.html")).unwrap();
    assert!(page.len() <= 1_200_000, "{} bytes", page.len());
    let policy = between(&page, "http-equiv=\"Content-Security-Policy\" content=\"", "\"");
    assert!(policy.starts_with("default-src 'none';") && !policy.contains("http"), "{policy}");
    // Nothing comes from anywhere: no address is loaded, by markup or by style.
    for loads in ["src=\"", "<link", "@import", "url(", "fetch(\"", "XMLHttpRequest", "WebSocket"] {
        assert!(!page.contains(loads), "the page holds {loads}");
    }
    let script = fs::read_to_string(repository().join("figures/playground/page/playground.js")).unwrap();
    assert!(script.lines().count() <= 1500 && page.contains(script.trim_end()));
}

#[test]
fn the_stamp_of_the_page_is_told() {
    let page = fs::read_to_string(repository().join("figures/playground.html")).unwrap();
    let known = between(&page, "name=\"dcel-sources\" content=\"", "\"");
    let now = stamp::stamp(repository()).unwrap();
    assert_eq!((known.len(), now.len()), (16, 16), "{known} {now}");
    assert!([known, now.as_str()].iter().all(|stamp| stamp.chars().all(|c| c.is_ascii_hexdigit())));
    // An older page works; that it is older is told, and mended by the builder.
    if known != now {
        println!("figures/playground.html is of the sources {known}, these are {now}: run figures/playground/builder");
    }
}

#[test]
fn a_file_is_put_into_the_page_and_a_bad_one_is_refused() {
    let folder = Folder::new();
    let told = folder.dcel("play --no-open").fine();
    assert_eq!(told, "playground.html: open it in a browser\n");
    let plain = folder.read("playground.html");
    assert!(plain == include_str!("../../figures/playground.html"));

    folder.write("plan.obj", "v 0 0\nv 4 0\nv 4 4\nf 1 2 3\n");
    assert_eq!(folder.dcel("play plan.obj --no-open").fine(), "plan.html: open it in a browser\n");
    let page = folder.read("plan.html");
    assert_eq!(between(&page, "id=\"scene\" data-name=\"", "\""), "plan.obj");
    assert_eq!(between(&page, "data-name=\"plan.obj\">", "<"), "diAwIDAKdiA0IDAKdiA0IDQKZiAxIDIgMwo=");
    assert_eq!(page.len() - plain.len(), "plan.obj".len() + 36);

    folder.write("bad.obj", "v 0 0\nv 1 x\n");
    folder.dcel("play bad.obj --no-open").fails(2, "bad.obj:2:5: `x` is not a number", "");
    assert!(!folder.path("bad.html").exists());
    folder.write("later.dcels", "rectangle\nsplit_fase h2 h8\n");
    folder.dcel("play later.dcels -o x.html --no-open").fails(2, "later.dcels:2:1", "split_face");
    folder.write("notes.md", "# No drawing\n");
    folder.dcel("play notes.md --no-open").fails(2, "no drawing that the kit can read", "help: it reads .dcel, .obj");
    folder.write("thrice.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 5\nv 2 1 7\nf 1 2 3\nf 1 2 4\nf 1 2 5\n");
    let told = folder.dcel("play thrice.obj --no-open");
    told.fails(2, "thrice.obj:6: the edge between vertices 0 and 1 has 3 faces", "help: leave faces out");
    folder.dcel("play missing.obj --no-open").fails(2, "missing.obj: cannot be read", "check the name");
    folder.dcel("play plan.obj -o plan.obj --no-open").fails(2, "the input itself", "");
    // What helps is what this command has.
    folder.write("rings.json", r#"{"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 0], [0, 0]]]}"#);
    folder.dcel("play rings.json --no-open").fails(2, "encloses nothing", "help: correct the data, or give --mend");
    assert!(!folder.dcel("play rings.json --no-open").err.contains("--drop-degenerate-rings"));
    folder.write("broken.json", "{");
    let told = folder.dcel("play broken.json --no-open");
    assert!(told.err.contains("not JSON") && !told.err.contains("dcel figure"), "{told:?}");
    // What crosses is cut where it does, on request.
    folder.write("cross.segments", "0 0 4 4\n0 4 4 0\n");
    folder.dcel("play cross.segments --no-open").fails(2, "cross", "");
    folder.dcel("play cross.segments --mend --no-open -o cross.html").fine();
    let page = folder.read("cross.html");
    assert_eq!(between(&page, "id=\"scene\" data-name=\"", "\""), "cross.dcel");
    folder.dcel("convert cross.segments cross.dcel --mend").fine();
    folder.dcel("play cross.dcel --no-open -o plain.html").fine();
    assert!(page == folder.read("plain.html"), "the scene is the mended structure");
    folder.dcel("film sweep cross.segments --mend -o f.html").fails(
        2,
        "the sweep looks at the segments as they are",
        "--mend",
    );
    let grid: String =
        (0..160 * 160).map(|i| format!("{} {} {} {}\n", i % 160, i / 160, i % 160 + 1, i / 160)).collect();
    folder.write("many.segments", &grid);
    folder.dcel("play many.segments --no-open").fails(2, "edges: the playground takes up to 20000", "dcel figure");
}
