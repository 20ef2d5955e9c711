//! What can be seen: paints, widths and opacities, by attributes, style sheet and `style`, handed down to children.
//!
//! ```text
//!   stroke="white"          on white paper       ┐
//!   stroke="none"           or none at all       ├── drawn, but nobody sees it
//!   stroke-width="0"  opacity="0"  visibility    ┘
//! ```
//!
//! What lies over a line is found out by `eye.rs`, from what all elements paint.

use super::colour::{Paint, paint};
use super::dashes::{self, Dashes};
use super::declarations::declarations;
use super::geometry::Geometry;
use super::letters::Letters;
use super::markers::Markers;
use super::numbers::{self, fraction};
use super::served::{Served, Servers};
use super::values::{is_unread, plainly};
use crate::figure::canvas::selectors::{Rule, Tag};
use roxmltree::Node;
use std::rc::Rc;

/// Why a line, a dot or an area cannot be seen.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum Hidden {
    NoStroke,
    NoFill,
    NoWidth,
    NoSize,
    Thin,
    Tiny,
    Transparent,
    Faint,
    Paper,
    Ground,
    Swallowed,
    Switched,
    Dashes,
    Veil,
    Clip,
    Canvas,
    Rim,
    Marker,
    Letters,
    Faded,
    Area,
    Dot,
    Line,
    Ends,
}

impl Hidden {
    /// The reason as the end of a sentence about one or several.
    pub(super) fn reason(self, several: bool) -> &'static str {
        let [one, many] = match self {
            Self::NoStroke => ["it has no stroke", "they have no stroke"],
            Self::NoFill => ["it has no fill", "they have no fill"],
            Self::NoWidth => ["its stroke-width is 0", "their stroke-width is 0"],
            Self::NoSize => ["it has no size: its radius is 0 or less", "they have no size: their radius is 0 or less"],
            Self::Thin => ["its line is thinner than 0.1 px", "their lines are thinner than 0.1 px"],
            Self::Tiny => ["its radius is less than 0.1 px", "their radius is less than 0.1 px"],
            Self::Transparent => ["its opacity is 0", "their opacity is 0"],
            Self::Faint => ["it is almost transparent", "they are almost transparent"],
            Self::Paper => ["it has the colour of the paper", "they have the colour of the paper"],
            Self::Ground => ["it has the colour of what lies below it", "they have the colour of what lies below them"],
            Self::Swallowed => [
                "it cannot be told from the lines that end there: make it larger",
                "they cannot be told from the lines that end there: make them larger",
            ],
            Self::Switched => ["its visibility is hidden", "their visibility is hidden"],
            Self::Dashes => ["its dashes leave it out", "their dashes leave them out"],
            Self::Veil => [
                "it has a mask or a filter, which are not worked out",
                "they have masks or filters, which are not worked out",
            ],
            Self::Clip => ["its clip-path cuts it off", "their clip-path cuts them off"],
            Self::Canvas => ["it lies outside of the viewBox", "they lie outside of the viewBox"],
            Self::Rim => [
                "only its rim is drawn, far from its middle: fill it, or make it smaller",
                "only their rims are drawn, far from their middles: fill them, or make them smaller",
            ],
            Self::Marker => [
                "a marker is drawn over it: make the markers smaller",
                "markers are drawn over them: make the markers smaller",
            ],
            Self::Letters => [
                "large letters are drawn over it: make the text smaller",
                "large letters are drawn over them: make the text smaller",
            ],
            Self::Faded => [
                "letters that cannot be told from what lies round them are drawn over it",
                "letters that cannot be told from what lies round them are drawn over them",
            ],
            Self::Area => [
                "a filled shape is drawn over it: draw faces first",
                "filled shapes are drawn over them: draw faces first",
            ],
            Self::Dot => [
                "a circle is drawn over it: make the circles smaller",
                "circles are drawn over them: make the circles smaller",
            ],
            Self::Line => ["a line is drawn over it", "lines are drawn over them"],
            Self::Ends => [
                "the circles at its ends cover it: make them smaller",
                "the circles at their ends cover them: make them smaller",
            ],
        };
        if several { many } else { one }
    }
}

/// The style of an element.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Ink {
    fill: Paint,
    fill_opacity: f64,
    pub(super) even_odd: bool,
    stroke: Paint,
    stroke_opacity: f64,
    width: f64,
    /// The width of the rims of letters, if it is said in parts of their size.
    rim: Option<f64>,
    /// Whether a line of no length is a dot.
    pub(super) round: bool,
    dashes: Rc<[f64]>,
    dash_start: f64,
    opacity: f64,
    visible: bool,
    colour: Paint,
    veiled: bool,
    /// What `fill` and `stroke` paint on what has no width or no height, if that is something else.
    flat: [Option<Paint>; 2],
    /// Whether areas are filled by a gradient or a pattern.
    pub(super) hatched: bool,
    servers: Rc<Servers>,
    pub(super) markers: Markers,
    pub(super) letters: Letters,
    /// Whether the rims of letters lie below them.
    pub(super) rim_below: bool,
    /// Where a text lies: 0 behind its place, 0.5 in the middle, 1 before it.
    pub(super) anchor: f64,
}

impl Default for Ink {
    fn default() -> Self {
        Self {
            fill: Paint::Colour([0; 3], 1.0),
            fill_opacity: 1.0,
            even_odd: false,
            stroke: Paint::None,
            stroke_opacity: 1.0,
            width: 1.0,
            rim: None,
            round: false,
            dashes: Rc::new([]),
            dash_start: 0.0,
            opacity: 1.0,
            visible: true,
            colour: Paint::Colour([0; 3], 1.0),
            veiled: false,
            flat: [None; 2],
            hatched: false,
            servers: Rc::default(),
            markers: Markers::default(),
            letters: Letters::default(),
            rim_below: false,
            anchor: 0.0,
        }
    }
}

/// What an element says of itself and does not hand down.
#[derive(Clone, Default, PartialEq, Debug)]
pub(super) struct Own {
    /// The id of a clip path.
    pub(super) clip: Option<String>,
    pub(super) transform: Option<String>,
    /// Where it lies and how large it is, by a style.
    pub(super) geometry: Geometry,
    /// Widths are not scaled.
    pub(super) fixed_width: bool,
    /// What lies outside of an inner `svg` is shown.
    pub(super) overflows: bool,
    /// Properties that veil it.
    veils: Vec<String>,
    /// What is painted behind it, if it is the root.
    pub(super) ground: Option<Paint>,
    /// A property that moves the element in a way that is not read.
    pub(super) unread: Option<String>,
    /// Properties whose values are not worked out, as they are written.
    pub(super) unworked: Vec<(String, String)>,
    /// An animation by rules, as it is written.
    pub(super) animation: Option<String>,
    /// The point about which it is turned, as it is written.
    pub(super) origin: Option<String>,
    hidden: bool,
    /// The width of lines as a part of the size of its letters, if it is said so.
    ems: Option<f64>,
}

impl Ink {
    /// The style of a root whose file has these gradients and patterns.
    pub(super) fn with(servers: Servers) -> Self {
        Self { servers: Rc::new(servers), ..Self::default() }
    }

    /// The same style for what stands elsewhere in the file and inherits nothing from here.
    pub(super) fn fresh(&self) -> Self {
        Self { servers: Rc::clone(&self.servers), ..Self::default() }
    }

    /// The style on what has no width or no height, if it is another one there.
    pub(super) fn flat(&self) -> Option<Self> {
        let [fill, stroke] = self.flat;
        let mut out = self.clone();
        out.fill = fill.unwrap_or(self.fill);
        out.stroke = stroke.unwrap_or(self.stroke);
        (fill.is_some() || stroke.is_some()).then_some(out)
    }

    /// The style of `node` inside an element with this style; `None` if it is not displayed. `path` is what the
    /// rules look at: the tags from the root to the node.
    pub(super) fn inside(&self, node: Node<'_, '_>, rules: &[Rule<'_>], path: &[Tag]) -> Option<(Self, Own)> {
        let (mut out, mut own) = (self.clone(), Own::default());
        let said = declarations(node, rules, path);
        said.iter().filter(|(key, _)| key.starts_with("--")).for_each(|(name, value)| out.letters.name(name, value));
        for (key, value) in said {
            out.set(key.strip_prefix("-webkit-").unwrap_or(&key), &value, self, &mut own);
        }
        out.rim = own.ems.map(|ems| ems * out.letters.size).or(out.rim);
        out.veiled |= !own.veils.is_empty();
        (!own.hidden).then_some((out, own))
    }

    fn set(&mut self, key: &str, value: &str, around: &Self, own: &mut Own) {
        let value = plainly(key, value.trim());
        own.unworked.retain(|(other, _)| other != key);
        // Letters keep their own.
        if !key.starts_with("font") && is_unread(key, value) {
            own.unworked.push((key.to_owned(), value.to_owned()));
        }
        let inherits = value == "inherit";
        let none = value == "none";
        match key {
            "display" => own.hidden = none,
            "visibility" if inherits => self.visible = around.visible,
            "visibility" => self.visible = value == "visible",
            "color" if inherits => self.colour = around.colour,
            "color" => self.colour = paint(value),
            "fill" if inherits => {
                (self.fill, self.flat[0], self.hatched) = (around.fill, around.flat[0], around.hatched);
            }
            "fill" => {
                Served { paint: self.fill, flat: self.flat[0], is_server: self.hatched } = self.servers.paint(value);
            }
            "fill-rule" if inherits => self.even_odd = around.even_odd,
            "fill-rule" => self.even_odd = value == "evenodd",
            "stroke" if inherits => (self.stroke, self.flat[1]) = (around.stroke, around.flat[1]),
            "stroke" => Served { paint: self.stroke, flat: self.flat[1], .. } = self.servers.paint(value),
            "stroke-width" => {
                self.width = numbers::measure(value).unwrap_or(around.width);
                self.rim = around.rim.filter(|_| inherits);
                let ems = value.strip_suffix("em").filter(|number| !number.ends_with('r'));
                own.ems = ems.and_then(numbers::length);
            }
            "stroke-linecap" if inherits => self.round = around.round,
            "stroke-linecap" => self.round = matches!(value, "round" | "square"),
            "stroke-dasharray" if inherits => self.dashes = Rc::clone(&around.dashes),
            "stroke-dasharray" => self.dashes = dashes::read(value),
            "stroke-dashoffset" if inherits => self.dash_start = around.dash_start,
            "stroke-dashoffset" => self.dash_start = numbers::measure(value).unwrap_or(0.0),
            "fill-opacity" => self.fill_opacity = fraction(value).unwrap_or(around.fill_opacity),
            "stroke-opacity" => self.stroke_opacity = fraction(value).unwrap_or(around.stroke_opacity),
            "opacity" if inherits => self.opacity = around.opacity * around.opacity,
            // The one property that adds up instead of being handed down.
            "opacity" => self.opacity = around.opacity * fraction(value).unwrap_or(1.0),
            "mask" | "mask-image" | "filter" | "mix-blend-mode" => {
                own.veils.retain(|veil| veil != key);
                own.veils.extend((!none && value != "normal").then(|| key.to_owned()));
            }
            "background" | "background-color" => own.ground = Some(paint(value)),
            "translate" | "rotate" | "scale" | "offset" | "offset-path" | "zoom" | "content-visibility"
                if !none && !["1", "normal", "visible", "auto"].contains(&value) =>
            {
                own.unread = Some(format!("{key}: {value}"));
            }
            "animation" | "animation-name" => own.animation = (!none).then(|| format!("{key}: {value}")),
            "transform-origin" => own.origin = Some(value.to_owned()),
            "clip-path" => own.clip = (!none && value != "initial").then(|| value.to_owned()),
            "transform" => own.transform = (!none).then(|| value.to_owned()),
            "vector-effect" => own.fixed_width = value == "non-scaling-stroke",
            "paint-order" if inherits => self.rim_below = around.rim_below,
            "paint-order" => self.rim_below = value.starts_with("stroke"),
            "marker" | "marker-start" | "marker-mid" | "marker-end" if !inherits => self.markers.set(key, value),
            "font-size" => self.letters.set("font-size", value, &around.letters),
            "font" => self.letters.set("font", value, &around.letters),
            "text-anchor" if !inherits => {
                self.anchor = match value {
                    "middle" => 0.5,
                    "end" => 1.0,
                    _ => 0.0,
                }
            }
            "overflow" => own.overflows = matches!(value, "visible" | "auto"),
            _ => own.geometry.set(key, value),
        }
    }

    fn resolved(&self, paint: Paint) -> Paint {
        if paint == Paint::Current { self.colour } else { paint }
    }

    /// The paint of areas, and how much of what lies below it covers.
    pub(super) fn fill(&self) -> (Paint, f64) {
        (self.resolved(self.fill), self.fill_opacity * self.opacity)
    }

    /// The paint of lines, and how much of what lies below it covers.
    pub(super) fn stroke(&self) -> (Paint, f64) {
        (self.resolved(self.stroke), self.stroke_opacity * self.opacity)
    }

    /// The width of lines before any transform.
    pub(super) fn width(&self) -> f64 {
        self.width.max(0.0)
    }

    /// The width of the rims of letters before any transform.
    pub(super) fn rim_width(&self) -> f64 {
        self.rim.map_or(self.width(), |rim| rim.max(0.0))
    }

    /// Why a line of this style cannot be seen, wherever it lies.
    pub(super) fn hidden_stroke(&self) -> Option<Hidden> {
        match self.stroke() {
            _ if !self.visible => Some(Hidden::Switched),
            (Paint::None, _) => Some(Hidden::NoStroke),
            _ if self.width <= 0.0 => Some(Hidden::NoWidth),
            (paint, opacity) => self.unpainted(paint, opacity),
        }
    }

    /// Why an area of this style cannot be seen, wherever it lies.
    pub(super) fn hidden_fill(&self) -> Option<Hidden> {
        match self.fill() {
            _ if !self.visible => Some(Hidden::Switched),
            (Paint::None, _) => Some(Hidden::NoFill),
            (paint, opacity) => self.unpainted(paint, opacity),
        }
    }

    fn unpainted(&self, paint: Paint, opacity: f64) -> Option<Hidden> {
        let own = if let Paint::Colour(_, alpha) = paint { alpha } else { 1.0 };
        let is_clear = opacity * own <= 0.0;
        is_clear.then_some(Hidden::Transparent).or(self.veiled.then_some(Hidden::Veil))
    }

    fn pattern(&self) -> Dashes<'_> {
        let ends = if self.round { self.width() } else { 0.0 };
        Dashes { lengths: &self.dashes, start: self.dash_start, ends }
    }

    /// The same with dashes so many times as long, if it has any.
    pub(super) fn with_longer_dashes(&self, by: f64) -> Option<Self> {
        let dashes = self.dashes.iter().map(|length| by * length).collect();
        (!self.dashes.is_empty()).then(|| Self { dashes, dash_start: by * self.dash_start, ..self.clone() })
    }

    /// Whether the dashes draw hardly anything of a line that lies so far from the start of its path, its lengths as
    /// they are before any transform.
    pub(super) fn dashed_away(&self, from: f64, length: f64) -> bool {
        self.pattern().leave_out(from, length)
    }

    /// Whether one gap of the dashes, longer than `usual`, leaves out a large part of such a line.
    pub(super) fn has_gap(&self, from: f64, length: f64, usual: f64) -> bool {
        self.pattern().leave_a_gap(from, length, usual)
    }

    /// The longest dashes on such a line that are no shorter than `least`: from where to where.
    pub(super) fn dashes(&self, from: f64, length: f64, least: f64) -> Vec<[f64; 2]> {
        self.pattern().drawn(from, length, least)
    }

    /// Whether nothing of this style can be seen because it is switched off.
    pub(super) fn is_switched_off(&self) -> bool {
        !self.visible || self.opacity <= 0.0
    }

    /// Whether an area of this style is painted, if only with the colour of the paper.
    pub(super) fn fills(&self) -> bool {
        self.hidden_fill().is_none_or(|why| why == Hidden::Veil)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn styled(element: &str) -> Option<Ink> {
        let text = format!("<g {element}/>");
        let document = roxmltree::Document::parse(&text).unwrap();
        Ink::default().inside(document.root_element(), &[], &[]).map(|(ink, _)| ink)
    }

    #[test]
    fn what_nobody_sees_wherever_it_lies() {
        for (style, why) in [
            ("stroke='red'", None),
            ("", Some(Hidden::NoStroke)),
            ("stroke='red' style='stroke:none!important;stroke:blue'", Some(Hidden::NoStroke)),
            ("stroke='red' stroke-width='0mm'", Some(Hidden::NoWidth)),
            ("stroke='red' stroke-opacity='0%'", Some(Hidden::Transparent)),
            ("stroke='rgb(9 9 9 / 50%)'", None),
            ("stroke='red' visibility='collapse'", Some(Hidden::Switched)),
            ("stroke='red' mask='url(#m)'", Some(Hidden::Veil)),
            ("color='red' stroke='currentColor'", None),
            ("color='transparent' stroke='currentColor'", Some(Hidden::NoStroke)),
        ] {
            assert_eq!(styled(style).unwrap().hidden_stroke(), why, "{style}");
        }
        assert_eq!(styled("style='display: none'"), None);
    }

    #[test]
    fn dashes_are_lines_unless_they_leave_them_out() {
        let away = |dashes: &str, from: f64, length: f64| {
            styled(&format!("stroke-dasharray='{dashes}'")).unwrap().dashed_away(from, length)
        };
        assert!(!away("none", 0.0, 9.0) && !away("5", 3.0, 90.0) && !away("1 3", 0.0, 80.0));
        assert!(away("0 1000", 0.0, 80.0) && away("10,1000", 20.0, 80.0) && away("1 19", 2.0, 8.0));
        assert!(!away("10,1000", 0.0, 20.0) && !away("50 50", 40.0, 30.0) && away("50 50", 50.0, 50.0));
    }
}
