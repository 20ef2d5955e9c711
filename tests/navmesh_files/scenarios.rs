//! `.scen`.

use crate::data;
use dcel_kit::io::{Optimum, Scenario};

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
    // One odd length is enough.
    assert_eq!(of(&[("0 0 7 4", "8.65685"), ("0 0 1 9", "9.2")]), Optimum::Euclidean);
    assert_eq!(of(&[("0 0 7 4", "-1")]), Optimum::Euclidean);
    assert_eq!(of(&[("0 0 7 4", "1e300")]), Optimum::Euclidean);
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
