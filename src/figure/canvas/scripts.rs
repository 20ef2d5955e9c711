//! Labels as they are written in books: `e_1` is e₁, `x_{12}` is x₁₂, `x^2` is x².
//!
//! ```text
//!   e_1  v_12  x_{12}  r^2      one letter, then _ or ^, then digits, one letter, or anything in braces
//!   living_room  a_b_c  \_      stay as they are
//! ```
//!
//! The small letters are characters of their own (Unicode's sub- and superscripts), so that a label stays text: it can be
//! searched, copied, and measured as any other. What has no such character stays as it was written.

/// Characters; the same below; the same above. A space where there is none.
const PLAIN: &str = "0123456789+-=()aehijklmnoprstuvx−,'";
const BELOW: &str = "₀₁₂₃₄₅₆₇₈₉₊₋₌₍₎ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ₋  ";
const ABOVE: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾   ⁱ    ⁿ        ⁻ ′";

/// Each character with the one below and the one above.
fn small() -> impl Iterator<Item = (char, char, char)> {
    PLAIN.chars().zip(BELOW.chars()).zip(ABOVE.chars()).map(|((plain, below), above)| (plain, below, above))
}

/// The label as it is drawn.
pub(in crate::figure) fn typeset(label: &str) -> String {
    label.split_inclusive(' ').map(word).collect()
}

/// One word, perhaps with a space at its end.
fn word(word: &str) -> String {
    let (bare, space) = word.strip_suffix(' ').map_or((word, ""), |bare| (bare, " "));
    let mut letters = bare.chars();
    let (base, sign) = (letters.next(), letters.next());
    let rest = letters.as_str();
    let is_above = match sign {
        Some('_') => false,
        Some('^') => true,
        _ => return word.to_owned(),
    };
    let inside = rest.strip_prefix('{').and_then(|rest| rest.strip_suffix('}'));
    let is_short = rest.chars().count() == 1 || rest.bytes().all(|b| b.is_ascii_digit());
    let Some(inside) = inside.or(is_short.then_some(rest)).filter(|inside| !inside.is_empty()) else {
        return word.to_owned();
    };
    let small_of = |c: char| {
        let (_, below, above) = small().find(|(plain, ..)| *plain == c)?;
        Some(if is_above { above } else { below }).filter(|c| *c != ' ')
    };
    match (base.filter(|c| c.is_alphabetic()), inside.chars().map(small_of).collect::<Option<String>>()) {
        (Some(base), Some(small)) => format!("{base}{small}{space}"),
        _ => word.to_owned(),
    }
}

/// The text as TeX writes it, of text with small letters.
pub(super) fn tex_of(c: char) -> Option<(char, bool)> {
    let found = small().find(|(_, below, above)| c != ' ' && (*below == c || *above == c));
    found.map(|(plain, _, above)| (plain, above == c))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_with_numbers_below_and_above_are_set_and_names_are_not() {
        for (label, drawn) in [
            ("e_1", "e₁"),
            ("v_12", "v₁₂"),
            ("x_{12}", "x₁₂"),
            ("x_i", "xᵢ"),
            ("x_{i+1}", "xᵢ₊₁"),
            ("r^2", "r²"),
            ("π_0 of f_2", "π₀ of f₂"),
            ("living_room", "living_room"),
            ("a_b_c", "a_b_c"),
            ("room_1", "room_1"),
            ("x_", "x_"),
            ("x_{}", "x_{}"),
            ("x_{1", "x_{1"),
            ("x_q", "x_q"),
            ("x_1y", "x_1y"),
            ("_1", "_1"),
            ("1_2", "1_2"),
            ("", ""),
        ] {
            assert_eq!(typeset(label), drawn);
        }
        assert_eq!(tex_of('₃'), Some(('3', false)));
        assert_eq!(tex_of('²'), Some(('2', true)));
        assert_eq!(tex_of(' '), None);
    }
}
