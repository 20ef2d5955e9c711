//! What may change after a moment is refused if it is compared, and passed over if it is not.

use super::seen::{equal, plain, within};
use super::{judge, refused};

/// The first line of the drawing with something inside.
fn in_first_line(inside: &str) -> String {
    plain().replacen("stroke=\"black\"/>", &format!("stroke=\"black\">{inside}</line>"), 1)
}

#[test]
fn an_animation_of_what_is_compared_is_refused_with_its_place() {
    for (name, attribute) in [
        ("set", "opacity"),
        ("set", "display"),
        ("set", "visibility"),
        ("set", "class"),
        ("set", "style"),
        ("animate", "stroke"),
        ("animate", "stroke-width"),
        ("animate", "x1"),
        ("animate", "stroke-dashoffset"),
        ("animate", "clip-path"),
        ("animateColor", "stroke"),
        ("animateTransform", "transform"),
    ] {
        let svg = in_first_line(&format!("\n <{name} attributeName=\"{attribute}\" to=\"0\" dur=\"1s\"/>"));
        let line = svg.lines().position(|line| line.contains("attributeName")).unwrap() + 1;
        let said = format!(
            "student:{line}:2: <{name}> changes `{attribute}` of <line> after a moment, and a comparison looks at one \
             moment only: take it out, or compare the picture without motion"
        );
        assert_eq!(refused(&svg), said);
    }
    let said = refused(&in_first_line("<animateMotion path=\"M0 0L99 99\" dur=\"1s\"/>"));
    assert!(said.contains("<animateMotion> changes the place of <line> after a moment"), "{said}");
    assert!(refused(&in_first_line("<animateTransform type=\"scale\" to=\"0\"/>")).contains("changes `transform`"));
    // By a link, from within a definition, of a gradient, of a whole group.
    for (before, after, said) in [
        ("", "<set href=\"#a\" attributeName=\"fill\" to=\"none\"/>", "`fill` of <rect>"),
        (
            "",
            "<set xmlns:xlink=\"http://www.w3.org/1999/xlink\" xlink:href=\"#a\" attributeName=\"x\" to=\"9\"/>",
            "`x` of <rect>",
        ),
        (
            "<linearGradient id=\"g\"><stop><set attributeName=\"stop-opacity\" to=\"0\"/></stop></linearGradient>",
            "",
            "`stop-opacity` of <stop>",
        ),
        ("<defs><g id=\"d\"><animate attributeName=\"opacity\" to=\"0\"/></g></defs>", "", "`opacity` of <g>"),
        ("<set attributeName=\"viewBox\" to=\"0 0 1 1\"/>", "", "`viewBox` of <svg>"),
        ("", "<use href=\"#a\"><set attributeName=\"xlink:href\" to=\"#b\"/></use>", "`href` of <use>"),
    ] {
        let own = "<rect id=\"a\" x=\"-9\" y=\"-9\" width=\"5\" height=\"5\"/>";
        let error = refused(&within(before, &format!("{own}{after}")));
        assert!(error.contains(&format!("changes {said} after a moment")), "{error}");
    }
}

#[test]
fn an_animation_of_what_is_not_compared_is_a_note() {
    let label = "<text x=\"9\" y=\"390\">A<animate attributeName=\"fill\" values=\"red;navy\" dur=\"1s\"/></text>";
    for (inside, note) in [
        (label, "not read: 1 <animate>"),
        (&label.replace("fill", "font-weight"), "not read: 1 <animate>"),
        (
            "<g><set attributeName=\"cursor\" to=\"pointer\"/><set attributeName=\"data-step\" to=\"2\"/></g>",
            "not read: 2 <set>",
        ),
        ("<set href=\"#nobody\" attributeName=\"opacity\" to=\"0\"/>", "not read: 1 <set>"),
    ] {
        let svg = within("", inside);
        equal(&svg);
        let answer = judge(&plain(), &svg);
        assert!(answer.notes().iter().any(|said| said == note), "{inside}: {:?}", answer.notes());
    }
    // Large letters that are painted only later hide what lies below them.
    let large = label.replace("x=\"9\"", "x=\"9\" font-size=\"900\" fill=\"none\"");
    let answer = judge(&plain(), &within("", &large));
    assert!(answer.text().contains("large letters are drawn over them"), "{}", answer.text());
    equal(&within("", &large.replace("\"fill\"", "\"font-weight\"")));
}

#[test]
fn an_animation_by_a_style_is_refused_where_something_has_it() {
    let keyframes = "@keyframes dash{to{stroke-dashoffset:-100}}";
    let ruled = |rules: &str| within(&format!("<style>{keyframes}{rules}</style>"), "<text y=\"390\">A</text>");
    let error = refused(&ruled("line{animation:dash 2s infinite}"));
    assert!(
        error.contains("<style> changes how <line> looks, by `animation: dash 2s infinite`, after a moment"),
        "{error}"
    );
    assert!(refused(&ruled("svg{Animation-Name:dash}")).contains("how <svg> looks"));
    for rules in ["", ".nobody{animation:dash 2s}", "line{animation:none}", "text{animation:dash 2s}"] {
        equal(&ruled(rules));
    }
    let error = refused(&within("<style>@keyframes out{to{opacity:0}}</style>", ""));
    assert!(error.contains("the style rule `@keyframes out` changes what is seen"), "{error}");
}

#[test]
fn films_of_the_kit_are_compared_by_their_frame_that_is_seen() {
    for film in [
        include_str!("../../../figures/film-split-face.svg"),
        include_str!("../../../figures/film-flips.svg"),
        include_str!("../../../figures/film-join-faces.svg"),
    ] {
        let answer = judge(film, &film.replace('\n', " "));
        assert!(answer.is_equal(), "{}", answer.text());
        let line = film.rfind("<line class=\"edge\"").or_else(|| film.rfind("<path class=\"edge\"")).unwrap();
        let moving = format!("{}<g><set attributeName=\"opacity\" to=\"0\"/></g>{}", &film[..line], &film[line..]);
        let error = dcel_kit::compare::compare(film, &moving, &dcel_kit::compare::Options::new()).unwrap_err();
        assert!(error.to_string().contains("<set> changes `opacity` of <g>"), "{error}");
    }
}
