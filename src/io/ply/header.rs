//! The header of a PLY file: encoding, elements and their properties.

use crate::io::problem::{ReadError, ReadProblem};
use crate::io::text::{Scanner, Syntax, Word};

/// How the records are written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Encoding {
    Text,
    LittleEndian,
    BigEndian,
}

/// The type of a value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Kind {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Kind {
    fn from_name(name: &[u8]) -> Option<Self> {
        Some(match name {
            b"char" | b"int8" => Self::I8,
            b"uchar" | b"uint8" => Self::U8,
            b"short" | b"int16" => Self::I16,
            b"ushort" | b"uint16" => Self::U16,
            b"int" | b"int32" => Self::I32,
            b"uint" | b"uint32" => Self::U32,
            b"float" | b"float32" => Self::F32,
            b"double" | b"float64" => Self::F64,
            _ => return None,
        })
    }

    /// How many bytes a value takes in binary data.
    pub(super) const fn bytes(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }
}

/// A value, or a list of values, that each record of an element has.
#[derive(Clone, Debug)]
pub(super) struct Property {
    pub(super) name: String,
    pub(super) kind: Kind,
    /// The type of the length, if this is a list.
    pub(super) list: Option<Kind>,
}

/// A table of the file.
#[derive(Clone, Debug)]
pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: u64,
    pub(super) properties: Vec<Property>,
}

/// What the header announces.
#[derive(Clone, Debug)]
pub(super) struct Header {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element>,
    /// The number of points it announces.
    pub(super) points: u64,
    /// The first byte behind it.
    pub(super) end: usize,
}

impl Header {
    /// Reads the header and checks that points and faces can be read from it.
    pub(super) fn read(bytes: &[u8], source: &str) -> Result<Self, ReadError> {
        let mut scanner = Scanner::new(bytes, source, Syntax::default())?;
        let word = scanner.need(|| "the word `ply`".to_owned())?;
        if word.text != b"ply" {
            return Err(scanner.expected(word, "the word `ply`", ""));
        }
        let mut encoding = None;
        let mut elements: Vec<Element> = Vec::new();
        loop {
            if !scanner.next_line() {
                return Err(scanner.missing("the line end_header".to_owned()));
            }
            let Some(word) = scanner.word() else { continue };
            match word.text {
                b"comment" | b"obj_info" => continue,
                b"format" => encoding = Some(format(&mut scanner)?),
                b"element" => elements.push(element(&mut scanner, &elements)?),
                b"property" => match elements.last_mut() {
                    Some(element) => element.properties.push(property(&mut scanner, element)?),
                    None => return Err(scanner.expected(word, "an element before the first property", "")),
                },
                b"end_header" => break,
                _ => {
                    let help = "the header has lines format, comment, element, property and end_header";
                    return Err(scanner.error(word.at, ReadProblem::UnknownWord { word: word.show() }, help));
                }
            }
            scanner.end_of_line("")?;
        }
        let end = after_header(bytes, scanner.at());
        let fail = |wanted: &str| Err(scanner.missing(wanted.to_owned()));
        let Some(encoding) = encoding else { return fail("a line such as `format ascii 1.0` before end_header") };
        for element in &elements {
            let has = |name| element.properties.iter().any(|p| p.name == name && p.list.is_none());
            if element.name == "vertex" && !(has("x") && has("y")) {
                return fail("properties x and y of the element vertex before end_header");
            }
            if element.name == "face" && element.count > 0 && !element.properties.iter().any(Property::is_corners) {
                return fail("the property list vertex_indices of the element face before end_header");
            }
        }
        let points = elements.iter().find(|e| e.name == "vertex").map_or(0, |e| e.count);
        Ok(Self { encoding, elements, points, end })
    }
}

/// The first byte behind the line `end_header`, which ends as the first line of the file does.
fn after_header(bytes: &[u8], at: usize) -> usize {
    let blanks = bytes[at..].iter().take_while(|&&b| b == b' ' || b == b'\t').count();
    let at = at + blanks;
    let first_end = bytes.iter().position(|&b| b == b'\n' || b == b'\r').unwrap_or(0);
    let length = match &bytes[first_end..] {
        [b'\r', b'\n', ..] if bytes[at..].starts_with(b"\r\n") => 2,
        _ => 1,
    };
    (at + length).min(bytes.len())
}

fn format(scanner: &mut Scanner<'_>) -> Result<Encoding, ReadError> {
    let word = scanner.need(|| "ascii, binary_little_endian or binary_big_endian".to_owned())?;
    let encoding = match word.text {
        b"ascii" => Encoding::Text,
        b"binary_little_endian" => Encoding::LittleEndian,
        b"binary_big_endian" => Encoding::BigEndian,
        _ => return Err(scanner.expected(word, "ascii, binary_little_endian or binary_big_endian", "")),
    };
    let word = scanner.need(|| "the version, 1.0".to_owned())?;
    match word.text {
        b"1.0" => Ok(encoding),
        _ => Err(scanner.expected(word, "version 1.0", "")),
    }
}

fn name(word: Word<'_>, scanner: &Scanner<'_>) -> Result<String, ReadError> {
    let name = std::str::from_utf8(word.text).map(str::to_owned);
    name.map_err(|_| scanner.error(word.at, ReadProblem::NotText, ""))
}

fn element(scanner: &mut Scanner<'_>, before: &[Element]) -> Result<Element, ReadError> {
    let word = scanner.need(|| "the name of the element".to_owned())?;
    let name = name(word, scanner)?;
    if name == "tristrips" {
        let problem = ReadProblem::Refused { what: "a PLY file of triangle strips".into() };
        return Err(scanner.error(word.at, problem, "save the model with single faces instead"));
    }
    if before.iter().any(|e| e.name == name) {
        return Err(scanner.expected(word, "each element once", ""));
    }
    let count = scanner.need(|| "the number of records".to_owned())?;
    Ok(Element { name, count: scanner.count(count)?, properties: Vec::new() })
}

fn property(scanner: &mut Scanner<'_>, element: &Element) -> Result<Property, ReadError> {
    let mut word = scanner.need(|| "the type of the property".to_owned())?;
    let mut list = None;
    if word.text == b"list" {
        let length = scanner.need(|| "the type of the length of the list".to_owned())?;
        list = Some(whole_kind(scanner, length)?);
        word = scanner.need(|| "the type of the items of the list".to_owned())?;
    }
    let kind = kind(scanner, word)?;
    let name_word = scanner.need(|| "the name of the property".to_owned())?;
    let property = Property { name: name(name_word, scanner)?, kind, list };
    if element.properties.iter().any(|p| p.name == property.name) {
        return Err(scanner.expected(name_word, "each property once", ""));
    }
    if element.name == "face" && property.is_corners() {
        whole_kind(scanner, word)?;
    }
    Ok(property)
}

fn kind(scanner: &Scanner<'_>, word: Word<'_>) -> Result<Kind, ReadError> {
    let wanted = "a type: char uchar short ushort int uint float double";
    Kind::from_name(word.text).ok_or_else(|| scanner.expected(word, wanted, ""))
}

fn whole_kind(scanner: &Scanner<'_>, word: Word<'_>) -> Result<Kind, ReadError> {
    let kind = kind(scanner, word)?;
    if kind.is_whole() { Ok(kind) } else { Err(scanner.expected(word, "a type of whole numbers", "")) }
}
