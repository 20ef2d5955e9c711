//! Values that a call gives back, as they are written in an answer.
//!
//! ```text
//!   id         12                      number    #0.1            point     (0.5,2)   (0,0,1)
//!   yes or no  true                    polygon   <0,0 4,0 3,3>   refusal   refused "the points are on one line"
//!   list       1 2 3   inside another: [1 2 3]                   structure structure, its lines follow as a dump
//! ```

use super::structure::Structure;
use super::text::{GREATEST, id, quoted};

/// How many values a call may return, those inside of lists counted.
const VALUES: usize = 20_000;
/// How deep lists may lie in each other.
const DEPTH: usize = 8;

/// A value that was returned.
#[derive(Clone, PartialEq, Debug)]
pub enum Value {
    /// Yes or no.
    Truth(bool),
    /// The number of an element. Numbers that no element can have are read as the greatest that an id can hold.
    Id(u32),
    /// A number.
    Number(f64),
    /// A point of the plane or of space.
    Point(Vec<f64>),
    /// Several values, in order.
    List(Vec<Value>),
    /// A polygon by its corners.
    Polygon(Vec<[f64; 2]>),
    /// The function says why it cannot do it.
    Refusal(String),
    /// A structure of its own.
    Structure(Structure),
}

impl Value {
    /// The number of an element.
    #[must_use]
    pub fn id(&self) -> Option<u32> {
        if let Self::Id(id) = self { Some(*id) } else { None }
    }

    /// The number.
    #[must_use]
    pub fn number(&self) -> Option<f64> {
        if let Self::Number(x) = self { Some(*x) } else { None }
    }

    /// Yes or no.
    #[must_use]
    pub fn truth(&self) -> Option<bool> {
        if let Self::Truth(truth) = self { Some(*truth) } else { None }
    }

    /// A point of the plane.
    #[must_use]
    pub fn point(&self) -> Option<[f64; 2]> {
        if let Self::Point(place) = self { place.as_slice().try_into().ok() } else { None }
    }

    /// A point of space.
    #[must_use]
    pub fn place(&self) -> Option<[f64; 3]> {
        if let Self::Point(place) = self { place.as_slice().try_into().ok() } else { None }
    }

    /// The numbers of so many elements, as a list.
    #[must_use]
    pub fn ids<const N: usize>(&self) -> Option<[u32; N]> {
        let Self::List(values) = self else { return None };
        values.iter().map(Self::id).collect::<Option<Vec<u32>>>()?.try_into().ok()
    }

    /// As it is written, but for numbers, which need no mark in a sentence.
    #[must_use]
    pub fn words(&self) -> String {
        let point = |place: &[f64]| place.iter().map(f64::to_string).collect::<Vec<_>>().join(", ");
        match self {
            Self::Truth(truth) => truth.to_string(),
            // What a program writes for "none": -1, or the greatest number that there is.
            Self::Id(id) if *id >= GREATEST => "none".to_owned(),
            Self::Id(id) => id.to_string(),
            Self::Number(x) => x.to_string(),
            Self::Point(place) => format!("({})", point(place)),
            Self::List(values) => format!("[{}]", values.iter().map(Self::words).collect::<Vec<_>>().join(" ")),
            Self::Polygon(corners) => corners.iter().map(|p| format!("({})", point(p))).collect::<Vec<_>>().join(" "),
            Self::Refusal(why) => format!("a refusal: {why}"),
            Self::Structure(_) => "a structure".to_owned(),
        }
    }
}

/// Why the text of some values cannot be read.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Unreadable<'a> {
    /// From here on it is no value.
    From(&'a str),
    /// There are more than are read.
    TooMany,
}

/// How many values are read of a call.
pub(super) const MOST: usize = VALUES;

/// Reads the values of a line; a structure stands there without its lines.
pub(super) fn read(text: &str) -> Result<Vec<Value>, Unreadable<'_>> {
    let mut reader = Reader { rest: text, values: 0 };
    let values = reader.list(0)?;
    if reader.rest.is_empty() { Ok(values) } else { Err(Unreadable::From(reader.rest)) }
}

struct Reader<'a> {
    rest: &'a str,
    values: usize,
}

impl<'a> Reader<'a> {
    /// Values with one blank between them, up to the end of the text or of the list.
    fn list(&mut self, depth: usize) -> Result<Vec<Value>, Unreadable<'a>> {
        let mut values = Vec::new();
        while !self.rest.is_empty() && !self.rest.starts_with(']') {
            if !values.is_empty() {
                self.rest = self.rest.strip_prefix(' ').ok_or(Unreadable::From(self.rest))?;
            }
            values.push(self.value(depth)?);
        }
        Ok(values)
    }

    fn value(&mut self, depth: usize) -> Result<Value, Unreadable<'a>> {
        self.values += 1;
        if self.values > MOST {
            return Err(Unreadable::TooMany);
        }
        let begin = self.rest;
        let wrong = Unreadable::From(begin);
        if let Some(rest) = begin.strip_prefix('[') {
            if depth == DEPTH {
                return Err(wrong);
            }
            self.rest = rest;
            let values = self.list(depth + 1)?;
            self.rest = self.rest.strip_prefix(']').ok_or(wrong)?;
            return Ok(Value::List(values));
        }
        if let Some(inside) = begin.strip_prefix('<') {
            let (corners, rest) = inside.split_once('>').ok_or(wrong)?;
            self.rest = rest;
            let corners = corners.split(' ').filter(|word| !word.is_empty());
            let corners: Option<Vec<[f64; 2]>> = corners.map(|word| coordinates(word)?.try_into().ok()).collect();
            let corners = corners.ok_or(wrong)?;
            self.values += corners.len();
            return if self.values > MOST { Err(Unreadable::TooMany) } else { Ok(Value::Polygon(corners)) };
        }
        if let Some(inside) = begin.strip_prefix('(') {
            let (place, rest) = inside.split_once(')').ok_or(wrong)?;
            self.rest = rest;
            let place = coordinates(place).filter(|place| matches!(place.len(), 2 | 3));
            return place.map(Value::Point).ok_or(wrong);
        }
        if let Some(why) = begin.strip_prefix("refused ") {
            let (why, rest) = quoted(why).ok_or(wrong)?;
            self.rest = rest;
            return Ok(Value::Refusal(why));
        }
        let end = begin.find([' ', ']']).unwrap_or(begin.len());
        let (word, rest) = begin.split_at(end);
        self.rest = rest;
        match word {
            "true" => Some(Value::Truth(true)),
            "false" => Some(Value::Truth(false)),
            "structure" => Some(Value::Structure(Structure::default())),
            word => match word.strip_prefix('#') {
                Some(number) => number.parse().ok().map(Value::Number),
                None => id(word).map(Value::Id),
            },
        }
        .ok_or(wrong)
    }
}

fn coordinates(text: &str) -> Option<Vec<f64>> {
    text.split(',').map(|word| word.parse().ok()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_value_is_read() {
        let values = read(r##"1 true #-0.1 (0.5,2) [1 [2 3] []] <0,0 4,0 3,3> refused "no \"three\" points" (1,2,3)"##);
        let list = Value::List(vec![Value::Id(1), Value::List(vec![Value::Id(2), Value::Id(3)]), Value::List(vec![])]);
        let expected = [
            Value::Id(1),
            Value::Truth(true),
            Value::Number(-0.1),
            Value::Point(vec![0.5, 2.0]),
            list,
            Value::Polygon(vec![[0.0, 0.0], [4.0, 0.0], [3.0, 3.0]]),
            Value::Refusal("no \"three\" points".to_owned()),
            Value::Point(vec![1.0, 2.0, 3.0]),
        ];
        assert_eq!(values.unwrap(), expected);
        assert_eq!(read("").unwrap(), []);
        assert_eq!(read("<>").unwrap(), [Value::Polygon(vec![])]);
        let nan = read("#NaN").unwrap();
        assert!(nan[0].number().is_some_and(f64::is_nan));
    }

    #[test]
    fn a_value_is_given_as_its_own_kind_alone() {
        let value = |text: &str| read(text).unwrap().remove(0);
        assert_eq!(["true", "false", "1"].map(|text| value(text).truth()), [Some(true), Some(false), None]);
        assert_eq!(["7", "true"].map(|text| value(text).id()), [Some(7), None]);
        assert_eq!(["#0.5", "1"].map(|text| value(text).number()), [Some(0.5), None]);
        assert_eq!(["(1,2)", "(1,2,3)", "1"].map(|text| value(text).point()), [Some([1.0, 2.0]), None, None]);
    }

    #[test]
    fn what_is_no_value_is_not_read() {
        for text in [
            "maybe",
            "1  2",
            " 1",
            "1 ",
            "-1",
            "[1",
            "1]",
            "[1 2]3",
            "(1)",
            "(1,2,3,4)",
            "(1,x)",
            "<1,2,3>",
            "<0,0",
            "refused why",
            "refused \"why",
            "#",
            "# 1",
            "0x1",
            "[[[[[[[[[1]]]]]]]]]",
        ] {
            assert!(matches!(read(text), Err(Unreadable::From(_))), "{text}");
        }
        assert_eq!(read(&"1 ".repeat(MOST + 1)), Err(Unreadable::TooMany));
        let flat = format!("[{}]", "[] ".repeat(MOST + 1));
        assert_eq!(read(&flat), Err(Unreadable::TooMany));
    }

    #[test]
    fn as_many_values_are_read_as_there_may_be_and_not_one_more() {
        let most = vec!["1"; MOST].join(" ");
        assert_eq!(read(&most).map(|values| values.len()), Ok(MOST));
        assert_eq!(read(&format!("{most} 1")), Err(Unreadable::TooMany));
        // A polygon counts with its corners, so that the number may be reached in the middle of a value.
        let polygon = format!("<{}>", vec!["0,0"; MOST - 1].join(" "));
        assert_eq!(read(&polygon).map(|values| values.len()), Ok(1));
        assert_eq!(read(&format!("{polygon} 1")), Err(Unreadable::TooMany));
    }
}
