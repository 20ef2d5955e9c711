//! What things are for, and how one sees it: a colour, a dash and a mark each.
//!
//! ```text
//!   Main ━━━ ●     Secondary ━ ━ ■     Start ━ ╍ ▲     Goal ╍╍╍ ★     Event ┅┅┅ ◆
//!   Right ━━ ✓     Wrong ┅┅┅ ✕         Plain ─── •     Dimmed ─── ○
//! ```
//!
//! The colours are those of the palette, so that a path of a sketch and an arrow of a structure figure agree. No
//! two roles have the same dash and mark: the picture can be read without any colour.

use super::glyph::Glyph;
use crate::figure::FigureOptions;
use crate::figure::canvas::number::drawn;
use crate::figure::canvas::style::{Colour, Palette, rule};

crate::named! {
    /// What a thing is for.
    #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
    #[non_exhaustive]
    pub enum Role {
        /// Walls, sites, sweep lines: what the picture is made of. Ink.
        #[default]
        Plain = "r-plain",
        /// What the picture is about: the path, the result. Blue.
        Main = "r-main",
        /// What the main thing is compared with or made from: portals, the dual. Orange, long dashes.
        Secondary = "r-secondary",
        /// Where something begins. Green, dashes and dots; a triangle.
        Start = "r-start",
        /// Where it is to end. Purple, short dashes; a star.
        Goal = "r-goal",
        /// Where something happens: a sweep's events, a funnel's corners. Ochre, dots; a diamond.
        Event = "r-event",
        /// What is as it should be. Green, very long dashes; a tick.
        Right = "r-right",
        /// What is not as it should be. Red, short dashes; a cross.
        Wrong = "r-wrong",
        /// What is there, but not looked at. Grey.
        Dimmed = "r-dimmed",
    }

    /// The class of everything in this role.
    fn class;
    /// All of them.
    const ALL;
}

impl Role {
    /// The mark of its points.
    #[must_use]
    pub const fn glyph(self) -> Glyph {
        match self {
            Self::Plain => Glyph::Dot,
            Self::Main => Glyph::Disc,
            Self::Secondary => Glyph::Square,
            Self::Start => Glyph::Triangle,
            Self::Goal => Glyph::Star,
            Self::Event => Glyph::Diamond,
            Self::Right => Glyph::Tick,
            Self::Wrong => Glyph::Cross,
            Self::Dimmed => Glyph::Ring,
        }
    }

    /// Lengths of dashes and gaps of its lines; none: the line is solid.
    #[must_use]
    pub const fn dash(self) -> Option<&'static str> {
        match self {
            Self::Plain | Self::Main | Self::Dimmed => None,
            Self::Secondary => Some("9 3"),
            Self::Start => Some("11 3 2.5 3"),
            Self::Goal => Some("5 2.5"),
            Self::Event => Some("2 2.5"),
            Self::Right => Some("17 3"),
            Self::Wrong => Some("3.5 2.5"),
        }
    }

    /// The width of its lines in px.
    pub(in crate::figure) const fn width(self) -> f64 {
        match self {
            Self::Main | Self::Right | Self::Wrong => 2.6,
            Self::Plain | Self::Dimmed => 1.4,
            Self::Secondary | Self::Start | Self::Goal | Self::Event => 2.0,
        }
    }

    /// The colour of its lines and marks.
    #[must_use]
    pub const fn line(self, palette: &Palette) -> Colour {
        match self {
            Self::Plain => palette.ink,
            Self::Main => palette.next,
            Self::Secondary => palette.half_edge,
            Self::Start | Self::Right => palette.origin,
            Self::Goal => palette.twin,
            Self::Event => palette.face,
            Self::Wrong => palette.wrong,
            Self::Dimmed => palette.dim,
        }
    }

    /// The colour of its areas, of which [`Palette::tint_opacity`] is seen.
    #[must_use]
    pub const fn fill(self, palette: &Palette) -> Colour {
        match self {
            Self::Plain => palette.edge,
            other => other.line(palette),
        }
    }

    /// The colour of its words: that of its lines, unless those are dimmed.
    #[must_use]
    pub const fn text(self, palette: &Palette) -> Colour {
        match self {
            Self::Dimmed => palette.grey,
            other => other.line(palette),
        }
    }
}

/// The style rules of sketches: those of the options and those of the roles.
pub(super) fn css(options: &FigureOptions, roles: &[Role]) -> String {
    let scope = options.prefix();
    let mut out = options.css();
    let mut fixed = |selector: &str, properties: &str| rule(&mut out, &scope, selector, properties);
    let halo = "paint-order:stroke;stroke-linejoin:round";
    fixed(".ln", "fill:none;stroke-linejoin:round");
    fixed(".ol", "fill:none;stroke-width:1.2;stroke-linejoin:round");
    fixed(".many", "fill:none;stroke-linecap:round;stroke-linejoin:round");
    fixed(".po", "fill:none;stroke-width:4;stroke-linecap:round");
    fixed(".gl", "stroke-width:1;stroke-linejoin:round");
    fixed(".go", "stroke-width:1.8");
    fixed(".gs", "fill:none;stroke-width:2.6;stroke-linecap:round");
    fixed(".gt", "fill:none;stroke-width:1.8;stroke-linecap:round;stroke-linejoin:round");
    fixed(".tie", "fill:none;stroke-width:1");
    fixed(".frame", "fill:none;stroke-width:1");
    fixed(".tx", &format!("{halo};stroke-width:.3em"));
    fixed(".start", "text-anchor:start");
    fixed(".bn", "font-weight:700");
    fixed(".ct", "font-weight:700;text-anchor:start");
    fixed(".cs", "text-anchor:start");
    fixed(".cm", "text-anchor:middle");
    for role in roles {
        fixed(&format!(".{} .ln", role.class()), &format!("stroke-width:{}", drawn(role.width())));
        if let Some(dash) = role.dash() {
            fixed(&format!(".{} .ln", role.class()), &format!("stroke-dasharray:{dash}"));
        }
    }
    fixed(".sk .solid", "stroke-dasharray:none");
    fixed(".sk .dashed", "stroke-dasharray:6 4");
    options.style.in_both(&mut out, |out, palette| colours(out, &scope, palette, roles));
    out
}

fn colours(out: &mut String, scope: &str, palette: &Palette, roles: &[Role]) {
    let mut rule = |selector: &str, properties: String| rule(out, scope, selector, &properties);
    let Palette { background, ink, dim, grey, tint_opacity, .. } = palette;
    // Over the tints of a structure, areas are paler: lines must be seen on both together.
    rule(".fi", format!("fill-opacity:{}", drawn(*tint_opacity)));
    rule(".over .fi", format!("fill-opacity:{}", drawn(0.5 * tint_opacity)));
    rule(".gt", format!("stroke:{background}"));
    rule(".bn", format!("fill:{background}"));
    for class in [".ct", ".cs", ".cm"] {
        rule(class, format!("fill:{ink}"));
    }
    rule(".frame", format!("stroke:{dim}"));
    for (class, property, colour) in [
        (".sh", "stroke", dim),
        (".barb", "fill", dim),
        (".edge", "stroke", dim),
        (".mesh", "stroke", dim),
        (".dot", "fill", dim),
        (".vd", "stroke", dim),
        (".hl", "fill", grey),
        (".vl", "fill", grey),
        (".fl", "fill", grey),
        (".ll", "fill", grey),
    ] {
        rule(&format!(".under {class}"), format!("{property}:{colour}"));
    }
    for role in roles {
        let (class, line, text) = (role.class(), role.line(palette), role.text(palette));
        for part in ["ln", "ol", "po", "gs", "tie", "many"] {
            rule(&format!(".{class} .{part}"), format!("stroke:{line}"));
        }
        rule(&format!(".{class} .fi"), format!("fill:{}", role.fill(palette)));
        rule(&format!(".{class} .gl"), format!("fill:{line};stroke:{background}"));
        rule(&format!(".{class} .go"), format!("fill:{background};stroke:{line}"));
        rule(&format!(".{class} .tx"), format!("fill:{text};stroke:{background}"));
    }
}
