//! Figures as pixels: the letters are there, inside the boxes that the layout gave them, and nothing depends on the
//! machine. Needs the feature `png`: `cargo test --features png --test png`.

#[path = "figures/cases.rs"]
#[allow(dead_code)] // some structures are for other figures
mod cases;
#[path = "figures/drawn.rs"]
#[allow(dead_code)] // more is read there than here
mod drawn;
mod shell;

use dcel_kit::FaceId;
use dcel_kit::figure::{self, FaceLabels, Figure, FigureOptions, Film, PngError, Style, Theme, Unit};
use dcel_kit::script::Script;
use drawn::Word;
use resvg::tiny_skia::Pixmap;
use shell::Folder;

fn pixels(png: &[u8]) -> Pixmap {
    Pixmap::decode_png(png).unwrap()
}

fn lab(options: &FigureOptions) -> Figure {
    figure::structure(&cases::lab(), options).unwrap()
}

fn colour(picture: &Pixmap, x: u32, y: u32) -> [u8; 3] {
    let pixel = picture.pixel(x, y).unwrap();
    [pixel.red(), pixel.green(), pixel.blue()]
}

/// How many pixels of a word differ from the picture without words, and how wide the differing part is. The halo
/// counts, too.
fn ink(with: &Pixmap, without: &Pixmap, word: &Word, scale: f64) -> (usize, f64) {
    let (half, reach) = (word.half(), 0.3 * word.size);
    let range = |i: usize| {
        let [low, high] = [-1.0, 1.0].map(|side| (word.at[i] + side * (half[i] + reach)) * scale);
        low.max(0.0) as u32..high as u32
    };
    let (mut count, mut columns) = (0, Vec::new());
    for x in range(0) {
        let column = range(1).filter(|&y| colour(with, x, y) != colour(without, x, y)).count();
        count += column;
        columns.extend((column > 0).then_some(x));
    }
    let wide = columns.last().map_or(0, |last| last - columns[0] + 1);
    (count, f64::from(wide) / scale)
}

#[test]
fn every_word_is_drawn_and_as_wide_as_its_box() {
    let (scale, words) = (2.0, drawn::read(&lab(&FigureOptions::new("Lab")).to_svg()).words);
    let with = pixels(&lab(&FigureOptions::new("Lab")).to_png(scale).unwrap());
    let bare = FigureOptions::new("Lab").vertex_labels(false).half_edge_labels(false).face_labels(FaceLabels::Off);
    let without = pixels(&lab(&bare).to_png(scale).unwrap());
    assert_eq!((with.width(), with.height()), (without.width(), without.height()));
    for class in ["vl", "hl", "fl"] {
        assert!(words.iter().any(|word| word.class == class), "{class}");
    }
    for word in &words {
        let (count, wide) = ink(&with, &without, word, scale);
        let area = 4.0 * word.half()[0] * word.half()[1] * scale * scale;
        assert!(count as f64 > 0.2 * area, "{word:?}: {count} pixels of {area}");
        // Between the first letter's left bearing and the halo of 0.3 em, at the most.
        let room = 2.0 * word.half()[0];
        assert!(wide > 0.75 * room && wide < room + 0.6 * word.size, "{word:?}: {wide} px wide, the box {room}");
    }
}

#[test]
fn the_bytes_depend_on_figure_and_scale_alone() {
    let draw = |font: &str, scale: f64| {
        let mut style = Style::default();
        style.font = font.to_owned();
        lab(&FigureOptions::new("Lab").style(style)).to_png(scale).unwrap()
    };
    let usual = draw(&Style::default().font, 1.0);
    assert_eq!(draw(&Style::default().font, 1.0), usual);
    for font in ["serif", "\"No Such Font\"", "Arial,monospace", "\"Liberation Sans\",sans-serif", ""] {
        assert!(draw(font, 1.0) == usual, "{font:?} must not change or drop letters");
    }
}

#[test]
fn sizes_are_those_of_the_figure_times_the_scale() {
    let figure = lab(&FigureOptions::new("Lab"));
    for scale in [0.5, 1.0, 2.0, 3.7] {
        let picture = pixels(&figure.to_png(scale).unwrap());
        let side = |px: f64| (px * scale).round() as u32;
        assert_eq!((picture.width(), picture.height()), (side(figure.size().0), side(figure.size().1)), "{scale}");
    }
    let paper = lab(&FigureOptions::new("Lab").width(480.0).unit(Unit::Cm));
    let screen = lab(&FigureOptions::new("Lab").width(480.0));
    let [paper, screen] = [&paper, &screen].map(|figure| pixels(&figure.to_png(1.0).unwrap()));
    assert_eq!((paper.width(), paper.height()), (screen.width(), screen.height()));
    let disc =
        |picture: &Pixmap| (0..picture.width()).filter(|&x| colour(picture, x, 60) == [0x1b, 0x24, 0x30]).count();
    assert!(disc(&paper) > 0 && disc(&paper).abs_diff(disc(&screen)) <= 2, "12.7 cm are 480 px");
}

#[test]
fn light_unless_the_style_is_dark() {
    let corner = |theme: Theme| {
        let picture =
            pixels(&lab(&FigureOptions::new("Lab").style(Style::default().theme(theme))).to_png(1.0).unwrap());
        colour(&picture, 1, 1)
    };
    assert_eq!([Theme::Auto, Theme::Light].map(corner), [[0xff; 3]; 2]);
    assert_eq!(corner(Theme::Dark), [0x15, 0x18, 0x1d]);
}

#[test]
fn what_cannot_be_pixels_is_refused() {
    let figure = lab(&FigureOptions::new("Lab"));
    for scale in [0.0, -1.0, f64::NAN, f64::INFINITY, 21.0] {
        assert!(matches!(figure.to_png(scale), Err(PngError::Scale { .. })), "{scale}");
    }
    let wide = lab(&FigureOptions::new("Lab").width(4000.0));
    let error = wide.to_png(20.0).unwrap_err();
    assert!(matches!(error, PngError::TooLarge { width, .. } if width > 20_000.0), "{error}");
}

#[test]
fn characters_without_a_glyph_are_named() {
    let named = |name: &str| lab(&FigureOptions::new("Lab").face_name(FaceId::new(1), name)).without_glyph();
    assert_eq!(named("Größe → ½ θ"), "");
    assert_eq!(named("北x京"), "京北");
}

#[test]
fn the_command_writes_png_by_the_ending_of_the_name() {
    let folder = Folder::new();
    let size = |name: &str| {
        let picture = pixels(&std::fs::read(folder.path(name)).unwrap());
        (picture.width(), picture.height())
    };
    assert_eq!(folder.dcel("figure square.obj --width 300 -o two.png").fine(), "");
    assert_eq!(size("two.png").0, 600, "twice the px, unless told");
    folder.dcel("figure square.obj --width 300 -o three.PNG --scale 3").fine();
    assert_eq!(size("three.PNG").0, 900);
    folder.dcel("figure --records -o records.png --scale 1").fine();
    assert_eq!(size("records.png"), (860, 462));
    folder.write("split.dcels", "rectangle\nsplit_face h2 h8\n");
    folder.dcel("script split.dcels --film film.png --scale 0.5").fine();
    assert_eq!(size("film.png").0, 415, "half of a page of 830 px");
    folder.write("names.txt", "f1 \"北\"\n");
    let told = folder.dcel("figure square.obj --colours names.txt -o north.png");
    assert!(told.code == Some(0) && told.err.contains("note: boxes stand for what the bundled font does not have: 北"));
    folder.dcel("figure square.obj -o two.svg --scale 3").fails(2, "--scale is for pixels", ".png");
    folder.dcel("figure square.obj -o two.png --scale 0").fails(2, "two.png: a scale of 0", "");
}

/// A page of paper of the size of the figure, with letters that can be searched for, and the same bytes each time.
#[test]
fn a_page_of_paper_has_the_size_of_the_figure() {
    let options = FigureOptions::new("Lab").width(480.0);
    let figure = lab(&options);
    let pdf = figure.to_pdf().unwrap();
    assert!(pdf.starts_with(b"%PDF-"));
    assert_eq!(pdf, lab(&options).to_pdf().unwrap());
    let text = String::from_utf8_lossy(&pdf);
    let page = &text[text.find("/MediaBox").unwrap()..];
    let sides: Vec<f64> = page[page.find('[').unwrap() + 1..page.find(']').unwrap()]
        .split_whitespace()
        .map(|x| x.parse().unwrap())
        .collect();
    assert!((sides[2] - 360.0).abs() < 0.5, "480 px are 360 points: {sides:?}");
    assert!(text.contains("/FontFile"), "the letters are embedded");
    let folder = Folder::new();
    folder.dcel("figure square.obj -o two.pdf --width 12cm");
    let bytes = std::fs::read(folder.path("two.pdf")).unwrap();
    let text = String::from_utf8_lossy(&bytes);
    let page = &text[text.find("/MediaBox").unwrap()..];
    let width: f64 = page[page.find('[').unwrap() + 1..].split_whitespace().nth(2).unwrap().parse().unwrap();
    assert!((width - 12.0 / 2.54 * 72.0).abs() < 0.5, "{width}");
}

/// Of the pixels below the captions: a frame that looks like the one before shows nothing.
#[test]
fn every_frame_of_the_films_of_edits_looks_different() {
    for name in ["split-face", "split-in-half", "join-faces"] {
        let text =
            std::fs::read_to_string(format!("{}/../../figures/scripts/{name}.dcels", env!("CARGO_MANIFEST_DIR")))
                .unwrap();
        let film = Film::of_script(&Script::parse(&text, name).unwrap());
        let figure = film.strip(&FigureOptions::new("F")).unwrap();
        let (svg, picture) = (figure.to_svg(), pixels(&figure.to_png(1.0).unwrap()));
        let document = roxmltree::Document::parse(&svg).unwrap();
        let shift = |node: roxmltree::Node<'_, '_>| -> [f64; 2] {
            let words =
                node.attribute("transform").map_or("0 0", |t| t.trim_start_matches("translate(").trim_end_matches(')'));
            let mut numbers = words.split([' ', ',']).map(|word| word.parse().unwrap());
            [numbers.next().unwrap(), numbers.next().unwrap_or(0.0)]
        };
        let frames: Vec<_> =
            document.descendants().filter(|n| n.attribute("class").is_some_and(|c| c.starts_with("fr"))).collect();
        assert_eq!(frames.len(), film.frames().len());
        let places: Vec<[f64; 2]> = frames.iter().map(|frame| shift(*frame)).collect();
        let drawing = |frame: &roxmltree::Node<'_, '_>| {
            shift(frame.children().rfind(|n| n.has_tag_name(("http://www.w3.org/2000/svg", "g"))).unwrap())
        };
        let head = drawing(&frames[0])[1];
        let step = places.iter().map(|place| place[1]).find(|&y| y > 0.0).unwrap();
        let (width, height) = (400, (step - head - 30.0) as u32);
        let at = |i: usize, x: u32, y: u32| colour(&picture, places[i][0] as u32 + x, (places[i][1] + head) as u32 + y);
        for i in 1..frames.len() {
            let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
            let differ = pixels.filter(|&(x, y)| at(i, x, y) != at(i - 1, x, y)).count();
            assert!(differ > 60, "{name}: frame {i} differs from the one before in {differ} pixels");
        }
    }
}
