//! Structures that are empty, impossible or broken.

use super::cases::{self, h};
use super::draw;
use super::drawn::read;
use dcel_kit::figure::{Detail, FigureError, FigureOptions, structure};
use dcel_kit::topology::Table;
use dcel_kit::{FaceId, VertexId};

#[test]
fn an_empty_plane_shows_its_outer_face() {
    let drawn = read(&draw("empty", &cases::plane(&[], &[])));
    assert_eq!(drawn.areas["f0"][0].0, "hatched");
    assert_eq!(drawn.words.iter().map(|word| word.text.as_str()).collect::<Vec<_>>(), ["f0"]);
    assert_eq!(structure(&Table::default(), &FigureOptions::default()).unwrap().notes(), [""; 0]);
}

#[test]
fn impossible_coordinates_are_refused_by_the_name_of_the_vertex() {
    let mut table = cases::cube();
    table.vertices[5].as_mut().unwrap().position = Some([1.0, f64::NAN]);
    let error = structure(&table, &FigureOptions::default()).unwrap_err();
    assert!(matches!(error, FigureError::Coordinate { vertex, .. } if vertex == VertexId::new(5)), "{error}");
    assert_eq!(error.to_string(), "v5: y is NaN: coordinates must be finite numbers");
    table.vertices[5].as_mut().unwrap().position = Some([-1e300, 0.0]);
    let error = structure(&table, &FigureOptions::default()).unwrap_err().to_string();
    assert!(error.starts_with("v5: x = -1e300"), "{error}");
    for row in table.vertices.iter_mut().flatten() {
        row.position = None;
    }
    let error = structure(&table, &FigureOptions::default()).unwrap_err();
    assert!(
        matches!(error, FigureError::NoPosition { vertices: 8, example, .. } if example == VertexId::new(0)),
        "{error}"
    );
}

#[test]
fn what_cannot_be_drawn_is_noted() {
    let mut table = cases::cube();
    table.vertices[2].as_mut().unwrap().position = None;
    table.half_edges[8].as_mut().unwrap().next = None;
    let figure = structure(&table, &FigureOptions::new("broken")).unwrap();
    let notes = figure.notes().join("\n");
    assert!(notes.contains("without a position, not drawn: v2"), "{notes}");
    assert!(notes.contains("h2, h3, h4, h5, h20, h21"), "{notes}");
    assert!(notes.contains("does not close or is taken already: f5"), "{notes}");
    let drawn = read(&figure.to_svg());
    assert!(drawn.data.contains_key("v2") && !drawn.discs.contains_key("v2"));
    assert!(!drawn.data["h8"].contains_key("data-next") && drawn.arrows.contains_key("h8"));
    assert!(!drawn.areas.contains_key("f5"), "a face whose boundary is broken is not filled");
}

/// A cycle belongs to the first face that claims it; walks that run into it from elsewhere end there.
#[test]
fn a_cycle_is_drawn_for_one_face_only() {
    let mut table = cases::cube();
    table.faces[2].as_mut().unwrap().half_edge = table.faces[1].as_ref().unwrap().half_edge;
    let figure = structure(&table, &FigureOptions::new("claimed")).unwrap();
    assert_eq!(figure.notes(), ["with a boundary that does not close or is taken already: f2"]);
    let drawn = read(&figure.to_svg());
    assert!(drawn.areas.contains_key("f1") && !drawn.areas.contains_key("f2"));
}

/// Any table can be drawn: missing and wrong pointers, missing rows, missing positions.
#[test]
fn broken_tables_are_drawn_without_panic() {
    let cases = [cases::cube(), cases::islands(), cases::stress(), cases::grid(6, true)];
    for seed in 0..600u64 {
        let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x1234_5678;
        let mut random = move |below: usize| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as usize % below.max(1)
        };
        let mut table = cases[random(cases.len())].clone();
        let (n, v, f) = (table.half_edges.len(), table.vertices.len(), table.faces.len());
        for _ in 0..1 + random(12) {
            let target = h(random(n + 3));
            let target = (random(4) > 0).then_some(target);
            match random(10) {
                0 => table.half_edges[random(n)] = None,
                1 => table.vertices[random(v)] = None,
                2 => table.faces[random(f)] = None,
                3 => table.vertices[random(v)].iter_mut().for_each(|row| row.position = None),
                4 => table.half_edges[random(n)].iter_mut().for_each(|row| row.twin = target),
                5 => table.half_edges[random(n)].iter_mut().for_each(|row| row.next = target),
                6 => table.half_edges[random(n)].iter_mut().for_each(|row| row.prev = target),
                7 => {
                    let face = FaceId::new(random(f + 2) as u32);
                    table.half_edges[random(n)].iter_mut().for_each(|row| row.face = Some(face));
                }
                8 => {
                    let origin = VertexId::new(random(v + 2) as u32);
                    table.half_edges[random(n)].iter_mut().for_each(|row| row.origin = Some(origin));
                }
                _ => table.faces[random(f)].iter_mut().for_each(|row| {
                    row.half_edge = target;
                    row.inner_components.extend(target.map(dcel_kit::topology::InnerComponent::Cycle));
                }),
            }
        }
        for detail in [Detail::Full, Detail::Arrows, Detail::Edges, Detail::Tiles] {
            let options = FigureOptions::new(format!("seed {seed}")).detail(detail);
            let svg = structure(&table, &options).unwrap_or_else(|error| panic!("seed {seed}: {error}")).to_svg();
            assert!(!svg.contains("NaN") && !svg.contains("inf\""), "seed {seed} {detail:?}");
            assert!(roxmltree::Document::parse(&svg).is_ok(), "seed {seed} {detail:?}");
        }
    }
}
