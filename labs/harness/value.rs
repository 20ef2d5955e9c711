//! What goes into a call and what comes back, and how it is written.
//!
//! ```text
//!   id         12                      number    #0.1            point     (0.5,2)   (0,0,1)
//!   yes or no  true                    polygon   <0,0 4,0 3,3>   refusal   refused "the points are on one line"
//!   list       1 2 3   inside another: [1 2 3]                   nothing   (an empty line)
//! ```
//!
//! Numbers are written with as many digits as it takes to read the very same number again.

/// A value that a call gives back.
#[derive(Clone, PartialEq, Debug)]
pub enum Value {
    /// The function gives nothing back.
    Nothing,
    /// Yes or no.
    Truth(bool),
    /// The number of a record.
    Id(usize),
    /// A number.
    Number(f64),
    /// A point of the plane.
    Point([f64; 2]),
    /// A point of space.
    Place([f64; 3]),
    /// Several values, in order.
    List(Vec<Value>),
    /// A polygon by its corners.
    Polygon(Vec<[f64; 2]>),
    /// The function says why it cannot do it.
    Refusal(String),
    /// A structure of its own, as the lines of a dump.
    Structure(String),
}

impl Value {
    /// A list of numbers of records.
    pub fn ids(ids: Vec<usize>) -> Self {
        Self::List(ids.into_iter().map(Self::Id).collect())
    }

    /// The structures among the values, in their order.
    pub(super) fn structures<'a>(&'a self, out: &mut Vec<&'a str>) {
        match self {
            Self::List(values) => values.iter().for_each(|value| value.structures(out)),
            Self::Structure(text) => out.push(text),
            _ => {}
        }
    }

    /// How many values it is: those of a list, else one.
    pub(super) fn count(&self) -> usize {
        match self {
            Self::Nothing => 0,
            Self::List(values) => values.len(),
            Self::Polygon(corners) => corners.len(),
            _ => 1,
        }
    }

    /// The value in one line.
    pub(super) fn words(&self) -> String {
        match self {
            Self::List(values) => joined(values),
            value => value.word(),
        }
    }

    fn word(&self) -> String {
        let point = |[x, y]: &[f64; 2]| format!("{x},{y}");
        match self {
            Self::Nothing => String::new(),
            Self::Truth(truth) => truth.to_string(),
            Self::Id(id) => id.to_string(),
            Self::Number(x) => format!("#{x}"),
            Self::Point(p) => format!("({})", point(p)),
            Self::Place([x, y, z]) => format!("({x},{y},{z})"),
            Self::List(values) => format!("[{}]", joined(values)),
            Self::Polygon(corners) => format!("<{}>", corners.iter().map(point).collect::<Vec<_>>().join(" ")),
            Self::Refusal(why) => format!("refused {why:?}"),
            Self::Structure(_) => "structure".to_owned(),
        }
    }
}

fn joined(values: &[Value]) -> String {
    let words: Vec<String> = values.iter().map(Value::word).collect();
    words.join(" ")
}

/// What a function takes, as it is written in a case.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Take {
    /// A record of the kind with this letter.
    Id(char),
    /// The same; or another record, from which this link leads to it.
    IdOr(char, &'static str),
    /// A number.
    Number,
    /// All numbers that are left.
    Numbers,
    /// `true` or `false`.
    Truth,
    /// A whole number from 0.
    Whole,
    /// All whole numbers that are left.
    Wholes,
    /// Two numbers.
    Point,
    /// All numbers that are left, two for each point.
    Points,
    /// Three numbers.
    Place,
    /// All numbers that are left, three for each point.
    Places,
}

/// An argument of a call.
#[derive(Clone, PartialEq, Debug)]
pub enum Argument {
    /// The number of a record.
    Id(usize),
    /// A number.
    Number(f64),
    /// Numbers.
    Numbers(Vec<f64>),
    /// Yes or no.
    Truth(bool),
    /// A point.
    Point([f64; 2]),
    /// Points.
    Points(Vec<[f64; 2]>),
    /// A whole number.
    Whole(usize),
    /// Whole numbers.
    Wholes(Vec<usize>),
    /// A point of space.
    Place([f64; 3]),
    /// Points of space.
    Places(Vec<[f64; 3]>),
}

const CHECKED: &str = "what a call takes is checked before it is made";

impl Argument {
    // What a call takes is checked before it is made, so each of these is asked for what is there.

    /// The number of a record.
    pub fn id(&self) -> usize {
        if let Self::Id(id) = self { *id } else { unreachable!("{CHECKED}") }
    }

    /// A number.
    pub fn number(&self) -> f64 {
        if let Self::Number(x) = self { *x } else { unreachable!("{CHECKED}") }
    }

    /// Numbers.
    pub fn numbers(&self) -> &[f64] {
        if let Self::Numbers(all) = self { all } else { unreachable!("{CHECKED}") }
    }

    /// Yes or no.
    pub fn truth(&self) -> bool {
        if let Self::Truth(truth) = self { *truth } else { unreachable!("{CHECKED}") }
    }

    /// A whole number.
    pub fn whole(&self) -> usize {
        if let Self::Whole(n) = self { *n } else { unreachable!("{CHECKED}") }
    }

    /// Whole numbers.
    pub fn wholes(&self) -> &[usize] {
        if let Self::Wholes(all) = self { all } else { unreachable!("{CHECKED}") }
    }

    /// A point of the plane.
    pub fn point(&self) -> [f64; 2] {
        if let Self::Point(p) = self { *p } else { unreachable!("{CHECKED}") }
    }

    /// Points of the plane.
    pub fn points(&self) -> &[[f64; 2]] {
        if let Self::Points(all) = self { all } else { unreachable!("{CHECKED}") }
    }

    /// A point of space.
    pub fn place(&self) -> [f64; 3] {
        if let Self::Place(p) = self { *p } else { unreachable!("{CHECKED}") }
    }

    /// Points of space.
    pub fn places(&self) -> &[[f64; 3]] {
        if let Self::Places(all) = self { all } else { unreachable!("{CHECKED}") }
    }

    /// As it is written.
    pub(super) fn words(&self) -> String {
        match self {
            Self::Id(id) => id.to_string(),
            Self::Number(x) => x.to_string(),
            Self::Numbers(all) => all.iter().map(f64::to_string).collect::<Vec<_>>().join(" "),
            Self::Truth(truth) => truth.to_string(),
            Self::Point([x, y]) => format!("{x} {y}"),
            Self::Points(points) => points.iter().map(|[x, y]| format!("{x} {y}")).collect::<Vec<_>>().join(" "),
            Self::Whole(n) => n.to_string(),
            Self::Wholes(all) => all.iter().map(usize::to_string).collect::<Vec<_>>().join(" "),
            Self::Place([x, y, z]) => format!("{x} {y} {z}"),
            Self::Places(all) => all.iter().map(|[x, y, z]| format!("{x} {y} {z}")).collect::<Vec<_>>().join(" "),
        }
    }
}

/// A number from 0.
pub fn whole(word: &str) -> Result<usize, String> {
    word.parse().map_err(|_| format!("`{word}` is not a number such as 0, 1, 2"))
}

/// A coordinate.
pub fn coordinate(word: &str) -> Result<f64, String> {
    let number: Option<f64> = word.parse().ok();
    number.filter(|x| x.is_finite()).ok_or_else(|| format!("`{word}` is not a number such as -2.5"))
}

/// Points of space, three numbers each.
pub fn places(words: &[&str]) -> Result<Vec<[f64; 3]>, String> {
    if !words.len().is_multiple_of(3) {
        return Err("a point of space has three coordinates; one of them is missing".to_owned());
    }
    let place = |three: &[&str]| Ok([coordinate(three[0])?, coordinate(three[1])?, coordinate(three[2])?]);
    words.chunks(3).map(place).collect()
}

/// Points, two numbers each.
pub fn points(words: &[&str]) -> Result<Vec<[f64; 2]>, String> {
    if !words.len().is_multiple_of(2) {
        return Err("a point has two coordinates; one of them is missing".to_owned());
    }
    words.chunks(2).map(|pair| Ok([coordinate(pair[0])?, coordinate(pair[1])?])).collect()
}
