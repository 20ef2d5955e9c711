//! Very many things are drawn in bulk: all of them, small, and without an id for each.

use super::{Role, Sketch, alone, is_sound};
use dcel_kit::figure::{self, FigureOptions};
use dcel_kit::plane::{Point, Subdivision, Window};

/// `count` points on a grid of whole px, lines beside them, and one thing with a label.
fn crowd(count: usize) -> Sketch {
    let mut sketch = Sketch::new();
    let place = |i: usize| [(i % 100) as f64 * 8.0, (i / 100) as f64 * 8.0];
    for i in 0..count {
        let [x, y] = place(i);
        sketch.point(Role::Event, [x, y]).title(format!("event {i}")).key("event");
        sketch.path(Role::Secondary, [[x + 1.0, y + 1.0], [x + 4.0, y + 2.0], [x + 5.0, y + 5.0]]).key("cut");
    }
    sketch.point(Role::Start, [0.0, -20.0]).label("start");
    sketch
}

/// The subpaths of the bulk group with this id, and how wide its lines are.
fn bulk(svg: &str, id: &str) -> Option<(usize, f64, String)> {
    let document = roxmltree::Document::parse(svg).unwrap();
    let group = document.descendants().find(|node| node.attribute("id") == Some(id))?;
    let paths = group.children().filter_map(|node| node.attribute("d"));
    let subpaths = paths.map(|d| d.matches('m').count()).sum();
    let title = group.children().find(|node| node.has_tag_name("title")).and_then(|title| title.text()).unwrap_or("");
    let count: usize = group.attribute("data-count")?.parse().ok()?;
    // Things that look the same to a tenth of a px are one.
    assert!(subpaths <= count && subpaths + 10 >= count, "{id}: {subpaths} of {count}");
    Some((subpaths, group.attribute("stroke-width")?.parse().ok()?, title.to_owned()))
}

#[test]
fn up_to_2000_things_have_a_group_each_and_more_one_for_each_role_and_kind() {
    let few = alone(&crowd(999));
    is_sound(&few, "few");
    assert!(few.contains("id=\"test-s-point-999\"") && few.contains("event 998") && !few.contains("data-count"));

    let many = alone(&crowd(1000));
    is_sound(&many, "many");
    assert!(!many.contains("s-path-") && !many.contains("event 998"), "drawn one by one");
    let (points, width, title) = bulk(&many, "test-s-event-points").unwrap();
    assert_eq!((points, title.as_str()), (1000, "1000 x event"));
    assert!(width <= 6.4, "{width}");
    let (paths, _, title) = bulk(&many, "test-s-secondary-paths").unwrap();
    assert_eq!((paths, title.as_str()), (1000, "1000 x cut"));
    // What has a label is what it was, with its own number.
    assert!(many.contains("id=\"test-s-point-1001\"") && many.contains(">start<"));
    // The legend shows dots and solid lines, as they are drawn.
    let document = roxmltree::Document::parse(&many).unwrap();
    let sample = |key: &str| document.descendants().find(|node| node.attribute("id") == Some(key)).unwrap();
    assert!(sample("test-s-key-1").children().any(|node| node.has_tag_name("circle")), "a dot for events");
    assert!(sample("test-s-key-2").children().any(|node| node.attribute("class") == Some("ln solid")), "a solid line");
}

#[test]
fn lines_and_dots_become_thinner_where_there_are_many() {
    let widths = [2_000, 32_000].map(|count| {
        let svg = alone(&crowd(count));
        ["test-s-event-points", "test-s-secondary-paths"].map(|id| bulk(&svg, id).unwrap().1)
    });
    for pair in widths.windows(2) {
        assert!(pair[1][0] < pair[0][0] && pair[1][1] < pair[0][1], "{widths:?}");
    }
}

#[test]
fn a_figure_of_voronoi_cells_takes_few_bytes_a_site() {
    let mut state = 5u64;
    let mut unit = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let sites: Vec<Point> = (0..6000).map(|_| Point::new(unit(), unit())).collect();
    let delaunay = Subdivision::delaunay(&sites).unwrap().subdivision;
    let voronoi = delaunay.voronoi().unwrap();
    let window = Window::around(&sites);
    let cells = voronoi.cells(window).unwrap();
    let options = FigureOptions::new("Cells");
    for (what, svg, most) in [
        ("cells", figure::voronoi_cells(&voronoi, &cells, false, &options).unwrap().to_svg(), 45.0),
        ("cells and triangles", figure::voronoi_cells(&voronoi, &cells, true, &options).unwrap().to_svg(), 100.0),
        ("edges", figure::voronoi_edges(&voronoi, &window, false, &options).unwrap().to_svg(), 70.0),
    ] {
        is_sound(&svg, what);
        let each = svg.len() as f64 / sites.len() as f64;
        assert!(each < most, "{what}: {each:.0} bytes a site");
        assert!(bulk(&svg, "cells-s-secondary-points").unwrap().0 + 10 >= sites.len(), "{what}: all sites");
    }
}
