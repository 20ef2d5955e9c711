//! The picture of the differences.
//!
//! ```text
//!   ┌───────────────────────────┐   ┌─────────┐
//!   │ ●────────●   grey: agrees │   │  yours  │        what was handed in, as it was read
//!   │ ┆ ❶    ╱     red, dashed: in the reference only
//!   │ ●┄┄┄┄╱   blue, solid: in yours only              ◎╌╌● moved: red ring, thin line, blue disc
//!   └───────────────────────────┘   3 differences, 21 of 24 half-edges agree
//!                                   ❶ edge v5-v6 between ... is missing
//! ```
//!
//! The reference is placed as in any figure; what only the student has is part of the layout, but drawn on top.

use super::answer::{Comparison, Scenery};
use super::pairing::{Places, span};
use super::report::{Difference, Slot, Spot, counted};
use super::{diff_style, yours};
use crate::figure::canvas::scene::{Group, Node, Step};
use crate::figure::canvas::text;
use crate::figure::canvas::vector::{Bounds, Xy, xy};
use crate::figure::layout::crowd::{Crowd, Shape};
use crate::figure::structure::look::{Look, Mark};
use crate::figure::structure::notes::Notes;
use crate::figure::structure::plate::Plate;
use crate::figure::structure::pointer::Pointer;
use crate::figure::structure::pointer_style;
use crate::figure::structure::skeleton::vertices;
use crate::figure::{Detail, Figure, FigureError, FigureOptions};
use crate::ids::{Element, HalfEdgeId, VertexId};
use crate::plane::{PlanarView, Point};
use crate::topology::{HalfEdgeRow, Table, VertexRow, View};

/// So many differences have badges and sentences.
const LISTED: usize = 10;
/// So many differences are drawn.
const DRAWN: usize = 200;
/// Radius of a badge, size of its number.
const BADGE: f64 = 8.5;
const NUMBER: f64 = 10.5;
/// How far beside its edge the number of a half-edge stands.
const BESIDE: f64 = 7.0;
/// Size of the names of half-edges.
const NAME: f64 = 10.0;
/// Text beside the picture: size, distance of lines, width of the column, of its text.
const SIZE: f64 = 12.0;
const LINE: f64 = 16.0;
const COLUMN: f64 = 380.0;
const WORDS: f64 = 330.0;

impl Comparison {
    /// The picture of the differences: what agrees grey, what only the reference has red and dashed, what only the
    /// student has blue; numbered badges lead to the sentences beside it. At most ten have badges.
    ///
    /// # Errors
    /// Those of [`structure`](crate::figure::structure()).
    pub fn figure(&self, options: &FigureOptions) -> Result<Figure, FigureError> {
        let table = match &self.scenery {
            Scenery::Table(table) => table.clone(),
            Scenery::Graph(graph) => super::shape::rebuild(graph),
        };
        let named = matches!(self.scenery, Scenery::Table(_));
        let mut options = options.checked().half_edge_labels(false);
        if !named {
            options = options.vertex_labels(false).face_labels(crate::figure::FaceLabels::Off);
        }
        diff_style::pale(&mut options.style);
        let layout = with_extras(&table, self.drawn());
        let sketch = Plate::new(&layout, &options, false)?;
        let detail = if named { sketch.picture.detail.max(Detail::Edges) } else { Detail::Edges };
        if detail == sketch.picture.detail {
            return Ok(self.on(&table, &sketch));
        }
        let options = options.detail(detail);
        Ok(self.on(&table, &Plate::new(&layout, &options, false)?))
    }

    /// The differences that are drawn.
    fn drawn(&self) -> &[Difference] {
        &self.differences[..self.differences.len().min(DRAWN)]
    }

    /// The finished drawing on a plate of the reference with the student's extras.
    fn on(&self, table: &Table, plate: &Plate<'_, Table>) -> Figure {
        let layout = plate.picture.view;
        let listed = &self.differences[..self.differences.len().min(LISTED)];
        let mut sheet = Sheet {
            plate,
            layout,
            crowd: plate.crowd.clone(),
            notes: Notes::default(),
            under: Vec::new(),
            over: Vec::new(),
        };
        let look = look(table, layout, self.drawn(), plate);
        for difference in self.drawn() {
            sheet.draw(&difference.spot);
        }
        if self.differences.len() > DRAWN {
            sheet.notes.0.push(format!("only the first {DRAWN} differences are drawn"));
        }
        sheet.names(table, listed);
        let over = std::mem::take(&mut sheet.over);
        let badges: Vec<bool> = (1..).zip(listed).map(|(number, difference)| sheet.badge(number, difference)).collect();
        let under = std::mem::take(&mut sheet.under);
        let mut nodes = plate.nodes(layout, &look, under);
        nodes.extend(over);
        nodes.append(&mut sheet.over);
        let mut scene = plate.picture.scene(nodes);
        let left = scene.size.x + 14.0;
        let mut top = 24.0;
        if let Some((sketch, fits)) = &self.student {
            let fit = fits.then_some(&plate.picture.fit);
            let (panel, height) = yours::panel(sketch, fit, xy(left, top), WORDS);
            scene.nodes.push(panel);
            top += height + 16.0;
        }
        let height = self.list(xy(left, top), &badges, &mut scene.nodes);
        scene.size = xy(scene.size.x + COLUMN, scene.size.y.max(height));
        let options = plate.picture.options;
        scene.css.push_str(&pointer_style::css(&options.style, &scene.prefix));
        scene.css.push_str(&diff_style::css(&options.style, &scene.prefix));
        scene.attributes.retain(|(name, _)| *name != "data-figure");
        scene.attributes.insert(0, ("data-figure", "difference".to_owned()));
        scene.description = self.text();
        Figure { scene, detail: plate.picture.detail, notes: sheet.notes.0 }
    }

    /// The sentences and the legend; returns how far down they reach. `badges` says which sentences have one in the picture.
    fn list(&self, at: Xy, badges: &[bool], nodes: &mut Vec<Node>) -> f64 {
        let left = at.x;
        let mut column = Column { left, y: at.y + 10.0, nodes: Vec::new() };
        let count = self.differences.len();
        let heading = if count == 0 { self.verdict() } else { counted(count, "difference", "differences") };
        let agreed = if self.agreed.is_empty() { String::new() } else { format!(", {}", self.agreed) };
        column.line("ct", 0.0, SIZE + 1.5, format!("{heading}{agreed}"));
        column.y += 10.0;
        for (i, difference) in self.differences.iter().take(LISTED).enumerate() {
            let centre = xy(left + BADGE, column.y);
            // What has no place in the picture has no badge there, and so none here.
            if badges.get(i) == Some(&true) {
                column.nodes.extend(badge(centre, i + 1, colour(&difference.spot)));
            } else {
                let number =
                    Node::Text { class: "ct", at: xy(left + 4.0, column.y), size: SIZE, text: (i + 1).to_string() };
                column.nodes.push(number);
            }
            for words in text::wrap(&text::clean(&difference.text), SIZE, false, WORDS, usize::MAX) {
                column.line("cs", 2.0 * BADGE + 10.0, SIZE, words);
            }
            column.y += 8.0;
        }
        if count > LISTED {
            column.line("cs", 2.0 * BADGE + 10.0, SIZE, format!("and {} more", count - LISTED));
        }
        column.y += 10.0;
        for (class, words) in [("agree", "agrees"), ("miss", "in the reference only"), ("extra", "in yours only")] {
            let (from, to) = (xy(left, column.y), xy(left + 44.0, column.y));
            column.nodes.push(marked(class, vec![Node::Line { class: "dl", from, to }]));
            column.line("cs", 56.0, SIZE, words.to_owned());
            column.y += 4.0;
        }
        let bottom = column.y + 10.0;
        nodes.push(Node::Group(Group { class: "list", nodes: column.nodes, ..Group::default() }));
        bottom
    }
}

/// The spot at which a difference is marked: the first of several.
fn place_of(spot: &Spot) -> Option<&Spot> {
    spot.each().first().filter(|spot| **spot != Spot::Nowhere)
}

/// The half-edges of the reference that a sentence names. `your h5` is one of the student.
fn named(sentence: &str) -> Vec<HalfEdgeId> {
    let words: Vec<&str> =
        sentence.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty()).collect();
    let is_his = |i: usize| i > 0 && words[i - 1] == "your" || words.get(i + 1..i + 3) == Some(&["of", "yours"]);
    let id = |(i, word): (usize, &&str)| word.parse::<HalfEdgeId>().ok().filter(|_| !is_his(i));
    words.iter().enumerate().filter_map(id).collect()
}

/// Lines of text below each other.
struct Column {
    left: f64,
    y: f64,
    nodes: Vec<Node>,
}

impl Column {
    fn line(&mut self, class: &'static str, indent: f64, size: f64, text: String) {
        self.nodes.push(Node::Text { class, at: xy(self.left + indent, self.y), size, text });
        self.y += LINE;
    }
}

/// The layout: the reference, with points and lines of the student's that it does not have.
fn with_extras(table: &Table, differences: &[Difference]) -> Table {
    let mut out = table.clone();
    let known: Vec<(VertexId, Point)> = vertices(table).filter_map(|v| Some((v, table.position(v)?))).collect();
    let points: Vec<Point> = known.iter().map(|k| k.1).collect();
    let reach = 1e-6 * span(&points);
    let places = Places::of(&points, reach);
    let vertex = |out: &mut Table, p: Point| {
        if let Some(i) = places.near(p, reach) {
            return known[i as usize].0;
        }
        out.vertices.push(Some(VertexRow { position: Some([p.x, p.y]), outgoing: None }));
        VertexId::new(out.vertices.len() as u32 - 1)
    };
    for spot in differences.iter().flat_map(|difference| difference.spot.each()) {
        match *spot {
            Spot::ExtraVertex(p) | Spot::Moved(_, p) => {
                vertex(&mut out, p);
            }
            Spot::ExtraEdge(ends) => {
                let [a, b] = ends.map(|p| vertex(&mut out, p));
                let first = HalfEdgeId::new(out.half_edges.len() as u32);
                let second = HalfEdgeId::new(first.number() + 1);
                for (origin, twin) in [(a, second), (b, first)] {
                    let (origin, twin) = (Some(origin), Some(twin));
                    out.half_edges.push(Some(HalfEdgeRow { origin, twin, ..HalfEdgeRow::default() }));
                }
            }
            _ => {}
        }
    }
    out
}

/// Everything of the reference that agrees is dimmed; the extras and what is missing are hidden here.
fn look(table: &Table, layout: &Table, differences: &[Difference], plate: &Plate<'_, Table>) -> Look {
    let mut look = Look::default().rest(Mark::Dim);
    (table.vertices.len()..layout.vertices.len()).for_each(|v| look.mark_vertex(VertexId::new(v as u32), Mark::Hidden));
    let extra = table.half_edges.len()..layout.half_edges.len();
    extra.for_each(|h| look.mark_half_edge(HalfEdgeId::new(h as u32), Mark::Hidden));
    let place = |p: Point| plate.picture.fit.place(p);
    for spot in differences.iter().flat_map(|difference| difference.spot.each()) {
        match spot {
            Spot::MissingEdge(ends) => {
                let ends = ends.map(place);
                let is_it = |h: &&HalfEdgeId| {
                    let segment = plate.skeleton().segment(**h);
                    segment.is_some_and(|(a, b)| [a, b] == ends || [b, a] == ends)
                };
                for &h in plate.skeleton().edges.iter().filter(is_it) {
                    look.mark_half_edge(h, Mark::Hidden);
                    layout.twin(h).into_iter().for_each(|t| look.mark_half_edge(t, Mark::Hidden));
                }
            }
            Spot::Pointer { half_edge, .. } => look.mark_half_edge(*half_edge, Mark::Hot),
            _ => {}
        }
    }
    look
}

/// The marks over the drawing.
struct Sheet<'a, 'p> {
    plate: &'a Plate<'p, Table>,
    layout: &'a Table,
    crowd: Crowd,
    notes: Notes,
    /// Lines and arrows, below the vertices.
    under: Vec<Node>,
    /// Rings, discs and badges, above all.
    over: Vec<Node>,
}

impl Sheet<'_, '_> {
    fn place(&self, p: Point) -> Xy {
        self.plate.picture.fit.place(p)
    }

    fn draw(&mut self, spot: &Spot) {
        match spot {
            Spot::MissingVertex(p) => self.round("miss", "ring", 11.0, *p),
            Spot::ExtraVertex(p) => self.round("extra", "disc", 5.5, *p),
            Spot::Moved(from, to) => {
                let ends = [*from, *to].map(|p| self.place(p));
                self.under.push(marked("extra", vec![Node::Line { class: "thread", from: ends[0], to: ends[1] }]));
                self.round("miss", "ring", 11.0, *from);
                self.round("extra", "disc", 5.5, *to);
            }
            Spot::MissingEdge(ends) => self.line("miss", *ends),
            Spot::ExtraEdge(ends) => self.line("extra", *ends),
            Spot::Pointer { half_edge, pointer, found } => self.pointer(*half_edge, *pointer, *found),
            Spot::Face(points) => self.outline("miss", points),
            Spot::ExtraFace(points) => self.outline("extra", points),
            Spot::Many(spots) => spots.iter().for_each(|spot| self.draw(spot)),
            Spot::At(_) | Spot::Beside(_) | Spot::Nowhere => {}
        }
    }

    fn outline(&mut self, mark: &'static str, points: &[Point]) {
        let outline: Vec<Xy> = points.iter().map(|&p| self.place(p)).collect();
        let steps = outline.iter().skip(1).chain(outline.first()).map(|&p| Step::Line(p)).collect();
        if let Some(&start) = outline.first() {
            self.under.push(marked(mark, vec![Node::Curve { class: "outline", start, steps }]));
        }
    }

    fn round(&mut self, mark: &'static str, class: &'static str, radius: f64, p: Point) {
        let centre = self.place(p);
        self.crowd.add(Shape::Disc(centre, radius), u32::MAX);
        self.over.push(marked(mark, vec![Node::Disc { class, centre, radius }]));
    }

    fn line(&mut self, mark: &'static str, ends: [Point; 2]) {
        let [from, to] = ends.map(|p| self.place(p));
        self.under.push(marked(mark, vec![Node::Line { class: "dl", from, to }]));
    }

    /// The arrow as it should be, and as it is.
    fn pointer(&mut self, h: HalfEdgeId, slot: Slot, found: Option<Element>) {
        let mut actual = self.layout.clone();
        let mut set = |h: HalfEdgeId, pointer: Option<Pointer>, of: &dyn Fn(&mut HalfEdgeRow)| {
            actual.half_edges.get_mut(h.index()).and_then(Option::as_mut).into_iter().for_each(of);
            pointer
        };
        let mine = match slot {
            Slot::Next => Some(Pointer::Next(h)),
            Slot::Prev => self.layout.prev(h).map(Pointer::Next),
            Slot::Twin => Some(Pointer::Twin(h)),
            Slot::Face => Some(Pointer::Face(h)),
            Slot::Whole => None,
        };
        let theirs = match (slot, found) {
            (Slot::Next, Some(Element::HalfEdge(to))) => set(h, mine, &|row| row.next = Some(to)),
            (Slot::Prev, Some(Element::HalfEdge(from))) => {
                set(from, Some(Pointer::Next(from)), &|row| row.next = Some(h))
            }
            (Slot::Twin, Some(Element::HalfEdge(to))) => set(h, mine, &|row| row.twin = Some(to)),
            (Slot::Face, Some(Element::Face(to))) => set(h, mine, &|row| row.face = Some(to)),
            _ => None,
        };
        let layout = self.layout;
        for (view, pointer, mark) in [(layout, mine, "miss"), (&actual, theirs, "extra")] {
            let Some(pointer) = pointer else { continue };
            let Some(tagged) = self.plate.arrow(view, pointer, 0.5, &mut self.crowd) else { continue };
            tagged.arrow.shapes().into_iter().for_each(|shape| self.crowd.add(shape, u32::MAX));
            self.under.push(marked(mark, tagged.arrow.nodes("pl", "ph").to_vec()));
        }
    }

    /// The names of the half-edges that the sentences name.
    fn names(&mut self, table: &Table, listed: &[Difference]) {
        let mut all: Vec<HalfEdgeId> = listed.iter().flat_map(|difference| named(&difference.text)).collect();
        all.sort_unstable();
        all.dedup();
        for h in all.into_iter().filter(|&h| table.has_half_edge(h)) {
            let Some((a, b)) = self.plate.skeleton().segment(h) else { continue };
            let Some(along) = (b - a).unit() else { continue };
            let shaft = self.plate.shafts.get(h).copied().flatten();
            let middle = shaft.map_or((a + b) * 0.5, |shaft| shaft.middle);
            let name = h.to_string();
            let half = 0.5 * text::width(&name, NAME, true);
            let free = |at: &Xy| self.crowd.blocker(&Bounds::around(*at, half, 0.5 * NAME)).is_none();
            // On the side of the half-edge, from its middle outwards.
            let steps = [0.0, 0.12, -0.12, 0.24, -0.24, 0.33, -0.33];
            let far = [half.max(8.0) + 3.0, half.max(8.0) + 9.0];
            let places =
                far.iter().flat_map(|off| steps.map(|t| middle + along * (t * (b - a).length()) + along.left() * *off));
            let places: Vec<Xy> = places.collect();
            let Some(&at) = places.iter().find(|at| free(at)).or(places.first()) else { continue };
            self.crowd.add(Shape::Segment(at - xy(half, 0.0), at + xy(half, 0.0), 0.5 * NAME), u32::MAX);
            self.over.push(Node::Text { class: "hn", at, size: NAME, text: name });
        }
    }

    /// The number of a sentence, at the nearest free place; whether there is one.
    fn badge(&mut self, number: usize, difference: &Difference) -> bool {
        let Some(anchor) = place_of(&difference.spot).and_then(|spot| self.anchor(spot)) else { return false };
        let size = self.plate.picture.fit.size;
        let inside = Bounds { min: xy(3.0, 3.0), max: size - xy(3.0, 3.0) };
        let steps = |n: i32| (-n..=n).map(|i| 5.0 * f64::from(i));
        let mut places: Vec<Xy> = steps(9).flat_map(|x| steps(9).map(move |y| anchor + xy(x, y))).collect();
        places.sort_by(|a, b| (*a - anchor).length().total_cmp(&(*b - anchor).length()));
        let bounds = |at: Xy| Bounds::around(at, BADGE, BADGE);
        let free = |at: &&Xy| inside.contains(&bounds(**at)) && self.crowd.blocker(&bounds(**at).grown(1.0)).is_none();
        let at = places.iter().find(free).copied().unwrap_or(anchor);
        self.crowd.add(Shape::Disc(at, BADGE), u32::MAX);
        self.over.extend(badge(at, number, colour(&difference.spot)));
        true
    }

    /// Where a badge should stand.
    fn anchor(&self, spot: &Spot) -> Option<Xy> {
        Some(match spot {
            Spot::At(p) | Spot::MissingVertex(p) | Spot::ExtraVertex(p) => self.place(*p),
            Spot::Beside(ends) => {
                let [a, b] = ends.map(|p| self.place(p));
                (b - a).unit().map_or(a, |along| (a + b) * 0.5 + along.left() * BESIDE)
            }
            Spot::Moved(_, to) => self.place(*to),
            Spot::MissingEdge(ends) | Spot::ExtraEdge(ends) => {
                let [a, b] = ends.map(|p| self.place(p));
                (a + b) * 0.5
            }
            Spot::Pointer { half_edge, pointer, .. } => {
                let shaft = self.plate.shafts.get(*half_edge).copied().flatten();
                let segment = self.plate.skeleton().segment(*half_edge);
                let at = match pointer {
                    Slot::Next => shaft.map(|shaft| shaft.tip),
                    Slot::Prev => shaft.map(|shaft| shaft.tail),
                    _ => shaft.map(|shaft| shaft.middle),
                };
                at.or(segment.map(|(a, b)| (a + b) * 0.5))?
            }
            Spot::Many(_) | Spot::Nowhere => return None,
            Spot::Face(points) | Spot::ExtraFace(points) if points.is_empty() => return None,
            Spot::Face(points) | Spot::ExtraFace(points) => {
                let sum = points.iter().fold(Xy::default(), |sum, &p| sum + self.place(p));
                sum * (1.0 / points.len().max(1) as f64)
            }
        })
    }
}

/// Blue for what is too much, red for the rest.
fn colour(spot: &Spot) -> &'static str {
    match spot {
        Spot::ExtraVertex(_) | Spot::ExtraEdge(_) | Spot::ExtraFace(_) | Spot::Moved(..) => "extra",
        _ => "miss",
    }
}

fn badge(centre: Xy, number: usize, mark: &'static str) -> [Node; 1] {
    let disc = Node::Disc { class: "badge", centre, radius: BADGE };
    let size = if number < 10 { NUMBER } else { NUMBER - 1.5 };
    [marked(mark, vec![disc, Node::Text { class: "bn", at: centre, size, text: number.to_string() }])]
}

fn marked(mark: &'static str, nodes: Vec<Node>) -> Node {
    Node::Group(Group { class: "diff", mark, nodes, ..Group::default() })
}
