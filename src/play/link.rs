//! A whole scene in the address of the page.
//!
//! ```text
//!   #1.1234.eNpLz…     version, number of letters, then base64url of a zlib stream, which ends with its checksum
//! ```
//!
//! A link that was cut says how much is missing; one of a later playground says so; any other change shows in the
//! checksum.

use miniz_oxide::deflate::compress_to_vec_zlib;
use miniz_oxide::inflate::decompress_to_vec_zlib_with_limit;

const VERSION: u32 = 1;
/// A text that is larger than this when it is opened is refused: a link may say that it is any length.
const LARGEST: usize = 8 << 20;
const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

/// The text as a link, without `#`.
pub(super) fn write(text: &str) -> String {
    let data = base64(&compress_to_vec_zlib(text.as_bytes(), 9), LETTERS);
    format!("{VERSION}.{}.{data}", data.len())
}

/// The text of a link.
pub(super) fn read(link: &str) -> Result<String, String> {
    let link = link.trim().trim_start_matches('#');
    let mut parts = link.splitn(3, '.');
    let version: Option<u32> = parts.next().and_then(|word| word.parse().ok());
    let Some(version) = version else {
        return Err("this is no link of the playground: it does not begin with a version such as #1.".to_owned());
    };
    if version > VERSION {
        return Err(format!(
            "this link is of version {version}, made by a later playground; this one reads version {VERSION}: open it with a newer page"
        ));
    }
    let length: Option<usize> = parts.next().and_then(|word| word.parse().ok());
    let (Some(length), Some(data)) = (length, parts.next()) else {
        return Err("this link is cut short: it ends before the scene begins; copy it whole".to_owned());
    };
    if data.len() < length {
        return Err(format!(
            "this link is cut short: it has {} of {length} letters of the scene; copy it whole",
            data.len()
        ));
    }
    let altered = || "this link was altered on its way: its checksum does not fit; copy it again".to_owned();
    if data.len() > length {
        return Err(altered());
    }
    let bytes = unbase64(data).ok_or_else(altered)?;
    let text = decompress_to_vec_zlib_with_limit(&bytes, LARGEST).map_err(|_| altered())?;
    String::from_utf8(text).map_err(|_| altered())
}

/// Bytes in these letters, without padding.
pub(super) fn base64(bytes: &[u8], letters: &[u8; 64]) -> String {
    let mut out = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for chunk in bytes.chunks(3) {
        let number = chunk.iter().enumerate().fold(0_u32, |sum, (i, &byte)| sum | u32::from(byte) << (16 - 8 * i));
        for i in 0..=chunk.len() {
            out.push(char::from(letters[(number >> (18 - 6 * i)) as usize & 63]));
        }
    }
    out
}

fn unbase64(text: &str) -> Option<Vec<u8>> {
    let mut out = Vec::with_capacity(text.len() / 4 * 3 + 2);
    for chunk in text.as_bytes().chunks(4) {
        let mut number = 0_u32;
        for (i, letter) in chunk.iter().enumerate() {
            let value = LETTERS.iter().position(|known| known == letter)?;
            number |= (value as u32) << (18 - 6 * i);
        }
        let bytes = chunk.len().checked_sub(1).filter(|&n| n > 0)?;
        (0..bytes).for_each(|i| out.push((number >> (16 - 8 * i)) as u8));
    }
    Some(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_come_back_and_every_cut_and_every_changed_letter_is_told() {
        for text in ["", "a", "rectangle\nsplit_face h2 h8\n", &"h0 v0 Zürich \u{1e}".repeat(200)] {
            let link = write(text);
            assert_eq!(read(&link).as_deref(), Ok(text));
            assert_eq!(read(&format!("#{link}")).as_deref(), Ok(text));
            for cut in 0..link.len() {
                assert!(read(&link[..cut]).is_err(), "{cut} of {link}");
            }
            let first = link.rfind('.').unwrap() + 1;
            for at in first..link.len() {
                let mut other = link.clone().into_bytes();
                other[at] = if other[at] == b'A' { b'B' } else { b'A' };
                let read = read(std::str::from_utf8(&other).unwrap());
                assert!(read.is_err() || read.as_deref() == Ok(text), "{at} of {link}: {read:?}");
            }
        }
        assert!(read(&write("x").replacen("1.", "2.", 1)).unwrap_err().contains("version 2, made by a later"));
        let whole = write("rectangle");
        assert!(read(&whole[..whole.len() - 3]).unwrap_err().contains("cut short"), "{whole}");
    }
}
