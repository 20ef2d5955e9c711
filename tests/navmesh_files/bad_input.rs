//! What is wrong is said with its place; no count in a header is trusted; nothing panics, whatever the bytes.

use crate::Random;
use dcel_kit::io::{Format, Grid, ReadOptions, Scenario, read_bytes};

const MAP: &str = "type octile\nheight 3\nwidth 4\nmap\n..@.\n.@..\n....\n";
const SCEN: &str = "version 1\n0\ta.map\t4\t3\t0\t0\t4\t3\t5\n";
const MESH: &str = "mesh\n3\n5 4\n0 0\n0 8\n8 8\n8 0\n5 5\n\
    0 3  4 1 5  -4 0 -2\n1 3  1 2 5  -1 0 3\n1 3  2 3 5  2 0 4\n1 3  3 4 5  3 0 -1\n";

#[track_caller]
fn map(from: &str, to: &str, message: &str) {
    assert!(MAP.contains(from), "{from}");
    let text = MAP.replacen(from, to, 1);
    for text in [text.clone(), text.replace('\n', "\r\n")] {
        let error = Grid::parse(text.as_bytes(), "a.map").expect_err("a bad map").to_string();
        assert!(error.starts_with(message), "{error}");
    }
}

#[test]
fn bad_maps_are_refused_with_their_place() {
    map("octile", "hex", "a.map:1:6: a map of type hex cannot be read; the kit reads maps of type octile");
    map("type octile", "typ octile", "a.map:1:1: expected `type`, `height`, `width` or `map`, found `typ`");
    map("height 3\n", "", "a.map:3:1: expected `height` and `width` before the rows, found `map`");
    map("width 4", "height 4", "a.map:3:1: `height` was given before, in line 2; leave one of them out");
    map("width 4", "width 0", "a.map:3:7: expected a number from 1 to");
    map("width 4", "width x", "a.map:3:7: `x` is not a whole number");
    map("width 4", "width 4 4", "a.map:3:9: expected the end of the line, found `4`; one number stands here");
    map(".@..", ".@.", "a.map:6:1: expected 4 cells in row 1, found 3; correct the line `width`, or the row");
    map(".@..", ".@...", "a.map:6:1: expected 4 cells in row 1, found 5");
    map(
        ".@..",
        ".@x.",
        "a.map:6:3: expected a cell, 2 of row 1, found `x.`; open cells are . G S, blocked ones @ O T W",
    );
    map(".@..", ".@ .", "a.map:6:1: expected 4 cells in row 1, found 2");
    map(
        "height 3",
        "height 2",
        "a.map:7:1: there is more than the 2 rows that the header counts; correct the line `height`",
    );
    map("height 3", "height 4", "a.map:8:1: expected row 3 of 4, found the end of the file");
    map("height 3", "height 2147483645", "a.map:8:1: expected row 3 of 2147483645");
    map("width 4", "width 2147483645", "a.map:5:1: expected 2147483645 cells in row 0, found 4");
    map("height 3", "height 99999999999", "a.map:2:8: expected a number from 1 to");
    map("map\n", "map x\n", "a.map:4:5: expected the end of the line");
    let cut = Grid::parse(b"type octile\nheight 3\n", "a.map").expect_err("cut off").to_string();
    assert!(cut.starts_with("a.map:3:1: expected `height`, `width` or `map`, found the end of the file"), "{cut}");
}

#[track_caller]
fn scen(from: &str, to: &str, message: &str) {
    assert!(SCEN.contains(from), "{from}");
    let error =
        Scenario::parse(SCEN.replacen(from, to, 1).as_bytes(), "a.scen").expect_err("a bad scenario").to_string();
    assert!(error.starts_with(message), "{error}");
}

#[test]
fn bad_scenarios_are_refused_with_their_place() {
    scen("version 1", "version 2", "a.scen:1:9: expected version 1, found `2`; the kit reads no other version");
    scen("version 1", "version one", "a.scen:1:9: `one` is not a number");
    scen("\t5", "", "a.scen:2:1: expected bucket, map, width, height, start x y, goal x y, length, found `0`");
    scen("\t5", "\t-2", "a.scen:2:21: expected a length, or -1 for no path, found `-2`");
    scen("\t5", "\tnan", "a.scen:2:21: expected a length, or -1 for no path, found `nan`");
    scen("\t5", "\tfive", "a.scen:2:21: `five` is not a number");
    scen("0\ta", "x\ta", "a.scen:2:1: `x` is not a whole number");
    scen("4\t3\t0", "4\t-3\t0", "a.scen:2:11: `-3` is not a count");
    scen("0\t0\t4", "0\t1e99\t4", "a.scen:2:15: y = 1e99 is outside the exact range");
}

#[track_caller]
fn mesh(from: &str, to: &str, message: &str) {
    assert!(MESH.contains(from), "{from}");
    let text = MESH.replacen(from, to, 1);
    let error = read_bytes(text.as_bytes(), Format::Mesh, "a.mesh", &ReadOptions::default()).expect_err("a bad mesh");
    assert!(error.to_string().starts_with(message), "{error}");
}

#[test]
fn bad_meshes_of_version_3_are_refused_with_their_place() {
    mesh("\n3\n", "\n4\n", "a.mesh:2:1: expected version 2 or 3, found `4`");
    mesh("0 3  4 1 5", "2 3  4 1 5", "a.mesh:9:1: expected 1 for a polygon to walk on, 0 for a blocked one, found `2`");
    mesh("0 3  4 1 5", "0 0  4 1 5", "a.mesh:9:3: expected the number of corners, at least 1");
    mesh("0 3  4 1 5", "0 3  4 0 5", "a.mesh:9:8: vertex 0 does not exist: there are 5; they are numbered 1 to 5");
    mesh("0 3  4 1 5", "0 3  4 6 5", "a.mesh:9:8: vertex 6 does not exist: there are 5; they are numbered 1 to 5");
    mesh("-4 0 -2", "-5 0 -2", "a.mesh:9:13: polygon -5 does not exist: there are 4; they are numbered 1 to 4");
    mesh("3 0 -1\n", "3 0\n", "a.mesh:13:1: expected the neighbours of polygon 3, found the end of the file");
    mesh("3 0 -1\n", "3 0 -1\n7", "a.mesh:13:1: there is more than the 4 polygons that the header counts");
    mesh("5 4", "999999999999 999999999999", "a.mesh:13:1: expected vertex 21 of 999999999999, found the end");
}

#[test]
fn no_bytes_make_a_reader_panic() {
    for (file, format) in [(MAP, Some(Format::Map)), (MESH, Some(Format::Mesh)), (SCEN, None)] {
        for seed in 0..1500 {
            let mut random = Random::new(seed);
            let mut bytes = file.as_bytes().to_vec();
            for _ in 0..=random.below(3) {
                let at = random.below(bytes.len().max(1) as u64) as usize;
                match random.below(4) {
                    _ if bytes.is_empty() => {}
                    0 => drop(bytes.remove(at)),
                    1 => bytes.insert(at, random.below(256) as u8),
                    2 => bytes.truncate(at + 1),
                    _ => bytes[at] = b"0123456789-. \n\r@"[random.below(16) as usize],
                }
            }
            // A reader may take them or refuse them; a refusal has a place.
            let told = match format {
                Some(format) => read_bytes(&bytes, format, "f", &ReadOptions::default()).err(),
                None => Scenario::parse(&bytes, "f").err(),
            };
            if let Some(error) = told {
                assert!(error.line.is_some() || bytes.is_empty(), "seed {seed}: {error}");
            }
        }
    }
}
