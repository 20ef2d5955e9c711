//! From the things of a sketch to shapes of the canvas, the room they take, and where their labels may stand.

use super::Glyph;
use super::clip;
use super::item::{Dash, Heads, Item, Kind};
use super::places::Anchor;
use super::round::{Piece, Round};
use crate::figure::canvas::crop::cut;
use crate::figure::canvas::scene::{Node, Step};
use crate::figure::canvas::vector::{Bounds, Xy, xy};
use crate::figure::layout::crowd::Shape;
use crate::figure::layout::fit::Fit;
use crate::figure::layout::pole::pole;
use crate::figure::structure::arrows::head;
use crate::plane::Point;
use crate::plane::predicates::orientation;
use std::cmp::Ordering;

/// Where a sketch is drawn.
#[derive(Clone, Copy, Debug)]
pub(in crate::figure) struct Canvas {
    pub(in crate::figure) fit: Fit,
    /// What lies outside is cut off.
    pub(in crate::figure) frame: Bounds,
}

/// A thing on the canvas.
#[derive(Default)]
pub(super) struct Drawn {
    pub(super) nodes: Vec<Node>,
    /// What labels must not cover.
    pub(super) ink: Vec<Shape>,
    /// Where its own label may stand, the best place first.
    pub(super) anchors: Vec<Anchor>,
}

/// Why nothing is to be seen.
pub(super) type Missing = &'static str;
const OUTSIDE: Missing = "outside the picture, not drawn";
const FLAT: Missing = "without extent, not drawn";

/// The layers, in the order in which they are painted.
pub(super) const fn layer(kind: &Kind) -> usize {
    match kind {
        Kind::Region(_) | Kind::Cone { .. } => 0,
        Kind::Path(_) | Kind::Ray(_) | Kind::Line(_) | Kind::Circle { .. } | Kind::Arc(_) => 1,
        Kind::Portal(_) => 2,
        Kind::Point(..) => 3,
        Kind::Text(_) | Kind::Badge(_) => 4,
    }
}

impl Canvas {
    fn place(&self, p: Point) -> Xy {
        self.fit.place(p)
    }

    /// The direction from `a` to `b` as seen, however far apart they are.
    fn way(&self, a: Point, b: Point) -> Option<Xy> {
        let (x, y) = (b.x - a.x, a.y - b.y);
        let size = x.abs().max(y.abs());
        xy(x / size, y / size).unit()
    }

    fn holds(&self, p: Xy) -> bool {
        self.frame.contains(&Bounds { min: p, max: p })
    }
}

impl Item {
    pub(super) fn draw(&self, canvas: &Canvas) -> Result<Drawn, Missing> {
        match &self.kind {
            Kind::Region(rings) => self.region(canvas, rings),
            Kind::Path(points) => self.path(canvas, points),
            Kind::Ray([a, b]) => self.straight(canvas, *a, *b, clip::ray),
            Kind::Line([a, b]) => self.straight(canvas, *a, *b, clip::line),
            Kind::Circle { centre, radius, .. } => {
                let round = Round { centre: canvas.place(*centre), radius: radius.abs() * canvas.fit.scale };
                self.round(canvas, round, Piece::WHOLE)
            }
            Kind::Arc([centre, from, to]) => {
                let (c, p) = (canvas.place(*centre), canvas.place(*from));
                let ways = canvas.way(*centre, *from).zip(canvas.way(*centre, *to));
                let (from, to) = ways.ok_or(FLAT)?;
                self.round(canvas, Round { centre: c, radius: (p - c).length() }, Piece { from, to })
            }
            Kind::Cone { corners, end } => self.cone(canvas, *corners, *end),
            Kind::Point(at, glyph) => point(canvas, *at, *glyph),
            Kind::Portal([left, right]) => portal(canvas, *left, *right),
            Kind::Text(at) | Kind::Badge(at) => {
                let at = canvas.place(*at);
                let anchors = vec![Anchor::centred(at), Anchor::round(at, 2.0)];
                if canvas.holds(at) { Ok(Drawn { anchors, ..Drawn::default() }) } else { Err(OUTSIDE) }
            }
        }
    }

    /// The class of its line.
    pub(super) const fn line_class(&self) -> &'static str {
        match self.dash {
            Dash::Role => "ln",
            Dash::Solid => "ln solid",
            Dash::Dashed => "ln dashed",
            #[cfg(feature = "solid")]
            Dash::Edge => "edge",
        }
    }

    fn region(&self, canvas: &Canvas, rings: &[Vec<Point>]) -> Result<Drawn, Missing> {
        let placed = rings.iter().map(|ring| ring.iter().map(|&p| canvas.place(p)).collect::<Vec<_>>());
        let seen: Vec<Vec<Xy>> = placed.map(|ring| cut(ring, &canvas.frame)).filter(|ring| ring.len() > 2).collect();
        self.area(canvas, seen)
    }

    fn cone(
        &self,
        canvas: &Canvas,
        [apex, right, left]: [Point; 3],
        end: Option<[Point; 2]>,
    ) -> Result<Drawn, Missing> {
        let (r, l) = canvas.way(apex, right).zip(canvas.way(apex, left)).ok_or(FLAT)?;
        let turn = orientation(apex, right, left);
        if turn == Ordering::Equal && r.dot(l) > 0.0 {
            return Err(FLAT);
        }
        let at = canvas.place(apex);
        let mut rings = clip::wedge(at, r, l, turn, &canvas.frame);
        if let (Some([p, q]), Ordering::Greater) = (end, turn) {
            rings = clip::before(&rings, at, canvas.place(p), canvas.place(q));
        }
        rings.retain(|ring| ring.len() > 2);
        self.area(canvas, rings)
    }

    fn area(&self, canvas: &Canvas, rings: Vec<Vec<Xy>>) -> Result<Drawn, Missing> {
        if rings.is_empty() {
            return Err(OUTSIDE);
        }
        let mut out = Drawn::default();
        if self.label.is_some()
            && let Some(pole) = pole(&rings, &[], 2.0, 60.0)
        {
            out.anchors.extend([Anchor::centred(pole.at), Anchor::round(pole.at, 0.0)]);
        }
        let lines = if self.outlined { outlines(&rings, &canvas.frame) } else { Vec::new() };
        let (class, hatch) = if self.hatched { ("hatched", Some("hole-hatch")) } else { ("fi", None) };
        if self.hatched {
            out.nodes.push(Node::Area { class: "bg", hatch: None, outlines: rings.clone() });
        }
        out.nodes.push(Node::Area { class, hatch, outlines: rings });
        for line in lines {
            out.ink.extend(along(&line, 0.6));
            out.nodes.extend(curve("ol", &line));
        }
        Ok(out)
    }

    fn path(&self, canvas: &Canvas, points: &[Point]) -> Result<Drawn, Missing> {
        let mut placed: Vec<Xy> = points.iter().map(|&p| canvas.place(p)).collect();
        placed.dedup();
        if placed.len() < 2 {
            return Err(FLAT);
        }
        let runs = clip::polyline(&placed, &canvas.frame);
        if runs.is_empty() {
            return Err(OUTSIDE);
        }
        let mut out = Drawn::default();
        for mut run in runs {
            out.ink.extend(along(&run, 0.5 * self.role.width()));
            out.anchors.extend(beside(&run, 0.5 * self.role.width()));
            let is_end = |p: Option<&Xy>, end: Option<&Xy>| p == end;
            let mut heads = Vec::new();
            if self.heads != Heads::None && is_end(run.last(), placed.last()) {
                heads.extend(self.head(&mut run, &mut out.ink));
            }
            if self.heads == Heads::Both && is_end(run.first(), placed.first()) {
                run.reverse();
                heads.extend(self.head(&mut run, &mut out.ink));
                run.reverse();
            }
            out.nodes.extend(curve(self.line_class(), &run));
            out.nodes.extend(heads);
        }
        Ok(out)
    }

    /// The arrow head at the end of a run, which is cut back to make room for it.
    fn head(&self, run: &mut [Xy], ink: &mut Vec<Shape>) -> Option<Node> {
        let [.., before, tip] = run else { return None };
        let along = (*tip - *before).unit()?;
        let size = (5.5 + 1.8 * self.role.width()).min(0.8 * (*tip - *before).length());
        let corners = head(*tip, along, size);
        ink.extend([Shape::Segment(corners[0], corners[1], 0.5), Shape::Segment(corners[0], corners[3], 0.5)]);
        *tip = *tip - along * (0.65 * size);
        Some(Node::Area { class: "gl", hatch: None, outlines: vec![corners.to_vec()] })
    }

    fn straight(
        &self,
        canvas: &Canvas,
        a: Point,
        b: Point,
        clip: fn(Xy, Xy, &Bounds) -> Option<(Xy, Xy)>,
    ) -> Result<Drawn, Missing> {
        let way = canvas.way(a, b).ok_or(FLAT)?;
        let (from, to) = clip(canvas.place(a), way, &canvas.frame).ok_or(OUTSIDE)?;
        let half = 0.5 * self.role.width();
        let aside = way.left();
        let anchor = |t: f64| Anchor::beside(from + (to - from) * t, half + 1.0, vec![aside, aside * -1.0]);
        Ok(Drawn {
            nodes: vec![Node::Line { class: self.line_class(), from, to }],
            ink: vec![Shape::Segment(from, to, half)],
            anchors: [0.85, 0.7, 0.55, 0.4, 0.25].map(anchor).to_vec(),
        })
    }

    fn round(&self, canvas: &Canvas, round: Round, piece: Piece) -> Result<Drawn, Missing> {
        if round.radius < 0.01 {
            return Err(FLAT);
        }
        let pieces = if round.is_inside(&canvas.frame) { vec![piece] } else { round.inside(piece, &canvas.frame) };
        let mut out = Drawn::default();
        if self.filled && piece == Piece::WHOLE {
            let ring = cut(round.points(piece), &canvas.frame);
            if pieces == [piece] {
                out.nodes.push(Node::Disc { class: "fi", centre: round.centre, radius: round.radius });
            } else if ring.len() > 2 {
                out.nodes.push(Node::Area { class: "fi", hatch: None, outlines: vec![ring] });
            }
        }
        let half = 0.5 * self.role.width();
        for &piece in &pieces {
            let points = round.points(piece);
            out.ink.extend(along(&points, half));
            let places = points.iter().step_by(4).filter_map(|&at| {
                let outwards = (at - round.centre).unit()?;
                Some(Anchor::beside(at, half + 1.0, vec![outwards, outwards * -1.0]))
            });
            out.anchors.extend(places);
            out.nodes.push(round.curve(piece, self.line_class()));
        }
        // The upper right of a circle is where labels are looked for.
        let to_the_north_east = |anchor: &Anchor| xy(0.6, -0.8).dot(anchor.at - round.centre);
        out.anchors.sort_by(|a, b| to_the_north_east(b).total_cmp(&to_the_north_east(a)));
        if out.nodes.is_empty() { Err(OUTSIDE) } else { Ok(out) }
    }
}

fn point(canvas: &Canvas, at: Point, glyph: Glyph) -> Result<Drawn, Missing> {
    let at = canvas.place(at);
    if !canvas.holds(at) {
        return Err(OUTSIDE);
    }
    let radius = glyph.radius();
    let ink = vec![Shape::Disc(at, radius + 1.0)];
    Ok(Drawn { nodes: glyph.nodes(at), ink, anchors: vec![Anchor::round(at, radius + 1.0)] })
}

/// Left a square, right a ring.
fn portal(canvas: &Canvas, left: Point, right: Point) -> Result<Drawn, Missing> {
    let (l, r) = (canvas.place(left), canvas.place(right));
    let (from, to) = clip::segment(l, r, &canvas.frame).ok_or(OUTSIDE)?;
    let aside = (to - from).unit().ok_or(FLAT)?.left();
    let mut nodes = vec![Node::Line { class: "po", from, to }];
    let mut ink = vec![Shape::Segment(from, to, 2.0)];
    for (end, glyph) in [(l, Glyph::Square), (r, Glyph::Ring)] {
        if canvas.holds(end) {
            nodes.extend(glyph.nodes(end));
            ink.push(Shape::Disc(end, glyph.radius() + 1.0));
        }
    }
    let middle = (from + to) * 0.5;
    let mut anchors = vec![Anchor::beside(middle, 3.0, vec![aside * -1.0, aside])];
    anchors.push(Anchor::round(middle, 3.0));
    Ok(Drawn { nodes, ink, anchors })
}

fn curve(class: &'static str, line: &[Xy]) -> Option<Node> {
    let (&start, rest) = line.split_first()?;
    Some(match rest {
        [to] => Node::Line { class, from: start, to: *to },
        _ => Node::Curve { class, start, steps: rest.iter().map(|&p| Step::Line(p)).collect() },
    })
}

fn along(line: &[Xy], half_width: f64) -> impl Iterator<Item = Shape> + '_ {
    line.windows(2).map(move |w| Shape::Segment(w[0], w[1], half_width))
}

/// Both sides of the middles of the longest steps.
fn beside(run: &[Xy], half_width: f64) -> Vec<Anchor> {
    let mut steps: Vec<(Xy, Xy)> = run.windows(2).map(|w| (w[0], w[1])).collect();
    steps.sort_by(|a, b| (b.1 - b.0).length().total_cmp(&(a.1 - a.0).length()));
    let anchor = |t: f64, &(a, b): &(Xy, Xy)| {
        let aside = (b - a).unit()?.left();
        Some(Anchor::beside(a + (b - a) * t, half_width + 1.0, vec![aside, aside * -1.0]))
    };
    let longest = &steps[..steps.len().min(5)];
    [0.5, 0.3, 0.7].iter().flat_map(|&t| longest.iter().filter_map(move |step| anchor(t, step))).collect()
}

/// The border of rings as lines, without what lies on the frame.
fn outlines(rings: &[Vec<Xy>], frame: &Bounds) -> Vec<Vec<Xy>> {
    let same = |a: f64, b: f64, side: f64| (a - side).abs() < 1e-6 && (b - side).abs() < 1e-6;
    let on_frame = |a: Xy, b: Xy| {
        same(a.x, b.x, frame.min.x)
            || same(a.x, b.x, frame.max.x)
            || same(a.y, b.y, frame.min.y)
            || same(a.y, b.y, frame.max.y)
    };
    let mut out: Vec<Vec<Xy>> = Vec::new();
    for ring in rings {
        let first = out.len();
        // Begin after a step on the frame, so that no line is cut where nothing is.
        let n = ring.len();
        let start = (0..n).find(|&i| on_frame(ring[(i + n - 1) % n], ring[i])).unwrap_or(0);
        for i in 0..n {
            let (a, b) = (ring[(start + i) % n], ring[(start + i + 1) % n]);
            if a == b || on_frame(a, b) {
                continue;
            }
            match out[first..].last_mut() {
                Some(line) if line.last() == Some(&a) => line.push(b),
                _ => out.push(vec![a, b]),
            }
        }
    }
    out
}
