//! How far work has come: stages begin at 0, go forward, end with all of their steps, and cost nothing unwatched.

use crate::numbers::Numbers;
use dcel_kit::io::{Format, Model, ReadOptions, read_bytes, write};
use dcel_kit::plane::{ArrangeOptions, Point, PointIndex, Subdivision, TriangulationMethod};
use dcel_kit::progress::{Progress, Standing};
use std::sync::atomic::{AtomicBool, Ordering};

/// Watches work from another thread; gives what was seen of it, and its last stage.
fn watched<R>(work: impl FnOnce() -> R + Send) -> (Vec<Standing>, Standing) {
    let (progress, ended) = (Progress::new(), AtomicBool::new(false));
    let seen = std::thread::scope(|scope| {
        let look = scope.spawn(|| {
            let mut seen: Vec<Standing> = Vec::new();
            while !ended.load(Ordering::Relaxed) {
                seen.extend(progress.now().filter(|now| seen.last() != Some(now)));
                std::thread::yield_now();
            }
            seen
        });
        progress.watch(work);
        ended.store(true, Ordering::Relaxed);
        look.join().unwrap()
    });
    assert_eq!(progress.now(), None, "all stages have ended");
    (seen, progress.last().expect("a stage"))
}

fn points(count: usize) -> Vec<Point> {
    let mut next = Numbers::new(91);
    (0..count).map(|_| Point::new(next.unit(), next.unit())).collect()
}

#[test]
fn stages_go_forward_and_end_with_their_last_step() {
    let points = points(60_000);
    let s = Subdivision::delaunay(&points).unwrap().subdivision;
    let index = PointIndex::new(&s);
    let mut text = Vec::new();
    let (seen, last) = watched(|| write(&mut text, &Model::planar(&s), Format::Dcel).unwrap());
    let lines = text.iter().filter(|&&b| b == b'\n').count() as u64;
    // The first line is no element.
    assert_eq!((last.what, last.done, last.total), ("writing", lines - 1, lines - 1));
    forward(&seen);
    for (name, what, total, steps, work) in [
        ("delaunay", "triangulating", 60_000, 1, &|| drop(Subdivision::delaunay(&points)) as _),
        ("locate", "locating", 60_000, 1, &|| drop(index.locate_all(&points))),
        ("read", "reading", text.len(), 4096 * 120, &|| {
            drop(read_bytes(&text, Format::Dcel, "text", &ReadOptions::default()));
        }),
        ("sweep", "sweeping", 30_000, 4096, &|| {
            let rows: Vec<[Point; 2]> = (0..15_000).map(|i| [0.0, 1.0].map(|x| Point::new(x, f64::from(i)))).collect();
            drop(Subdivision::from_segments(&rows).unwrap());
        }),
        ("crossings", "looking for crossings", 19_600, 4096, &|| {
            let short = points.iter().map(|p| [*p, Point::new(p.x + 0.003, p.y - 0.002)]).collect::<Vec<_>>();
            let options = ArrangeOptions { split: true, ..ArrangeOptions::default() };
            drop(Subdivision::arrange_segments(&short, &options).unwrap());
        }),
        ("triangulate", "triangulating", 60_000, 4096, &|| {
            // Teeth that lean over, so that it is not monotone.
            let tooth = |i: i32| Point::new(f64::from(i / 2) + 1.5 * f64::from(i % 2), f64::from(1 - i % 2 * 2));
            let mut corners: Vec<Point> = (0..60_000).map(tooth).collect();
            corners.extend([Point::new(40_000.0, 9.0), Point::new(-1.0, 9.0)]);
            let mut comb = Subdivision::polygon(&corners).unwrap();
            comb.triangulate(TriangulationMethod::Monotone).unwrap();
        }),
    ] as [(&str, &str, usize, usize, &(dyn Fn() + Sync)); 6]
    {
        let (seen, last) = watched(work);
        forward(&seen);
        assert_eq!(last.what, what, "{name}");
        let (done, all) = (last.done as usize, last.total as usize);
        assert!(all >= total && all < total + total / 10 + 10, "{name}: {all} steps");
        assert!(done <= all && done + steps >= all, "{name}: {done} of {all} at the end");
    }
}

/// A file is read forward, whether its parts are lines, rings, arcs or records.
#[test]
fn every_kind_of_reader_tells_how_far_it_is() {
    let s = Subdivision::delaunay(&points(20_000)).unwrap().subdivision;
    let mut files = Vec::new();
    for format in [Format::Obj, Format::Ply, Format::PlyBinary, Format::StlBinary, Format::GeoJson] {
        let mut bytes = Vec::new();
        write(&mut bytes, &Model::planar(&s), format).unwrap();
        files.push((format, bytes));
    }
    let (mut arcs, mut rings) = (Vec::new(), Vec::new());
    for i in 0..2000 {
        arcs.push(format!("[[{i},0],[{i}.9,0],[{i},1],[{i},0]]"));
        rings.push(format!("[[{i}]]"));
    }
    let (arcs, rings) = (arcs.join(","), rings.join(","));
    let topology = format!(
        r#"{{"type":"Topology","objects":{{"o":{{"type":"MultiPolygon","arcs":[{rings}]}}}},"arcs":[{arcs}]}}"#
    );
    files.push((Format::TopoJson, topology.into_bytes()));
    for (format, bytes) in &files {
        let (seen, last) = watched(|| drop(read_bytes(bytes, *format, "file", &ReadOptions::default()).unwrap()));
        forward(&seen);
        // Binary STL is counted in triangles of 50 bytes.
        let total = if *format == Format::StlBinary { bytes.len() / 50 } else { bytes.len() };
        assert_eq!((last.what, last.total), ("reading", total as u64), "{format}");
        let left = (last.total - last.done) as f64 / total as f64;
        assert!(left < 0.15, "{format}: {} of {total} at the end", last.done);
    }
}

/// Stages come one after another, and each goes forward.
fn forward(seen: &[Standing]) {
    for pair in seen.windows(2) {
        let [before, after] = [pair[0], pair[1]];
        let goes_on = before.stage < after.stage || (before.what == after.what && before.done <= after.done);
        assert!(goes_on && after.done <= after.total, "{before:?}, then {after:?}");
    }
}

#[test]
fn watches_are_of_their_thread_and_end_with_their_work() {
    let points = points(20_000);
    let (outer, inner) = (Progress::new(), Progress::new());
    outer.watch(|| {
        inner.watch(|| drop(Subdivision::delaunay(&points)));
        assert_eq!((inner.last().map(|last| last.done), outer.last()), (Some(20_000), None));
        let fails = std::panic::catch_unwind(|| Progress::new().watch(|| panic!("on purpose")));
        assert!(fails.is_err());
        std::thread::scope(|scope| drop(scope.spawn(|| drop(Subdivision::delaunay(&points))).join()));
        assert_eq!(outer.last(), None, "another thread tells nothing");
        drop(Subdivision::delaunay(&points));
    });
    assert_eq!(outer.last().map(|last| last.done), Some(20_000));
    // Small work is no stage.
    let small = Progress::new();
    small.watch(|| drop(Subdivision::delaunay(&points[..100])));
    assert_eq!(small.last(), None);
}
