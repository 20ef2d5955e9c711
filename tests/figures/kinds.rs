//! Tables, records and panels say what the structure says; marks mark what they name; no option is ignored.

use crate::cases;
use crate::cases::{P, h};
use crate::drawn;
use dcel_kit::figure::sketch::{Backdrop, Role, Sketch};
use dcel_kit::figure::{FigureError, FigureOptions, Overrides, Pointers, focus, inset, pointers, records, tables};
use dcel_kit::topology::{InnerComponent, Table, View};
use dcel_kit::{Element, FaceId, HalfEdgeId, VertexId};
use roxmltree::{Document, Node};
use std::collections::{BTreeMap, BTreeSet};

fn has_class(node: Node<'_, '_>, class: &str) -> bool {
    node.attribute("class").is_some_and(|classes| classes.split(' ').any(|one| one == class))
}

fn by_id<'a, 'i>(document: &'a Document<'i>, id: &str) -> Node<'a, 'i> {
    document.descendants().find(|n| n.attribute("id") == Some(id)).unwrap_or_else(|| panic!("no {id}"))
}

/// The texts right inside a group: words and places.
fn texts(group: Node<'_, '_>) -> Vec<(String, P)> {
    let inside = group.children().filter(|n| n.has_tag_name(("http://www.w3.org/2000/svg", "text")));
    let place = |n: Node<'_, '_>| ["x", "y"].map(|axis| n.attribute(axis).unwrap().parse().unwrap());
    inside.map(|n| (n.text().unwrap().trim().to_owned(), place(n))).collect()
}

/// The box of the first outline of a path.
fn extent(path: Node<'_, '_>) -> [P; 2] {
    let outline = drawn::path(path.attribute("d").unwrap()).remove(0);
    let fold = |f: fn(f64, f64) -> f64| [0, 1].map(|i| outline.iter().map(|p| p[i]).reduce(f).unwrap());
    [fold(f64::min), fold(f64::max)]
}

fn word<I: ToString>(id: Option<I>) -> String {
    id.map_or_else(|| "–".to_owned(), |id| id.to_string())
}

/// What the three tables must say, row by row.
fn expected(table: &Table) -> [Vec<Vec<String>>; 3] {
    let half_edges = (0..table.half_edges.len()).map(|i| {
        let h = h(i);
        let links = [word(table.twin(h)), word(table.next(h)), word(table.prev(h)), word(table.face(h))];
        [h.to_string(), word(table.origin(h))].into_iter().chain(links).collect()
    });
    let vertices = table.vertices.iter().enumerate().map(|(i, row)| {
        let (v, at) = (VertexId::new(i as u32), row.unwrap().position.unwrap());
        vec![v.to_string(), at[0].to_string(), at[1].to_string(), word(table.outgoing(v))]
    });
    let faces = (0..table.faces.len()).map(|i| {
        let f = FaceId::new(i as u32);
        let ring = |ring: &InnerComponent| match ring {
            InnerComponent::Cycle(h) => h.to_string(),
            InnerComponent::Isolated(v) => v.to_string(),
        };
        let rings: Vec<String> = table.inner_components(f).iter().map(ring).collect();
        vec![
            f.to_string(),
            word(table.half_edge(f)),
            if rings.is_empty() { word(None::<FaceId>) } else { rings.join(" ") },
        ]
    });
    [half_edges.collect(), vertices.collect(), faces.collect()]
}

const TABLES: [(&str, &[&str]); 3] = [
    ("half-edges", &["origin", "twin", "next", "prev", "face"]),
    ("vertices", &["x", "y", "outgoing"]),
    ("faces", &["half-edge", "inner components"]),
];

#[test]
fn tables_have_the_rows_of_the_structure_in_order_under_their_heads() {
    for (name, table) in [("lab", cases::lab()), ("islands", cases::islands()), ("stress", cases::stress())] {
        let svg = tables(&table, None, &FigureOptions::new("t")).unwrap().to_svg();
        let document = Document::parse(&svg).unwrap();
        for ((title, head), expected) in TABLES.into_iter().zip(expected(&table)) {
            let group = by_id(&document, &format!("t-table-{title}"));
            let heads = texts(group);
            assert_eq!(heads.iter().map(|(word, _)| word.as_str()).collect::<Vec<_>>(), head, "{name}");
            let rows: Vec<Node<'_, '_>> = group.children().filter(|n| has_class(*n, "row")).collect();
            let words: Vec<Vec<String>> =
                rows.iter().map(|row| texts(*row).into_iter().map(|(word, _)| word).collect()).collect();
            assert_eq!(words, expected, "{name}: {title}");
            let mut above = heads[0].1[1];
            for row in rows {
                let cells = texts(row);
                let y = cells[0].1[1];
                assert!(y > above && cells.iter().all(|(_, at)| (at[1] - y).abs() < 0.01), "{name}: {cells:?}");
                above = y;
                assert_eq!(row.attribute("id"), Some(format!("t-row-{}", cells[0].0).as_str()));
                for ((_, at), (_, head)) in cells[1..].iter().zip(&heads) {
                    assert!((at[0] - head[0]).abs() < 0.01, "{name}: a cell is not under its head");
                }
            }
        }
    }
}

#[test]
fn names_have_a_column_and_faces_have_id_and_name_in_the_picture() {
    let overrides = Overrides::parse("f1 \"kitchen\"\nf2 \"f0\"\nf3 \"\"\nv1 \"A\"\n").unwrap();
    let options = FigureOptions::new("t").overrides(overrides);
    let (lab, count) = (cases::lab(), cases::lab().faces.len());
    let svg = tables(&lab, None, &options).unwrap().to_svg();
    let document = Document::parse(&svg).unwrap();
    let table = |title: &str| -> Vec<Vec<String>> {
        let rows = by_id(&document, &format!("t-table-{title}"));
        let rows = rows.children().filter(|n| has_class(*n, "row"));
        rows.map(|row| texts(row).into_iter().map(|(word, _)| word).collect()).collect()
    };
    let names: Vec<String> = table("faces").into_iter().map(|row| row[3].clone()).collect();
    assert_eq!(names[..4], ["–", "kitchen", "f0", "–"]);
    assert_eq!(names.len(), count);
    let named: Vec<Vec<String>> = table("vertices").into_iter().filter(|row| row[4] != "–").collect();
    assert_eq!(named.iter().map(|row| [&row[0], &row[4]]).collect::<Vec<_>>(), [["v1", "A"]]);
    assert!(table("half-edges").iter().all(|row| row.len() == 6), "no half-edge has a name");
    let label =
        |f: &str| texts(by_id(&document, &format!("t-{f}"))).into_iter().map(|(word, _)| word).collect::<String>();
    assert_eq!(["f1", "f2", "f3"].map(label), ["f1 kitchen", "f2 f0", "f3"]);

    // The two tables below the picture and the long one beside it share no place.
    let boxes = ["half-edges", "vertices", "faces"].map(|title| -> [P; 2] {
        let group = by_id(&document, &format!("t-table-{title}"));
        let under = group.children().find(|n| n.has_tag_name(("http://www.w3.org/2000/svg", "line"))).unwrap();
        let [left, right] = ["x1", "x2"].map(|x| under.attribute(x).unwrap().parse().unwrap());
        let last = group.children().rfind(|n| has_class(*n, "row")).unwrap();
        [[left, texts(group)[0].1[1]], [right, texts(last)[0].1[1]]]
    });
    for (i, a) in boxes.iter().enumerate() {
        for b in &boxes[..i] {
            assert!((0..2).any(|axis| a[1][axis] < b[0][axis] || b[1][axis] < a[0][axis]), "{a:?} and {b:?}");
        }
    }
}

#[test]
fn an_inset_shows_the_part_between_its_corners_and_says_where_it_is() {
    let points =
        [[0., 0.], [1000., 0.], [1000., 500.], [0., 500.], [700., 300.], [704., 300.], [704., 303.], [700., 303.]];
    let sides = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)];
    let table = cases::plane(&points, &sides);
    let options = FigureOptions::new("t");
    for (corners, expected) in [
        (None, vec!["v4", "v5", "v6", "v7"]),
        (Some([[690., 290.], [702., 310.]]), vec!["v4", "v7"]),
        (Some([[-10., -10.], [20., 20.]]), vec!["v0"]),
    ] {
        let svg = inset(&table, corners, &options).unwrap().to_svg();
        let document = Document::parse(&svg).unwrap();
        let ids: Vec<&str> = document.descendants().filter_map(|n| n.attribute("id")).collect();
        assert_eq!(ids.len(), ids.iter().collect::<BTreeSet<_>>().len(), "ids are unique");
        let near: Vec<&str> =
            ids.iter().filter_map(|id| id.strip_prefix("t-z-")).filter(|id| id.starts_with('v')).collect();
        assert_eq!(near, expected);
        assert_eq!(ids.iter().filter(|id| id.starts_with("t-v")).count(), 8, "the whole is above");
        // Edges on both drawings, many times as long below: h8 is the side from v4 to v5.
        let length = |id: &str| {
            let line = by_id(&document, id).children().find(|n| has_class(*n, "sh")).unwrap();
            let [a, b] = ["x1", "x2"].map(|x| line.attribute(x).unwrap().parse::<f64>().unwrap());
            (b - a).abs()
        };
        if corners.is_none() {
            assert!(length("t-z-h8") > 40.0);
            let whole = by_id(&document, "t-h8").children().find(|n| has_class(*n, "sh"));
            assert!(whole.is_none() || length("t-h8") < 5.0);
        }
    }
    let empty = inset(&Table::default(), None, &options);
    assert_eq!(empty.is_ok(), dcel_kit::figure::structure(&Table::default(), &options).is_ok());
}

#[test]
fn a_name_that_reads_like_an_id_stands_in_quotation_marks() {
    let names = [(1, "f0"), (2, "h12"), (3, " "), (4, "f"), (5, "f0a")].map(|(f, name)| (FaceId::new(f), name));
    let options = FigureOptions::new("t").face_names(names);
    let svg = dcel_kit::figure::structure(&cases::lab(), &options).unwrap().to_svg();
    let document = Document::parse(&svg).unwrap();
    let label =
        |f: u32| texts(by_id(&document, &format!("t-f{f}"))).into_iter().map(|(word, _)| word).collect::<String>();
    assert_eq!([1, 2, 3, 4, 5].map(label), ["\u{201c}f0\u{201d}", "\u{201c}h12\u{201d}", "f3", "f", "f0a"]);
}

#[test]
fn names_stand_above_what_is_drawn_over_a_structure() {
    for backdrop in [Backdrop::Plain, Backdrop::Dimmed] {
        let mut sketch = Sketch::new();
        sketch.path(Role::Secondary, [[-0.5, 1.5], [6.5, 1.5]]);
        let svg = sketch.over(&cases::lab(), backdrop, &FigureOptions::new("t")).unwrap().to_svg();
        let document = Document::parse(&svg).unwrap();
        let at = |id: &str| document.descendants().position(|n| n.attribute("id") == Some(id)).unwrap();
        let path = at("t-s-path-1");
        assert!(at("t-h0") < path, "the half-edges are below");
        let names: Vec<usize> = (0..)
            .zip(document.descendants())
            .filter(|(_, n)| has_class(*n, "hl") || has_class(*n, "fl") && n.text() != Some("f0"))
            .map(|(i, _)| i)
            .collect();
        assert!(names.len() > 20 && names.iter().all(|&i| i > path), "{path} {names:?}");
    }
}

#[test]
fn the_marked_row_is_the_marked_element() {
    let table = cases::lab();
    let elements: Vec<Element> = vec![h(13).into(), h(0).into(), VertexId::new(4).into(), FaceId::new(0).into()];
    for element in elements {
        let svg = tables(&table, Some(element), &FigureOptions::new("t")).unwrap().to_svg();
        let document = Document::parse(&svg).unwrap();
        let hot: Vec<&str> =
            document.descendants().filter(|n| has_class(*n, "hot")).map(|n| n.attribute("id").unwrap()).collect();
        assert_eq!(hot, [format!("t-{element}"), format!("t-row-{element}")], "picture, then table");
        let row = by_id(&document, &format!("t-row-{element}"));
        let strip = extent(row.children().find(|n| has_class(*n, "hit")).unwrap());
        let mark = extent(row.children().find(|n| has_class(*n, "mark")).unwrap());
        for (word, [x, y]) in texts(row) {
            assert!(strip[0][1] < y && y < strip[1][1] && strip[0][0] < x && x < strip[1][0], "{element}: {word}");
            assert!(mark[0][1] < y && y < mark[1][1] && mark[1][0] < strip[0][0], "{element}: {word}");
        }
        let dim = document.descendants().filter(|n| has_class(*n, "he") && has_class(*n, "dim")).count();
        assert_eq!(dim, table.half_edges.len() - usize::from(matches!(element, Element::HalfEdge(_))));
    }
    let svg = tables(&table, None, &FigureOptions::new("t")).unwrap().to_svg();
    assert!(!svg.contains(" hot\"") && !svg.contains(" dim\""), "nothing is marked unless asked for");
    let error = tables(&table, Some(h(99).into()), &FigureOptions::new("t")).unwrap_err();
    assert_eq!(error, FigureError::NotDrawn { element: h(99).into() });
}

#[test]
fn long_tables_end_and_say_so() {
    let table = cases::grid(9, true);
    let figure = tables(&table, None, &FigureOptions::new("t")).unwrap();
    let svg = figure.to_svg();
    let rows = |kind: char| svg.matches(&format!("id=\"t-row-{kind}")).count();
    assert_eq!((rows('h'), rows('v'), rows('f')), (120, 81, 120));
    let more = [(table.half_edges.len() - 120, "half-edges"), (table.faces.len() - 120, "faces")];
    for (more, what) in more {
        assert!(figure.notes().contains(&format!("{more} more rows of {what} are not shown")), "{:?}", figure.notes());
    }
}

/// From the row of the field to the border of the record that the field refers to.
#[test]
fn every_reference_of_the_records_leaves_its_field_and_reaches_its_record() {
    let svg = records(&FigureOptions::new("r")).to_svg();
    let document = Document::parse(&svg).unwrap();
    let mut boxes = BTreeMap::new();
    // The row of every field, and the type written beside it.
    let mut fields = BTreeMap::new();
    for record in ["Dcel", "Vertex", "HalfEdge", "Face"] {
        let group = by_id(&document, &format!("r-{}", record.to_lowercase()));
        boxes.insert(record, extent(group.children().find(|n| n.attribute("class") == Some("rec")).unwrap()));
        let words = texts(group);
        assert_eq!(words[0].0, record);
        for pair in words[1..].chunks(2) {
            fields.insert(format!("{record}.{}", pair[0].0), (pair[0].1[1], pair[1].0.clone()));
        }
    }
    let mut drawn_fields = BTreeSet::new();
    for arrow in document.descendants().filter(|n| has_class(*n, "ptr")) {
        let path = |class: &str| arrow.children().find(|n| has_class(*n, class)).unwrap();
        let line = drawn::path(path("pl").attribute("d").unwrap());
        let (start, tip) = (line[0][0], drawn::path(path("ph").attribute("d").unwrap())[0][0]);
        let on_border = |p: P, [low, high]: [P; 2]| {
            let inside = (0..2).all(|i| p[i] >= low[i] - 0.1 && p[i] <= high[i] + 0.1);
            inside && (0..2).any(|i| (p[i] - low[i]).abs() < 0.1 || (p[i] - high[i]).abs() < 0.1)
        };
        let at = |p: P| boxes.iter().find(|(_, bounds)| on_border(p, **bounds)).map(|(record, _)| *record);
        let (from, to) = (at(start).expect("starts at a record"), at(tip).expect("ends at a record"));
        if has_class(arrow, "owns") && from == "Dcel" && (start[1] - boxes["Dcel"][1][1]).abs() < 0.1 {
            drawn_fields.insert("Dcel.half_edges".to_owned());
            assert_eq!(to, "HalfEdge");
            continue;
        }
        let row =
            fields.iter().find(|(name, (y, _))| name.starts_with(&format!("{from}.")) && (y - start[1]).abs() < 2.0);
        let (field, (_, kind)) = row.unwrap_or_else(|| panic!("from {start:?} of {from} to {to}: not at a field"));
        assert_eq!(kind.trim_start_matches("list of "), to, "{field}");
        let class = match field.split('.').nth(1).unwrap() {
            "vertices" | "half_edges" | "faces" => "owns",
            "prev" => "next",
            "half_edge" => "boundary",
            "face" => "face-of",
            name => name,
        };
        assert!(has_class(arrow, class), "{field} has the colour of another family");
        assert!(drawn_fields.insert(field.clone()), "{field} twice");
    }
    fields.retain(|name, _| name != "Vertex.position");
    assert_eq!(drawn_fields, fields.into_keys().collect());
}

/// The tags of the arrows name the face of the half-edge, and a missing pointer has no arrow.
#[test]
fn face_arrows_say_the_right_face() {
    for (name, table) in [("lab", cases::lab()), ("islands", cases::islands())] {
        let figure = pointers(&table, &[Pointers::Face], &FigureOptions::new("p")).unwrap();
        let picture = drawn::read(&figure.to_svg());
        let svg = figure.to_svg();
        let document = Document::parse(&svg).unwrap();
        let label = |f: &str| picture.words.iter().find(|w| w.class == "fl" && w.text == f).map(|w| (w.at, w.half()));
        let mut tags = 0;
        for arrow in document.descendants().filter(|n| has_class(*n, "face-of") && n.attribute("id").is_some()) {
            let own = arrow.attribute("id").unwrap().trim_start_matches("p-").trim_end_matches("-face-of");
            let face = word(table.face(own.parse::<HalfEdgeId>().unwrap()));
            let title = arrow.children().find(|n| n.tag_name().name() == "title").unwrap().text().unwrap().trim();
            assert_eq!(title, format!("{own}.face = {face}"), "{name}");
            let head = arrow.children().find(|n| has_class(*n, "ph")).unwrap();
            let tip = drawn::path(head.attribute("d").unwrap())[0][0];
            if let Some((tag, _)) = texts(arrow).first() {
                assert_eq!(*tag, face, "{name}: {own}");
                tags += 1;
            } else {
                let (at, half) = label(&face).unwrap();
                let off = [0, 1].map(|i| ((tip[i] - at[i]).abs() - half[i]).max(0.0));
                assert!(off[0].hypot(off[1]) < 8.0, "{name}: the arrow of {own} ends {off:?} from the label of {face}");
            }
        }
        assert!(tags > 0, "{name}");
    }
}

#[test]
fn parts_show_their_elements_and_note_what_leads_out() {
    let table = cases::lab();
    let chosen = [FaceId::new(1), FaceId::new(2)];
    let inside: BTreeSet<String> = (0..table.half_edges.len())
        .filter(|&i| table.face(h(i)).is_some_and(|f| chosen.contains(&f)))
        .map(|i| h(i).to_string())
        .collect();
    let options = FigureOptions::new("p").faces(chosen);
    let ids = |svg: &str, class: &str| -> BTreeSet<String> {
        let document = Document::parse(svg).unwrap();
        let found = document.descendants().filter(|n| has_class(*n, class));
        found
            .map(|n| n.attribute("id").unwrap().trim_start_matches("p-").trim_start_matches("row-").to_owned())
            .collect()
    };
    let panel = pointers(&table, &[Pointers::Twin], &options).unwrap();
    assert_eq!(ids(&panel.to_svg(), "he"), inside);
    let twins = panel.notes().iter().find_map(|note| note.strip_prefix("leading to what is not drawn: ")).unwrap();
    let lone = inside.iter().filter(|name| !inside.contains(&word(table.twin(name.parse().unwrap()))));
    let mut lone: Vec<String> = lone.map(|name| format!("{name}.twin")).collect();
    lone.sort_by_key(|name| name[1..].split('.').next().unwrap().parse::<u32>().unwrap());
    assert_eq!(twins, lone.join(", "));
    let rows = ids(&tables(&table, None, &options).unwrap().to_svg(), "row");
    let half_edges: BTreeSet<String> = rows.into_iter().filter(|name| name.starts_with('h')).collect();
    assert_eq!(half_edges, inside);

    let own: HalfEdgeId = inside.first().unwrap().parse().unwrap();
    assert_eq!(ids(&focus(&table, own, &options).unwrap().to_svg(), "he"), inside);
    let other = (0..table.half_edges.len()).map(h).find(|h| !inside.contains(&h.to_string())).unwrap();
    let error = FigureError::NotDrawn { element: other.into() };
    assert_eq!(focus(&table, other, &options).unwrap_err(), error);
    assert_eq!(tables(&table, Some(other.into()), &options).unwrap_err(), error);
    let missing = FigureOptions::new("p").faces([FaceId::new(99)]);
    assert!(matches!(pointers(&table, &[Pointers::Next], &missing), Err(FigureError::UnknownFace { .. })));
}

/// A picture that is cropped and stands beside others ends at its own border, in a window of its own.
#[test]
fn windows_end_where_panels_and_tables_begin() {
    let table = cases::lab();
    let at = |v: u32| table.vertices[v as usize].unwrap().position.unwrap();
    let corners = [at(0), at(6)];
    let options = || FigureOptions::new("p").crop(corners[0], corners[1]);
    let whole = FigureOptions::new("p");
    let figures = [
        (
            pointers(&table, &[Pointers::Next, Pointers::Twin], &options()),
            pointers(&table, &[Pointers::Next, Pointers::Twin], &whole),
            2,
        ),
        (focus(&table, h(0), &options()), focus(&table, h(0), &whole), 1),
        (tables(&table, None, &options()), tables(&table, None, &whole), 1),
    ];
    for (cropped, whole, windows) in figures {
        let (cropped, whole) = (cropped.unwrap().to_svg(), whole.unwrap().to_svg());
        let document = Document::parse(&cropped).unwrap();
        let inner: Vec<Node<'_, '_>> =
            document.root_element().descendants().skip(1).filter(|n| n.tag_name().name() == "svg").collect();
        assert_eq!(inner.len(), windows);
        assert_eq!(Document::parse(&whole).unwrap().descendants().filter(|n| n.tag_name().name() == "svg").count(), 1);
        for window in inner {
            assert!(window.has_attribute("width") && window.has_attribute("height"));
            let shown = window.descendants().filter(|n| has_class(*n, "he")).count();
            assert!(shown > 2 && shown < table.half_edges.len(), "{shown}");
        }
    }
}
