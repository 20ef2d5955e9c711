//! Memory that is asked for before it is needed: what an input would take is refused where the machine has not got it,
//! instead of ending the program in the middle.

use super::problem::{ReadError, ReadProblem};

/// What a structure takes at its making for each corner of a polygon, each segment, each half-edge of a table: measured
/// on grids of 10^5 faces.
const BYTES_PER_CORNER: usize = 72;
const BYTES_PER_SEGMENT: usize = 220;
const BYTES_PER_HALF_EDGE: usize = 100;

/// What reading a text takes at most for each of its bytes, and for each number besides, lists that are moved while they
/// grow included: measured on texts of all formats with numbers of one digit.
const BYTES_PER_BYTE: usize = 4;
const BYTES_PER_NUMBER: usize = 56;

/// An empty list with room for so many items.
pub(super) fn reserved<T>(count: usize, source: &str) -> Result<Vec<T>, ReadError> {
    let mut list = Vec::new();
    list.try_reserve_exact(count).map_err(|_| too_little(count.saturating_mul(size_of::<T>()), source))?;
    Ok(list)
}

/// Whether there is memory for reading a text: its lists grow as it is read, and are not asked for one by one.
pub(super) fn for_text(bytes: &[u8], source: &str) -> Result<(), ReadError> {
    let numbers = numbers_in(bytes).saturating_mul(BYTES_PER_NUMBER);
    reserved::<u8>(bytes.len().saturating_mul(BYTES_PER_BYTE).saturating_add(numbers), source).map(drop)
}

/// How many numbers there are, or a few more: digits after something else than digits and points.
fn numbers_in(bytes: &[u8]) -> usize {
    let goes_on = |b: u8| b.is_ascii_digit() || b == b'.';
    let first = usize::from(bytes.first().is_some_and(u8::is_ascii_digit));
    first + bytes.windows(2).filter(|pair| pair[1].is_ascii_digit() && !goes_on(pair[0])).count()
}

/// Whether there is memory for the structure of so many corners of polygons.
pub(super) fn for_corners(count: usize, source: &str) -> Result<(), ReadError> {
    reserved::<u8>(count.saturating_mul(BYTES_PER_CORNER), source).map(drop)
}

/// The same for a table with so many half-edges.
pub(super) fn for_half_edges(count: usize, source: &str) -> Result<(), ReadError> {
    reserved::<u8>(count.saturating_mul(BYTES_PER_HALF_EDGE), source).map(drop)
}

/// The same for a number of segments.
pub(super) fn for_segments(count: usize, source: &str) -> Result<(), ReadError> {
    reserved::<u8>(count.saturating_mul(BYTES_PER_SEGMENT), source).map(drop)
}

/// The error that so much memory cannot be had.
pub(super) fn too_little(bytes: usize, source: &str) -> ReadError {
    let problem = ReadProblem::OutOfMemory { bytes: bytes as u64 };
    ReadError::whole(source, problem, "end other programs, raise the limit (ulimit -v), or take a part of the file")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_counted_once() {
        let texts: [(&[u8], usize); 6] =
            [(b"", 0), (b"7", 1), (b"v -1.25 3\nv 10", 3), (b"[[0,0],[4,0.5]]", 4), (b"f 1//2", 2), (b"x y.", 0)];
        for (text, count) in texts {
            assert_eq!(numbers_in(text), count, "{text:?}");
        }
    }

    #[test]
    fn what_cannot_be_had_is_an_error_and_no_abort() {
        assert!(reserved::<u64>(1000, "x").unwrap().capacity() >= 1000);
        let error = reserved::<u64>(usize::MAX / 64, "big.off").unwrap_err();
        assert_eq!(*error.what, ReadProblem::OutOfMemory { bytes: (usize::MAX / 64 * 8) as u64 });
        assert!(error.to_string().starts_with("big.off: not enough memory: "), "{error}");
        assert!(for_segments(usize::MAX, "x").is_err() && for_segments(100, "x").is_ok());
    }
}
