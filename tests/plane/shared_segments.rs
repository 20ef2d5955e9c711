//! Promise: segments give the faces that others state for lines, ways, drawings and polygons (`../shared/data`,
//! families O02, O04, O05, O07, O12, O14).

use dcel_kit::io::{Document, Format, ReadOptions, SegmentSoup, read_bytes, read_path};
use dcel_kit::plane::predicates::orientation;
use dcel_kit::plane::{ArrangeOptions, Arranged, Point, SegmentFault, SegmentsError, Subdivision};
use dcel_kit::topology::{InnerComponent, components, violations};
use dcel_kit::{FaceId, VertexId};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

fn data(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data").join(path)
}

fn json(path: &Path) -> Value {
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

fn arrange(soup: &SegmentSoup, split: bool) -> Result<Arranged, SegmentsError> {
    let options = ArrangeOptions { merge: true, split, ..ArrangeOptions::default() };
    let arranged = Subdivision::arrange_graph(&soup.points, &soup.segments, &options)?;
    let s = &arranged.subdivision;
    assert_eq!((violations(s), s.geometry_violations()), (vec![], vec![]));
    let (v, e, f) = (s.vertex_count() as i64, s.edge_count() as i64, s.face_count() as i64);
    assert_eq!(v - e + f, 1 + components(s).count() as i64);
    Ok(arranged)
}

fn wkt(text: &str) -> SegmentSoup {
    let outlines = ReadOptions { outlines: true, ..ReadOptions::default() };
    let read = read_bytes(text.as_bytes(), Format::Wkt, "text", &outlines);
    match read.unwrap_or_else(|e| panic!("{e}")).document {
        Document::Segments(soup) => soup,
        _ => panic!("segments expected"),
    }
}

// ---- polygons as sets of rings ------------------------------------------------------------------------------------

type Corner = (u64, u64);
/// A polygon: its outer ring, then its holes in order; each ring without direction and start.
type Polygon = (Vec<Corner>, Vec<Vec<Corner>>);

fn corner(p: Point) -> Corner {
    ((p.x + 0.0).to_bits(), (p.y + 0.0).to_bits())
}

fn canonical(mut ring: Vec<Corner>) -> Vec<Corner> {
    if ring.len() > 1 && ring.first() == ring.last() {
        ring.pop();
    }
    let back: Vec<Corner> = ring.iter().rev().copied().collect();
    let turns = |ring: &[Corner]| (0..ring.len()).map(|i| [&ring[i..], &ring[..i]].concat()).min().unwrap_or_default();
    turns(&ring).min(turns(&back))
}

fn polygon(mut rings: Vec<Vec<Corner>>) -> Polygon {
    let outer = canonical(rings.remove(0));
    let mut holes: Vec<_> = rings.into_iter().map(canonical).collect();
    holes.sort();
    (outer, holes)
}

/// The bounded faces of the segments without dangles and cut edges.
fn polygons_of(s: &Subdivision) -> BTreeSet<Polygon> {
    let residues = s.dangles_and_cut_edges();
    let gone: BTreeSet<_> = residues.dangles.iter().chain(&residues.cut_edges).copied().collect();
    let kept = s.edges().filter(|e| !gone.contains(e)).map(|e| e.half_edges().map(|h| s.point(s.origin(h))));
    let s = Subdivision::from_segments(&kept.collect::<Vec<_>>()).unwrap();
    assert_eq!(s.dangles_and_cut_edges(), Default::default(), "what is left bounds faces");
    let faces = s.faces().filter(|&f| f != s.outer_face());
    let ring = |h| s.cycle(h).map(|h| corner(s.point(s.origin(h)))).collect();
    faces.map(|f| polygon(s.cycles(f).map(ring).collect())).collect()
}

/// The polygons of a file. Their numbers are read by the kit, which rounds them correctly.
fn geojson_polygons(path: &Path) -> BTreeSet<Polygon> {
    let Document::Polygons(soup) = read_path(path, &ReadOptions::default()).unwrap().document else { panic!() };
    let at = |&p: &u32| corner(Point::new(soup.points[p as usize][0], soup.points[p as usize][1]));
    let rings = |face| soup.faces.cycles(face).map(|cycle| cycle.iter().map(at).collect()).collect();
    (0..soup.faces.face_count()).map(|face| polygon(rings(face))).collect()
}

/// The polygons in a text such as `GEOMETRYCOLLECTION (POLYGON ((0 0, 1 0, 0 1, 0 0)))`, read anew: every innermost
/// bracket is a ring, every bracket round rings a polygon.
fn wkt_polygons(text: &str) -> BTreeSet<Polygon> {
    let mut found = BTreeSet::new();
    let mut stack: Vec<(String, Vec<Vec<Corner>>)> = vec![Default::default()];
    for c in text.chars() {
        match c {
            '(' => stack.push(Default::default()),
            ')' => {
                let (text, rings) = stack.pop().unwrap();
                if !rings.is_empty() {
                    found.insert(polygon(rings));
                } else if text.bytes().any(|b| b.is_ascii_digit()) {
                    let number = |word: &str| word.parse::<f64>().unwrap();
                    let point = |pair: &str| {
                        let mut words = pair.split_whitespace().map(number);
                        corner(Point::new(words.next().unwrap(), words.next().unwrap()))
                    };
                    let ring = text.split(',').map(point).collect();
                    stack.last_mut().unwrap().1.push(ring);
                }
            }
            c => stack.last_mut().unwrap().0.push(c),
        }
    }
    found
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn lines_polygonize_as_stated() {
    let folder = data("O04-turf/turf-polygonize/test");
    let mut refused = Vec::new();
    let mut files = 0;
    for entry in std::fs::read_dir(folder.join("in")).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        let Document::Segments(soup) = read_path(&path, &ReadOptions::default()).unwrap().document else { panic!() };
        files += 1;
        match arrange(&soup, false) {
            Ok(arranged) => {
                let stated = geojson_polygons(&folder.join("out").join(&name));
                assert!(!stated.is_empty());
                assert_eq!(polygons_of(&arranged.subdivision), stated, "{name}");
            }
            Err(SegmentsError::Faults { faults, .. }) => {
                assert!(
                    faults.iter().all(|fault| matches!(fault, SegmentFault::Crossing { .. })),
                    "{name}: {faults:?}"
                );
                assert!(!arrange(&soup, true).unwrap().crossings.is_empty());
                refused.push(name);
            }
            Err(other) => panic!("{name}: {other}"),
        }
    }
    assert_eq!((files, refused), (7, vec!["kinked-linestring.geojson".to_owned()]));
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn cases_of_jts_polygonize_as_stated() {
    let text = std::fs::read_to_string(data("O14-jts-xml/TestPolygonize.xml")).unwrap();
    let document = roxmltree::Document::parse(&text).unwrap();
    let (mut equal, mut touching) = (0, 0);
    for case in document.descendants().filter(|n| n.has_tag_name("case")) {
        let part = |name: &str| case.descendants().find(|n| n.has_tag_name(name)).and_then(|n| n.text()).unwrap();
        let stated = wkt_polygons(part("op"));
        match arrange(&wkt(part("a")), false) {
            Ok(arranged) => {
                assert_eq!(polygons_of(&arranged.subdivision), stated, "{}", part("desc"));
                equal += 1;
            }
            // Its lines touch without a common point, and the source leaves them so.
            Err(SegmentsError::Faults { faults, .. }) => {
                assert!(faults.iter().all(|fault| matches!(fault, SegmentFault::Touching { .. })), "{faults:?}");
                touching += 1;
            }
            Err(other) => panic!("{other}"),
        }
    }
    assert_eq!((equal, touching), (5, 1));
}

/// The area on the left of all cycles of a face, times two.
fn doubled_area(s: &Subdivision, f: FaceId) -> f64 {
    let cross = |a: Point, b: Point| a.x * b.y - a.y * b.x;
    s.cycles(f).flat_map(|h| s.cycle(h)).map(|h| cross(s.point(s.origin(h)), s.point(s.destination(h)))).sum()
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn areas_of_ways_are_unions_of_faces() {
    let expected = json(&data("O07-osm-grid/expected.json"));
    let mut checked = 0;
    for (case, stated) in expected.as_object().unwrap() {
        let areas: Vec<&str> = stated["areas"].as_array().unwrap().iter().filter_map(Value::as_str).collect();
        if areas.contains(&"INVALID") {
            continue;
        }
        let path = data("O07-osm-grid/7").join(case).join("ways.wkt");
        let Document::Segments(soup) = read_path(&path, &ReadOptions::default()).unwrap().document else { panic!() };
        let s = arrange(&soup, true).unwrap_or_else(|e| panic!("{case}: {e}")).subdivision;
        // The area may leave out vertices of the ways; with its segments no edge is new.
        let mut both = soup.clone();
        let mut outline: Vec<usize> = Vec::new();
        let mut doubled = 0.0;
        for area in &areas {
            let shapes = wkt(area);
            let first = both.points.len() as u32;
            both.points.extend(&shapes.points);
            outline.extend(both.segments.len()..both.segments.len() + shapes.segments.len());
            both.segments.extend(shapes.segments.iter().map(|ends| ends.map(|p| p + first)));
            for (outer, holes) in wkt_polygons(&area.replacen("MULTIPOLYGON(", "(", 1)) {
                let area = |ring: &[Corner]| -> f64 {
                    let at = |c: Corner| Point::new(f64::from_bits(c.0), f64::from_bits(c.1));
                    let sides = ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&a, &b)| (at(a), at(b)));
                    sides.map(|(a, b)| a.x * b.y - a.y * b.x).sum::<f64>().abs()
                };
                doubled += area(&outer) - holes.iter().map(|hole| area(hole)).sum::<f64>();
            }
        }
        let arranged = arrange(&both, true).unwrap();
        assert_eq!(arranged.subdivision.edge_count(), s.edge_count(), "{case}: every side of the area is an edge");
        let s = arranged.subdivision.clone();
        // The outline flips between inside and outside; f0 is outside.
        let mut flips = vec![false; s.edge_bound()];
        outline.iter().flat_map(|&i| arranged.chain(i)).for_each(|h| flips[h.edge().index()] ^= true);
        let mut inside: BTreeMap<FaceId, bool> = BTreeMap::from([(s.outer_face(), false)]);
        let mut open = vec![s.outer_face()];
        while let Some(f) = open.pop() {
            for h in s.cycles(f).flat_map(|h| s.cycle(h)) {
                let flips = flips[h.edge().index()];
                let other = s.face(h.twin());
                match inside.get(&other) {
                    None => {
                        inside.insert(other, inside[&f] ^ flips);
                        open.push(other);
                    }
                    Some(&known) => assert_eq!(known, inside[&f] ^ flips, "{case}: {f} and {other}"),
                }
            }
        }
        assert_eq!(inside.len(), s.face_count(), "{case}");
        let sum: f64 = inside.iter().filter(|(_, inside)| **inside).map(|(&f, _)| doubled_area(&s, f)).sum();
        assert!((sum - doubled).abs() < 1e-9, "{case}: {sum} for {doubled}");
        checked += 1;
    }
    assert_eq!(checked, 50);
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn straight_line_drawings_have_the_stated_face_walks() {
    let graphs = json(&data("O12-networkx-planarity/embeddings.json"));
    for (name, graph) in graphs.as_object().unwrap() {
        let number = |v: &Value| v.as_u64().unwrap() as u32;
        let positions = graph["straight_line_positions"].as_object().unwrap();
        let mut points = vec![Point::default(); positions.len()];
        for (v, place) in positions {
            let [x, y] = [0, 1].map(|i| place[i].as_f64().unwrap());
            points[v.parse::<usize>().unwrap()] = Point::new(x, y);
        }
        let mut edges: Vec<[u32; 2]> = Vec::new();
        for (u, around) in graph["rotation_cw"].as_object().unwrap() {
            let u: u32 = u.parse().unwrap();
            edges.extend(around.as_array().unwrap().iter().map(number).filter(|&v| u < v).map(|v| [u, v]));
        }
        // The parts of a drawing may lie over each other: components are then built one by one.
        let whole = Subdivision::from_graph(&points, &edges);
        if graph["C"] != 1 {
            if let Ok(s) = &whole {
                assert_eq!(s.face_count() as u64, graph["F_planar"].as_u64().unwrap(), "{name}");
            }
            continue;
        }
        let s = whole.unwrap_or_else(|e| panic!("{name}: {e}"));
        let counts = [s.vertex_count(), s.edge_count(), s.face_count()].map(|n| n as u64);
        assert_eq!(counts, ["V", "E", "F_planar"].map(|key| graph[key].as_u64().unwrap()), "{name}");
        let least = |walk: Vec<u32>| (0..walk.len()).map(|i| [&walk[i..], &walk[..i]].concat()).min().unwrap();
        let stated: BTreeSet<Vec<u32>> = graph["face_walks"]
            .as_array()
            .unwrap()
            .iter()
            .map(|walk| least(walk.as_array().unwrap().iter().map(number).collect()))
            .collect();
        let walk = |f| s.incident_vertices(f).map(VertexId::number).collect::<Vec<_>>();
        let ours: BTreeSet<Vec<u32>> = s.faces().map(|f| least(walk(f))).collect();
        let reversed = s.faces().map(|f| least(walk(f).into_iter().rev().collect())).collect();
        assert!(stated == ours || stated == reversed, "{name}: {ours:?}, stated {stated:?}");
        for (v, around) in graph["rotation_cw"].as_object().unwrap() {
            let v = VertexId::new(v.parse().unwrap());
            let clockwise: Vec<u32> = s.outgoing_half_edges(v).rev().map(|h| s.destination(h).number()).collect();
            assert_eq!(least(clockwise), least(around.as_array().unwrap().iter().map(number).collect()), "{name}: {v}");
        }
    }
    for (name, edges) in json(&data("O12-networkx-planarity/nonplanar.json")).as_object().unwrap() {
        // However a graph that is not planar is drawn, something meets.
        let edges: Vec<[u32; 2]> =
            edges.as_array().unwrap().iter().map(|e| [0, 1].map(|i| e[i].as_u64().unwrap() as u32)).collect();
        let n = edges.as_flattened().iter().max().unwrap() + 1;
        let points: Vec<Point> = (0..n).map(|i| Point::new(f64::from(i), f64::from(i * i % 31))).collect();
        assert!(matches!(Subdivision::from_graph(&points, &edges), Err(SegmentsError::Faults { .. })), "{name}");
    }
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn drawn_tilings_have_the_stated_counts_and_their_labels_in_their_faces() {
    let folder = data("O05-tessella-dcel");
    let expected = json(&folder.join("expected.json"));
    let (mut files, mut all_convex) = (0, 0);
    for (name, stated) in expected.as_object().unwrap().iter().filter(|(_, stated)| stated["lines"].is_u64()) {
        let text = std::fs::read_to_string(folder.join(name)).unwrap();
        let document = roxmltree::Document::parse(&text).unwrap();
        let number = |n: roxmltree::Node<'_, '_>, name: &str| n.attribute(name).unwrap().parse::<f64>().unwrap();
        // The files round to six decimals; equal ends agree to better than three.
        let mut places: BTreeMap<(i64, i64), u32> = BTreeMap::new();
        let mut points = Vec::new();
        let mut end = |x: f64, y: f64| {
            *places.entry(((x * 1e3).round() as i64, (y * 1e3).round() as i64)).or_insert_with(|| {
                points.push(Point::new(x, -y));
                points.len() as u32 - 1
            })
        };
        let lines: Vec<[u32; 2]> = document
            .descendants()
            .filter(|n| n.has_tag_name("line"))
            .map(|n| [end(number(n, "x1"), number(n, "y1")), end(number(n, "x2"), number(n, "y2"))])
            .collect();
        let mut s = Subdivision::from_graph(&points, &lines).unwrap_or_else(|e| panic!("{name}: {e}"));
        let counts = [s.vertex_count(), s.edge_count(), components(&s).count(), s.face_count()].map(|n| n as u64);
        assert_eq!(counts, ["V", "E", "C", "F_with_outer"].map(|key| stated[key].as_u64().unwrap()), "{name}");
        // The labels F1, F2, ... stand in the middle of their corners: in a convex face that is inside.
        let labels = document.descendants().filter(|n| {
            n.has_tag_name("text")
                && n.parent().is_some_and(|g| g.attribute("fill") == Some("green"))
                && n.text().is_some_and(|t| t.strip_prefix('F').is_some_and(|t| t.parse::<u32>().is_ok()))
        });
        let labels: Vec<Point> = labels.map(|n| Point::new(number(n, "x"), -number(n, "y"))).collect();
        let convex = |f| {
            let turn =
                |h| orientation(s.point(s.origin(h)), s.point(s.destination(h)), s.point(s.destination(s.next(h))));
            s.incident_half_edges(f).all(|h| turn(h).is_ge()) && s.inner_components(f).is_empty()
        };
        if labels.len() == s.face_count() - 1 && s.faces().skip(1).all(convex) {
            let faces = s.mark_holes(&labels).unwrap_or_else(|e| panic!("{name}: {e}"));
            assert_eq!(faces.iter().collect::<BTreeSet<_>>().len(), s.face_count() - 1, "{name}");
            all_convex += 1;
        }
        files += 1;
    }
    assert_eq!((files, all_convex), (77, 57));
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn simple_polygons_are_one_face_and_the_others_are_refused_by_name() {
    let folder = data("O02-poly2tri");
    let mut simple = 0;
    for (name, stated) in json(&folder.join("expected.json")).as_object().unwrap() {
        let text = std::fs::read_to_string(folder.join(name)).unwrap();
        let corners: Vec<Point> = text
            .lines()
            .filter(|line| !line.starts_with('+'))
            .filter_map(|line| {
                let mut words = line.split_whitespace().map_while(|word| word.parse().ok());
                Some(Point::new(words.next()?, words.next()?))
            })
            .collect();
        let n = corners.len() as u32;
        assert_eq!(u64::from(n), stated["n"].as_u64().unwrap(), "{name}");
        let sides: Vec<[u32; 2]> = (0..n).map(|i| [i, (i + 1) % n]).collect();
        match Subdivision::from_graph(&corners, &sides) {
            Ok(s) => {
                assert_eq!(stated["valid_simple"], true, "{name}");
                assert_eq!((s.face_count(), s.edge_count()), (2, n as usize), "{name}");
                let area = doubled_area(&s, FaceId::new(1)) / 2.0;
                let stated_area = stated["area"].as_f64().unwrap().abs();
                assert!((area - stated_area).abs() <= 1e-9 * stated_area, "{name}: {area} for {stated_area}");
                assert_eq!(s.inner_components(FaceId::new(0)), [] as [InnerComponent; 0], "{name}");
                simple += 1;
            }
            Err(SegmentsError::Faults { faults, .. }) => {
                assert_eq!(stated["valid_simple"], false, "{name}: {}", faults[0]);
                let options = ArrangeOptions { split: true, ..ArrangeOptions::default() };
                Subdivision::arrange_graph(&corners, &sides, &options).unwrap_or_else(|e| panic!("{name}: {e}"));
            }
            Err(other) => panic!("{name}: {other}"),
        }
    }
    assert_eq!(simple, 18);
}
