//! Names that nobody can read are told, and so are names too many.

use super::declared::{changed, moved, named, reference, within};
use super::ship;
use dcel_kit::compare::{Options, compare};
use dcel_kit::figure::{Detail, FigureOptions, Theme, structure};

/// The reference with this style on the name of an element.
fn styled(element: &str, style: &str) -> String {
    changed(|lines| {
        let at = within(lines, element, "<text");
        lines[at] = lines[at].replacen("<text", &format!("<text style=\"{style}\""), 1);
    })
}

#[track_caller]
fn reads(svg: &str) {
    assert!(named(svg).starts_with("equal"), "{}", named(svg));
}

#[track_caller]
fn says(svg: &str, said: &str) {
    assert!(named(svg).contains(said), "`{said}` not said: {}", named(svg));
}

#[test]
fn letters_of_the_colour_of_their_halo_cannot_be_read() {
    for element in ["v1", "h0", "f1"] {
        let said = format!("the name of {element} cannot be seen");
        for style in ["fill:#fff", "fill:white;stroke-width:4px", "fill:#fdfdfd;paint-order:normal;stroke-width:.3em"] {
            says(&styled(element, style), &said);
        }
    }
    // A dark blot on the paper says no more than a white one.
    for style in ["stroke:#6b5300", "fill:#123456;stroke:#123456;stroke-width:1em", "stroke-width:4px;stroke:#6b5300"] {
        says(&styled("f1", style), "the name of f1 cannot be seen");
    }
    // A thin rim makes letters bold; light letters are read on a dark halo, and dark letters without any.
    for style in [
        "stroke:#6b5300;stroke-width:.08em",
        "stroke:#6b5300;stroke-width:1px",
        "fill:#fff;stroke:#000",
        "stroke:none",
        "fill:#fff;stroke:#000;paint-order:normal;stroke-width:.05em",
        "stroke-width:0",
        "stroke:none;fill:#036",
    ] {
        reads(&styled("f1", style));
    }
}

#[test]
fn letters_smaller_than_4_px_cannot_be_read() {
    for element in ["v1", "h0", "f1"] {
        let said = format!("the name of {element} cannot be seen");
        for size in ["0", ".1px", "1px", "3px", "2pt"] {
            says(&styled(element, &format!("font-size:{size}")), &said);
        }
        for size in ["5px", "7.2px", "4pt"] {
            reads(&styled(element, &format!("font-size:{size}")));
        }
    }
    // However they become small, and in one direction only, too.
    for [x, y] in [[0.1, 0.1], [1.0, 0.1], [0.1, 1.0]] {
        let small = changed(|lines| {
            let at = within(lines, "f1", "<text");
            let [u, v] = place(&lines[at]);
            let moved = format!("<text transform=\"translate({u} {v}) scale({x} {y}) translate(-{u} -{v})\"");
            lines[at] = lines[at].replacen("<text", &moved, 1);
        });
        says(&small, "the name of f1 cannot be seen");
    }
    // A file without a size fills a window; a small one is looked at enlarged.
    for size in ["", "width=\"60\" height=\"40\" "] {
        let svg = reference();
        let at = svg.find(" width=\"").unwrap() + 1;
        let end = at + svg[at..].find('>').unwrap();
        let root = &svg[at..end];
        let tall = svg.find(" height=\"").unwrap() + 1;
        let height = &svg[tall..tall + svg[tall..].find(' ').unwrap() + 1];
        let width = &root[..root.find(' ').unwrap() + 1];
        reads(&svg.replacen(width, size, 1).replacen(height, "", 1));
    }
}

/// The place of a text.
fn place(line: &str) -> [f64; 2] {
    [" x=\"", " y=\""].map(|key| {
        let rest = &line[line.find(key).unwrap() + key.len()..];
        rest[..rest.find('"').unwrap()].parse().unwrap()
    })
}

/// What the kit draws can be read, whatever it looks like.
#[test]
fn names_that_the_kit_draws_can_be_read() {
    let options = |name: &str| FigureOptions::new(name).detail(Detail::Full);
    let dark = dcel_kit::figure::Style::default().theme(Theme::Dark);
    let plane = ship();
    for options in [
        options("ship"),
        options("mine").width(1234.5),
        options("mine").width(320.0),
        options("mine").plain(true),
        options("mine").style(dark.clone()),
        options("mine").style(dark).plain(true),
        options("mine").interactive(true),
    ] {
        let svg = structure(&plane, &options).unwrap().to_svg();
        // What is not read in the reference is excused: so none of it may be missing without any excuse.
        let shown = |svg: &str| compare(&reference(), svg, &Options::new().names(true)).unwrap();
        let told = shown(&svg).text();
        assert!(!told.contains("cannot be seen") && !told.contains("twice") && !told.contains("too: "), "{told}");
    }
    // A halo that is a copy of the text below it is one, too.
    let plain = structure(&plane, &options("ship").plain(true)).unwrap().to_svg();
    let lines: Vec<&str> = plain.lines().collect();
    let copies: Vec<usize> = (0..lines.len()).filter(|&i| lines[i].contains(">f1</text>")).collect();
    assert_eq!(copies.len(), 2, "{plain}");
    let mut blot: Vec<String> = lines.iter().map(|&line| line.to_owned()).collect();
    let fill = |line: &str| {
        let rest = &line[line.find("fill=\"").unwrap()..];
        rest[..rest[6..].find('"').unwrap() + 7].to_owned()
    };
    blot[copies[1]] = blot[copies[1]].replacen(&fill(lines[copies[1]]), &fill(lines[copies[0]]), 1);
    let answer = compare(&plain, &blot.join("\n"), &Options::new().names(true)).unwrap().text();
    assert!(answer.contains("the name of f1 cannot be seen"), "{answer}");
}

/// The reference with another text behind the name of an element, so far from it.
fn more(element: &str, text: &str, [x, y]: [f64; 2], attributes: &str) -> String {
    changed(|lines| {
        let at = within(lines, element, "<text");
        let [u, v] = place(&lines[at]);
        let class = &lines[at][lines[at].find("class=\"").unwrap()..][..10];
        let more = format!("<text {class} {attributes} x=\"{}\" y=\"{}\">{text}</text>", u + x, v + y);
        lines.insert(at + 1, more);
    })
}

/// The reference with something behind everything.
fn behind(nodes: &str) -> String {
    reference().replacen("</svg>", &format!("{nodes}</svg>"), 1)
}

#[test]
fn names_too_many_are_told() {
    says(&more("f1", "f2", [0.0, 20.0], ""), "1 name is drawn at something else, too: f2 at f1");
    says(&more("h0", "h7", [15.0, 0.0], ""), "1 name is drawn at something else, too: h7 at h0");
    says(&more("v1", "h7", [15.0, 15.0], ""), "1 name is drawn at something else, too: h7 at v1");
    says(&more("f1", "f1", [0.0, 25.0], ""), "1 name is drawn twice: f1");
    let lines: Vec<String> = reference().lines().map(str::to_owned).collect();
    let [x, y] = place(&lines[within(&lines, "f2", "<text")]);
    let text = |name: &str| format!("<text x=\"{x}\" y=\"{}\">{name}</text>", y + 12.0);
    says(&behind(&text("h0")), "1 name is drawn twice: h0");
    says(&behind(&(text("h0") + &text("v3"))), "2 names are drawn twice: h0, v3");
    let unnamed = changed(|lines| _ = lines.remove(within(lines, "f1", "<text")));
    let loose = unnamed.replacen("</svg>", &format!("{}</svg>", text("f1")), 1);
    says(&loose, "1 name stands where nothing of that name is drawn: f1");
    // Whatever the reference draws too often may be drawn so.
    let twice = behind(&text("h0"));
    let again = twice.replacen("<desc", " <desc", 1);
    assert!(compare(&twice, &again, &Options::new().names(true)).unwrap().is_equal());
    assert!(!compare(&twice, &behind(&text("h2")), &Options::new().names(true)).unwrap().is_equal());
}

#[test]
fn texts_that_name_nothing_are_no_names() {
    reads(&more("h0", "h0", [0.0, 0.0], ""));
    reads(&more("f1", "f2", [0.0, 20.0], "visibility=\"hidden\""));
    reads(&more("f1", "f99", [0.0, 20.0], ""));
    let lines: Vec<String> = reference().lines().map(str::to_owned).collect();
    let [x, y] = place(&lines[within(&lines, "f2", "<text")]);
    let text = |name: &str| format!("<text x=\"{x}\" y=\"{}\">{name}</text>", y + 12.0);
    for words in ["f2 is a sail", "h0, h1", "next", "area", "f", "h", "12", "v 1", "v66"] {
        reads(&behind(&text(words)));
    }
    for group in ["class=\"table\"", "class=\"legend\"", "class=\"caption\"", "id=\"notes\"", "class=\"a title\""] {
        reads(&behind(&format!("<g {group}>{}</g>", text("h0"))));
    }
    // Clear of the structure, as a table that nobody calls so.
    reads(&behind("<text x=\"30\" y=\"-300\">h0</text><text x=\"30\" y=\"-320\">v0</text>"));
}

/// No figure of the kit draws a name too many, be it a film, a page, an inset or a table.
#[test]
fn figures_of_the_kit_draw_no_name_too_many() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../figures");
    let mut seen = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|ending| ending != "svg") {
            continue;
        }
        let full = std::fs::read_to_string(&path).unwrap();
        // A reference without any name excuses none.
        let bare: Vec<&str> = full.lines().filter(|line| !line.starts_with("<text")).collect();
        if let Ok(answer) = compare(&bare.join("\n"), &full, &Options::new().names(true)) {
            assert!(answer.is_equal(), "{}: {}", path.display(), answer.text());
            seen += 1;
        }
    }
    assert!(seen > 5, "{seen}");
}

/// The reference with another text in the place of a name.
fn renamed(element: &str, text: &str) -> String {
    changed(|lines| {
        let at = within(lines, element, "<text");
        lines[at] = lines[at].replace(&format!(">{element}<"), &format!(">{text}<"));
    })
}

#[test]
fn texts_that_are_no_names_stand_for_none() {
    for (element, text) in [("v1", "xyz"), ("h0", "v99"), ("f1", "a sail")] {
        let said = format!("the name of {element} is not drawn: `{text}` stands in its place");
        says(&renamed(element, text), &said);
        // A reference that shows no name asks for none.
        let shown = compare(&renamed(element, "?"), &renamed(element, text), &Options::new().names(true)).unwrap();
        assert!(shown.is_equal(), "{}", shown.text());
        // A note beside the name is none of its business.
        reads(&more(element, text, [0.0, 30.0], ""));
    }
    for (element, text) in [("v1", "v\u{2081}"), ("v1", "v_1"), ("h0", "h<tspan dy=\"2\">0</tspan>"), ("f1", "$f_1$")] {
        reads(&renamed(element, text));
    }
}

#[test]
fn names_may_stand_outside_of_the_groups_of_what_they_name() {
    for element in ["v1", "h0", "f1"] {
        let mut text = String::new();
        let unnamed = changed(|lines| text = lines.remove(within(lines, element, "<text")));
        reads(&unnamed.replacen("</svg>", &format!("{text}</svg>"), 1));
        says(&unnamed, &format!("the name of {element} is not drawn"));
    }
}

#[test]
fn names_of_vertices_stand_near_them() {
    let far = |shift: &str| changed(|lines| moved(lines, "v1", "<text", &format!("translate({shift})")));
    for shift in ["0 -130", "-110 0"] {
        says(&far(shift), "the name of v1 does not stand where v1 is drawn");
    }
    for shift in ["0 20", "0 -24", "16 16"] {
        reads(&far(shift));
    }
    // A line may lead to it.
    let lines: Vec<String> = reference().lines().map(str::to_owned).collect();
    let [x, y] = place(&lines[within(&lines, "v1", "<text")]);
    let led = changed(|lines| {
        moved(lines, "v1", "<text", "translate(-60 -70)");
        let [u, v] = [x - 54.0, y - 63.0];
        let leader = format!("<line class=\"leader\" x1=\"{x}\" y1=\"{y}\" x2=\"{u}\" y2=\"{v}\"/>");
        let at = within(lines, "v1", "<text");
        lines.insert(at, leader);
    });
    reads(&led);
}

#[test]
fn names_that_are_covered_or_faint_cannot_be_read() {
    let said = |element: &str| format!("the name of {element} cannot be seen");
    let below = changed(|lines| {
        let [text, disc] = ["<text", "<circle"].map(|start| within(lines, "v1", start));
        lines.swap(text, disc);
    });
    says(&below, &said("v1"));
    let lines: Vec<String> = reference().lines().map(str::to_owned).collect();
    let over = |element: &str, node: &dyn Fn(f64, f64) -> String| {
        let [x, y] = place(&lines[within(&lines, element, "<text")]);
        behind(&node(x, y))
    };
    for width in [28.0, 16.0] {
        let covered = |x: f64, y: f64| {
            let left = x - 0.5 * width;
            format!("<rect x=\"{left}\" y=\"{}\" width=\"{width}\" height=\"20\" fill=\"#fff\"/>", y - 10.0)
        };
        says(&over("f1", &covered), &said("f1"));
    }
    // A thin line across hides no letters.
    let crossed = |x: f64, y: f64| {
        format!("<g class=\"ptr\"><path fill=\"none\" stroke=\"#000\" d=\"M{} {y}h30\"/></g>", x - 15.0)
    };
    reads(&over("f1", &crossed));
    let text = |words: &'static str, fill: &'static str| {
        move |x: f64, y: f64| format!("<text x=\"{x}\" y=\"{y}\" dy=\".36em\" fill=\"{fill}\">{words}</text>")
    };
    says(&over("v1", &text("XX", "black")), &said("v1"));
    for style in ["fill-opacity:0", "opacity:.05", "fill:#f4f4f4;stroke:none"] {
        says(&styled("v1", style), &said("v1"));
    }
    reads(&styled("v1", "opacity:.6"));
    let squeezed = |length: f64| {
        changed(|lines| {
            let at = within(lines, "v1", "<text");
            let how = format!("<text textLength=\"{length}\" lengthAdjust=\"spacingAndGlyphs\"");
            lines[at] = lines[at].replacen("<text", &how, 1);
        })
    };
    says(&squeezed(0.1), &said("v1"));
    reads(&squeezed(14.0));
}

/// Of a face that is called so, `Garden`, `f1` and `f1 Garden` are names.
#[test]
fn faces_are_called_by_number_and_name() {
    let svg = |name: &str, text: &str| {
        changed(|lines| {
            let at = within(lines, "f1", "<text");
            lines[at] = lines[at].replace(">f1<", &format!(">{text}<"));
            let group = lines[..at].iter().rposition(|line| line.starts_with("<g ")).unwrap();
            lines[group] = lines[group].replacen("<g ", &format!("<g data-name=\"{name}\" "), 1);
        })
    };
    let answer = |mine: &str, theirs: &str| compare(mine, theirs, &Options::new().names(true)).unwrap();
    let plain = svg("Garden", "Garden");
    for (name, text) in [("f1 Garden", "f1 Garden"), ("Garden", "f1: Garden"), ("Garden", "f1")] {
        for [mine, theirs] in [[&plain, &svg(name, text)], [&svg(name, text), &plain]] {
            assert!(answer(mine, theirs).is_equal(), "{name}: {}", answer(mine, theirs).text());
        }
    }
    for (name, text) in [("Garden", "Shed"), ("f1 Shed", "f1 Shed"), ("f2 Garden", "f2 Garden")] {
        assert!(!answer(&plain, &svg(name, text)).is_equal(), "{name}");
    }
}
