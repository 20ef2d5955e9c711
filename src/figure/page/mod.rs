//! A page: the picture, a table for each kind of element, and a panel to walk with.
//!
//! ```text
//!   ┌──────────────┬───────────────────────────┐
//!   │              │ h5 half-edge, origin v3 … │   panel: only where scripts run
//!   │   picture    │ [next] [prev] [twin] …    │
//!   │ (sticks)     ├───────────────────────────┤
//!   │              │ h4 │ v2 │ h5 │ h9 │ …     │   tables: the structure itself
//!   │              │ h5 │ v3 │ h4 │ …         │   row selected = element highlighted
//!   └──────────────┴───────────────────────────┘
//! ```
//!
//! One file, nothing from the network. Without scripts it is the picture and the tables; every name in a table
//! is a link to the element in the picture, which then shows its pointers. The script reads the structure
//! from the tables and needs nothing else. The bytes depend on the input alone.

use crate::figure::canvas::number;
use crate::figure::canvas::scene::Node;
use crate::figure::structure;
use crate::figure::structure::skeleton::{destination, faces, half_edges, vertices};
use crate::figure::{Detail, Figure, FigureError, FigureOptions};
use crate::ids::{Element, FaceId, HalfEdgeId, Id, VertexId};
use crate::plane::PlanarView;
use std::collections::BTreeSet;
use std::fmt::{Display, Write};

/// A table has no more rows than this.
const ROWS: usize = 1000;
/// A picture is never shown at less than this part of its width on a narrow screen: some of its letters are as small as can be.
const LEAST: f64 = 1.0;
const CSS: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

/// A self-contained HTML page, see [`page()`].
#[derive(Clone, Debug)]
pub struct Page {
    figure: Figure,
    html: String,
}

impl Page {
    /// The HTML document, with a line break at its end. The same structure always gives the same bytes.
    #[must_use]
    pub fn to_html(&self) -> &str {
        &self.html
    }

    /// The picture in the page.
    #[must_use]
    pub fn figure(&self) -> &Figure {
        &self.figure
    }
}

/// Draws a structure as a page: the interactive picture, tables of half-edges, vertices and faces, and a panel
/// that walks from half-edge to half-edge by `next`, `prev` and `twin`, round a face and round a vertex.
///
/// Each table shows at most 1000 rows and says how many there are. Where the picture is too small to show
/// single half-edges, the page says so.
///
/// Cost: that of [`structure`](structure()).
///
/// # Errors
/// Those of [`structure`](structure()).
pub fn page(view: &dyn PlanarView, options: &FigureOptions) -> Result<Page, FigureError> {
    let options = options.clone().interactive(true);
    let figure = structure(view, &options)?;
    let drawn = figure.scene.nodes.iter().filter_map(|node| match node {
        Node::Group(group) => group.id.clone(),
        _ => None,
    });
    let listed = names(half_edges(view)).chain(names(vertices(view))).chain(names(faces(view)));
    let tables =
        Tables { view, options: &options, prefix: options.prefix(), drawn: drawn.collect(), listed: listed.collect() };
    let html = tables.document(&figure);
    Ok(Page { figure, html })
}

/// The names of the elements that a table shows.
fn names<'a, I: Id + 'a>(ids: impl Iterator<Item = I> + 'a) -> impl Iterator<Item = String> + 'a {
    ids.take(ROWS).map(|id| id.to_string())
}

struct Tables<'a> {
    view: &'a dyn PlanarView,
    options: &'a FigureOptions,
    prefix: String,
    /// What the picture shows one by one.
    drawn: BTreeSet<String>,
    /// What the tables show.
    listed: BTreeSet<String>,
}

/// A cell: the name of the pointer, and where it leads.
type Cell = (&'static str, Vec<Target>);

/// What a pointer leads to.
struct Target {
    name: String,
    /// The id of what shows it in this page, if something does.
    place: Option<String>,
}

impl Tables<'_> {
    fn document(&self, figure: &Figure) -> String {
        let prefix = &self.prefix;
        let title = escaped(&self.options.title);
        // On a narrow screen the picture keeps its size, so that its letters can be read, and its box scrolls.
        let least = number::drawn(LEAST * figure.size().0);
        let css = CSS.replace("#FIG", &format!("#{prefix}")).replace("LEAST", &least);
        let svg = figure.to_svg();
        let notes = self.notes(figure);
        let tables = [self.half_edge_table(), self.vertex_table(), self.face_table()].concat();
        let panel = self.panel();
        format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <meta name=\"color-scheme\" content=\"light dark\">\n<title>{title}</title>\n<style>\n{css}</style>\n\
             </head>\n<body data-figure=\"{prefix}\">\n\
             <a class=\"skip\" href=\"#{prefix}-page-tables\">To the tables</a>\n<h1>{title}</h1>\n{notes}<main>\n\
             <figure>\n{svg}</figure>\n<div>\n{panel}<div id=\"{prefix}-page-tables\" tabindex=\"-1\">\n{tables}</div>\n\
             </div>\n</main>\n<script>\n{SCRIPT}</script>\n</body>\n</html>\n"
        )
    }

    /// What the picture leaves out.
    fn notes(&self, figure: &Figure) -> String {
        let level = match figure.detail() {
            Detail::Full | Detail::Arrows => None,
            Detail::Edges => Some("The edges are too short here to show their half-edges: see the tables."),
            Detail::Tiles => {
                Some("The edges are too short here to show single half-edges and vertices: see the tables.")
            }
        };
        let paragraph = |text: &str| format!("<p class=\"notes\">{}</p>\n", escaped(text));
        level.into_iter().chain(figure.notes().iter().map(String::as_str)).map(paragraph).collect()
    }

    fn panel(&self) -> String {
        let id = |name: &str| format!("{}-page-{name}", self.prefix);
        let button = |name: &str, text: &str, key: &str| {
            let id = id(name);
            format!("<button type=\"button\" id=\"{id}\">{text} <kbd>{key}</kbd></button>\n")
        };
        let buttons = [
            button("prev", "prev", "p"),
            button("next", "next", "n"),
            button("twin", "twin", "t"),
            button("face", "walk the face", "f"),
            button("star", "walk round the vertex", "s"),
            button("stop", "stop", "Esc"),
        ]
        .concat();
        let (state, trail, form, query, message) = (id("state"), id("trail"), id("search"), id("query"), id("message"));
        format!(
            "<section class=\"panel\" aria-label=\"Walk\">\n\
             <p class=\"state\" id=\"{state}\" aria-live=\"polite\">Click an element in the picture or in a table, or go there with the tab and arrow keys.</p>\n\
             <div class=\"bar\">\n{buttons}</div>\n<form class=\"bar\" id=\"{form}\">\n\
             <label for=\"{query}\">Go to</label>\n\
             <input id=\"{query}\" autocomplete=\"off\" spellcheck=\"false\" placeholder=\"h0, v0, f0\">\n\
             <button type=\"submit\">show</button> <kbd>/</kbd>\n</form>\n\
             <p id=\"{message}\" role=\"status\"></p>\n<p class=\"trail\" id=\"{trail}\"></p>\n</section>\n"
        )
    }

    fn half_edge_table(&self) -> String {
        let row = |h: HalfEdgeId| {
            let cells = vec![
                ("origin", self.pointer(self.view.origin(h))),
                ("destination", self.pointer(destination(self.view, h))),
                ("twin", self.pointer(self.view.twin(h))),
                ("next", self.pointer(self.view.next(h))),
                ("prev", self.pointer(self.view.prev(h))),
                ("face", self.pointer(self.view.face(h))),
            ];
            self.row(&self.target(h), None, &cells, "")
        };
        let columns = ["origin", "destination", "twin", "next", "prev", "face"];
        self.table("Half-edges", "half-edge", &columns, half_edges(self.view), row)
    }

    fn vertex_table(&self) -> String {
        let row = |v: VertexId| {
            let cells = [("outgoing", self.pointer(self.view.outgoing(v)))];
            let number = |x: Option<f64>| x.map_or_else(|| "none".to_owned(), number::model);
            let position = self.view.position(v);
            let (x, y) = (number(position.map(|p| p.x)), number(position.map(|p| p.y)));
            self.row(&self.target(v), None, &cells, &format!("<td>{x}</td><td>{y}</td>"))
        };
        self.table("Vertices", "vertex", &["outgoing", "x", "y"], vertices(self.view), row)
    }

    fn face_table(&self) -> String {
        let row = |f: FaceId| {
            let rings = self.view.inner_components(f).iter().map(|&ring| self.target(Element::from(ring)));
            let cells = [("boundary", self.pointer(self.view.half_edge(f))), ("rings", rings.collect())];
            let name = self.options.name(f);
            let outer = self.view.outer_face() == Some(f);
            let kind = if outer { "outer face" } else { ["face", "hole"][usize::from(self.view.is_hole(f))] };
            let rest = format!("<td>{kind}</td><td>{}</td>", escaped(name.unwrap_or("")));
            self.row(&self.target(f), name, &cells, &rest)
        };
        self.table("Faces", "face", &["half-edge", "inner components", "kind", "name"], faces(self.view), row)
    }

    fn table<I: Id>(
        &self,
        title: &str,
        first: &str,
        columns: &[&str],
        ids: impl Iterator<Item = I>,
        row: impl Fn(I) -> String,
    ) -> String {
        let mut ids = ids.fuse();
        let rows: Vec<String> = ids.by_ref().take(ROWS).map(row).collect();
        let (count, rows) = (rows.len() + ids.count(), rows.concat());
        if count == 0 {
            return format!("<h2>{title} (0)</h2>\n");
        }
        let shown = if count > ROWS { format!("<p>The first {ROWS} of {count}.</p>\n") } else { String::new() };
        let head: String = columns.iter().map(|column| format!("<th scope=\"col\">{column}</th>")).collect();
        format!(
            "<h2>{title} ({count})</h2>\n{shown}<div class=\"rows\" role=\"region\" aria-label=\"{title}\" \
             tabindex=\"0\">\n<table>\n<thead><tr><th scope=\"col\">{first}</th>{head}</tr></thead>\n<tbody>\n\
             {rows}</tbody>\n</table>\n</div>\n"
        )
    }

    fn row(&self, element: &Target, name: Option<&str>, cells: &[Cell], rest: &str) -> String {
        let id = &element.name;
        let mut out = format!("<tr id=\"{}-row-{id}\" data-id=\"{id}\"", self.prefix);
        if let Some(name) = name {
            let _ = write!(out, " data-name=\"{}\"", escaped(name));
        }
        let _ = write!(out, "><th scope=\"row\">{}</th>", element.html());
        for (pointer, targets) in cells {
            let _ = write!(out, "<td data-pointer=\"{pointer}\"");
            if targets.is_empty() {
                out.push_str(">none</td>");
                continue;
            }
            let names: Vec<&str> = targets.iter().map(|target| target.name.as_str()).collect();
            let links: Vec<String> = targets.iter().map(Target::html).collect();
            let _ = write!(out, " data-to=\"{}\">{}</td>", names.join(" "), links.join(" "));
        }
        out.push_str(rest);
        out.push_str("</tr>\n");
        out
    }

    /// The element in the picture, else its row.
    fn target(&self, id: impl Display) -> Target {
        let (name, prefix) = (id.to_string(), &self.prefix);
        let place = if self.drawn.contains(&name) {
            Some(format!("{prefix}-{name}"))
        } else {
            self.listed.contains(&name).then(|| format!("{prefix}-row-{name}"))
        };
        Target { name, place }
    }

    fn pointer(&self, id: Option<impl Id>) -> Vec<Target> {
        id.into_iter().map(|id| self.target(id)).collect()
    }
}

impl Target {
    fn html(&self) -> String {
        match &self.place {
            Some(place) => format!("<a href=\"#{place}\">{}</a>", self.name),
            None => self.name.clone(),
        }
    }
}

/// The text with the characters that HTML reserves as entities.
#[must_use]
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
