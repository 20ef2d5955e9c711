//! `.scen`.

use crate::{Random, data, plane};
use dcel_kit::io::{Format, Grid, Optimum, Scenario};
use dcel_kit::navmesh::{NavMesh, PathAlgorithm, Planner};
use dcel_kit::plane::Point;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

fn parse(text: &str) -> Scenario {
    Scenario::parse(text.as_bytes(), "file.scen").unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn queries_are_read_with_or_without_a_version_and_with_any_blanks() {
    let plain = "0\tmaps/a.map\t9\t8\t1\t2\t3\t4\t2.82842712\n7 a b.map 9 8 -0.5 2.5 3 4 -1\n";
    for text in
        [plain.to_owned(), format!("version 1\n{plain}"), format!("version 1.0\r\n\r\n{}", plain.replace('\n', "\r\n"))]
    {
        let scenario = parse(&text);
        let [a, b] = scenario.queries.as_slice() else { panic!("{scenario:?}") };
        assert_eq!(
            (a.bucket, a.map.as_str(), a.start, a.goal),
            (0, "maps/a.map", (1.0, 2.0).into(), (3.0, 4.0).into())
        );
        assert_eq!((a.length, b.length), (Some(2.82842712), None));
        assert_eq!((b.bucket, b.map.as_str(), b.start), (7, "a b.map", (-0.5, 2.5).into()));
    }
    assert_eq!(parse(plain).queries[1].line, 2);
}

#[test]
fn the_kind_of_the_lengths_shows_in_the_numbers() {
    let of = |queries: &[(&str, &str)]| {
        let text: String = queries.iter().map(|(ends, length)| format!("0 a.map 9 9 {ends} {length}\n")).collect();
        parse(&text).optimum()
    };
    // 3 straight steps and 4 diagonal ones; the same way through the air is shorter.
    assert_eq!(of(&[("0 0 7 4", "8.65685")]), Optimum::Octile);
    assert_eq!(of(&[("0 0 7 4", "8.06226")]), Optimum::Euclidean);
    // A sum of whole steps, but less than the octile distance: only the Euclidean length can be.
    assert_eq!(of(&[("0 0 4 3", "5")]), Optimum::Euclidean);
    // The whole file decides: one odd length is a slip among octile ones, and one octile sum a chance among others.
    assert_eq!(of(&[("0 0 7 4", "8.65685"), ("0 0 1 9", "9.2")]), Optimum::Octile);
    assert_eq!(
        of(&[("0 0 7 4", "8.65685"), ("0 0 1 9", "9.2"), ("0 0 2 9", "9.3"), ("0 0 3 9", "9.5")]),
        Optimum::Euclidean
    );
    assert_eq!(of(&[("0 0 7 4", "-1")]), Optimum::Euclidean);
    assert_eq!(of(&[("0 0 7 4", "1e300")]), Optimum::Euclidean);
}

/// A grid of `size` by `size` cells, one in seven blocked, and its text.
fn random_grid(size: u32, random: &mut Random) -> (Grid, String) {
    let mut text = format!("type octile\nheight {size}\nwidth {size}\nmap\n");
    for _ in 0..size {
        text.extend((0..size).map(|_| if random.below(7) == 0 { '@' } else { '.' }));
        text.push('\n');
    }
    (Grid::parse(text.as_bytes(), "grid").expect("a map"), text)
}

/// The costs from a cell to all others by Dijkstra: steps of 1 and √2, no corner is cut.
fn octile_costs(grid: &Grid, size: u32, start: [u32; 2]) -> Vec<f64> {
    let index = |[x, y]: [u32; 2]| (y * size + x) as usize;
    let mut cost = vec![f64::INFINITY; (size * size) as usize];
    cost[index(start)] = 0.0;
    let mut queue = BinaryHeap::from([Reverse((0u64, start))]);
    while let Some(Reverse((key, [x, y]))) = queue.pop() {
        let here = f64::from_bits(key);
        if here > cost[index([x, y])] {
            continue;
        }
        for (dx, dy) in (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| (dx, dy))) {
            let [u, v] = [x.wrapping_add_signed(dx), y.wrapping_add_signed(dy)];
            if !grid.is_open(u, v) || !grid.is_open(u, y) || !grid.is_open(x, v) {
                continue;
            }
            let there = here + f64::from(dx * dx + dy * dy).sqrt();
            if there < cost[index([u, v])] {
                cost[index([u, v])] = there;
                queue.push(Reverse((there.to_bits(), [u, v])));
            }
        }
    }
    cost
}

/// As `%.6g` prints it: six significant digits, zeros at the end left out.
fn six_digits(x: f64) -> String {
    let before = if x < 1.0 { 0 } else { x.log10().floor() as usize + 1 };
    let text = format!("{x:.*}", 6_usize.saturating_sub(before));
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

type Print = fn(f64) -> String;
const PRINTS: [Print; 4] = [six_digits, |x| format!("{x:.2}"), |x| format!("{x:.8}"), |x| format!("{x}")];

/// Both kinds of lengths of the same queries, made here by two other programs than the reader: steps by Dijkstra, and
/// shortest ways; each as files print them. Lengths of several hundreds leave few digits behind the point.
#[test]
fn made_files_of_both_kinds_are_told_apart_at_every_precision() {
    let (mut long, mut files) = (0, 0);
    for (seed, size) in [(1, 12), (2, 40), (3, 160), (4, 260)] {
        let mut random = Random::new(seed);
        let (grid, text) = random_grid(size, &mut random);
        let mesh = NavMesh::new(&plane(text.as_bytes(), Format::Map)).expect("rectangles");
        let mut planner = Planner::new();
        let open: Vec<[u32; 2]> =
            (0..size).flat_map(|y| (0..size).map(move |x| [x, y])).filter(|&[x, y]| grid.is_open(x, y)).collect();
        let at = |[x, y]: [u32; 2]| Point::new(f64::from(x), -f64::from(y));
        // A start that is no double corner, and not walled in.
        let (start, costs) = std::iter::repeat_with(|| open[random.below(open.len() as u64) as usize])
            .filter(|&start| mesh.place(at(start)).is_ok())
            .map(|start| (start, octile_costs(&grid, size, start)))
            .find(|(_, costs)| 2 * costs.iter().filter(|cost| cost.is_finite()).count() > open.len())
            .expect("most cells hang together");
        let mut queries = Vec::new();
        while queries.len() < 40 {
            let goal = open[random.below(open.len() as u64) as usize];
            let octile = costs[(goal[1] * size + goal[0]) as usize];
            let Ok(way) = planner.route_between(&mesh, PathAlgorithm::Exact, at(start), at(goal)) else { continue };
            if octile.is_finite() && goal != start {
                queries.push((goal, [octile, way.length]));
            }
        }
        for (print, (which, optimum)) in
            PRINTS.iter().flat_map(|print| [(0, Optimum::Octile), (1, Optimum::Euclidean)].map(|kind| (print, kind)))
        {
            let line = |(goal, lengths): &([u32; 2], [f64; 2])| {
                let [[x0, y0], [x1, y1]] = [start, *goal];
                format!("0 a.map {size} {size} {x0} {y0} {x1} {y1} {}\n", print(lengths[which]))
            };
            let file: String = queries.iter().map(line).collect();
            let scenario = parse(&file);
            let verdict = scenario.verdict();
            assert_eq!((verdict.optimum, verdict.fits()), (optimum, true), "seed {seed}: {verdict}\n{file}");
            for (query, (_, lengths)) in scenario.queries.iter().zip(&queries) {
                let context = format!("seed {seed}: {query:?}, {}", lengths[which]);
                // What was printed is met without any tolerance but for doubles; two units of the last digit are not.
                assert!(query.agrees(Some(lengths[which]), Optimum::Euclidean, 1e-14), "{context}");
                let off = 4.0 * query.precision + 1e-9 * lengths[which];
                assert!(!query.agrees(Some(lengths[which] + off), Optimum::Euclidean, 1e-14), "{context}");
                assert!(query.agrees(Some(lengths[1]), optimum, 1e-14), "{context}");
                long += usize::from(lengths[which] > 100.0);
            }
            files += 1;
        }
    }
    assert!(files == 32 && long > 200, "{files} files, {long} long ways");
}

#[test]
fn a_file_that_fits_neither_says_which_it_nearly_fits() {
    let of = |queries: &[&str]| {
        let text: String = queries.iter().map(|query| format!("0 a.map 99 99 {query}\n")).collect();
        parse(&text).verdict()
    };
    let octile = ["0 0 7 4 8.65685", "0 0 20 9 23.7279", "0 0 30 11 34.5563", "0 0 31 3 32.2426"];
    assert_eq!(of(&octile).to_string(), "octile: all of 4 lengths are sums a + b√2 of steps");
    let verdict = of(&[octile[0], octile[1], octile[2], "0 0 31 3 32.5"]);
    assert_eq!(verdict.optimum, Optimum::Octile);
    assert_eq!(
        verdict.to_string(),
        "neither octile nor Euclidean, but nearly octile: 1 of 4 lengths is no sum a + b√2 of steps, the first in line 4"
    );
    assert_eq!(of(&octile[1..2]).to_string(), "octile: the 1 length is a sum a + b√2 of steps");
    let euclidean = ["0 0 7 4 8.06226", "0 0 20 9 21.9317", "0 0 30 11 31.9531"];
    let verdict = of(&euclidean);
    assert_eq!(verdict.to_string(), "Euclidean: 3 of 3 lengths are no sum a + b√2 of steps, the first in line 1");
    let verdict = of(&[euclidean[0], "0 0 31 3 31.1", euclidean[1], euclidean[2]]);
    assert_eq!(
        (verdict.optimum, verdict.too_short.count, verdict.too_short.first_line),
        (Optimum::Euclidean, 1, Some(2))
    );
    assert!(verdict.to_string().starts_with("neither octile nor Euclidean, but nearly Euclidean: 1 of 4"), "{verdict}");
    // Straight ways are the same by both, and none is stated.
    let verdict = of(&["0 0 8 0 8", "1 1 4 4 4.24264"]);
    assert!(verdict.fits() && verdict.to_string().contains("which is the same here"), "{verdict}");
    assert_eq!(of(&["0 0 8 0 -1"]).to_string(), "no length is stated");
    // Whole numbers of straight steps alone, however aslant the way: Manhattan distances, if there are two or more.
    let manhattan = ["0 0 9 5 14", "1 2 8 3 8", "0 9 9 0 18", "3 3 5 9 8", "2 2 2 2 0", "0 0 9 0 9"];
    let verdict = of(&manhattan);
    assert!(verdict.straight_steps && verdict.fits() && verdict.optimum == Optimum::Octile, "{verdict}");
    let said =
        "octile: all of 6 lengths are sums a + b√2 of steps, none of them diagonal (Manhattan): as upper bounds only";
    assert_eq!(verdict.to_string(), said);
    assert!(!of(&manhattan[..1]).straight_steps && !of(&manhattan[4..]).straight_steps && !of(&octile).straight_steps);
    assert!(!of(&[manhattan[0], manhattan[1], octile[0]]).straight_steps);
    // The parity of the steps: no way of whole straight and diagonal steps from here to there is 9 long.
    assert_eq!(of(&["0 0 4 4 9"]).not_octile.count, 1);
    assert_eq!(of(&["0 0 4 4 10"]).not_octile.count, 0);
}

/// As the files of the benchmarks have it: 48 diagonal steps of 1.41421354, printed with six digits, are 67.8822; with
/// the √2 of doubles they are 67.8823.
#[test]
fn sums_in_single_precision_are_octile_lengths_too() {
    let mut single = 0;
    for steps in 1..400_u32 {
        for straight in [0, 1, 15, 60] {
            let sum = (0..steps).fold(f64::from(straight), |sum, _| sum + f64::from(std::f32::consts::SQRT_2));
            let true_length = f64::from(straight) + f64::from(steps) * std::f64::consts::SQRT_2;
            single += usize::from(six_digits(sum) != six_digits(true_length));
            let file = format!("0 a.map 999 999 0 0 {} {steps} {}\n", steps + straight, six_digits(sum));
            let scenario = parse(&file);
            assert_eq!(scenario.verdict().not_octile.count, 0, "{file}");
            assert!(scenario.queries[0].agrees(Some(true_length), Optimum::Octile, 1e-14), "{file}");
            let longer = true_length + 4.0 * scenario.queries[0].precision;
            assert!(!scenario.queries[0].agrees(Some(longer), Optimum::Octile, 1e-14), "{file}");
        }
    }
    assert!(single > 5, "{single} sums are printed otherwise");
    // Between both, and none of them.
    assert_eq!(parse("0 a.map 999 999 0 0 48 48 67.8821").verdict().not_octile.count, 1);
}

/// The lengths of the city maps of the benchmarks are sums of 1.414213562, printed with eight digits behind the point.
#[test]
fn sums_of_a_decimal_fraction_for_the_root_of_two_are_octile_lengths_too() {
    let root = std::f64::consts::SQRT_2;
    let mut random = Random::new(5);
    for (digits, decimals) in [(2, 4), (3, 5), (4, 6), (6, 7), (8, 9), (9, 8)] {
        let fraction: f64 = format!("{root:.digits$}").parse().expect("digits");
        let mut steps = || [random.below(200), 1 + random.below(300)].map(|n| n as u32);
        let queries: Vec<[u32; 2]> = (0..40).map(|_| steps()).collect();
        let file = |length: &dyn Fn(f64, f64) -> f64| -> String {
            let line = |&[straight, diagonal]: &[u32; 2]| {
                let length = length(f64::from(straight), f64::from(diagonal));
                format!("0 a.map 999 999 0 0 {} {diagonal} {length:.decimals$}\n", straight + diagonal)
            };
            queries.iter().map(line).collect()
        };
        let scenario = parse(&file(&|straight, diagonal| straight + diagonal * fraction));
        let verdict = scenario.verdict();
        assert_eq!((verdict.optimum, verdict.fits(), verdict.diagonal), (Optimum::Octile, true, Some(fraction)));
        let said = format!("octile: all of 40 lengths are sums a + b√2 of steps, with √2 = {fraction}");
        assert_eq!(verdict.to_string(), said);
        for (query, &[straight, diagonal]) in scenario.queries.iter().zip(&queries) {
            let cost = f64::from(straight) + f64::from(diagonal) * root;
            assert!(query.agrees(Some(cost), Optimum::Octile, 1e-14 + verdict.shortfall()), "{query:?}");
            let stated = f64::from(straight) + f64::from(diagonal) * fraction;
            let longer = stated * (root / fraction).max(1.0) * (1.0 + 1e-7) + 4.0 * query.precision;
            assert!(!query.agrees(Some(longer), Optimum::Octile, 1e-14 + verdict.shortfall()), "{query:?}");
        }
        // As far as they are known, the lengths of straight lines are none, whatever stands for the root.
        let straight = parse(&file(&|straight, diagonal| (straight + diagonal).hypot(diagonal) + 0.3)).verdict();
        assert_eq!((straight.optimum, straight.diagonal), (Optimum::Euclidean, None));
        // One length is no reason to take another root; and one slip in forty none to give it up.
        let one = format!("0 a.map 999 999 0 0 300 100 {:.decimals$}\n", 200.0 + 100.0 * fraction + 0.013);
        let nearly = parse(&(file(&|straight, diagonal| straight + diagonal * fraction) + &one)).verdict();
        assert_eq!((nearly.optimum, nearly.diagonal, nearly.not_octile.count), (Optimum::Octile, Some(fraction), 1));
    }
}

#[test]
fn a_stated_0_between_two_places_is_no_path() {
    let scenario =
        parse("0 a.map 9 9 1 1 5 1 0\n0 a.map 9 9 1 1 1 1 0\n0 a.map 9 9 1 1 5 1 -1\n0 a.map 9 9 1 1 5 1 4\n");
    let lengths: Vec<_> = scenario.queries.iter().map(|query| query.length).collect();
    assert_eq!(lengths, [None, Some(0.0), None, Some(4.0)]);
    assert!(scenario.queries[0].agrees(None, Optimum::Octile, 0.0));
    assert!(!scenario.queries[0].agrees(Some(4.0), Optimum::Octile, 0.0));
    assert_eq!(scenario.verdict().stated, 2);
}

#[test]
fn a_length_is_as_exact_as_its_file_prints_it() {
    let of = |lengths: &[&str]| {
        let text: String = lengths.iter().map(|length| format!("0 a.map 9 9 0 0 0 0 {length}\n")).collect();
        parse(&text).queries.iter().map(|query| query.precision).collect::<Vec<f64>>()
    };
    let close = |a: &[f64], b: &[f64]| a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-12 * b);
    for (lengths, precisions) in [
        // Six significant digits, zeros left out.
        (&["3.41421", "12", "49.669", "123.456", "1234.5", "0.707107"][..], &[5e-6, 5e-5, 5e-5, 5e-4, 5e-3, 5e-7][..]),
        (&["3.41", "12.00", "1234.50", "-1"], &[5e-3, 5e-3, 5e-3, 0.0]),
        (&["5.830951895", "283.000000000"], &[5e-10, 5e-10]),
        // No decimals at all: six digits, as most programs print.
        (&["6", "12", "0"], &[5e-6, 5e-5, 0.0]),
        (&["6.5e2", "1.25E+1"], &[5e-1, 5e-2]),
        (&["7.414"], &[5e-4]),
    ] {
        let found = of(lengths);
        assert!(close(&found, precisions), "{lengths:?}: {found:?} instead of {precisions:?}");
    }
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn the_shared_scenarios_mean_what_their_page_says() {
    let read = |name: &str| Scenario::parse(&std::fs::read(data(name)).expect("the file"), name).expect("a scenario");
    let cape = read("O15-gppc-acrossthecape/AcrosstheCape.map.scen");
    assert_eq!((cape.queries.len(), cape.optimum()), (201, Optimum::Euclidean));
    let arena = read("O09-polyanya-arena/arena.scen");
    assert_eq!((arena.queries.len(), arena.optimum()), (160, Optimum::Octile));
    let ambiguous = read("O16-navmesh-tests/bad-ambig.scen");
    let lengths: Vec<_> = ambiguous.queries.iter().map(|q| q.length).collect();
    assert_eq!(lengths, [Some(4.0), None, None, None]);
}
