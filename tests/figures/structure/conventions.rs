//! The files: ids, references, numbers, style sheets, colours, escapes, equal bytes.

use super::drawn::read;
use super::{cases, draw, gallery};
use dcel_kit::FaceId;
use dcel_kit::figure::{Colour, FigureOptions, Style, structure};
use std::collections::BTreeSet;

#[test]
fn files_are_well_formed_and_their_references_resolve() {
    for (name, table, options) in gallery() {
        let svg = structure(&table, &options).unwrap().to_svg();
        assert!(svg.ends_with("</svg>\n"), "{name}: no line break at the end");
        let document = roxmltree::Document::parse(&svg).unwrap_or_else(|error| panic!("{name}: {error}"));
        let mut ids = BTreeSet::new();
        let mut wanted = BTreeSet::new();
        for node in document.descendants() {
            for attribute in node.attributes() {
                let value = attribute.value();
                match attribute.name() {
                    "id" => assert!(ids.insert(value.to_owned()), "{name}: id {value} twice"),
                    "aria-labelledby" => wanted.extend(value.split(' ').map(str::to_owned)),
                    _ if value.contains("url(") => {
                        wanted.insert(value.trim_start_matches("url(#").trim_end_matches(')').to_owned());
                    }
                    _ => {}
                }
            }
        }
        assert!(wanted.len() >= 2, "{name}: title and description are not referred to");
        assert!(wanted.is_subset(&ids), "{name}: {:?} do not resolve", wanted.difference(&ids).collect::<Vec<_>>());
        let root = document.root_element();
        assert_eq!((root.attribute("data-figure"), root.attribute("data-y")), (Some("dcel"), Some("up")));
        assert!(ids.iter().all(|id| *id == options.prefix() || id.starts_with(&format!("{}-", options.prefix()))));
    }
}

#[test]
fn numbers_are_finite_short_and_never_negative_zero() {
    for (name, table, options) in gallery() {
        let svg = structure(&table, &options).unwrap().to_svg();
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{name}");
        let document = roxmltree::Document::parse(&svg).unwrap();
        let drawn = ["x", "y", "x1", "y1", "x2", "y2", "cx", "cy", "r", "width", "height", "viewBox", "d", "font-size"];
        for attribute in document.descendants().flat_map(|n| n.attributes()).filter(|a| drawn.contains(&a.name())) {
            let value = attribute.value();
            for number in value.split(|c: char| !(c.is_ascii_digit() || c == '.' || c == '-')).filter(|n| !n.is_empty())
            {
                for number in number.split_inclusive('-').map(|n| n.trim_end_matches('-')).filter(|n| !n.is_empty()) {
                    let decimals = number.split('.').nth(1).unwrap_or("1");
                    assert!(!decimals.is_empty() && decimals.len() <= 2, "{name}: {}={value}", attribute.name());
                    assert!(!decimals.ends_with('0'), "{name}: {}={value}", attribute.name());
                }
            }
            for tail in value.match_indices("-0").map(|(i, _)| &value[i + 2..]) {
                assert!(tail.starts_with('.') && !tail.starts_with(".0"), "{name}: negative zero in {value}");
            }
        }
    }
}

#[test]
fn the_same_structure_gives_the_same_bytes() {
    for (name, table, options) in gallery() {
        let draw = || structure(&table, &options).unwrap().to_svg();
        assert!(draw() == draw(), "{name}");
    }
}

/// Functions whose last bit differs between platforms, and maps whose order does.
#[test]
fn no_source_of_platform_differences_is_used() {
    let source = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../src");
    let mut paths = vec![source.join("figure"), source.join("compare")];
    let mut read = 0;
    while let Some(path) = paths.pop() {
        if path.is_dir() {
            paths.extend(std::fs::read_dir(path).unwrap().map(|entry| entry.unwrap().path()));
            continue;
        }
        if path.extension().is_none_or(|extension| extension != "rs") {
            continue;
        }
        // Comparing reads drawings of others, turned and curved ones among them, and judges them with room for rounding.
        // What it draws itself is in the files of the difference picture.
        let draws =
            path.file_name().is_some_and(|name| name.to_string_lossy().starts_with("diff") || name == "yours.rs");
        if path.components().any(|part| part.as_os_str() == "compare") && !draws {
            continue;
        }
        let text = std::fs::read_to_string(&path).unwrap();
        let forbidden = [
            ".sin(",
            ".cos(",
            ".tan(",
            ".atan",
            ".asin(",
            ".acos(",
            ".sin_cos(",
            ".hypot(",
            ".powf(",
            ".powi(",
            ".exp(",
            ".ln(",
            ".log",
            ".cbrt(",
            ".mul_add(",
            "HashMap<",
            "HashSet<",
        ];
        for word in forbidden {
            assert!(!text.contains(word), "{} uses {word}", path.display());
        }
        read += 1;
    }
    assert!(read > 10, "only {read} files were read");
}

#[test]
fn style_rules_are_scoped_and_dark_mode_is_there() {
    for (name, table, options) in gallery() {
        let svg = structure(&table, &options).unwrap().to_svg();
        let document = roxmltree::Document::parse(&svg).unwrap();
        let style = document.descendants().find(|n| n.tag_name().name() == "style").unwrap().text().unwrap();
        let scope = format!("#{} ", options.prefix());
        for rule in style.lines().filter(|line| !line.trim().is_empty()) {
            let dark = rule == "@media (prefers-color-scheme:dark){" || rule == "}";
            assert!(dark || rule.starts_with(&scope), "{name}: {rule}");
            assert!(!rule.contains('>') && !rule.contains("var("), "{name}: {rule}");
        }
        let (light, dark) = style.split_once("@media (prefers-color-scheme:dark){").unwrap();
        let worn: BTreeSet<&str> =
            document.descendants().filter_map(|n| n.attribute("class")).flat_map(str::split_whitespace).collect();
        for class in ["bg", "sh", "barb", "vd", "hl", "fl", "edge", "hatch", "face"] {
            let rule = format!(".{class}{{");
            let has = [light.contains(&rule), dark.contains(&rule)];
            assert_eq!(has, [worn.contains(class); 2], "{name}: {class} has one palette only, or is not worn");
        }
        for attribute in document.descendants().flat_map(|n| n.attributes()) {
            let fixed = ["fill", "stroke", "style", "color"].contains(&attribute.name());
            assert!(!fixed || attribute.value().starts_with("url("), "{name}: {attribute:?} ignores dark mode");
        }
    }
}

#[test]
fn two_figures_in_one_page_share_no_id() {
    let [a, b] = ["First", "Second"].map(|title| draw(title, &cases::cube()));
    let ids = |svg: &str| {
        let document = roxmltree::Document::parse(svg).unwrap();
        document.descendants().filter_map(|n| n.attribute("id").map(str::to_owned)).collect::<BTreeSet<_>>()
    };
    assert!(ids(&a).len() > 40 && ids(&a).is_disjoint(&ids(&b)));
    assert!(!a.contains("#second") && !b.contains("#first"));
}

#[test]
fn texts_of_the_caller_are_escaped() {
    let title = "a <b> & \"c\" ]]> \u{1} 'd'";
    let options = FigureOptions::new(title).face_name(FaceId::new(1), "<f> & \"g\"").id_prefix("x");
    let svg = structure(&cases::cube(), &options).unwrap().to_svg();
    let document = roxmltree::Document::parse(&svg).unwrap();
    let text = document.descendants().find(|n| n.attribute("id") == Some("x-title")).unwrap().text().unwrap();
    assert_eq!(text.trim(), title.replace('\u{1}', "\u{fffd}"));
    assert_eq!(read(&svg).data["f1"]["data-name"], "<f> & \"g\"");
}

/// WCAG 2.1: text 4.5, lines 3, on the paper and on every tint.
#[test]
fn lines_and_texts_stand_out_on_every_tint_in_both_palettes() {
    let channels = |c: Colour| [16, 8, 0].map(|shift| f64::from(c.0 >> shift & 255));
    let luminance = |c: [f64; 3]| {
        let linear = |v: f64| if v <= 10.0 { v / 255.0 / 12.92 } else { ((v / 255.0 + 0.055) / 1.055).powf(2.4) };
        0.2126 * linear(c[0]) + 0.7152 * linear(c[1]) + 0.0722 * linear(c[2])
    };
    let contrast = |a: [f64; 3], b: [f64; 3]| {
        let (a, b) = (luminance(a), luminance(b));
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    };
    let style = Style::default();
    for palette in [&style.light, style.dark.as_ref().unwrap()] {
        let paper = channels(palette.background);
        let tinted = style.tints.map(|tint| {
            let (hue, o) = (channels(tint), palette.tint_opacity);
            [0, 1, 2].map(|i| paper[i] * (1.0 - o) + hue[i] * o)
        });
        for (what, colour, least) in [
            ("ink", palette.ink, 4.5),
            ("half-edge", palette.half_edge, 4.5),
            ("face", palette.face, 4.5),
            ("edge", palette.edge, 3.0),
        ] {
            for ground in std::iter::once(paper).chain(tinted) {
                let value = contrast(channels(colour), ground);
                assert!(value >= least, "{what} {colour} on {ground:?}: {value}");
            }
        }
    }
}
