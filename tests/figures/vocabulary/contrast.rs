//! Contrast by WCAG 2.1: texts 4.5, lines and marks that mean something 3, on every ground they can lie on, in both
//! palettes. Dimmed lines are dimmed on purpose and exempt; their words are not.

use dcel_kit::HalfEdgeId;
use dcel_kit::figure::sketch::Role;
use dcel_kit::figure::{Colour, FigureOptions, Palette, Style, focus};
use dcel_kit::plane::Subdivision;

type Rgb = [f64; 3];

fn rgb(colour: Colour) -> Rgb {
    [16, 8, 0].map(|shift| f64::from(colour.0 >> shift & 255))
}

fn mix(ground: Rgb, colour: Rgb, part: f64) -> Rgb {
    [0, 1, 2].map(|i| ground[i] * (1.0 - part) + colour[i] * part)
}

fn luminance(c: Rgb) -> f64 {
    let linear =
        |v: f64| if v <= 0.040_45 * 255.0 { v / 255.0 / 12.92 } else { ((v / 255.0 + 0.055) / 1.055).powf(2.4) };
    0.2126 * linear(c[0]) + 0.7152 * linear(c[1]) + 0.0722 * linear(c[2])
}

fn contrast(a: Rgb, b: Rgb) -> f64 {
    let (a, b) = (luminance(a), luminance(b));
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

type Grounds = Vec<(String, Rgb)>;

/// What a structure is drawn on: paper, tints of faces, the hatched outer face.
fn structure_grounds(style: &Style, palette: &Palette) -> Grounds {
    let paper = rgb(palette.background);
    let mut out = vec![("paper".to_owned(), paper)];
    for (i, tint) in style.tints.iter().enumerate() {
        out.push((format!("tint {i}"), mix(paper, rgb(*tint), palette.tint_opacity)));
    }
    // The hatch has an opacity of 0.55; a line can lie along one of its lines.
    out.push(("hatch".to_owned(), mix(paper, rgb(palette.hatch), 0.55)));
    out
}

/// The grounds with an area of every role on them, which covers `part` of a tint's opacity.
fn below_areas(grounds: &Grounds, palette: &Palette, part: f64) -> Grounds {
    let over = |(what, ground): &(String, Rgb)| {
        let area = |role: Role| {
            (format!("{role:?} on {what}"), mix(*ground, rgb(role.fill(palette)), part * palette.tint_opacity))
        };
        Role::ALL.map(area)
    };
    grounds.iter().flat_map(over).collect()
}

/// All of it: a sketch alone has areas on areas, a sketch over a structure has paler ones on its tints.
fn grounds(style: &Style, palette: &Palette) -> Grounds {
    let structure = structure_grounds(style, palette);
    let mut out = below_areas(&structure, palette, 0.5);
    let one = below_areas(&structure[..1].to_vec(), palette, 1.0);
    out.extend(below_areas(&one, palette, 1.0));
    out.extend(one);
    out.extend(structure);
    out
}

fn palettes(style: &Style) -> [(&'static str, &Palette); 2] {
    [("light", &style.light), ("dark", style.dark.as_ref().unwrap())]
}

#[test]
fn lines_that_mean_something_stand_out_wherever_they_lie() {
    let style = Style::default();
    for (theme, palette) in palettes(&style) {
        let roles = Role::ALL.into_iter().filter(|&role| role != Role::Dimmed);
        let mut lines: Vec<(String, Colour)> = roles.map(|role| (format!("{role:?}"), role.line(palette))).collect();
        for (what, colour) in [
            ("ink", palette.ink),
            ("half-edge", palette.half_edge),
            ("edge", palette.edge),
            ("next", palette.next),
            ("twin", palette.twin),
            ("origin and outgoing", palette.origin),
            ("face and boundary", palette.face),
            ("wrong", palette.wrong),
        ] {
            lines.push((what.to_owned(), colour));
        }
        for (ground, under) in grounds(&style, palette) {
            for (what, colour) in &lines {
                // Structures have no areas of sketches below them at full strength.
                if what == "edge" && ground.matches(" on ").count() == 2 {
                    continue;
                }
                let value = contrast(rgb(*colour), under);
                assert!(value >= 3.0, "{theme}: {what} {colour} on {ground}: {value:.2}");
            }
        }
    }
}

#[test]
fn texts_can_be_read_wherever_they_stand() {
    let style = Style::default();
    for (theme, palette) in palettes(&style) {
        let mut texts: Vec<(String, Colour)> =
            Role::ALL.into_iter().map(|role| (format!("{role:?}"), role.text(palette))).collect();
        for (what, colour) in [
            ("vertex name", palette.ink),
            ("half-edge name", palette.half_edge),
            ("face name", palette.face),
            ("grey", palette.grey),
            ("next", palette.next),
            ("twin", palette.twin),
            ("origin", palette.origin),
            ("gone", palette.wrong),
        ] {
            texts.push((what.to_owned(), colour));
        }
        // Words have a halo of paper; on the tints of faces they could be read without it.
        for (ground, under) in &structure_grounds(&style, palette) {
            for (what, colour) in &texts {
                let value = contrast(rgb(*colour), *under);
                assert!(value >= 4.5, "{theme}: {what} {colour} on {ground}: {value:.2}");
            }
        }
        for (what, colour) in [("ink", palette.ink), ("half-edge", palette.half_edge), ("face", palette.face)] {
            let value = contrast(rgb(colour), rgb(palette.hit));
            assert!(value >= 4.5, "{theme}: {what} on a marked row: {value:.2}");
        }
        for role in Role::ALL.into_iter().filter(|&role| role != Role::Dimmed) {
            let value = contrast(rgb(palette.background), rgb(role.line(palette)));
            assert!(value >= 4.5, "{theme}: the number of a badge of {role:?}: {value:.2}");
        }
    }
}

/// What the style sheet of a focus figure says of the edges and of a face that is marked.
#[test]
fn edges_stand_out_on_the_face_that_is_marked() {
    let style = Style::default();
    let lab = Subdivision::lab_rectangle();
    let svg = focus(&lab, HalfEdgeId::new(0), &FigureOptions::new("Focus")).unwrap().to_svg();
    assert!(svg.contains("class=\"f hot\""), "the face is marked");
    let (light, dark) = svg.rsplit_once("prefers-color-scheme:dark").unwrap();
    let last = |css: &str, rule: &str| {
        let value = css.rsplit_once(rule).unwrap_or_else(|| panic!("no rule {rule}")).1;
        value[..value.find(['}', ';']).unwrap()].to_owned()
    };
    let part: f64 = format!("0{}", last(light, " .f.hot .face{fill-opacity:")).parse().unwrap();
    assert!(part >= 2.0 * style.light.tint_opacity.min(0.16), "a marked face looks marked: {part}");
    for ((theme, palette), css) in palettes(&style).into_iter().zip([light, dark]) {
        let hex = last(css, " .edge{stroke:");
        let edge = Colour(u32::from_str_radix(hex.trim_start_matches('#'), 16).unwrap());
        for tint in style.tints {
            let under = mix(rgb(palette.background), rgb(tint), part);
            let value = contrast(rgb(edge), under);
            assert!(value >= 3.0, "{theme}: an edge {edge} on {tint} of a marked face: {value:.2}");
        }
    }
}

/// The formula against the values that WCAG states.
#[test]
fn the_formula_is_that_of_the_guidelines() {
    let value = |a: u32, b: u32| contrast(rgb(Colour(a)), rgb(Colour(b)));
    assert!((value(0, 0x00ff_ffff) - 21.0).abs() < 1e-9);
    assert!((value(0x0076_7676, 0x00ff_ffff) - 4.54).abs() < 0.005);
    assert!((value(0x00ff_0000, 0x00ff_ffff) - 3.998).abs() < 0.005);
}
