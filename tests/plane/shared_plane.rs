//! Promise: the converter gives the counts, neighbours and borders that others state for real maps and tilings
//! (`../shared/data`, families O05, O08, O09).

use dcel_kit::io::{Document, Format, PolygonSoup, ReadOptions, read_path};
use dcel_kit::plane::{ConvertOptions, Point, Subdivision};
use dcel_kit::topology::PolygonList;
use dcel_kit::{FaceId, VertexId};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

fn data(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data").join(path)
}

fn json(path: &str) -> Value {
    serde_json::from_str(&std::fs::read_to_string(data(path)).unwrap()).unwrap()
}

fn soup(path: &Path, options: &ReadOptions) -> PolygonSoup {
    match read_path(path, options).unwrap().document {
        Document::Polygons(soup) => soup,
        _ => panic!("polygons expected"),
    }
}

fn convert(soup: &PolygonSoup, full_check: bool) -> Subdivision {
    let points = soup.points.iter().map(|&[x, y, _]| Point::new(x, y)).collect();
    let options = ConvertOptions { orient: true, full_check, ..ConvertOptions::default() };
    Subdivision::convert_polygons(points, &soup.faces, &options).unwrap().subdivision
}

fn components(s: &Subdivision) -> usize {
    let mut seen = vec![false; s.vertex_bound()];
    let mut count = 0;
    for start in s.vertices() {
        if seen[start.index()] {
            continue;
        }
        count += 1;
        seen[start.index()] = true;
        let mut stack = vec![start];
        while let Some(v) = stack.pop() {
            for w in s.adjacent_vertices(v) {
                if !std::mem::replace(&mut seen[w.index()], true) {
                    stack.push(w);
                }
            }
        }
    }
    count
}

/// Polygon lists drawn by another half-edge library: the first polygon is the outline, the group holds the tiles.
fn tiles(svg: &str) -> (Vec<Point>, PolygonList, Vec<u32>) {
    let document = roxmltree::Document::parse(svg).unwrap();
    let mut numbers: BTreeMap<(i64, i64), u32> = BTreeMap::new();
    let mut points = Vec::new();
    let mut corners = |node: roxmltree::Node<'_, '_>| -> Vec<u32> {
        let text = node.attribute("points").unwrap();
        let corner = |pair: &str| {
            let (x, y) = pair.split_once(',').unwrap();
            let (x, y): (f64, f64) = (x.parse().unwrap(), y.parse().unwrap());
            // The files round to six decimals; equal corners agree to better than three. y points down there.
            *numbers.entry(((x * 1e3).round() as i64, (y * 1e3).round() as i64)).or_insert_with(|| {
                points.push(Point::new(x, -y));
                points.len() as u32 - 1
            })
        };
        text.split_whitespace().map(corner).collect()
    };
    let polygons = |node: roxmltree::Node<'_, '_>| node.has_tag_name("polygon");
    let group = document.descendants().find(|n| n.attribute("id") == Some("tiling-polygons")).unwrap();
    let mut list = PolygonList::new();
    for tile in group.children().filter(|&n| polygons(n)) {
        list.push_face(&corners(tile));
    }
    let outline = corners(document.root_element().children().find(|&n| polygons(n)).unwrap());
    (points, list, outline)
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn tilings_have_the_stated_counts_and_outline() {
    let expected = json("O05-tessella-dcel/expected.json");
    let mut files = 0;
    for (name, stated) in expected.as_object().unwrap().iter().filter(|(name, _)| name.starts_with("templates/")) {
        let path = data("O05-tessella-dcel").join(name);
        let (points, list, outline) = tiles(&std::fs::read_to_string(path).unwrap());
        let options = ConvertOptions { orient: true, full_check: true, ..ConvertOptions::default() };
        let s = Subdivision::convert_polygons(points, &list, &options)
            .unwrap_or_else(|e| panic!("{name}: {e}"))
            .subdivision;
        let counts = [s.vertex_count(), s.edge_count(), s.face_count()].map(|n| n as u64);
        let polygons = stated["polygons"].as_u64().unwrap();
        assert_eq!(counts, [stated["V"].as_u64().unwrap(), stated["E"].as_u64().unwrap(), polygons + 1], "{name}");
        let border: Vec<u32> = s.incident_vertices(s.outer_face()).map(VertexId::number).collect();
        assert_eq!(border.len() as u64, stated["boundary_edges"].as_u64().unwrap(), "{name}");
        assert_eq!(border.iter().collect::<BTreeSet<_>>(), outline.iter().collect(), "{name}: outline");
        files += 1;
    }
    assert_eq!(files, 18);
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn the_states_have_their_107_borders() {
    let options = ReadOptions { y_down: true, drop_degenerate_rings: true, ..ReadOptions::default() };
    let soup = soup(&data("O08-us-atlas/states-albers-10m.json"), &options);
    let s = convert(&soup, true);
    assert_eq!((s.vertex_count(), s.edge_count(), components(&s), s.face_count()), (6818, 6872, 143, 198));
    let name = |f: FaceId| soup.names.get((f.number() as usize).checked_sub(1)?)?.clone();
    let mut borders: BTreeMap<String, BTreeSet<String>> =
        soup.names.iter().flatten().map(|n| (n.clone(), BTreeSet::new())).collect();
    for h in s.half_edges() {
        let across = name(s.face(h)).zip(name(s.face(h.twin())));
        if let Some((a, b)) = across.filter(|(a, b)| a != b) {
            borders.get_mut(&a).unwrap().insert(b);
        }
    }
    let stated = json("O08-us-atlas/state_adjacency.json");
    for (state, neighbours) in stated.as_object().unwrap() {
        let neighbours: BTreeSet<String> =
            neighbours.as_array().unwrap().iter().map(|n| n.as_str().unwrap().to_owned()).collect();
        assert_eq!(borders[state], neighbours, "{state}");
    }
    let total: usize = borders.values().map(BTreeSet::len).sum();
    assert_eq!(total, 2 * 107);

    let four: BTreeSet<_> = ["Arizona", "Colorado", "New Mexico", "Utah"].into();
    let corner = s.vertices().filter(|&v| {
        let names: BTreeSet<_> = s.incident_faces(v).filter_map(name).collect();
        names.iter().map(String::as_str).collect::<BTreeSet<_>>() == four
    });
    let corner: Vec<_> = corner.collect();
    assert_eq!(corner.len(), 1);
    assert_eq!(s.degree(corner[0]), 4);
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn nations_are_planar_too() {
    let expected = json("O08-us-atlas/expected.json");
    for file in ["nation-10m.json", "nation-albers-10m.json"] {
        let options = ReadOptions { drop_degenerate_rings: true, ..ReadOptions::default() };
        let s = convert(&soup(&data("O08-us-atlas").join(file), &options), true);
        let stated = &expected[file];
        let counts = [s.vertex_count(), s.edge_count(), components(&s), s.face_count()];
        let stated = ["V", "E", "C", "F_euler"].map(|key| stated[key].as_u64().unwrap() as usize);
        assert_eq!(counts, stated, "{file}");
    }
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn the_arena_has_the_stated_neighbours() {
    let expected = json("O09-polyanya-arena/expected.json");
    for file in ["arena.mesh", "arena-merged.mesh"] {
        let path = data("O09-polyanya-arena").join(file);
        let options = ReadOptions { format: Some(Format::Mesh), ..ReadOptions::default() };
        let s = convert(&soup(&path, &options), true);
        let stated = &expected[format!("open/O09-polyanya-arena/{file}")];
        let polygons = stated["polygons"].as_u64().unwrap() as usize;
        assert_eq!(s.edge_count() as u64, stated["E"].as_u64().unwrap(), "{file}");
        assert_eq!(s.face_count() as u64, stated["F_total_with_obstacles_if_planar"].as_u64().unwrap(), "{file}");

        let text = std::fs::read_to_string(path).unwrap();
        let lines: Vec<Vec<i64>> =
            text.lines().skip(2).map(|l| l.split_whitespace().map(|w| w.parse().unwrap()).collect()).collect();
        let (vertices, faces) = (lines[0][0] as usize, lines[0][1] as usize);
        assert_eq!(faces, polygons);
        let number = |f: FaceId| {
            let i = i64::from(f.number()) - 1;
            if (0..faces as i64).contains(&i) { i } else { -1 }
        };
        // The file lists, for each corner, the polygon across the edge that ends there.
        for (i, line) in lines[1 + vertices..][..faces].iter().enumerate() {
            let n = line[0] as usize;
            let stated: Vec<i64> = line[1 + n..].to_vec();
            let f = FaceId::new(i as u32 + 1);
            let across: Vec<i64> = s.adjacent_faces(f).map(number).collect();
            let starts = s.incident_vertices(f).position(|v| i64::from(v.number()) == line[1]).unwrap();
            let from_first: Vec<i64> = (0..n).map(|k| across[(starts + n - 1 + k) % n]).collect();
            assert_eq!(from_first, stated, "{file}: polygon {i}");
        }
        for (v, line) in lines[1..=vertices].iter().enumerate() {
            let stated: BTreeSet<i64> = line[3..].iter().copied().collect();
            let ours: BTreeSet<i64> = s.incident_faces(VertexId::new(v as u32)).map(number).collect();
            assert_eq!(ours, stated, "{file}: vertex {v}");
        }
    }
}
