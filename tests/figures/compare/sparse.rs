//! Of a line of one dash with a long gap the dash is seen: it hides an edge, and is one too many elsewhere.

use super::judge;
use super::shown::{EDGES, P, drawn, edge, line, same, says, vertex, with};

const DASHES: [&str; 5] = ["3 200", "10 1000", "30 1000", "3 60", "6 100"];

fn dashed(ends: [P; 2], dashes: &str) -> String {
    line(ends, &format!("stroke=\"#333\" stroke-width=\"1.5\" stroke-dasharray=\"{dashes}\""))
}

#[test]
fn a_dash_that_the_reference_does_not_have_is_told() {
    for dashes in DASHES {
        let extra = dashed([[50.0, 350.0], [550.0, 50.0]], dashes);
        says(&with(&extra), "edge between (50, 350) and (550, 50) is not in the reference");
        // In the middle of nowhere.
        let answer = judge(&with(""), &with(&dashed([[250.0, 230.0], [380.0, 140.0]], dashes)));
        assert!(answer.text().contains("a line ends at (250, 230), where there is no vertex"), "{}", answer.text());
    }
    let dot = dashed([[250.0, 230.0], [380.0, 140.0]], "0 1000").replace("/>", " stroke-linecap=\"round\"/>");
    assert!(!judge(&with(""), &with(&dot)).is_equal());
    // Below the circle at its end, without ink, and along an edge that is drawn nobody sees it.
    same(&with("").replacen("<circle", &format!("{}<circle", dashed([[50.0, 350.0], [550.0, 50.0]], "3 1000")), 1));
    same(&with(&dashed([[50.0, 350.0], [550.0, 50.0]], "0 1000")));
    same(&with(&dashed([[50.0, 350.0], [550.0, 350.0]], "30 1000")));
    same(&with(&dashed([[150.0, 350.0], [450.0, 350.0]], "30 1000")));
}

#[test]
fn an_edge_of_which_one_dash_is_drawn_is_hidden() {
    for dashes in DASHES {
        let first = |i: usize, ends: [P; 2]| if i == 0 { dashed(ends, dashes) } else { edge(i, ends) };
        let said = "edge between (50, 350) and (550, 350) cannot be seen: its dashes leave it out";
        says(&drawn(first, vertex, ""), said);
        // A reference that draws such a line has it, too.
        let own = with(&dashed([[50.0, 350.0], [550.0, 50.0]], dashes));
        let answer = judge(&own, &own.replace('\n', " "));
        assert!(answer.is_equal(), "{}", answer.text());
        let moved = with(&dashed([[250.0, 230.0], [550.0, 50.0]], dashes));
        assert!(!judge(&own, &moved).is_equal(), "{dashes}");
    }
    assert_eq!(EDGES[0], [0, 1]);
}

/// A sparse line that begins along an edge is told where it goes on.
#[test]
fn a_sparse_line_beyond_an_edge_is_told() {
    let end = [550.0, 350.0];
    let middle = [300.0, 350.0];
    let more = |last: &str| {
        let first = |i: usize, ends: [P; 2]| if i == 0 { edge(i, [ends[0], middle]) } else { edge(i, ends) };
        drawn(first, vertex, &format!("{}{last}", vertex(middle)))
    };
    let reference = more("");
    let answer = judge(&reference, &more(&dashed([[50.0, 350.0], end], "3 40")));
    let said = "edge between (550, 350) and (300, 350) is not in the reference";
    assert!(answer.text().contains(said), "{}", answer.text());
    // A copy that nobody sees hides none that is seen.
    let twice = format!("{}{}", dashed([middle, end], "3 40"), dashed([middle, end], "0 1000"));
    assert!(judge(&reference, &more(&twice)).text().contains(said));
}
