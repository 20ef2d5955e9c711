//! Promise: what is mended covers what others say (`../shared/data`, families O04 and O14).

use crate::mend::{area, check, soup};
use crate::numbers::Numbers;
use dcel_kit::io::{Format, LoadOptions, ReadOptions, Structure, assemble, read_bytes};
use dcel_kit::plane::Subdivision;
use dcel_kit::topology::Mode;
use serde_json::Value;
use std::path::{Path, PathBuf};

/// Rings of coordinates, the outer one first, none with its first point again at the end.
type Polygon = Vec<Vec<(f64, f64)>>;

fn data(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data").join(path)
}

fn opened(mut ring: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    if ring.len() > 1 && ring.first() == ring.last() {
        ring.pop();
    }
    ring
}

/// The polygons of GeoJSON.
fn polygons_in(value: &Value) -> Vec<Polygon> {
    let list = |value: &Value| value.as_array().cloned().unwrap_or_default();
    let number = |p: &Value, i: usize| p[i].as_f64().expect("a number");
    let ring = |ring: &Value| opened(list(ring).iter().map(|p| (number(p, 0), number(p, 1))).collect());
    let polygon = |rings: &Value| list(rings).iter().map(ring).collect::<Polygon>();
    match value["type"].as_str() {
        Some("FeatureCollection") => list(&value["features"]).iter().flat_map(polygons_in).collect(),
        Some("Feature") => polygons_in(&value["geometry"]),
        Some("Polygon") => vec![polygon(&value["coordinates"])],
        Some("MultiPolygon") => list(&value["coordinates"]).iter().map(polygon).collect(),
        _ => Vec::new(),
    }
}

/// The area that an odd number of the polygons covers.
fn odd_area(polygons: &[Polygon]) -> f64 {
    let (points, list) = soup(polygons);
    let mended = Subdivision::mend_polygons(&points, &list).expect("all can be mended");
    let s = &mended.subdivision;
    s.faces().filter(|&f| mended.cover.count(f) % 2 == 1).map(|f| area(s, f)).sum()
}

/// Polygons that cross themselves are cut into simple ones there: what an odd number of these covers is what the
/// polygon covers by even-odd.
#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn unkinked_polygons_cover_what_was_mended() {
    let folder = data("O04-turf/turf-unkink-polygon/test");
    let (mut files, mut even_odd, mut one_by_one) = (0, 0, 0);
    for entry in std::fs::read_dir(folder.join("in")).expect("the folder") {
        let path = entry.expect("an entry").path();
        let read = |path: &Path| -> Vec<Polygon> {
            polygons_in(&serde_json::from_str(&std::fs::read_to_string(path).expect("a file")).expect("JSON"))
        };
        let name = path.file_name().expect("a name");
        let (given, stated) = (read(&path), read(&folder.join("out").join(name)));
        check(&given, &mut Numbers::new(1), &format!("{name:?}"));
        // Inner rings are taken away, whatever they do to each other; the source takes them for polygons.
        if given.iter().all(|rings| rings.len() == 1) {
            let (ours, theirs) = (odd_area(&given), odd_area(&stated));
            assert!((ours - theirs).abs() <= 1e-12 * theirs && theirs > 0.0, "{name:?}: {ours}, stated {theirs}");
            even_odd += 1;
        }
        files += 1;
        // Where no part is covered twice, their polygons are our cells.
        let (points, list) = soup(&given);
        let mended = Subdivision::mend_polygons(&points, &list).expect("as before");
        let s = &mended.subdivision;
        let sorted = |mut areas: Vec<f64>| {
            areas.sort_by(f64::total_cmp);
            areas
        };
        let cells = sorted(s.faces().filter(|&f| mended.cover.count(f) > 0).map(|f| area(s, f)).collect());
        let parts = sorted(stated.iter().map(|polygon| odd_area(std::slice::from_ref(polygon))).collect());
        let same = cells.len() == parts.len()
            && cells.iter().zip(&parts).all(|(cell, part)| (cell - part).abs() <= 1e-12 * part.abs());
        one_by_one += usize::from(same);
    }
    assert_eq!((files, even_odd, one_by_one), (8, 7, 6));
}

/// The polygons of a text such as `MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)))`: every innermost bracket is a ring, every
/// bracket round rings a polygon.
fn polygons_of_text(text: &str) -> Vec<Polygon> {
    let mut found = Vec::new();
    let mut stack: Vec<(String, Polygon)> = vec![Default::default()];
    for c in text.chars() {
        match c {
            '(' => stack.push(Default::default()),
            ')' => {
                let (text, rings) = stack.pop().expect("an open bracket");
                if rings.is_empty() {
                    let point = |pair: &str| {
                        let words: Vec<f64> = pair.split_whitespace().map(|x| x.parse().expect("a number")).collect();
                        (words[0], words[1])
                    };
                    let ring = opened(text.split(',').filter(|pair| !pair.trim().is_empty()).map(point).collect());
                    stack.last_mut().expect("the text").1.push(ring);
                } else {
                    found.push(rings);
                }
            }
            c => stack.last_mut().expect("the text").0.push(c),
        }
    }
    found
}

/// What the kit says of polygons that it reads from a file, without being asked to mend them.
fn is_accepted(polygons: &[Polygon]) -> bool {
    let ring =
        |ring: &Vec<(f64, f64)>| -> Vec<[f64; 2]> { ring.iter().chain(ring.first()).map(|&(x, y)| [x, y]).collect() };
    let coordinates: Vec<Vec<_>> = polygons.iter().map(|rings| rings.iter().map(ring).collect()).collect();
    let text = serde_json::json!({ "type": "MultiPolygon", "coordinates": coordinates }).to_string();
    let options = LoadOptions { mode: Some(Mode::Plane), ..LoadOptions::default() };
    let read = read_bytes(text.as_bytes(), Format::GeoJson, "case", &ReadOptions::default());
    let Ok(read) = read else { return false };
    let loaded = assemble(read, "case", &options);
    loaded.is_ok_and(|loaded| match loaded.structure {
        Structure::Plane(s) => s.geometry_violations().is_empty(),
        _ => false,
    })
}

/// Valid and invalid polygons: both are mended to what their rings enclose; the valid ones are accepted as they are, the
/// others refused.
#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn polygons_of_jts_are_mended_and_told_from_bad_ones() {
    let text = std::fs::read_to_string(data("O14-jts-xml/TestValid.xml")).expect("the file");
    let document = roxmltree::Document::parse(&text).expect("XML");
    let (mut counts, mut others) = ([0, 0], Vec::new());
    for case in document.descendants().filter(|node| node.has_tag_name("case")) {
        let part = |name: &str| {
            let node = case.descendants().find(|node| node.has_tag_name(name));
            node.and_then(|node| node.text()).unwrap_or_default().trim()
        };
        let shape = part("a");
        if !(shape.starts_with("POLYGON") || shape.starts_with("MULTIPOLYGON"))
            || ["EMPTY", "NaN", "Inf"].iter().any(|word| shape.contains(word))
        {
            continue;
        }
        let (polygons, name) = (polygons_of_text(shape), part("desc"));
        check(&polygons, &mut Numbers::new(2), name);
        let valid = part("op") == "true";
        counts[usize::from(valid)] += 1;
        if is_accepted(&polygons) != valid {
            others.push((valid, name));
        }
    }
    // Neighbours of a map share their sides; only within one multipolygon of OGC they must not.
    let neighbours = ["same", "different"].map(|what| (false, what));
    let what = |name: &str| {
        name.strip_prefix("mA - shells adjacent, ")?.strip_suffix(" vertices (self-intersection)").map(str::to_owned)
    };
    let named: Vec<_> =
        others.iter().map(|&(valid, name)| (valid, what(name).unwrap_or_else(|| name.to_owned()))).collect();
    assert_eq!(named, neighbours.map(|(valid, what)| (valid, what.to_owned())));
    assert_eq!(counts, [41, 23]);
}
