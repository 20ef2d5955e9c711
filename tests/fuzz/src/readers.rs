//! Every format: read, built, written, read again.

use crate::{Ends, Outcome, assert_place, halves};
use dcel_kit::io::{
    Document, Format, LoadOptions, Loaded, Model, PolygonSoup, Read, ReadError, ReadOptions, ReadProblem, Scenario,
    SegmentSoup, Structure, WriteError, assemble, points_from_text, read_bytes, read_triangle, write, write_triangle,
};
use dcel_kit::plane::{Subdivision, check_coordinate};
use dcel_kit::topology::{Dcel, Mode, Table, violations};

/// What errors call the file.
const FILE: &str = "file";
/// Longer inputs say nothing that shorter ones do not.
const LONGEST: usize = 1 << 16;
/// Larger documents are read, but not built: the checks would take longer than an input is worth.
const LARGEST: usize = 3000;
/// Larger documents are not mended: n segments may have n² crossings.
const MENDED: usize = 120;

macro_rules! formats {
    ($($name:ident: $format:ident;)*) => {
        $(pub(crate) fn $name(data: &[u8]) -> Outcome {
            of_format(data, Format::$format)
        })*
    };
}

formats! {
    obj: Obj;
    off: Off;
    ply: Ply;
    stl: Stl;
    geojson: GeoJson;
    topojson: TopoJson;
    mesh: Mesh;
    map: Map;
    wkt: Wkt;
    poly: Poly;
    segments: Segments;
    dcel: Dcel;
}

fn of_format(data: &[u8], format: Format) -> Outcome {
    let data = &data[..data.len().min(LONGEST)];
    let _ = Format::from_content(data);
    let usual = ReadOptions::default();
    let mut outcome = document(data, read_bytes(data, format, FILE, &usual), true);
    // What is tolerated with a note, too.
    let kind =
        ReadOptions { y_down: true, drop_degenerate_rings: true, close_rings: true, outlines: true, ..usual.clone() };
    let kind = read_bytes(data, format, FILE, &kind);
    if kind.is_ok() || matches!(format, Format::GeoJson | Format::TopoJson) {
        outcome = outcome.and(document(data, kind, false));
    }
    outcome
}

pub(crate) fn triangle(data: &[u8]) -> Outcome {
    let (node, ele) = halves(&data[..data.len().min(LONGEST)]);
    match read_triangle(node, ele, "node", "ele", &ReadOptions::default()) {
        Ok(read) => document(&[node, b"\n", ele].concat(), Ok(read), true),
        Err(error) => {
            let of_node = error.source == "node";
            assert!(of_node || error.source == "ele", "the error names no file: {error}");
            refusal(if of_node { node } else { ele }, &error)
        }
    }
}

pub(crate) fn points(data: &[u8]) -> Outcome {
    let data = &data[..data.len().min(LONGEST)];
    match points_from_text(data, FILE) {
        Ok(list) => {
            assert_eq!(list.points.len(), list.lines.len());
            assert!(list.points.iter().all(|p| p.check().is_ok()), "a bad coordinate");
            // Written as plain numbers they come back.
            if list.points.is_empty() {
                return Outcome::of(&list.notes.join("\n"));
            }
            let text: String = list.points.iter().map(|p| format!("{:?} {:?}\n", p.x, p.y)).collect();
            let again = points_from_text(text.as_bytes(), FILE).unwrap_or_else(|error| panic!("{error}\n{text}"));
            assert_eq!(bits(list.points.iter().map(|p| [p.x, p.y])), bits(again.points.iter().map(|p| [p.x, p.y])));
            Outcome::of(&list.notes.join("\n")).and(Outcome(list.points.len().min(3) as u64))
        }
        Err(error) => refusal(data, &error),
    }
}

pub(crate) fn scenario(data: &[u8]) -> Outcome {
    let data = &data[..data.len().min(LONGEST)];
    match Scenario::parse(data, FILE) {
        Ok(scenario) => {
            for query in &scenario.queries {
                assert_place(data, Ends::Any, query.line.into(), None, "a query");
                assert!(query.precision.is_finite() && query.precision >= 0.0, "{query:?}");
                assert!(query.length.is_none_or(|length| length.is_finite() && length >= 0.0), "{query:?}");
                // A file agrees with itself.
                assert!(query.agrees(query.length, dcel_kit::io::Optimum::Euclidean, 0.0), "{query:?}");
            }
            Outcome::of(&format!("{:?} {:?}", scenario.optimum(), scenario.verdict().misfits()))
        }
        Err(error) => refusal(data, &error),
    }
}

fn bits<const N: usize>(points: impl Iterator<Item = [f64; N]>) -> Vec<[u64; N]> {
    points.map(|point| point.map(f64::to_bits)).collect()
}

/// Claims that an error says something, at a place that is there, and that memory was no reason.
fn refusal(data: &[u8], error: &ReadError) -> Outcome {
    let message = error.to_string();
    assert!(!error.what.to_string().is_empty(), "an error without words: {message:?}");
    assert!(!message.contains('\n'), "an error of several lines: {message:?}");
    assert!(!matches!(*error.what, ReadProblem::OutOfMemory { .. }), "a short file asks for all memory: {message}");
    let of_the_whole = matches!(
        *error.what,
        ReadProblem::Empty
            | ReadProblem::Refused { .. }
            | ReadProblem::TooLarge { .. }
            | ReadProblem::Shape { .. }
            | ReadProblem::NotText
            | ReadProblem::DegenerateRing { .. }
            | ReadProblem::UnclosedRing { .. }
            | ReadProblem::PartnerMissing { .. }
    ) || message.contains("neither text nor a whole binary file");
    match (error.line, error.offset) {
        // A text that is no UTF-8 has no characters to count.
        (Some(line), _) if std::str::from_utf8(data).is_ok() => {
            assert_place(data, Ends::Any, line.into(), error.column.map(u64::from), &message);
        }
        (Some(line), _) => assert!(line > 0, "{message}"),
        (None, Some(byte)) => assert!(byte <= data.len() as u64, "byte {byte} of {}: {message}", data.len()),
        (None, None) => assert!(of_the_whole, "an error without a place: {message}"),
    }
    Outcome::of(&message)
}

/// Claims what every reading promises, then builds, writes and reads again.
fn document(data: &[u8], read: Result<Read, ReadError>, whole: bool) -> Outcome {
    let read = match read {
        Ok(read) => read,
        Err(error) => {
            assert_eq!(error.source, FILE, "the error names another file: {error}");
            return refusal(data, &error);
        }
    };
    let size = match &read.document {
        Document::Polygons(soup) => polygons(soup),
        Document::Segments(soup) => segments_of(soup),
        Document::Table(table) => {
            table_comes_back(table);
            table.half_edges.len() + table.vertices.len()
        }
        Document::Columns(_) => unreachable!("columns were not asked for"),
    };
    let mut outcome = Outcome::of(&read.notes.join("\n")).and(Outcome(size.min(4) as u64));
    if size > LARGEST || !whole {
        return outcome;
    }
    let options = |orient, mend, mode| LoadOptions { orient, mend, mode, ..LoadOptions::default() };
    let mut all = vec![options(false, false, None), options(true, false, Some(Mode::Plane))];
    if size <= MENDED {
        all.push(options(false, true, Some(Mode::Plane)));
    }
    if matches!(read.document, Document::Polygons(_)) {
        all.push(options(true, false, Some(Mode::Surface)));
    }
    for options in all {
        match assemble(read.clone(), FILE, &options) {
            Ok(loaded) => outcome = outcome.and(built(&loaded, &options)),
            Err(error) => {
                let message = error.to_string();
                let named = [FILE, "ele", "node"].iter().any(|name| message.starts_with(&format!("{name}:")));
                assert!(named && message.len() > FILE.len() + 2, "{options:?}: {message:?}");
                assert!(!error.what().is_empty());
                outcome = outcome.and(Outcome::of(&message));
            }
        }
    }
    outcome
}

fn polygons(soup: &PolygonSoup) -> usize {
    let points = soup.points.len();
    assert!(soup.faces.corners().iter().all(|&v| (v as usize) < points), "a corner without a point");
    let fine = |x: &f64| check_coordinate('x', *x).is_ok();
    assert!(soup.points.as_flattened().iter().all(fine), "a bad coordinate");
    assert!(soup.faces.outer_cycles().all(|cycle| !cycle.is_empty()), "a face without corners");
    assert!(soup.blocked.is_sorted() && soup.blocked.iter().all(|&f| (f as usize) < soup.faces.face_count()));
    points + soup.faces.corners().len()
}

fn segments_of(soup: &SegmentSoup) -> usize {
    let points = soup.points.len();
    assert!(soup.segments.as_flattened().iter().all(|&v| (v as usize) < points), "an end without a point");
    assert!(soup.points.iter().chain(&soup.hole_points).all(|p| p.check().is_ok()), "a bad coordinate");
    points + soup.segments.len()
}

/// Any table, a broken one too, is written and read back as the same.
fn table_comes_back(table: &Table) {
    let text = written(&Model::table(table), Format::Dcel).expect("the kit's own text holds everything");
    let read = read_bytes(&text, Format::Dcel, FILE, &ReadOptions::default());
    let Document::Table(again) = read.unwrap_or_else(|error| panic!("{error}")).document else { panic!("no table") };
    assert!(again == *table, "the table changed");
    assert_eq!(written(&Model::table(&again), Format::Dcel).expect("as before"), text, "the text changed");
}

fn written(model: &Model<'_>, format: Format) -> Option<Vec<u8>> {
    let mut bytes = Vec::new();
    match write(&mut bytes, model, format) {
        Ok(()) => Some(bytes),
        Err(WriteError::Io(error)) => panic!("memory refuses to be written: {error}"),
        Err(error) => {
            assert!(!error.to_string().is_empty() && bytes.is_empty(), "{error}: written nevertheless");
            None
        }
    }
}

/// Claims the invariants of what was built, and that every format that holds it gives it back.
fn built(loaded: &Loaded, options: &LoadOptions) -> Outcome {
    let model = match &loaded.structure {
        Structure::Plane(plane) => {
            assert_eq!(violations(plane), [], "{options:?}");
            assert_eq!(plane.geometry_violations(), [], "{options:?}");
            Model::planar(plane)
        }
        Structure::Surface(surface) => {
            assert_eq!(violations(surface), [], "{options:?}");
            Model::surface(
                surface,
                |v| surface.has_vertex(v).then(|| surface.point(v)),
                |f| surface.is_boundary_face(f),
            )
        }
        _ => return Outcome(0),
    };
    let mut held = 0;
    for (i, format) in Format::ALL.into_iter().enumerate().filter(|(_, format)| format.can_write()) {
        let Some(bytes) = (format != Format::Triangle).then(|| written(&model, format)).flatten() else { continue };
        held |= 1 << i;
        match format {
            Format::Tables => {}
            Format::Dcel => dcel_comes_back(&bytes, &loaded.structure),
            _ => polygons_come_back(&bytes, format, &loaded.structure),
        }
    }
    let (mut node, mut ele) = (Vec::new(), Vec::new());
    if matches!(loaded.structure, Structure::Plane(_)) && write_triangle(&mut node, &mut ele, &model).is_ok() {
        read_triangle(&node, &ele, "node", "ele", &ReadOptions::default()).unwrap_or_else(|error| panic!("{error}"));
    }
    Outcome::of(&loaded.notes.join("\n")).and(Outcome(held))
}

fn dcel_comes_back(bytes: &[u8], structure: &Structure) {
    let Structure::Plane(_) = structure else { return };
    let read = read_bytes(bytes, Format::Dcel, FILE, &ReadOptions::default());
    let Document::Table(table) = read.unwrap_or_else(|error| panic!("{error}")).document else { panic!("no table") };
    let again = Subdivision::from_table(&table).unwrap_or_else(|error| panic!("{error}"));
    // Ids after the last one that exists are forgotten, so the texts are compared.
    assert_eq!(written(&Model::planar(&again), Format::Dcel).as_deref(), Some(bytes), "the subdivision changed");
}

/// Whether a cycle comes through a vertex more than once.
fn is_pinched(dcel: &Dcel) -> bool {
    let mut seen = std::collections::HashSet::new();
    dcel.half_edges().any(|h| {
        // Once for each cycle, from its smallest half-edge on.
        let cycle: Vec<_> = dcel.cycle(h).collect();
        seen.clear();
        cycle.iter().min() == Some(&h) && !cycle.iter().all(|&h| seen.insert(dcel.origin(h)))
    })
}

/// What is written as polygons is read as polygons, and written again as the same bytes.
fn polygons_come_back(bytes: &[u8], format: Format, structure: &Structure) {
    let show = || String::from_utf8_lossy(&bytes[..bytes.len().min(2000)]).into_owned();
    let read = |bytes: &[u8]| {
        let read = read_bytes(bytes, format, FILE, &ReadOptions::default());
        read.unwrap_or_else(|error| panic!("{format}: {error}\n{}", show()))
    };
    let first = read(bytes);
    let (in_plane, dcel) = match structure {
        Structure::Plane(plane) => (true, plane.topology()),
        Structure::Surface(surface) => (false, surface.topology()),
        _ => return,
    };
    let alone = dcel.vertices().any(|v| dcel.outgoing(v).is_none());
    // Single precision may move points onto and over each other, STL joins points at the same place, points without
    // polygons are not built, and the builder takes no cycle that comes twice through a vertex.
    if format == Format::StlBinary || format == Format::Stl && !in_plane || alone || is_pinched(dcel) {
        return;
    }
    let mode = Some(if in_plane { Mode::Plane } else { Mode::Surface });
    let options = LoadOptions { mode, ..LoadOptions::default() };
    let again = assemble(first.clone(), FILE, &options).unwrap_or_else(|error| panic!("{format}: {error}\n{}", show()));
    let text = match &again.structure {
        Structure::Plane(plane) => written(&Model::planar(plane), format),
        Structure::Surface(surface) => written(
            &Model::surface(
                surface,
                |v| surface.has_vertex(v).then(|| surface.point(v)),
                |f| surface.is_boundary_face(f),
            ),
            format,
        ),
        _ => None,
    };
    let text = text.unwrap_or_else(|| panic!("{format}: written once, but not twice\n{}", show()));
    let second = read(&text);
    let (Document::Polygons(first), Document::Polygons(second)) = (first.document, second.document) else {
        panic!("{format}: no polygons\n{}", show())
    };
    // STL joins points, among them 0 and -0.
    let shift = if format == Format::Stl { 0.0 } else { -0.0 };
    let [a, b] = [first.points, second.points].map(|points| bits(points.into_iter().map(|p| p.map(|x| x + shift))));
    assert!(a == b, "{format}: other points\n{}", show());
    assert!(first.faces == second.faces && first.blocked == second.blocked, "{format}: other faces\n{}", show());
    // GeoJSON names faces by their numbers, which leave no gaps any more; a mesh lists what lies round a vertex from any
    // of its edges on.
    let exact = !matches!(format, Format::GeoJson | Format::Mesh | Format::Stl);
    assert!(!exact || text == bytes, "{format}\n{}\n{}", show(), String::from_utf8_lossy(&text));
}
