//! Every colour, size and font of a figure in one place.
//!
//! ```text
//!     ●═══ h5 ═════▸                   half-edge: shaft, barb on the face side, label
//!   (v3)───────────────(v2)            edge: thin, grey; vertex: disc with its name
//!       ◂════ h4 ══════●
//!              f3                      face: tint, label; outer face: hatch
//! ```
//!
//! The colours of lines and text have a contrast of at least 3 (text: 4.5) on the background and on every
//! tint, in the light and in the dark palette. The tints are the hues of Okabe and Ito, which people with any
//! colour vision can tell apart; they are far too pale for lines and never used for those.
//!
//! Source: Okabe and Ito, *Color Universal Design*, 2008; WCAG 2.1, 1.4.3 and 1.4.11.
//!
//! ```text
//!   file.rs  A style as a JSON file
//! ```

pub(crate) mod file;

use std::fmt::{self, Write};

/// A colour as 0xRRGGBB; prints as `#rrggbb`.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Colour(pub u32);

impl fmt::Display for Colour {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#{:06x}", self.0 & 0x00ff_ffff)
    }
}

/// The colours for one background.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub struct Palette {
    /// Paper, inside of vertex discs, halo of labels.
    pub background: Colour,
    /// Vertex discs and their names.
    pub ink: Colour,
    /// Shafts, barbs and labels of half-edges.
    pub half_edge: Colour,
    /// The line between two vertices.
    pub edge: Colour,
    /// Labels of faces.
    pub face: Colour,
    /// Hatch of the outer face and of hole faces.
    pub hatch: Colour,
    /// `next` arrows.
    pub next: Colour,
    /// `twin` arrows.
    pub twin: Colour,
    /// Arrows between vertices and half-edges: `outgoing`, `origin`.
    pub origin: Colour,
    /// What is wrong, missing or gone.
    pub wrong: Colour,
    /// Lines that are not what the drawing is about.
    pub dim: Colour,
    /// Text that is not what the drawing is about.
    pub grey: Colour,
    /// Behind a marked row of a table, and behind the names of records.
    pub hit: Colour,
    /// How much of a tint covers the background, 0 to 1.
    pub tint_opacity: f64,
}

/// How a figure looks. Lengths are px of the canvas. Change what you like of the [`Default`]:
///
/// ```
/// # use dcel_kit::figure::{Colour, Style};
/// let mut style = Style::default();
/// style.light.half_edge = Colour(0x0067a5);
/// style.dark = None;
/// ```
#[derive(Clone, PartialEq, Debug, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
#[non_exhaustive]
pub struct Style {
    /// Colours on a light page.
    #[serde(deserialize_with = "file::light")]
    pub light: Palette,
    /// Colours for readers who prefer dark pages; `None`: the light ones always.
    #[serde(deserialize_with = "file::dark")]
    pub dark: Option<Palette>,
    /// Hues of the faces, used in turn: f1 the first, f2 the second, unless a neighbour has it.
    #[serde(deserialize_with = "file::tints")]
    pub tints: [Colour; 7],
    /// The CSS list of font families. Default: DejaVu Sans and the common system fonts.
    pub font: String,
    /// Free band round the drawing when half-edges are drawn: 62.
    pub padding: f64,
    /// Free band round a drawing without half-edges: 30.
    pub small_padding: f64,
    /// Distance of a shaft from its edge: 7.5.
    pub offset: f64,
    /// Radius of a vertex disc: 9.5 (11 when names have three characters or more).
    pub vertex_radius: f64,
    /// Width of an edge: 1.5.
    pub edge_width: f64,
    /// Width of a shaft: 2.
    pub shaft_width: f64,
    /// Length of a barb: 11; it reaches half as far to the side.
    pub barb: f64,
    /// Size of vertex names: 9.5.
    pub vertex_text: f64,
    /// Size of half-edge labels: 9.5.
    pub half_edge_text: f64,
    /// Largest size of face labels: 17.
    pub face_text: f64,
    /// Largest size of face labels on a map, where edges are not drawn one by one: 11.
    pub map_text: f64,
    /// Distance of the hatch lines: 7.
    pub hatch_step: f64,
}

impl Default for Style {
    fn default() -> Self {
        Self {
            light: Palette {
                background: Colour(0x00ff_ffff),
                ink: Colour(0x001b_2430),
                half_edge: Colour(0x00b5_420a),
                edge: Colour(0x0077_7d86),
                face: Colour(0x006b_5300),
                hatch: Colour(0x00d5_d8dd),
                next: Colour(0x0000_67a5),
                twin: Colour(0x008a_2b7a),
                origin: Colour(0x0000_664d),
                wrong: Colour(0x00c8_102e),
                dim: Colour(0x00b3_b9c2),
                grey: Colour(0x005f_6671),
                hit: Colour(0x00fb_e6b8),
                tint_opacity: 0.13,
            },
            dark: Some(Palette {
                background: Colour(0x0015_181d),
                ink: Colour(0x00e8_eaee),
                half_edge: Colour(0x00ff_9a62),
                edge: Colour(0x00a0_a6b0),
                face: Colour(0x00e0_c46a),
                hatch: Colour(0x003a_3f48),
                next: Colour(0x006c_bcf5),
                twin: Colour(0x00e3_9ad6),
                origin: Colour(0x0056_d3ad),
                wrong: Colour(0x00ff_938b),
                dim: Colour(0x0056_5c66),
                grey: Colour(0x00b0_b6bf),
                hit: Colour(0x0046_3a1c),
                tint_opacity: 0.22,
            }),
            tints: [
                Colour(0x0000_72b2),
                Colour(0x00e6_9f00),
                Colour(0x0000_9e73),
                Colour(0x00cc_79a7),
                Colour(0x0056_b4e9),
                Colour(0x00d5_5e00),
                Colour(0x00f0_e442),
            ],
            font: "\"DejaVu Sans\",\"Segoe UI\",Helvetica,Arial,sans-serif".to_owned(),
            padding: 62.0,
            small_padding: 30.0,
            offset: 7.5,
            vertex_radius: 9.5,
            edge_width: 1.5,
            shaft_width: 2.0,
            barb: 11.0,
            vertex_text: 9.5,
            half_edge_text: 9.5,
            face_text: 17.0,
            map_text: 11.0,
            hatch_step: 7.0,
        }
    }
}

/// For which pages a figure is made.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
#[non_exhaustive]
pub enum Theme {
    /// Light, and dark for readers who prefer that.
    #[default]
    Auto,
    /// Always light.
    Light,
    /// Always dark.
    Dark,
}

impl Style {
    /// The same style for light pages, for dark ones, or for both.
    #[must_use]
    pub fn theme(self, theme: Theme) -> Self {
        match (theme, self.dark) {
            (Theme::Auto, dark) => Self { dark, ..self },
            (Theme::Dark, Some(dark)) => Self { light: dark, dark: None, ..self },
            (Theme::Light | Theme::Dark, _) => Self { dark: None, ..self },
        }
    }

    /// The same style with every number inside a range in which the layout works, and a font list that cannot
    /// end the style sheet.
    pub(crate) fn checked(&self) -> Self {
        let usual = Self::default();
        let pick = |value: f64, low: f64, high: f64, usual: f64| {
            if value.is_finite() { value.clamp(low, high) } else { usual }
        };
        let font: String = self.font.chars().filter(|c| !c.is_control() && !"{}<>;&\\".contains(*c)).collect();
        let palette = |p: &Palette| Palette { tint_opacity: pick(p.tint_opacity, 0.0, 1.0, 0.13), ..p.clone() };
        Self {
            light: palette(&self.light),
            dark: self.dark.as_ref().map(palette),
            tints: self.tints,
            font: if font.trim().is_empty() { usual.font } else { font },
            padding: pick(self.padding, 8.0, 500.0, usual.padding),
            small_padding: pick(self.small_padding, 8.0, 500.0, usual.small_padding),
            offset: pick(self.offset, 1.0, 50.0, usual.offset),
            vertex_radius: pick(self.vertex_radius, 1.0, 50.0, usual.vertex_radius),
            edge_width: pick(self.edge_width, 0.1, 20.0, usual.edge_width),
            shaft_width: pick(self.shaft_width, 0.1, 20.0, usual.shaft_width),
            barb: pick(self.barb, 1.0, 50.0, usual.barb),
            vertex_text: pick(self.vertex_text, 4.0, 60.0, usual.vertex_text),
            half_edge_text: pick(self.half_edge_text, 4.0, 60.0, usual.half_edge_text),
            face_text: pick(self.face_text, 4.0, 60.0, usual.face_text),
            map_text: pick(self.map_text, 4.0, 60.0, usual.map_text),
            hatch_step: pick(self.hatch_step, 2.0, 60.0, usual.hatch_step),
        }
    }

    /// The style sheet. Every selector begins with `#scope `, so that several figures can stand in one page.
    /// Literal colours only: CSS variables and `>` do not survive all renderers.
    pub(crate) fn css(&self, scope: &str) -> String {
        use crate::figure::canvas::number::drawn;
        let mut out = String::new();
        let halo = |width: &str| format!("paint-order:stroke;stroke-width:{width}em;stroke-linejoin:round");
        let fixed: [(&str, String); 14] = [
            ("text", format!("font-family:{};text-anchor:middle", self.font)),
            (".edge", format!("stroke-width:{};fill:none;stroke-linecap:round", drawn(self.edge_width))),
            (".mesh", "fill:none;stroke-linejoin:round".to_owned()),
            (".dots", "stroke-width:3;fill:none;stroke-linecap:round".to_owned()),
            (".hatch", "stroke-width:1.6".to_owned()),
            (".hatched", "opacity:.55".to_owned()),
            (".sh", format!("stroke-width:{};fill:none", drawn(self.shaft_width))),
            (".thin", format!("stroke-width:{}", drawn(0.5 * self.shaft_width))),
            (".vd", "stroke-width:1.8".to_owned()),
            (".vl", format!("font-weight:700;{}", halo(".26"))),
            (".hl", halo(".3")),
            (".fl", format!("font-style:italic;font-weight:700;{}", halo(".24"))),
            (".ll", format!("font-style:italic;font-weight:700;{}", halo(".24"))),
            (".leader", "stroke-width:1;fill:none;stroke-linecap:round".to_owned()),
        ];
        for (selector, properties) in fixed {
            rule(&mut out, scope, selector, &properties);
        }
        for (i, hue) in self.tints.iter().enumerate() {
            rule(&mut out, scope, &format!(".t{i}"), &format!("fill:{hue}"));
        }
        self.in_both(&mut out, |out, palette| colours(out, scope, palette));
        out
    }

    /// Adds the rules of the light palette, and those of the dark one for readers who prefer that.
    pub(crate) fn in_both(&self, out: &mut String, mut rules: impl FnMut(&mut String, &Palette)) {
        rules(out, &self.light);
        if let Some(dark) = &self.dark {
            out.push_str("@media (prefers-color-scheme:dark){\n");
            rules(out, dark);
            out.push_str("}\n");
        }
    }
}

/// Adds the rule of a selector.
pub(crate) fn rule(out: &mut String, scope: &str, selector: &str, properties: &str) {
    let _ = writeln!(out, "#{scope} {selector}{{{properties}}}");
}

fn colours(out: &mut String, scope: &str, palette: &Palette) {
    let Palette { background, ink, half_edge, edge, face, hatch, tint_opacity, .. } = palette;
    let rules = [
        (".bg", format!("fill:{background}")),
        (".face", format!("fill-opacity:{}", crate::figure::canvas::number::drawn(*tint_opacity))),
        (".edge", format!("stroke:{edge}")),
        (".mesh", format!("stroke:{edge}")),
        (".hatch", format!("stroke:{hatch}")),
        (".sh", format!("stroke:{half_edge}")),
        (".barb", format!("fill:{half_edge}")),
        (".vd", format!("fill:{background};stroke:{ink}")),
        (".dot", format!("fill:{ink}")),
        (".dots", format!("stroke:{ink}")),
        (".vl", format!("fill:{ink};stroke:{background}")),
        (".hl", format!("fill:{half_edge};stroke:{background}")),
        (".fl", format!("fill:{face};stroke:{background}")),
        (".ll", format!("fill:{face};stroke:{background}")),
        (".leader", format!("stroke:{face}")),
        (".root", format!("fill:{face}")),
    ];
    for (selector, properties) in rules {
        rule(out, scope, selector, &properties);
    }
}
