//! Charts: places by values, names that can be read.

use super::is_sound;
use super::read::{Drawing, Group, P, overlap};
use dcel_kit::figure::FigureOptions;
use dcel_kit::figure::chart::{Axis, Chart, ChartError, Growth, Sample};
use std::collections::BTreeMap;

fn draw(chart: &Chart) -> Drawing {
    let svg = chart.figure(&FigureOptions::new("Chart")).unwrap().to_svg();
    is_sound(&svg, "chart");
    Drawing::read(&svg)
}

/// The marks by their values.
fn marks(svg: &str) -> BTreeMap<String, P> {
    let document = roxmltree::Document::parse(svg).unwrap();
    let groups = document.descendants().filter(|node| node.has_attribute("data-x"));
    let mark = |group: roxmltree::Node<'_, '_>| {
        let disc = group.children().find(|node| node.has_attribute("cx"))?;
        let at = ["cx", "cy"].map(|name| disc.attribute(name).unwrap().parse().unwrap());
        Some((format!("{},{}", group.attribute("data-x")?, group.attribute("data-y")?), at))
    };
    groups.filter_map(mark).collect()
}

#[test]
fn equal_ratios_are_equally_far_on_log_axes_and_equal_steps_on_linear_ones() {
    let mut chart = Chart::new(Axis::log("n"), Axis::linear("time").unit("s"));
    chart.series("a", [(10.0, 5.0), (100.0, 10.0), (1e3, 15.0), (1e4, 20.0)]);
    let svg = chart.figure(&FigureOptions::new("Chart")).unwrap().to_svg();
    let marks = marks(&svg);
    let at = |key: &str| marks[key];
    let steps = [at("10,5"), at("100,10"), at("1000,15"), at("10000,20")];
    for w in steps.windows(3) {
        assert!((w[2][0] - w[1][0] - (w[1][0] - w[0][0])).abs() < 0.021, "{w:?}");
        assert!((w[2][1] - w[1][1] - (w[1][1] - w[0][1])).abs() < 0.021, "{w:?}");
    }
    assert!(steps[0][1] > steps[1][1] && steps[0][0] < steps[1][0], "y up, x to the right");
    assert!(Drawing::read(&svg).words.iter().any(|word| word.text == "time (s)"));
}

fn line(group: &Group) -> Vec<P> {
    group.rings("ln").concat()
}

#[test]
fn references_have_the_slope_they_are_called_by() {
    let mut chart = Chart::new(Axis::log("n"), Axis::log("time"));
    chart.series("a", [(1.0, 1.0), (1e4, 1e4)]);
    chart
        .reference(Growth::Linear, [1.0, 1.0])
        .reference(Growth::Quadratic, [1.0, 1.0])
        .reference(Growth::Root, [1.0, 1.0]);
    chart.reference(Growth::NLogN, [2.0, 2.0]);
    let drawn = draw(&chart);
    let ends = |i: usize| {
        let line = line(&drawn.groups[&format!("reference-{i}")]);
        (line[0], *line.last().unwrap(), line.len())
    };
    let slope = |(a, b, _): (P, P, usize)| (a[1] - b[1]) / (b[0] - a[0]);
    let unit = slope(ends(1));
    assert!((slope(ends(2)) / unit - 2.0).abs() < 0.01 && (slope(ends(3)) / unit - 0.5).abs() < 0.01);
    assert_eq!(ends(2).2, 2, "a power is drawn as one straight line");
    let bent = line(&drawn.groups["reference-4"]);
    assert!(bent.len() > 8 && slope(ends(4)) > unit, "n log n bends");
    // The quadratic leaves at the top, at a hundred.
    let series = line(&drawn.groups["series-1"]);
    let middle = 0.5 * (series[0][0] + series.last().unwrap()[0]);
    assert!((ends(2).1[0] - middle).abs() < 0.05, "{:?}", ends(2));
}

#[test]
fn names_of_series_do_not_cover_each_other() {
    let mut chart = Chart::new(Axis::linear("x"), Axis::linear("y"));
    for i in 0..8 {
        let end = 10.0 + 0.01 * f64::from(i);
        chart.series(&format!("series {i}"), [(0.0, f64::from(i)), (5.0, end)]);
    }
    chart.series("early", [(0.0, 2.0), (2.0, 6.0)]);
    let drawn = draw(&chart);
    let names: Vec<_> =
        drawn.groups.iter().filter(|(id, _)| id.ends_with("-label")).map(|(_, g)| g.words[0].clone()).collect();
    assert_eq!(names.len(), 9);
    for (i, a) in drawn.words.iter().enumerate() {
        for b in &drawn.words[i + 1..] {
            assert!(!overlap(a.bounds(), b.bounds()), "{a:?} covers {b:?}");
        }
        let [left, top, right, bottom] = a.bounds();
        assert!(left >= 0.0 && top >= 0.0 && right <= drawn.size[0] && bottom <= drawn.size[1], "{a:?}");
    }
    let classes: std::collections::BTreeSet<&str> =
        (1..=8).map(|i| drawn.groups[&format!("series-{i}")].class.as_str()).collect();
    assert_eq!(classes.len(), 8, "eight series, eight looks");
}

#[test]
fn error_bars_span_their_range() {
    let mut chart = Chart::new(Axis::linear("x"), Axis::linear("y").range(0.0, 10.0));
    chart.series("a", [Sample::new(1.0, 5.0).between(2.5, 7.5), Sample::new(3.0, 4.0)]);
    let svg = chart.figure(&FigureOptions::new("Chart")).unwrap().to_svg();
    let drawn = Drawing::read(&svg);
    let bars: Vec<_> = drawn.groups["series-1"].lines.iter().filter(|line| line.0 == "ol").collect();
    assert_eq!(bars.len(), 3, "a bar and two caps: {bars:?}");
    let (_, low, high) = bars[0].clone();
    let axis = |value: &str| drawn.words.iter().find(|word| word.class == "ce" && word.text == value).unwrap().at[1];
    let unit = (axis("0") - axis("10")) / 10.0;
    assert!((low[1] - (axis("0") - 2.5 * unit)).abs() < 0.03 && (high[1] - (axis("0") - 7.5 * unit)).abs() < 0.03);
}

#[test]
fn points_without_a_place_are_noted_and_a_chart_without_points_is_refused() {
    let mut chart = Chart::new(Axis::log("n"), Axis::linear("y"));
    let points = [(0.0, 1.0), (-3.0, 1.0), (f64::NAN, 1.0), (1.0, f64::INFINITY)];
    chart.series("bad", points);
    assert_eq!(chart.figure(&FigureOptions::new("Chart")).unwrap_err(), ChartError::NoPoint { points: 4 });
    chart.series("good", [(1.0, 1.0)]);
    let figure = chart.figure(&FigureOptions::new("Chart")).unwrap();
    assert_eq!(figure.notes(), ["without a place on the axes, not drawn: 4 points of bad"]);
    is_sound(&figure.to_svg(), "one point");
    assert_eq!(
        Chart::new(Axis::linear("x"), Axis::linear("y")).figure(&FigureOptions::new("Chart")).unwrap_err(),
        ChartError::NoPoint { points: 0 }
    );
}

#[test]
fn extreme_values_have_axes() {
    for (low, high) in [(1e-280, 1e280), (1.0, 1.0 + 1e-15), (-1e250, 1e250), (1e-250, 2e-250), (0.0, 0.0)] {
        for log in [false, true] {
            let axis = |title| if log { Axis::log(title) } else { Axis::linear(title) };
            let mut chart = Chart::new(axis("x"), axis("y"));
            chart.series("a", [(low, high), (high, low)]);
            match chart.figure(&FigureOptions::new("Chart")) {
                Ok(figure) => is_sound(&figure.to_svg(), &format!("{low} to {high}, {log}")),
                Err(error) => assert!(log && low <= 0.0, "{low} to {high}: {error}"),
            }
        }
    }
}

#[test]
fn narrow_charts_and_long_words_stay_on_their_canvas() {
    let mut chart =
        Chart::new(Axis::linear("a title that is far too long for a canvas this narrow"), Axis::linear("y"));
    chart.series("a series with a name that is longer than the plot is wide", [(0.0, 0.0), (1.0, 1234.0)]);
    let svg = chart.figure(&FigureOptions::new("Chart").width(240.0)).unwrap().to_svg();
    let drawn = Drawing::read(&svg);
    for word in &drawn.words {
        let [left, _, right, _] = word.bounds();
        assert!(left >= 0.0 && right <= drawn.size[0] + 0.01, "{word:?}");
    }
}
