//! Judging functions that give a value back: most of what many labs ask for.
//!
//! ```text
//!   left_turn 0 0 4 0 1 3     ──▶  the student's program says  returned #-1
//!                             ──▶  the reference says          #1: the points turn left
//!                             ──▶  "left_turn 0 0 4 0 1 3 returned -1, expected 1: the points turn left"
//! ```
//!
//! A judge lists its [`Function`]s, with a reference for each, and calls [`judge`]. Calls that panic, do not come back
//! or lead nowhere are told here, the same for every lab.

use super::fault::{Exchange, Fault, FaultKind, Instead, exchanges};
use super::protocol::{CallEnd, Case, CaseAnswer, Structure, Value};

/// How many characters of what was returned stand in a sentence.
const SHOWN: usize = 200;

/// A function of the lab, and what is right of it.
pub struct Function {
    /// Its word in a case.
    pub word: &'static str,
    /// The graded test that its answers decide.
    pub test: &'static str,
    /// What is wrong with the values that a call gave back; nothing if they are right.
    pub wrong: fn(&Exchange, &[Value]) -> Option<Wrong>,
}

/// What is wrong with an answer.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Wrong {
    /// What tells this mistake from others of the same function, in a word; the same however things are numbered.
    pub tag: String,
    /// What was expected, as it stands in a sentence; nothing if a sentence without it is better.
    pub expected: Option<String>,
    /// Why, as the end of a sentence.
    pub because: String,
    /// All that holds of the wrong value: `the opposite sign`. What says most comes first.
    pub is: Vec<&'static str>,
}

impl Wrong {
    /// Another value was expected.
    pub fn value(expected: &Value, because: impl Into<String>) -> Self {
        Self { expected: Some(expected.words()), ..Self::because("value", because) }
    }

    /// What was returned breaks a promise.
    pub fn because(tag: &str, because: impl Into<String>) -> Self {
        Self { tag: tag.to_owned(), because: because.into(), ..Self::default() }
    }

    /// The value is none that the function can give.
    #[must_use]
    pub fn kind(wanted: &str) -> Self {
        Self::because("type", format!("that is not {wanted}"))
    }

    /// With what holds of the wrong value.
    #[must_use]
    pub fn is(mut self, all: impl IntoIterator<Item = (bool, &'static str)>) -> Self {
        self.is.extend(all.into_iter().filter(|(holds, _)| *holds).map(|(_, words)| words));
        self
    }
}

/// What is wrong with the answers to a case, as far as it calls these functions.
#[must_use]
pub fn judge(functions: &[Function], case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
    exchanges(case, answer).iter().filter_map(|exchange| fault(functions, exchange)).collect()
}

/// What is wrong with one call; nothing if it calls none of these functions.
#[must_use]
pub fn fault(functions: &[Function], exchange: &Exchange) -> Option<Fault> {
    let function = functions.iter().find(|function| function.word == exchange.function)?;
    let call = exchange.line();
    let fault = |kind, tag: &str, words| Fault::new(function.test, kind, exchange.step, [function.word, tag], words);
    let Some((_, end)) = exchange.called else {
        let words = format!("{call}: a link of it is not set");
        return Some(fault(FaultKind::Wrong, "unresolved", words));
    };
    let values = match end {
        CallEnd::Returned(values) => values,
        end => {
            let kind = FaultKind::of_end(end)?;
            return Some(fault(kind, "end", format!("{call} {}", end.words())));
        }
    };
    let wrong = (function.wrong)(exchange, values)?;
    let because = if wrong.because.is_empty() { String::new() } else { format!(": {}", wrong.because) };
    let expected = wrong.expected.map_or_else(String::new, |expected| format!(", expected {}", cut(&expected)));
    let words = format!("{call} returned {}{expected}{because}", listed(values));
    let tag = format!("{} {}", wrong.tag, outline(values, exchange));
    let fault = fault(FaultKind::Wrong, &tag, words);
    let instead = (!wrong.is.is_empty()).then(|| Instead { subject: "the answer".to_owned(), is: wrong.is });
    Some(Fault { instead, ..fault })
}

/// What was returned, so that it tells a mistake from others which are wrong in the same calls: the same however new
/// elements are numbered, and however sums are rounded. Numbers are compared with the greatest beside them.
fn outline(values: &[Value], exchange: &Exchange) -> String {
    fn numbers(all: &[f64]) -> String {
        const STEPS: f64 = 1e4;
        let most = all.iter().filter(|x| x.is_finite()).fold(0.0, |most: f64, x| most.max(x.abs()));
        let least = f64::MIN_POSITIVE;
        let one = |x: f64| if x.is_finite() { (x / most.max(least) * STEPS).round() as i64 } else { i64::MAX };
        let size = most.max(least).log2().round();
        all.iter().fold(format!("2^{size}"), |out, &x| format!("{out} {}", one(x)))
    }
    let given = exchange.structure_before.map_or(0, Structure::len);
    let one = |value: &Value| match value {
        Value::Id(id) if (*id as usize) < given => format!("{id}"),
        Value::Id(_) => "new".to_owned(),
        Value::Number(x) if x.fract() == 0.0 => format!("#{x}"),
        Value::Number(x) => format!("#{}", numbers(&[*x])),
        Value::List(all) => format!("[{}]", outline(all, exchange)),
        Value::Polygon(corners) => format!("<{}>", numbers(corners.as_flattened())),
        Value::Refusal(why) => format!("no {why}"),
        Value::Truth(truth) => truth.to_string(),
        Value::Point(_) | Value::Structure(_) => String::new(),
    };
    let places = values.iter().filter_map(|value| if let Value::Point(place) = value { Some(place) } else { None });
    let places: Vec<f64> = places.flatten().copied().collect();
    let places = if places.is_empty() { String::new() } else { format!("({})", numbers(&places)) };
    values.iter().map(one).chain([places]).collect::<Vec<_>>().join(" ")
}

/// Values as they stand in a sentence.
#[must_use]
pub fn listed(values: &[Value]) -> String {
    let words: Vec<String> = values.iter().map(Value::words).collect();
    if words.is_empty() { "nothing".to_owned() } else { cut(&words.join(" ")) }
}

fn cut(text: &str) -> String {
    let mut out: String = text.chars().take(SHOWN).collect();
    if out.len() < text.len() {
        out.push_str(" …");
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::{Called, Reply, Start, Step};

    const FUNCTIONS: &[Function] = &[Function {
        word: "twice",
        test: "doubling",
        wrong: |exchange, values| {
            let expected = 2.0 * exchange.numbers()[0];
            let [Value::Number(found)] = values else { return Some(Wrong::kind("one number")) };
            let wrong = Wrong::value(&Value::Number(expected), "two times the number");
            (*found - expected != 0.0).then(|| wrong.is([(*found + expected == 0.0, "the opposite sign")]))
        },
    }];

    fn said(end: CallEnd) -> Option<Fault> {
        let case = Case::new("x", Start::none()).step(Step::of_line("twice 4"));
        let reply = Reply::Called(Called { arguments: vec![4], end });
        let answer = CaseAnswer { replies: vec![reply], complete: true, broken: None };
        judge(FUNCTIONS, &case, &answer).pop()
    }

    #[test]
    fn right_answers_pass_and_wrong_ones_are_told_with_the_reason() {
        let returned = |x| said(CallEnd::Returned(vec![Value::Number(x)]));
        assert_eq!(returned(8.0), None);
        let fault = returned(-8.0).unwrap();
        assert_eq!(fault.words, "twice 4 returned -8, expected 8: two times the number");
        assert_eq!(
            (fault.test, fault.kind.clone(), fault.instead.unwrap().is),
            ("doubling", FaultKind::Wrong, vec!["the opposite sign"])
        );
        let tag = |x| returned(x).unwrap().tag;
        assert_ne!(tag(9.0), tag(-8.0), "other values are other mistakes");
        assert_eq!(tag(7.1), tag(7.1 + 1e-12), "however they are rounded");
        let of_places = |x| {
            let places = vec![Value::Point(vec![x, 1.0]), Value::Point(vec![-2.0, 5.0])];
            said(CallEnd::Returned(places)).unwrap().tag
        };
        assert_eq!(of_places(0.0), of_places(6e-17), "nothing, but for rounding");
        assert_ne!(of_places(0.0), of_places(0.5));
        let of_polygon = |corners| said(CallEnd::Returned(vec![Value::Polygon(corners)])).unwrap().tag;
        let large = |x| of_polygon(vec![[x, 0.0], [4e6, 3e6]]);
        assert_eq!(large(1e6), large(1e6 + 1e-7), "rounding grows with the numbers");
        let small = |x| of_polygon(vec![[x, 0.0], [4e-6, 3e-6]]);
        assert_ne!(small(1e-6), small(2e-6), "what matters shrinks with them");
        let of_ids = |id| said(CallEnd::Returned(vec![Value::Id(id)])).unwrap().tag;
        assert_eq!(of_ids(5), of_ids(6), "new elements have any numbers");
        let nothing = said(CallEnd::Returned(Vec::new())).unwrap();
        assert_eq!(nothing.words, "twice 4 returned nothing: that is not one number");
        let message = "attempt to divide by zero".to_owned();
        let crashed = said(CallEnd::Panicked { message, place: None }).unwrap();
        assert_eq!(crashed.words, "twice 4 panicked: attempt to divide by zero");
        let message = "not yet implemented: twice".to_owned();
        assert_eq!(said(CallEnd::Panicked { message, place: None }).unwrap().kind, FaultKind::Unattempted);
    }
}
