//! Interactive figures and pages, read as text: names, references, rows, limits. What they do is seen in
//! `browser.rs`.

use dcel_kit::figure::{self, Detail, FigureOptions};
use dcel_kit::plane::{PlanarView, Subdivision};
use dcel_kit::topology::{Dcel, Table};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use roxmltree::{Document, Node};
use std::collections::BTreeSet;

fn lab() -> Subdivision {
    let mut lab = Subdivision::lab_rectangle();
    lab.split_face(HalfEdgeId::new(2), HalfEdgeId::new(8)).unwrap();
    lab
}

fn interactive(view: &impl PlanarView) -> String {
    figure::structure(view, &FigureOptions::new("Lab").interactive(true)).unwrap().to_svg()
}

fn class<'a>(node: Node<'a, '_>) -> &'a str {
    node.attribute("class").unwrap_or("")
}

fn half_edges<'a>(document: &'a Document<'a>) -> Vec<Node<'a, 'a>> {
    document.descendants().filter(|node| class(*node) == "he").collect()
}

fn start_of(path: &str) -> [f64; 2] {
    let apart = path.replace('-', " -");
    let words = apart.split(|c: char| !(c.is_ascii_digit() || c == '.' || c == '-'));
    let mut numbers = words.filter(|word| !word.is_empty());
    [(); 2].map(|()| numbers.next().unwrap().parse().unwrap())
}

#[test]
fn every_half_edge_hides_its_own_next_twin_origin_and_face() {
    let svg = interactive(&lab());
    let document = Document::parse(&svg).unwrap();
    let groups = half_edges(&document);
    assert_eq!(groups.len(), 14);
    for (i, group) in groups.iter().enumerate() {
        assert_eq!(group.attribute("id"), Some(format!("lab-h{i}").as_str()), "tab order is the order of the numbers");
        assert_eq!((group.attribute("tabindex"), group.attribute("role")), (Some("0"), Some("img")));
        let pointers = group.children().find(|node| class(*node) == "ptr").unwrap();
        let families: Vec<&str> = pointers.children().filter(Node::is_element).map(class).collect();
        assert_eq!(families, ["next", "twin", "origin", "face-of"], "h{i}");
        // The arrow of prev, then that of next, which begins at the tip of the barb.
        let next: Vec<Node> = pointers.descendants().filter(|node| class(*node) == "pl").take(2).collect();
        let barb = group.children().find(|node| class(*node) == "barb").unwrap();
        let (tip, start) = (start_of(barb.attribute("d").unwrap()), start_of(next[1].attribute("d").unwrap()));
        let apart = (0..2).map(|k| (tip[k] - start[k]).abs()).fold(0.0, f64::max);
        assert!(apart <= 1.01, "h{i}: barb {tip:?}, next {start:?}");
    }
}

#[test]
fn without_room_for_half_edges_nothing_is_interactive() {
    let options = FigureOptions::new("Lab").interactive(true).detail(Detail::Edges);
    let svg = figure::structure(&lab(), &options).unwrap().to_svg();
    assert!(!svg.contains("tabindex") && !svg.contains(".ptr"));
    assert!(svg.contains("role=\"img\""));
}

/// The values of an attribute in a text.
fn values<'a>(text: &'a str, attribute: &str) -> Vec<&'a str> {
    let key = format!(" {attribute}=\"");
    text.split(&key).skip(1).map(|rest| rest.split('"').next().unwrap()).collect()
}

fn check_references(name: &str, text: &str) {
    let mut ids = BTreeSet::new();
    for id in values(text, "id") {
        assert!(ids.insert(id), "{name}: id {id} twice");
    }
    let links = values(text, "href").into_iter().filter_map(|href| href.strip_prefix('#'));
    let paints = text.split("url(#").skip(1).map(|rest| rest.split(')').next().unwrap());
    let spoken = ["aria-labelledby", "aria-describedby", "for"].into_iter().flat_map(|key| values(text, key));
    for id in links.chain(paints).chain(spoken.flat_map(|ids| ids.split(' '))) {
        assert!(ids.contains(id), "{name}: {id} leads nowhere");
    }
}

#[test]
fn no_reference_figure_has_an_id_twice_or_a_reference_to_nothing() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../figures");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "svg" || extension == "html") {
            check_references(&path.display().to_string(), &std::fs::read_to_string(&path).unwrap());
            count += 1;
        }
    }
    assert!(count >= 5, "{count} figures");
}

fn row<'a>(html: &'a str, id: &str) -> &'a str {
    let from = html.find(&format!("<tr id=\"lab-row-{id}\"")).unwrap_or_else(|| panic!("no row of {id}"));
    &html[from..from + html[from..].find("</tr>").unwrap()]
}

#[test]
fn the_tables_of_a_page_say_what_the_structure_says() {
    let lab = lab();
    let page = figure::page(&lab, &FigureOptions::new("Lab").face_name(FaceId::new(1), "a<b")).unwrap();
    let html = page.to_html();
    check_references("lab", html);
    let link = |id: &str| format!("data-to=\"{id}\"><a href=\"#lab-{id}\">{id}</a></td>");
    for h in (0..14).map(HalfEdgeId::new) {
        let row = row(html, &h.to_string());
        for (pointer, to) in [
            ("origin", lab.origin(h).to_string()),
            ("destination", lab.destination(h).to_string()),
            ("twin", lab.twin(h).to_string()),
            ("next", lab.next(h).to_string()),
            ("prev", lab.prev(h).to_string()),
            ("face", lab.face(h).to_string()),
        ] {
            assert!(row.contains(&format!("<td data-pointer=\"{pointer}\" {}", link(&to))), "{h}: {pointer} in {row}");
        }
    }
    for v in (0..6).map(VertexId::new) {
        let (row, p) = (row(html, &v.to_string()), PlanarView::position(&lab, v).unwrap());
        assert!(row.contains(&format!("<td>{}</td><td>{}</td>", p.x, p.y)), "{row}");
    }
    assert!(row(html, "f0").contains("<td>outer face</td>"));
    assert!(row(html, "f1").contains("data-name=\"a&lt;b\"") && row(html, "f1").ends_with("<td>a&lt;b</td>"));
    let again = figure::page(&lab, &FigureOptions::new("Lab").face_name(FaceId::new(1), "a<b")).unwrap();
    assert!(again.to_html() == html, "the same structure gives the same bytes");
    assert!(!html.contains("http://") || html.matches("http://").count() == html.matches("xmlns=\"http://").count());
}

#[test]
fn a_page_of_a_large_structure_says_what_it_leaves_out() {
    let mut table = Table::from_view(&Dcel::polygon(3000).unwrap());
    for (i, vertex) in table.vertices.iter_mut().flatten().enumerate() {
        // On a parabola: convex.
        let x = i as f64;
        vertex.position = Some([x, x * x]);
    }
    table.outer_face = Some(FaceId::new(0));
    let page = figure::page(&table, &FigureOptions::new("Lab")).unwrap();
    let html = page.to_html();
    assert_eq!(page.figure().detail(), Detail::Tiles);
    assert!(html.contains("The edges are too short here to show single half-edges and vertices"));
    assert!(html.contains("<h2>Half-edges (6000)</h2>\n<p>The first 1000 of 6000.</p>"));
    assert_eq!(values(html, "data-id").iter().filter(|id| id.starts_with('h')).count(), 1000);
    check_references("large", html);
    assert!(row(html, "h0").contains("href=\"#lab-row-h1\""), "what the picture does not show is shown by its row");
}

#[test]
fn a_broken_structure_has_a_page_too() {
    let mut table = Table::from_view(&lab());
    for (i, vertex) in table.vertices.iter_mut().flatten().enumerate() {
        vertex.position = Some([(i * i % 7) as f64, i as f64]);
    }
    table.half_edges[4].as_mut().unwrap().next = None;
    table.half_edges[5].as_mut().unwrap().prev = Some(HalfEdgeId::new(77));
    table.half_edges[6].as_mut().unwrap().twin = Some(HalfEdgeId::new(6));
    table.half_edges[7] = None;
    let page = figure::page(&table, &FigureOptions::new("Lab")).unwrap();
    let html = page.to_html();
    check_references("broken", html);
    assert!(row(html, "h4").contains("<td data-pointer=\"next\">none</td>"));
    assert!(row(html, "h5").contains("<td data-pointer=\"prev\" data-to=\"h77\">h77</td>"), "no link to nothing");
    assert!(!html.contains("lab-row-h7\""));
    assert!(!page.figure().notes().is_empty() && html.contains("class=\"notes\""));
}
