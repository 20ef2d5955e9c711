//! A table in columns says the same as the table of rows, right or wrong, and becomes the same subdivision or the same error.

use crate::round_trips::{random_table, same_table, written};
use crate::support::{Face, Random, grid, island, structure, table};
use dcel_kit::io::{Document, Format, LoadOptions, Model, ReadOptions, assemble, read_bytes};
use dcel_kit::plane::{Subdivision, TableError};
use dcel_kit::topology::{Table, TableColumns, View, violations};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};

fn columns(text: &[u8], options: &ReadOptions) -> TableColumns {
    let options = ReadOptions { columns: true, ..options.clone() };
    match read_bytes(text, Format::Dcel, "file", &options).unwrap_or_else(|error| panic!("{error}")).document {
        Document::Columns(columns) => columns,
        other => panic!("no columns: {other:?}"),
    }
}

/// Compares what both say. Returns the subdivision, if it is one.
fn check(original: &Table, what: &str) -> Result<Subdivision, TableError> {
    let text = written(&Model::table(original), Format::Dcel);
    let (rows, columns) = (table(&text), columns(&text, &ReadOptions::default()));
    assert_eq!(Table::from_view(&columns), Table::from_view(&rows), "{what}");
    assert_eq!(violations(&columns), violations(&rows), "{what}");
    for f in (0..columns.face_bound() as u32 + 2).map(FaceId::new) {
        let row = rows.faces.get(f.index()).and_then(Option::as_ref);
        assert_eq!(columns.name(f), row.and_then(|row| row.name.as_deref()), "{what}: {f}");
    }
    let model = Model::planar(&columns).with_names(|f| columns.name(f));
    assert!(written(&model, Format::Dcel) == text, "{what}");
    let (mut rest, expected) = (columns.clone(), Subdivision::from_table(&rows));
    let made = Subdivision::from_columns(&mut rest);
    assert_eq!(made, expected, "{what}");
    assert_eq!(rest, if made.is_ok() { TableColumns::default() } else { columns.clone() }, "{what}: what is left");
    let bytes = |made: &Result<Subdivision, TableError>| made.as_ref().map_or(0, Subdivision::memory_bytes);
    assert_eq!(bytes(&made), bytes(&expected), "{what}: no more room than is used");
    assert!(same_table(&columns.clone().into_table(), &rows), "{what}");
    made
}

#[test]
fn columns_hold_any_table_however_broken() {
    for seed in 0..2000 {
        let _ = check(&random_table(&mut Random::new(seed)), &format!("seed {seed}"));
    }
}

#[test]
fn y_is_turned_in_columns_as_in_rows() {
    let text = b"dcel 1\nv0 1 2\nv1\nv3 0 0\n";
    let turned = columns(text, &ReadOptions { y_down: true, ..ReadOptions::default() });
    let positions: Vec<_> = (0..5).map(|v| turned.position(VertexId::new(v))).collect();
    assert_eq!(positions, [Some([1.0, -2.0]), None, None, Some([0.0, 0.0]), None]);
    assert_eq!(positions[3].map(|p| p[1].is_sign_negative()), Some(false));
}

/// Changes one thing of a table.
fn spoilt(table: &Table, random: &mut Random) -> Table {
    let mut table = table.clone();
    let h = random.below(table.half_edges.len());
    let (v, f) = (random.below(table.vertices.len()), random.below(table.faces.len()));
    let other = HalfEdgeId::new(random.below(table.half_edges.len() + 1) as u32);
    let pointer = (random.below(4) > 0).then_some(other);
    let row = table.half_edges[h].as_mut().expect("a row");
    match random.below(13) {
        0 => row.twin = pointer,
        1 => row.next = pointer,
        2 => row.prev = pointer,
        3 => row.face = Some(FaceId::new(f as u32)),
        4 => row.origin = Some(VertexId::new(v as u32)),
        5 => table.half_edges[h] = None,
        6 => table.vertices[v] = None,
        7 => table.faces[f] = None,
        8 => table.outer_face = (random.below(2) > 0).then_some(FaceId::new(f as u32)),
        9 => table.vertices[v].as_mut().expect("a row").position = None,
        10 => table.vertices[v].as_mut().expect("a row").position = Some([random.coordinate(), 1.5]),
        11 => table.faces[f].as_mut().expect("a row").hole ^= true,
        _ => table.faces[f].as_mut().expect("a row").half_edge = pointer,
    }
    table
}

/// The same with the numbers of two faces or two half-edges exchanged.
fn renumbered(table: &Table, random: &mut Random) -> Table {
    let text = String::from_utf8(written(&Model::table(table), Format::Dcel)).expect("text");
    let (letter, count) = if random.below(2) == 0 { ('f', table.faces.len()) } else { ('h', table.half_edges.len()) };
    let (a, b) = (format!("{letter}{}", random.below(count)), format!("{letter}{}", random.below(count)));
    let line = |line: &str| {
        let words = line.split(' ').map(|word| {
            if word == a {
                &b
            } else if word == b {
                &a
            } else {
                word
            }
        });
        words.collect::<Vec<_>>().join(" ") + "\n"
    };
    crate::support::table(text.lines().map(line).collect::<String>().as_bytes())
}

#[test]
fn columns_become_the_same_subdivision_or_the_same_error() {
    let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    let whole = [grid(3, true), grid(2, false), island(), structure(&square, &[Face::new(&[&[0, 1, 2, 3]])])];
    let (mut good, mut bad) = (0, 0);
    for (i, table) in whole.iter().enumerate() {
        assert!(check(table, &format!("table {i}")).is_ok());
        for seed in 0..400 {
            let random = &mut Random::new(seed);
            let what = format!("table {i}, seed {seed}");
            let changed = if seed % 4 == 0 { renumbered(table, random) } else { spoilt(table, random) };
            let is_good = check(&changed, &what).is_ok();
            *(if is_good { &mut good } else { &mut bad }) += 1;
        }
    }
    assert!(good > 100 && bad > 500, "{good} and {bad}");
}

#[test]
fn names_go_with_their_faces_when_the_outer_face_becomes_f0() {
    let text = written(&Model::table(&grid(1, true)), Format::Dcel);
    let text = String::from_utf8(text).expect("text").replace("f0 outer", "f0 name \"sea\" outer");
    let text = text.replace("\nf1 ", "\nf1 name \"a\" ").replace("\nf2 ", "\nf2 name \"b\" ");
    let exchanged = text.replace("f0", "fx").replace("f2", "f0").replace("fx", "f2");
    for (text, first) in [(text, "sea"), (exchanged, "sea")] {
        let loaded = [false, true].map(|columns| {
            let options = ReadOptions { columns, ..ReadOptions::default() };
            let read = read_bytes(text.as_bytes(), Format::Dcel, "file", &options).unwrap_or_else(|e| panic!("{e}"));
            assemble(read, "file", &LoadOptions::default()).unwrap_or_else(|error| panic!("{error}"))
        });
        let [rows, columns] = &loaded;
        assert_eq!(rows.structure, columns.structure);
        let name = |i: usize, f: u32| loaded[i].names.get(FaceId::new(f)).and_then(|name| name.as_deref());
        for f in 0..4 {
            assert_eq!(name(0, f), name(1, f), "f{f}");
        }
        assert_eq!(name(1, 0), Some(first));
    }
}
