//! Colours as CSS writes them.
//!
//! ```text
//!   teal   #abc   #aabbcc80   rgb(10%, 0%, 0%)   rgb(0 0 0 / 50%)   hsl(120 50% 50%)   currentColor   url(#hatch)
//! ```

use super::numbers::Reader;

/// What an area or a line is painted with.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Paint {
    None,
    /// `url(#...)`: a hatch or a gradient.
    Pattern,
    /// Red, green, blue, and how much of what lies below it covers.
    Colour([u8; 3], f64),
    /// The value of the property `color`.
    Current,
    /// A colour that is not worked out, and so can be seen.
    Some,
}

/// The value of `fill`, `stroke` or `color`.
pub(super) fn paint(text: &str) -> Paint {
    let text = text.trim().to_ascii_lowercase();
    if let Some(digits) = text.strip_prefix('#') {
        return hexadecimal(digits).unwrap_or(Paint::Some);
    }
    if text.starts_with("url(") {
        return Paint::Pattern;
    }
    if let Some((name, rest)) = text.split_once('(') {
        let inside = rest.strip_suffix(')').unwrap_or(rest);
        return match name {
            "rgb" | "rgba" => rgb(inside),
            "hsl" | "hsla" => hsl(inside),
            "hwb" => hwb(inside),
            // Nobody who only looks has asked for the dark one.
            "light-dark" => light(inside).map(paint),
            _ => None,
        }
        .unwrap_or(Paint::Some);
    }
    match text.as_str() {
        "none" | "transparent" => Paint::None,
        "currentcolor" => Paint::Current,
        name => match NAMES.binary_search_by(|(other, _)| (*other).cmp(name)) {
            Ok(i) => solid(NAMES[i].1),
            Err(_) => Paint::Some,
        },
    }
}

fn solid(rgb: u32) -> Paint {
    let [_, r, g, b] = rgb.to_be_bytes();
    Paint::Colour([r, g, b], 1.0)
}

/// A colour that covers this much; nothing at all is no paint.
fn covering(rgb: [f64; 3], alpha: f64) -> Paint {
    let rgb = rgb.map(|c| c.clamp(0.0, 255.0).round() as u8);
    if alpha > 0.0 { Paint::Colour(rgb, alpha.min(1.0)) } else { Paint::None }
}

/// `abc`, `abcd`, `aabbcc` or `aabbccdd`.
fn hexadecimal(digits: &str) -> Option<Paint> {
    let short = matches!(digits.len(), 3 | 4);
    if !(short || matches!(digits.len(), 6 | 8)) || !digits.bytes().all(|b| b.is_ascii_hexdigit()) {
        return None;
    }
    let width = if short { 1 } else { 2 };
    let parts = (0..digits.len() / width).map(|i| u8::from_str_radix(&digits[i * width..(i + 1) * width], 16));
    let parts: Vec<u8> = parts.collect::<Result<_, _>>().ok()?;
    let part = |i: usize| f64::from(if short { parts[i] * 17 } else { parts[i] });
    let alpha = if parts.len() > 3 { part(3) / 255.0 } else { 1.0 };
    Some(covering([part(0), part(1), part(2)], alpha))
}

/// Three parts and perhaps a fourth, each a number or a percentage of what stands in `wholes`.
fn parts(text: &str, wholes: [f64; 4]) -> Option<[f64; 4]> {
    let mut reader = Reader::new(text);
    let mut out = Vec::new();
    while !reader.at_end() {
        if out.len() == 3 {
            // A slash stands before the opacity.
            let _ = reader.sign(b'/');
        }
        let value = reader.number()?;
        let whole = *wholes.get(out.len())?;
        if reader.is_next("deg") {
            reader.word();
        }
        out.push(if reader.percent() { value * whole / 100.0 } else { value });
    }
    if out.len() == 3 {
        out.push(1.0);
    }
    out.try_into().ok()
}

fn rgb(text: &str) -> Option<Paint> {
    let [r, g, b, alpha] = parts(text, [255.0, 255.0, 255.0, 1.0])?;
    Some(covering([r, g, b], alpha))
}

/// A colour of a hue in degrees: each channel by where the pure hue has it, from -1 for all of it to 1 for nothing.
fn of_hue(hue: f64, alpha: f64, channel: impl Fn(f64) -> f64) -> Paint {
    let rgb = [0.0, 8.0, 4.0].map(|n| {
        let k = (n + hue.rem_euclid(360.0) / 30.0) % 12.0;
        255.0 * channel((k - 3.0).min(9.0 - k).clamp(-1.0, 1.0))
    });
    covering(rgb, alpha)
}

fn hsl(text: &str) -> Option<Paint> {
    let [hue, saturation, light, alpha] = parts(text, [360.0, 1.0, 1.0, 1.0])?;
    let light = light.clamp(0.0, 1.0);
    let reach = saturation.clamp(0.0, 1.0) * light.min(1.0 - light);
    Some(of_hue(hue, alpha, |pure| light - reach * pure))
}

/// The first of two colours: the comma between them stands within no brackets.
fn light(text: &str) -> Option<&str> {
    let mut depth = 0;
    let comma = text.find(|c: char| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        depth == 0 && c == ','
    })?;
    Some(&text[..comma])
}

fn hwb(text: &str) -> Option<Paint> {
    let [hue, white, black, alpha] = parts(text, [360.0, 1.0, 1.0, 1.0])?;
    let (white, black) = (white.clamp(0.0, 1.0), black.clamp(0.0, 1.0));
    let sum = (white + black).max(1.0);
    let (white, black) = (white / sum, black / sum);
    Some(of_hue(hue, alpha, |pure| white + (0.5 - 0.5 * pure) * (1.0 - white - black)))
}

/// The named colours of CSS, sorted by name (W3C, CSS Color Module Level 4, section 6.1).
#[rustfmt::skip]
const NAMES: [(&str, u32); 148] = [
    ("aliceblue", 0xf0f8ff), ("antiquewhite", 0xfaebd7), ("aqua", 0x00ffff), ("aquamarine", 0x7fffd4),
    ("azure", 0xf0ffff), ("beige", 0xf5f5dc), ("bisque", 0xffe4c4), ("black", 0x000000), ("blanchedalmond", 0xffebcd),
    ("blue", 0x0000ff), ("blueviolet", 0x8a2be2), ("brown", 0xa52a2a), ("burlywood", 0xdeb887),
    ("cadetblue", 0x5f9ea0), ("chartreuse", 0x7fff00), ("chocolate", 0xd2691e), ("coral", 0xff7f50),
    ("cornflowerblue", 0x6495ed), ("cornsilk", 0xfff8dc), ("crimson", 0xdc143c), ("cyan", 0x00ffff),
    ("darkblue", 0x00008b), ("darkcyan", 0x008b8b), ("darkgoldenrod", 0xb8860b), ("darkgray", 0xa9a9a9),
    ("darkgreen", 0x006400), ("darkgrey", 0xa9a9a9), ("darkkhaki", 0xbdb76b), ("darkmagenta", 0x8b008b),
    ("darkolivegreen", 0x556b2f), ("darkorange", 0xff8c00), ("darkorchid", 0x9932cc), ("darkred", 0x8b0000),
    ("darksalmon", 0xe9967a), ("darkseagreen", 0x8fbc8f), ("darkslateblue", 0x483d8b), ("darkslategray", 0x2f4f4f),
    ("darkslategrey", 0x2f4f4f), ("darkturquoise", 0x00ced1), ("darkviolet", 0x9400d3), ("deeppink", 0xff1493),
    ("deepskyblue", 0x00bfff), ("dimgray", 0x696969), ("dimgrey", 0x696969), ("dodgerblue", 0x1e90ff),
    ("firebrick", 0xb22222), ("floralwhite", 0xfffaf0), ("forestgreen", 0x228b22), ("fuchsia", 0xff00ff),
    ("gainsboro", 0xdcdcdc), ("ghostwhite", 0xf8f8ff), ("gold", 0xffd700), ("goldenrod", 0xdaa520),
    ("gray", 0x808080), ("green", 0x008000), ("greenyellow", 0xadff2f), ("grey", 0x808080), ("honeydew", 0xf0fff0),
    ("hotpink", 0xff69b4), ("indianred", 0xcd5c5c), ("indigo", 0x4b0082), ("ivory", 0xfffff0), ("khaki", 0xf0e68c),
    ("lavender", 0xe6e6fa), ("lavenderblush", 0xfff0f5), ("lawngreen", 0x7cfc00), ("lemonchiffon", 0xfffacd),
    ("lightblue", 0xadd8e6), ("lightcoral", 0xf08080), ("lightcyan", 0xe0ffff), ("lightgoldenrodyellow", 0xfafad2),
    ("lightgray", 0xd3d3d3), ("lightgreen", 0x90ee90), ("lightgrey", 0xd3d3d3), ("lightpink", 0xffb6c1),
    ("lightsalmon", 0xffa07a), ("lightseagreen", 0x20b2aa), ("lightskyblue", 0x87cefa), ("lightslategray", 0x778899),
    ("lightslategrey", 0x778899), ("lightsteelblue", 0xb0c4de), ("lightyellow", 0xffffe0), ("lime", 0x00ff00),
    ("limegreen", 0x32cd32), ("linen", 0xfaf0e6), ("magenta", 0xff00ff), ("maroon", 0x800000),
    ("mediumaquamarine", 0x66cdaa), ("mediumblue", 0x0000cd), ("mediumorchid", 0xba55d3), ("mediumpurple", 0x9370db),
    ("mediumseagreen", 0x3cb371), ("mediumslateblue", 0x7b68ee), ("mediumspringgreen", 0x00fa9a),
    ("mediumturquoise", 0x48d1cc), ("mediumvioletred", 0xc71585), ("midnightblue", 0x191970), ("mintcream", 0xf5fffa),
    ("mistyrose", 0xffe4e1), ("moccasin", 0xffe4b5), ("navajowhite", 0xffdead), ("navy", 0x000080),
    ("oldlace", 0xfdf5e6), ("olive", 0x808000), ("olivedrab", 0x6b8e23), ("orange", 0xffa500),
    ("orangered", 0xff4500), ("orchid", 0xda70d6), ("palegoldenrod", 0xeee8aa), ("palegreen", 0x98fb98),
    ("paleturquoise", 0xafeeee), ("palevioletred", 0xdb7093), ("papayawhip", 0xffefd5), ("peachpuff", 0xffdab9),
    ("peru", 0xcd853f), ("pink", 0xffc0cb), ("plum", 0xdda0dd), ("powderblue", 0xb0e0e6), ("purple", 0x800080),
    ("rebeccapurple", 0x663399), ("red", 0xff0000), ("rosybrown", 0xbc8f8f), ("royalblue", 0x4169e1),
    ("saddlebrown", 0x8b4513), ("salmon", 0xfa8072), ("sandybrown", 0xf4a460), ("seagreen", 0x2e8b57),
    ("seashell", 0xfff5ee), ("sienna", 0xa0522d), ("silver", 0xc0c0c0), ("skyblue", 0x87ceeb),
    ("slateblue", 0x6a5acd), ("slategray", 0x708090), ("slategrey", 0x708090), ("snow", 0xfffafa),
    ("springgreen", 0x00ff7f), ("steelblue", 0x4682b4), ("tan", 0xd2b48c), ("teal", 0x008080), ("thistle", 0xd8bfd8),
    ("tomato", 0xff6347), ("turquoise", 0x40e0d0), ("violet", 0xee82ee), ("wheat", 0xf5deb3), ("white", 0xffffff),
    ("whitesmoke", 0xf5f5f5), ("yellow", 0xffff00), ("yellowgreen", 0x9acd32),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_are_read_in_every_form() {
        for white in
            ["#fff", "#FFFFFF", " white ", "rgb(255, 255 255)", "#ffffffff", "rgb(100%,100%,100%)", "hsl(9 0% 100%)"]
        {
            assert_eq!(paint(white), Paint::Colour([255; 3], 1.0), "{white}");
        }
        for none in [
            "none",
            "transparent",
            "#0000",
            "#12345600",
            "rgb(1 2 3 / 0)",
            "rgba(9,9,9,0%)",
            "hwb(0 0% 0% / 0)",
            "light-dark(none, red)",
        ] {
            assert_eq!(paint(none), Paint::None, "{none}");
        }
        for green in
            ["rgb(0 128 0 / 50%)", "rgba(0, 128, 0, .5)", "hsl(120deg 100% 25.1% / 0.5)", "hwb(120 0% 49.8% / .5)"]
        {
            assert_eq!(paint(green), Paint::Colour([0, 128, 0], 0.5), "{green}");
        }
        assert_eq!(paint("Teal"), Paint::Colour([0, 128, 128], 1.0));
        assert_eq!(paint("currentColor"), Paint::Current);
        assert_eq!(paint("url(#hatch) red"), Paint::Pattern);
        for other in ["teall", "#12", "#ggg", "rgb(1,2)", "rgb(1 2 3 4 5)", "#é1", "lab(1 2 3)"] {
            assert_eq!(paint(other), Paint::Some, "{other}");
        }
    }

    #[test]
    fn the_names_are_sorted() {
        assert!(NAMES.windows(2).all(|w| w[0].0 < w[1].0));
    }
}
