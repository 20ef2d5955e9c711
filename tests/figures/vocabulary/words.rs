//! Labels, badges and the legend.

use super::read::{Drawing, overlap};
use super::{alone, everything};
use dcel_kit::figure::FigureOptions;
use dcel_kit::figure::sketch::{Backdrop, Multiples, Role, Sketch};
use dcel_kit::plane::Subdivision;

/// Labels and badges cover neither each other, nor marks, nor the numbers of badges.
fn is_readable(svg: &str, what: &str) -> usize {
    let drawn = Drawing::read(svg);
    let mut boxes: Vec<(String, [f64; 4])> = Vec::new();
    for (id, group) in drawn.groups.iter().filter(|(id, _)| id.contains("s-")) {
        if id.contains("badge") {
            let (c, r) = group.discs[0];
            boxes.push((id.clone(), [c[0] - r, c[1] - r, c[0] + r, c[1] + r]));
        } else if id.ends_with("-label") || id.contains("s-text") {
            boxes.extend(group.words.iter().map(|word| (id.clone(), word.bounds())));
        }
    }
    let labels = boxes.len();
    for (id, group) in drawn.groups.iter().filter(|(id, _)| id.contains("s-point") && !id.ends_with("-label")) {
        let corners = group.corners();
        let side = |i: usize, f: fn(f64, f64) -> f64| corners.iter().map(|p| p[i]).reduce(f).unwrap();
        boxes.push((id.clone(), [side(0, f64::min), side(1, f64::min), side(0, f64::max), side(1, f64::max)]));
    }
    for (i, (id, a)) in boxes.iter().take(labels).enumerate() {
        for (other, b) in &boxes[i + 1..] {
            assert!(!overlap(*a, *b), "{what}: {id} {a:?} covers {other} {b:?}");
        }
        assert!(
            a[0] >= 0.0 && a[1] >= 0.0 && a[2] <= drawn.size[0] && a[3] <= drawn.size[1],
            "{what}: {id} leaves the canvas"
        );
        for (owner, group) in
            drawn.groups.iter().filter(|(owner, _)| owner.contains("s-path") && !owner.contains("label"))
        {
            for ring in group.rings("ln") {
                let crossed = ring.windows(2).any(|w| meets(*a, w[0], w[1]));
                assert!(!crossed, "{what}: {id} covers {owner}");
            }
        }
    }
    labels
}

/// Whether a segment meets a box, by looking at many of its points.
fn meets(b: [f64; 4], p: [f64; 2], q: [f64; 2]) -> bool {
    (0..=400).any(|i| {
        let t = f64::from(i) / 400.0;
        let at = [p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])];
        b[0] < at[0] && at[0] < b[2] && b[1] < at[1] && at[1] < b[3]
    })
}

#[test]
fn labels_cover_nothing() {
    assert!(is_readable(&alone(&everything()), "everything") > 12);
    let lab = Subdivision::lab_rectangle();
    for seed in 1..30u64 {
        let mut state = seed;
        let mut random = |size: f64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            size * ((state >> 40) as f64 / (1u64 << 24) as f64 - 0.5)
        };
        let mut sketch = Sketch::new();
        for i in 0..14 {
            let p = [random(480.0), random(280.0)];
            sketch.point(Role::ALL[i % 9], p).label(format!("point number {i}"));
            if i % 3 == 0 {
                sketch.path(Role::Main, [p, [random(480.0), random(280.0)]]).label(format!("path {i}"));
                sketch.badge(Role::Wrong, p, "here");
            }
        }
        let what = format!("seed {seed}");
        let labels = is_readable(&alone(&sketch), &what);
        assert!(labels >= 15, "{what}: only {labels} of 24 labels found room");
        let over = sketch.over(&lab, Backdrop::Dimmed, &FigureOptions::new("Test")).unwrap();
        is_readable(&over.to_svg(), &what);
    }
}

/// In one corner of the canvas there is no room for forty names: those that are left out are noted.
#[test]
fn labels_without_room_are_left_out_and_noted() {
    let mut sketch = Sketch::new();
    sketch.point(Role::Plain, [100.0, 100.0]);
    for i in 0..40 {
        sketch.point(Role::Main, [f64::from(i % 8) * 0.5, f64::from(i / 8) * 0.5]).label(format!("a long name {i}"));
    }
    let figure = sketch.figure(&FigureOptions::new("Test")).unwrap();
    let shown = is_readable(&figure.to_svg(), "crowd");
    assert!(shown < 40);
    let noted = figure.notes().iter().find(|note| note.starts_with("no room for the words of"));
    assert!(noted.is_some_and(|note| note.contains("point-")), "{:?}", figure.notes());
    let drawn = Drawing::read(&figure.to_svg());
    assert_eq!(drawn.groups["s-point-41"].title.as_deref(), Some("a long name 39"), "the title remains");
}

#[test]
fn labels_of_the_structure_keep_clear_of_the_sketch() {
    let lab = Subdivision::lab_rectangle();
    let options = FigureOptions::new("Test");
    let words = |svg: &str, class: &str| {
        let drawn = Drawing::read(svg);
        drawn.words.into_iter().filter(|word| word.class == class).collect::<Vec<_>>()
    };
    let before = words(&Sketch::new().over(&lab, Backdrop::Plain, &options).unwrap().to_svg(), "fl");
    let label = before.iter().find(|word| word.text == "f1").unwrap().clone();
    // A line right through the middle, where the label of f1 would stand.
    let mut sketch = Sketch::new();
    sketch.path(Role::Main, [[-240.0, 0.0], [240.0, 0.0]]);
    let svg = sketch.over(&lab, Backdrop::Plain, &options).unwrap().to_svg();
    let line = Drawing::read(&svg).groups["s-path-1"].lines[0].clone();
    assert!(meets(label.bounds(), line.1, line.2), "the test needs a line through the label");
    let moved = words(&svg, "fl").into_iter().find(|word| word.text == "f1").unwrap();
    assert!(!meets(moved.bounds(), line.1, line.2), "{moved:?}");
}

#[test]
fn badges_match_the_legend() {
    let svg = alone(&everything());
    let drawn = Drawing::read(&svg);
    for (number, words) in [(1, "a corner that the path must not touch"), (2, "the start")] {
        let badge = &drawn.groups[&format!("s-badge-{number}")];
        assert_eq!(badge.data["data-badge"], number.to_string());
        assert_eq!(badge.words[0].text, number.to_string());
        assert_eq!(badge.title.as_deref(), Some(words));
        let key =
            drawn.groups.values().find(|g| g.data.get("data-badge") == Some(&number.to_string()) && g.words.len() > 1);
        let key = key.unwrap_or_else(|| panic!("no line of the legend has the number {number}"));
        assert_eq!(key.words[0].text, number.to_string());
        let said: Vec<&str> = key.words[1..].iter().map(|word| word.text.as_str()).collect();
        assert_eq!(said.join(" "), words);
        assert_eq!(key.class, badge.class, "the colour is the same");
    }
    let said: String = drawn.words.iter().map(|word| word.text.clone() + "\n").collect();
    for words in ["room", "path", "what is seen", "portal"] {
        assert!(said.contains(words), "{words}");
    }
}

#[test]
fn badges_of_panels_are_numbered_through_and_samples_stand_once() {
    let with_badge = |words: &str| {
        let mut sketch = Sketch::new();
        sketch.path(Role::Main, [[0.0, 0.0], [4.0, 3.0]]).key("path");
        sketch.badge(Role::Wrong, [2.0, 1.0], words);
        sketch
    };
    let mut panels = Multiples::new();
    panels.sketch("a", "", with_badge("first")).sketch("b", "", with_badge("second"));
    let drawn = Drawing::read(&panels.figure(&FigureOptions::new("Test")).unwrap().to_svg());
    assert_eq!(drawn.groups["p1-s-badge-1"].words[0].text, "1");
    assert_eq!(drawn.groups["p2-s-badge-1"].words[0].text, "2");
    let said: Vec<&str> = drawn.words.iter().map(|word| word.text.as_str()).collect();
    assert_eq!(said.iter().filter(|word| **word == "path").count(), 1);
    assert!(said.contains(&"first") && said.contains(&"second"));
}

#[test]
fn everything_has_a_title_for_readers_who_do_not_see_it() {
    let mut sketch = everything();
    sketch.path(Role::Main, [[1.0, 1.0], [2.0, 2.0]]).label("short").title("the way home");
    let drawn = Drawing::read(&alone(&sketch));
    let titles =
        drawn.groups.iter().filter(|(id, _)| id.starts_with("s-") && !id.contains("label") && !id.contains("key"));
    for (id, group) in titles.filter(|(id, _)| !id.contains("text")) {
        assert!(group.title.as_ref().is_some_and(|title| !title.is_empty()), "{id}");
    }
    assert_eq!(drawn.groups["s-path-3"].title.as_deref(), Some("the way home"));
    assert_eq!(drawn.groups["s-path-1"].title.as_deref(), Some("path"));
}
