//! Figures and pages in other programs: in a real browser, and in LaTeX. In the browser: what the console says, what
//! hovering, focus and addresses show, what the page does on clicks and keys.

#[path = "browser/devtools.rs"]
mod devtools;
#[path = "browser/latex.rs"]
mod latex;
#[path = "support/trials.rs"]
mod trials;

use dcel_kit::figure::{self, FigureOptions, Film};
use dcel_kit::plane::Subdivision;
use dcel_kit::script::Script;
use devtools::Browser;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use trials::trials;

/// A folder with one file.
struct File {
    path: PathBuf,
    _folder: tempfile::TempDir,
}

impl File {
    fn new(name: &str, text: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        Self { path, _folder: folder }
    }
}

fn lab() -> Subdivision {
    let mut lab = Subdivision::lab_rectangle();
    lab.split_face(dcel_kit::HalfEdgeId::new(2), dcel_kit::HalfEdgeId::new(8)).unwrap();
    lab
}

fn picture() -> File {
    let options = FigureOptions::new("Lab").interactive(true);
    File::new("lab.svg", &figure::structure(&lab(), &options).unwrap().to_svg())
}

fn page() -> File {
    File::new("lab.html", figure::page(&lab(), &FigureOptions::new("Lab")).unwrap().to_html())
}

/// The ids of the half-edges whose pointers are seen.
const SHOWN: &str = "[...document.querySelectorAll('.he')].filter(g => g.querySelector('.ptr') && \
                     getComputedStyle(g.querySelector('.ptr')).display !== 'none').map(g => g.id)";

/// A point on the shaft of a half-edge, in px of the window.
fn on_shaft(browser: &mut Browser, id: &str) -> [f64; 2] {
    let box_of = format!("document.querySelector('#{id} .sh').getBoundingClientRect()");
    let place = browser.eval(&format!("(b => [b.x + b.width / 2, b.y + b.height / 2])({box_of})"));
    [0, 1].map(|i| place[i].as_f64().unwrap())
}

fn every_reference_figure_opens_without_a_word_from_the_console() {
    let mut browser = Browser::start(800, 600);
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../figures");
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.retain(|path| path.extension().is_some_and(|extension| extension == "svg" || extension == "html"));
    files.sort();
    assert!(files.len() >= 5, "{files:?}");
    for path in files {
        browser.open(&path, "");
        // What has a d, points, x or r that is no number has no box.
        let flat = "[...document.querySelectorAll('text, circle, path, line')].filter(e => \
                    !e.closest('.ptr, defs') && e.getBBox().width + e.getBBox().height === 0).map(e => e.outerHTML)";
        assert_eq!(browser.eval(flat), json!([]), "{}", path.display());
        assert_eq!(browser.eval("document.querySelectorAll('parsererror').length"), 0, "{}", path.display());
        let complaints = browser.complaints();
        assert!(complaints.is_empty(), "{}: {complaints:?}", path.display());
    }
}

fn mouse_focus_and_address_show_the_pointers_of_one_half_edge() {
    let file = picture();
    let mut browser = Browser::start(1700, 1700);
    browser.open(&file.path, "");
    assert_eq!(browser.eval(SHOWN), json!([]));
    for id in ["lab-h3", "lab-h12"] {
        let place = on_shaft(&mut browser, id);
        browser.hover(place);
        assert_eq!(browser.eval(SHOWN), json!([id]), "hover");
    }
    browser.hover([2.0, 2.0]);
    for id in ["lab-h0", "lab-h1", "lab-h2"] {
        browser.press("Tab");
        assert_eq!(browser.eval(SHOWN), json!([id]), "focus");
    }
    let order = "[...document.querySelectorAll('[tabindex]')].map(e => e.id)";
    let half_edges: Vec<String> = (0..14).map(|i| format!("lab-h{i}")).collect();
    assert_eq!(browser.eval(order), json!(half_edges));
    browser.open(&file.path, "lab-h5");
    assert_eq!(browser.eval(SHOWN), json!(["lab-h5"]), "address");
    let stroke = "getComputedStyle(document.querySelector('#lab-h5 .sh')).stroke";
    browser.media("screen", "prefers-color-scheme", "light");
    let light = browser.eval(stroke);
    browser.media("screen", "prefers-color-scheme", "dark");
    assert_ne!(browser.eval(stroke), light, "dark mode has colours of its own");
    assert!(browser.complaints().is_empty(), "{:?}", browser.complaints());
}

fn screen_readers_hear_every_half_edge() {
    let file = picture();
    let mut browser = Browser::start(800, 600);
    browser.open(&file.path, "");
    let tree = browser.call("Accessibility.getFullAXTree", &json!({}));
    let nodes = tree["nodes"].as_array().unwrap();
    let name = |node: &Value| node["name"]["value"].as_str().unwrap_or("").to_owned();
    let named = |role: &str| nodes.iter().filter(|node| node["role"]["value"] == role).map(name).collect::<Vec<_>>();
    let images = named("image");
    let heard: Vec<&String> = images.iter().filter(|name| name.starts_with('h')).collect();
    assert_eq!(heard.len(), 14, "{images:?}");
    let lab = lab();
    let h = dcel_kit::HalfEdgeId::new(4);
    let words = format!(
        "h4: {} to {}, face {}, twin h5, next {}, prev {}",
        lab.origin(h),
        lab.destination(h),
        lab.face(h),
        lab.next(h),
        lab.prev(h)
    );
    assert!(images.contains(&words), "{words} is not among {images:?}");
    assert_eq!(
        spoken(nodes, "group", "Lab"),
        lab_words(" A half-edge under the mouse or in focus shows its pointers.")
    );
}

/// What screen readers say after the name of the element of this role.
fn spoken(nodes: &[Value], role: &str, name: &str) -> String {
    let found: Vec<&Value> =
        nodes.iter().filter(|node| node["role"]["value"] == role && node["name"]["value"] == name).collect();
    assert_eq!(found.len(), 1, "{role} {name:?}: {found:?}");
    found[0]["description"]["value"].as_str().unwrap_or("").to_owned()
}

fn lab_words(end: &str) -> String {
    format!(
        "6 vertices, 7 edges, 14 half-edges, 3 faces. Each half-edge runs on the left of its edge; its one-sided barb \
         points to its face.{end}"
    )
}

fn a_picture_is_one_image_with_a_name_and_a_description() {
    let file = File::new("lab.svg", &figure::structure(&lab(), &FigureOptions::new("Lab")).unwrap().to_svg());
    let mut browser = Browser::start(800, 600);
    browser.open(&file.path, "");
    let tree = browser.call("Accessibility.getFullAXTree", &json!({}));
    let nodes = tree["nodes"].as_array().unwrap();
    assert_eq!(spoken(nodes, "image", "Lab"), lab_words(""));
    let heard = nodes.iter().filter(|node| node["ignored"] == false && node["role"]["value"] == "image").count();
    assert_eq!(heard, 1, "the parts of a still picture are not read one by one");
    assert_eq!(browser.eval("document.querySelectorAll('[tabindex], a').length"), 0, "nothing to tab to");
}

fn the_keyboard_goes_there_and_back_and_focus_is_seen() {
    let file = picture();
    let mut browser = Browser::start(1000, 800);
    browser.open(&file.path, "");
    let focused = "document.activeElement.id";
    let width = "parseFloat(getComputedStyle(document.querySelector('#lab-h1 .sh')).strokeWidth)";
    let thin = browser.eval(width).as_f64().unwrap();
    for id in ["lab-h0", "lab-h1"] {
        browser.press("Tab");
        assert_eq!(browser.eval(focused), json!(id));
    }
    assert!(browser.eval(width).as_f64().unwrap() > 1.5 * thin, "the half-edge in focus is bold");
    for kind in ["keyDown", "keyUp"] {
        let shift = json!({"type": kind, "key": "Tab", "windowsVirtualKeyCode": 9, "modifiers": 8});
        browser.call("Input.dispatchKeyEvent", &shift);
    }
    assert_eq!(browser.eval(focused), json!("lab-h0"), "and back");
    assert!(browser.eval(width).as_f64().unwrap() < 1.1 * thin);
}

/// The ids of the frames of a stepper that are seen.
const FRAMES: &str = "[...document.querySelectorAll('.fr')].filter(g => getComputedStyle(g).display !== 'none')\
                      .map(g => g.id)";

fn a_stepper_shows_one_frame_follows_its_links_and_prints_all() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../figures/stepper-split-face.svg");
    let mut browser = Browser::start(900, 700);
    browser.open(&path, "");
    assert_eq!(browser.eval(FRAMES), json!(["steps-step-0"]), "without an address the first");
    for (link, frame) in [("next", 1), ("next", 2), ("next", 3), ("back", 2)] {
        let box_of = format!(
            "[...document.querySelectorAll('a')].filter(a => a.textContent.includes('{link}') && \
             a.getBoundingClientRect().width > 0).map(a => a.getBoundingClientRect())[0]"
        );
        let place = browser.eval(&format!("(b => [b.x + b.width / 2, b.y + b.height / 2])({box_of})"));
        browser.click([0, 1].map(|i| place[i].as_f64().unwrap()));
        let shown = format!("JSON.stringify({FRAMES}) === '[\"steps-step-{frame}\"]'");
        browser.wait_for(&shown);
    }
    browser.open(&path, "steps-step-5");
    assert_eq!(browser.eval(FRAMES), json!(["steps-step-5"]), "by address");
    let frame =
        "(b => [b.left, b.top, b.right, b.bottom])(document.querySelector('.fr:target').getBoundingClientRect())";
    let edges: Vec<f64> = browser.eval(frame).as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
    assert!(edges[0] >= -1.0 && edges[1] >= -1.0 && edges[2] < 900.0 && edges[3] < 700.0, "in the window: {edges:?}");
    browser.media("print", "prefers-color-scheme", "light");
    let all: Vec<String> = (0..7).map(|i| format!("steps-step-{i}")).collect();
    assert_eq!(browser.eval(FRAMES), json!(all), "on paper");
    let links = "[...document.querySelectorAll('.nav')].filter(g => getComputedStyle(g).display !== 'none').length";
    assert_eq!(browser.eval(links), 0, "no links on paper");
    assert!(browser.complaints().is_empty(), "{:?}", browser.complaints());
}

fn a_printed_page_has_no_buttons_and_whole_tables() {
    let file = page();
    let mut browser = Browser::start(1400, 900);
    browser.open(&file.path, "lab-h4");
    let seen = |selector: &str| {
        format!("[...document.querySelectorAll('{selector}')].filter(e => e.getBoundingClientRect().height > 0).length")
    };
    assert!(browser.eval(&seen("button")).as_u64().unwrap() > 3);
    browser.media("print", "prefers-color-scheme", "light");
    assert_eq!(browser.eval(&seen("button, input")), 0);
    let cut = "[...document.querySelectorAll('.rows')].filter(e => e.scrollHeight > e.clientHeight + 1).length";
    assert_eq!(browser.eval(cut), 0, "no table ends at the border of its box");
    assert_eq!(browser.eval(&seen("tbody tr")), 14 + 6 + 3);
    assert_eq!(browser.eval("getComputedStyle(document.documentElement).backgroundColor"), "rgb(255, 255, 255)");
}

/// In the dark every figure has dark paper, and no line or letter keeps its light colour, but for those that a file of
/// colours names one by one. The tints of areas are the same hues, thicker.
fn dark_mode_changes_paper_ink_and_lines_of_every_reference_figure() {
    let mut browser = Browser::start(800, 600);
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../figures");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "svg") {
            continue;
        }
        browser.open(&path, "");
        let colours = "(() => { const rules = [...document.querySelectorAll('style')].map(s => s.textContent).join(' '); \
                       const own = e => { const g = e.closest('g[id]'); return g && rules.includes('#' + g.id + ' .' + e.getAttribute('class') + '{fill'); }; \
                       return [...new Set([...document.querySelectorAll('rect.bg, text, line, path, circle')].filter(e => \
                       !e.matches('.hit, [fill^=url]') && !own(e) && !/\\bt[0-9]\\b/.test(e.getAttribute('class')) && !e.closest('defs')).map(e => {\
                       const s = getComputedStyle(e); const k = e.getAttribute('class'); \
                       return [k, ...(e.tagName === 'text' ? [s.fill] : [s.fill, s.stroke])].join(' ') }))] })()";
        browser.media("screen", "prefers-color-scheme", "light");
        let light = browser.eval(colours);
        browser.media("screen", "prefers-color-scheme", "dark");
        let dark = browser.eval(colours);
        let dark: Vec<&Value> = dark.as_array().unwrap().iter().collect();
        let kept: Vec<&Value> = light.as_array().unwrap().iter().filter(|colour| dark.contains(colour)).collect();
        assert!(kept.is_empty(), "{}: the same in light and dark: {kept:?}", path.display());
        count += 1;
    }
    assert!(count >= 10, "{count}");
}

/// A page of 830 px shrinks what is wider: no letter may end up below 9 px there.
fn every_letter_of_a_reference_figure_can_be_read_on_a_page_of_830_px() {
    let mut browser = Browser::start(830, 600);
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../figures");
    let mut letters = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "svg") {
            continue;
        }
        browser.open(&path, "");
        let small = "(() => { const shrunk = Math.min(1, 830 / document.documentElement.width.baseVal.value); \
                     const sizes = [...document.querySelectorAll('text, tspan')].filter(t => [...t.childNodes].some(\
                     n => n.nodeType === 3 && n.data.trim())).map(t => [t.textContent.trim(), \
                     shrunk * parseFloat(getComputedStyle(t).fontSize)]); \
                     return [sizes.length, sizes.filter(s => s[1] < 8.995)]; })()";
        let found = browser.eval(small);
        assert_eq!(found[1], json!([]), "{}", path.display());
        letters += found[0].as_u64().unwrap();
    }
    assert!(letters > 1500, "{letters}");
}

/// What a telephone shows: no letter under 9 px, none cut off, none over another one.
fn figures_for_400_px_can_be_read_there() {
    let script = |name: &str| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../figures/scripts").join(name);
        Script::parse(&std::fs::read_to_string(path).unwrap(), name).unwrap()
    };
    let ship = script("lab-04-drawing.dcels").run().end;
    let options = FigureOptions::new("Narrow").width(400.0).columns(1);
    let cut = script("split-in-half.dcels");
    let film = Film::of_script(&cut);
    let slip = film.beside(&["h8.next".parse().unwrap()]).unwrap();
    let h = dcel_kit::HalfEdgeId::new(2);
    let drawings = [
        ("structure", figure::structure(&lab(), &options)),
        ("many half-edges", figure::structure(&ship, &options)),
        ("tables", figure::tables(&lab(), Some(h.into()), &options)),
        ("focus", figure::focus(&lab(), h, &options)),
        ("pointers", figure::pointers(&lab(), &[figure::Pointers::Next, figure::Pointers::Twin], &options)),
        ("dual", figure::dual(&ship, &options).map_err(|error| panic!("{error}"))),
        ("film", film.strip(&options)),
        ("a slip", slip.strip(&options.clone().width(190.0))),
    ];
    let mut browser = Browser::start(400, 800);
    let (mut letters, mut open) = (0, |name: &str, file: &Path, fits: bool| -> u64 {
        browser.open(file, "");
        let found = browser.eval(
            "(() => { const shown = t => t.textContent.trim() && getComputedStyle(t).visibility !== 'hidden' \
             && t.getBoundingClientRect().width > 0; \
             const texts = [...document.querySelectorAll('svg text')].filter(shown); \
             const boxes = texts.map(t => { const b = t.getBoundingClientRect(); \
               return { word: t.textContent.trim(), x: [b.left + 1, b.right - 1], y: [b.top + b.height * .22, b.bottom - b.height * .22], \
               size: parseFloat(getComputedStyle(t).fontSize) * t.getScreenCTM().a }; }); \
             const meet = (a, b) => a.x[0] < b.x[1] && b.x[0] < a.x[1] && a.y[0] < b.y[1] && b.y[0] < a.y[1]; \
             const over = boxes.flatMap((a, i) => boxes.slice(0, i).filter(b => meet(a, b)).map(b => [a.word, b.word])); \
             return { count: boxes.length, over, small: boxes.filter(b => b.size < 8.99).map(b => [b.word, b.size]), \
               outside: boxes.filter(b => b.x[0] < -1.5 || b.x[1] > 401.5).map(b => b.word), \
               wide: document.documentElement.scrollWidth }; })()",
        );
        assert_eq!(found["over"], json!([]), "{name}: names over each other");
        assert_eq!(found["small"], json!([]), "{name}: small letters");
        if fits {
            assert_eq!(found["outside"], json!([]), "{name}: words cut off");
            assert!(found["wide"].as_f64().unwrap() <= 400.0, "{name} is {} px wide", found["wide"]);
        }
        found["count"].as_u64().unwrap()
    });
    for (name, figure) in drawings {
        let figure = figure.unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(figure.size().0 <= 400.0, "{name} is {} px wide", figure.size().0);
        letters += open(name, &File::new("narrow.svg", &figure.to_svg()).path, true);
    }
    letters += open("player", &File::new("film.html", &film.page(&FigureOptions::new("F")).unwrap()).path, false);
    assert!(letters > 300, "{letters}");
}

fn the_page_follows_clicks_keys_and_the_search() {
    let (file, lab) = (page(), lab());
    let mut browser = Browser::start(1400, 1200);
    browser.open(&file.path, "");
    let on = "[...document.querySelectorAll('.on')].map(e => e.id)";
    let pair = |id: &str| json!([format!("lab-{id}"), format!("lab-row-{id}")]);
    browser.eval("document.querySelector('#lab-row-h4 td:last-child').click()");
    assert_eq!(browser.eval(on), pair("h4"), "click on a row");
    assert_eq!(browser.eval(SHOWN), json!(["lab-h4"]));
    let place = on_shaft(&mut browser, "lab-h7");
    browser.hover(place);
    browser.click(place);
    assert_eq!(browser.eval(on), pair("h7"), "click in the picture");
    browser.hover([2.0, 2.0]);

    let mut h = dcel_kit::HalfEdgeId::new(7);
    for (key, name) in [("n", "next"), ("n", "next"), ("t", "twin"), ("p", "prev")] {
        h = match name {
            "next" => lab.next(h),
            "prev" => lab.prev(h),
            _ => lab.twin(h),
        };
        browser.press(key);
        assert_eq!(browser.eval(on), pair(&h.to_string()), "key {key}");
    }
    h = lab.next(h);
    browser.eval("document.getElementById('lab-page-next').click()");
    assert_eq!(browser.eval(on), pair(&h.to_string()), "button");
    browser.eval("document.querySelector('#lab-page-state a').click()");
    assert_eq!(browser.eval(on), pair(&lab.origin(h).to_string()), "link in the panel");
    browser.press("n");
    let message = "document.getElementById('lab-page-message').textContent";
    let said = browser.eval(message);
    assert!(said.as_str().unwrap().contains("has no next"), "{said}");

    browser.press("/");
    browser.insert("F1");
    browser.press("Enter");
    assert_eq!(browser.eval(on), pair("f1"), "search");
    browser.eval("document.getElementById('lab-page-query').value = ''");
    browser.insert("h99");
    browser.press("Enter");
    let said = browser.eval(message);
    assert!(said.as_str().unwrap().contains("There is no h99"), "{said}");
    assert_eq!(browser.eval(on), pair("f1"), "an unknown name changes nothing");
    assert!(browser.complaints().is_empty(), "{:?}", browser.complaints());
}

fn the_page_has_few_tab_stops_and_arrow_keys_lead_on_from_each() {
    let (file, lab) = (page(), lab());
    let mut browser = Browser::start(1200, 1000);
    browser.open(&file.path, "");
    let stops = browser.eval("[...document.querySelectorAll('a, button, input, [tabindex]')].filter(e => e.tabIndex >= 0 && !e.disabled).length");
    let stops = stops.as_u64().unwrap();
    assert!((4..=14).contains(&stops), "{stops} stops of the tab key");

    let on = "document.querySelector('.he.on')?.id";
    let focus = "document.activeElement.id || document.activeElement.textContent";
    browser.eval("document.getElementById('lab-h0').focus()");
    let mut h = dcel_kit::HalfEdgeId::new(0);
    for (key, to) in [("ArrowRight", 0), ("ArrowRight", 0), ("ArrowUp", 1), ("ArrowLeft", 2), ("ArrowDown", 1)] {
        h = [lab.next(h), lab.twin(h), lab.prev(h)][to];
        browser.press(key);
        assert_eq!(browser.eval(on), json!(format!("lab-{h}")), "{key}");
        assert_eq!(browser.eval(focus), json!(format!("lab-{h}")), "{key} takes the focus along");
    }
    let one = "document.querySelectorAll('#lab [tabindex=\"0\"]').length";
    assert_eq!(browser.eval(one), 1, "the tab key comes back to where one was");

    // In the table of half-edges: from the first name one row down, two cells on.
    browser.eval("document.querySelector('#lab-row-h0 a').focus()");
    for key in ["ArrowDown", "ArrowRight", "ArrowRight"] {
        browser.press(key);
    }
    let cell = dcel_kit::HalfEdgeId::new(1);
    assert_eq!(browser.eval("document.activeElement.textContent"), json!(lab.destination(cell).to_string()));
    assert_eq!(browser.eval("document.activeElement.closest('tr').dataset.id"), "h1");
    browser.press("End");
    assert_eq!(browser.eval("document.activeElement.closest('tr').matches(':last-child')"), true);
    assert!(browser.complaints().is_empty(), "{:?}", browser.complaints());
}

fn no_column_of_the_page_is_cut_and_its_picture_can_be_read_on_a_phone() {
    let file = page();
    for width in [1440, 1200, 1152, 1000, 768, 400] {
        let mut browser = Browser::start(width, 900);
        browser.open(&file.path, "");
        let cut = browser.eval("[...document.querySelectorAll('.rows')].filter(e => e.scrollWidth > e.clientWidth).map(e => e.getAttribute('aria-label'))");
        assert_eq!(cut, json!([]), "cut at {width} px");
        assert_eq!(
            browser.eval("document.documentElement.scrollWidth"),
            width,
            "the page itself does not scroll sideways"
        );
        let letters = browser.eval(
            "Math.min(...[...document.querySelectorAll('#lab text')].map(e => \
             parseFloat(getComputedStyle(e).fontSize) * e.getScreenCTM().a))",
        );
        let letters = letters.as_f64().unwrap();
        assert!(letters >= 8.99, "letters of {letters} px at {width} px");
    }
}

fn the_page_walks_round_a_face_and_round_a_vertex() {
    let (file, lab) = (page(), lab());
    let mut browser = Browser::start(1400, 1200);
    let trail = "document.getElementById('lab-page-trail').textContent";
    let seen = "[...document.querySelectorAll('tr.seen')].map(e => e.dataset.id).sort()";
    let sorted = |ids: &mut dyn Iterator<Item = dcel_kit::HalfEdgeId>| {
        let mut names: Vec<String> = ids.map(|h| h.to_string()).collect();
        names.sort();
        json!(names)
    };
    browser.media("screen", "prefers-reduced-motion", "reduce");
    browser.open(&file.path, "lab-v1");
    let v = dcel_kit::VertexId::new(1);
    browser.press("s");
    assert_eq!(browser.eval(seen), sorted(&mut lab.outgoing_half_edges(v)), "at once, without motion");
    let said = browser.eval(trail);
    assert!(said.as_str().unwrap().contains(&format!("again: {} half-edge", lab.outgoing_half_edges(v).count())));

    browser.media("screen", "prefers-reduced-motion", "no-preference");
    browser.open(&file.path, "lab-f1");
    let f = dcel_kit::FaceId::new(1);
    browser.press("f");
    assert_eq!(browser.eval(&format!("{seen}.length")), 1, "step by step");
    browser.wait_for("document.getElementById('lab-page-stop').disabled");
    assert_eq!(browser.eval(seen), sorted(&mut lab.incident_half_edges(f)));
    browser.press("f");
    browser.press("Escape");
    std::thread::sleep(std::time::Duration::from_millis(900));
    assert_eq!(browser.eval(&format!("{seen}.length")), 1, "stopped");
    assert!(browser.complaints().is_empty(), "{:?}", browser.complaints());
}

fn without_scripts_the_page_is_picture_and_tables() {
    let file = page();
    let mut browser = Browser::start(1400, 1200);
    browser.scripts(false);
    browser.open(&file.path, "lab-h6");
    // Before styles are asked for: for that the inspector loads the file once more by itself, and Chromium may refuse it.
    assert!(browser.complaints().is_empty(), "{:?}", browser.complaints());
    let shown = |browser: &mut Browser, selector: &str| {
        let document = browser.call("DOM.getDocument", &json!({"depth": 0}))["root"]["nodeId"].clone();
        let query = json!({"nodeId": document, "selector": selector});
        let node = browser.call("DOM.querySelector", &query)["nodeId"].clone();
        browser.call("DOM.enable", &json!({}));
        browser.call("CSS.enable", &json!({}));
        let styles = browser.call("CSS.getComputedStyleForNode", &json!({"nodeId": node}));
        let styles = styles["computedStyle"].as_array().unwrap();
        styles.iter().find(|style| style["name"] == "display").unwrap()["value"] != "none"
    };
    for (selector, expected) in [
        (".panel", false),
        ("#lab-row-h6", true),
        ("#lab svg, #lab", true),
        ("#lab-h6 .ptr", true),
        ("#lab-h5 .ptr", false),
    ] {
        assert_eq!(shown(&mut browser, selector), expected, "{selector}");
    }
}

fn names_of_the_caller_stay_text() {
    let evil = "</style></title></script><script>console.error('run')</script><b>\"&";
    let options = FigureOptions::new(evil).id_prefix("x").face_name(dcel_kit::FaceId::new(1), evil);
    let file = File::new("evil.html", figure::page(&lab(), &options).unwrap().to_html());
    let mut browser = Browser::start(800, 600);
    browser.open(&file.path, "x-f1");
    assert!(browser.complaints().is_empty(), "{:?}", browser.complaints());
    assert_eq!(browser.eval("document.title"), evil);
    assert_eq!(browser.eval("document.querySelectorAll('script').length"), 1);
    assert_eq!(browser.eval("document.querySelector('#x-row-f1').dataset.name"), evil);
}

trials! {
    every_reference_figure_opens_without_a_word_from_the_console: Chromium;
    mouse_focus_and_address_show_the_pointers_of_one_half_edge: Chromium;
    screen_readers_hear_every_half_edge: Chromium;
    a_picture_is_one_image_with_a_name_and_a_description: Chromium;
    the_keyboard_goes_there_and_back_and_focus_is_seen: Chromium;
    a_stepper_shows_one_frame_follows_its_links_and_prints_all: Chromium;
    a_printed_page_has_no_buttons_and_whole_tables: Chromium;
    dark_mode_changes_paper_ink_and_lines_of_every_reference_figure: Chromium;
    every_letter_of_a_reference_figure_can_be_read_on_a_page_of_830_px: Chromium;
    figures_for_400_px_can_be_read_there: Chromium;
    the_page_follows_clicks_keys_and_the_search: Chromium;
    the_page_has_few_tab_stops_and_arrow_keys_lead_on_from_each: Chromium;
    no_column_of_the_page_is_cut_and_its_picture_can_be_read_on_a_phone: Chromium;
    the_page_walks_round_a_face_and_round_a_vertex: Chromium;
    without_scripts_the_page_is_picture_and_tables: Chromium;
    names_of_the_caller_stay_text: Chromium;
}

fn main() {
    trials::run(trials().into_iter().chain(latex::trials()).collect())
}
