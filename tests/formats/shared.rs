//! Files made by others, against what their sources state.

use dcel_kit::io::{Document, Format, PolygonSoup, Read, ReadError, ReadOptions, ReadProblem, read_path};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

fn data(folder: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data").join(folder)
}

fn expected(folder: &str) -> BTreeMap<String, Value> {
    let text = std::fs::read_to_string(data(folder).join("expected.json")).unwrap();
    serde_json::from_str(&text).unwrap()
}

fn soup(read: Result<Read, ReadError>) -> PolygonSoup {
    match read.unwrap_or_else(|error| panic!("{error}")).document {
        Document::Polygons(soup) => soup,
        _ => panic!("a table"),
    }
}

fn edges(soup: &PolygonSoup) -> BTreeSet<[u32; 2]> {
    let cycles = (0..soup.faces.cycle_count()).map(|c| soup.faces.cycle(c));
    let pairs = cycles.flat_map(|c| c.iter().zip(c.iter().cycle().skip(1)));
    pairs.map(|(&a, &b)| [a.min(b), a.max(b)]).collect()
}

fn states() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../figures/data/states-albers-10m.json")
}

#[test]
fn the_states_have_the_stated_numbers() {
    let options = ReadOptions { y_down: true, drop_degenerate_rings: true, ..ReadOptions::default() };
    let read = read_path(&states(), &options).unwrap();
    let notes = read.notes.join("\n");
    assert!(notes.contains("states was read (choose with --object)"), "{notes}");
    assert!(notes.contains("dropped a degenerate ring: states[26] \"Delaware\" polygon "), "{notes}");
    let soup = soup(Ok(read));
    assert_eq!((soup.points.len(), edges(&soup).len(), soup.faces.face_count()), (6818, 6872, 197));
    assert_eq!(soup.names.iter().flatten().collect::<BTreeSet<_>>().len(), 51);
    let named = |name: &str| soup.names.iter().filter(|n| n.as_deref() == Some(name)).count();
    assert_eq!((named("Colorado"), named("Delaware")), (1, 1));
    assert!(named("Alaska") > 20, "a MultiPolygon gives several faces of one name");
    // With y turned upwards Florida is south of Maine.
    let lowest = |name: &str| {
        let faces = (0..soup.faces.face_count()).filter(|&f| soup.names[f].as_deref() == Some(name));
        let ys = faces.flat_map(|f| soup.faces.cycles(f).flatten()).map(|&v| soup.points[v as usize][1]);
        ys.fold(f64::INFINITY, f64::min)
    };
    assert!(lowest("Florida") < lowest("Maine"));
}

#[test]
fn the_states_are_refused_for_delaware_by_default() {
    let error = read_path(&states(), &ReadOptions::default()).unwrap_err();
    assert!(matches!(&*error.what, ReadProblem::DegenerateRing { distinct: 2, .. }), "{error}");
    let text = error.to_string();
    for part in ["\"Delaware\" polygon ", " ring 0: ", "--drop-degenerate-rings"] {
        assert!(text.contains(part), "{text}");
    }
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn every_map_of_the_atlas_has_the_stated_numbers() {
    for (file, stated) in expected("O08-us-atlas") {
        let number = |key: &str| stated[key].as_u64().unwrap() as usize;
        // The object with the most polygons uses every arc of its file.
        let options = ReadOptions { drop_degenerate_rings: true, ..ReadOptions::default() };
        let soup = soup(read_path(&data("O08-us-atlas").join(&file), &options));
        assert_eq!((soup.points.len(), edges(&soup).len()), (number("V"), number("E")), "{file}");
    }
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn stated_neighbours_of_the_arena_are_behind_the_shared_edges() {
    for (path, stated) in expected("O09-polyanya-arena") {
        let path = data("O09-polyanya-arena").join(Path::new(&path).file_name().unwrap());
        let soup = soup(read_path(&path, &ReadOptions::default()));
        let number = |key: &str| stated[key].as_u64().unwrap() as usize;
        assert_eq!((soup.points.len(), soup.faces.face_count()), (number("V"), number("polygons")));
        assert_eq!(edges(&soup).len(), number("E"));
        let mut left = BTreeMap::new();
        for (f, cycle) in soup.faces.outer_cycles().enumerate() {
            for (k, &a) in cycle.iter().enumerate() {
                assert_eq!(left.insert((a, cycle[(k + 1) % cycle.len()]), f as i64), None);
            }
        }
        let text = std::fs::read_to_string(&path).unwrap();
        let mut words = text.split_ascii_whitespace().skip(4).map(|word| word.parse::<f64>().unwrap());
        for _ in 0..soup.points.len() {
            let around = words.by_ref().nth(2).unwrap() as usize;
            words.by_ref().take(around).for_each(drop);
        }
        let mut agree = 0;
        for cycle in soup.faces.outer_cycles() {
            let n = words.next().unwrap() as usize;
            let corners: Vec<u32> = words.by_ref().take(n).map(|v| v as u32).collect();
            assert_eq!(corners, cycle);
            for k in 0..n {
                // Neighbour k lies behind the edge from corner k-1 to corner k.
                let behind = left.get(&(cycle[k], cycle[(k + n - 1) % n])).copied().unwrap_or(-1);
                assert_eq!(words.next().unwrap() as i64, behind, "{path:?}: {cycle:?} edge {k}");
                agree += 1;
            }
        }
        assert_eq!(agree, number("neighbour_entries_agree_with_shared_edges"), "{path:?}");
    }
}

/// Files that the source splits into triangles after reading: (name, its faces, ours).
const SPLIT_BY_SOURCE: [(&str, usize, usize); 1] = [("plane.ply", 2, 1)];

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn small_surfaces_have_the_stated_points_and_faces() {
    let mut read = 0;
    for folder in ["O11-pmp-small", "O13-trimesh-small"] {
        for (file, stated) in expected(folder) {
            let path = data(folder).join(&file);
            if !matches!(Format::from_path(&path), Some(Format::Obj | Format::Off | Format::Ply)) {
                continue;
            }
            let number = |key: &str| stated[key].as_u64().unwrap() as usize;
            assert_eq!(number("faces_with_bad_index"), 0, "{file}: no file of the two families has one");
            let soup = soup(read_path(&path, &ReadOptions::default()));
            assert_eq!(soup.points.len(), number("V_listed"), "{file}");
            read += 1;
            if let Some(&(_, theirs, ours)) = SPLIT_BY_SOURCE.iter().find(|(name, ..)| *name == file) {
                assert_eq!((number("F"), soup.faces.face_count()), (theirs, ours), "{file}");
                continue;
            }
            let mut sizes: BTreeMap<String, u64> = BTreeMap::new();
            for cycle in soup.faces.outer_cycles() {
                *sizes.entry(cycle.len().to_string()).or_default() += 1;
            }
            assert_eq!(serde_json::to_value(&sizes).unwrap(), stated["face_sizes"], "{file}");
            assert_eq!(edges(&soup).iter().filter(|[a, b]| a != b).count(), number("E"), "{file}");
            assert_eq!(soup.faces.outer_cycles().filter(|c| c.len() < 3).count(), number("faces_too_small"), "{file}");
            assert_eq!(
                soup.places.face_lines.len(),
                if file.ends_with("tet.ply") || file.ends_with("pocket.ply") { 0 } else { number("F") }
            );
        }
    }
    assert_eq!(read, 29, "the number of OBJ, OFF and PLY files");
}
