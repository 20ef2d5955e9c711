//! Memory that is asked for before it is needed: what an input would take is refused where the machine has not got it,
//! instead of ending the program in the middle.

use super::problem::{ReadError, ReadProblem};
use super::read::Document;

/// What a structure takes at its making for each corner of a polygon, each segment, each half-edge of a table: measured
/// on grids of 10^5 faces.
const BYTES_PER_CORNER: usize = 72;
const BYTES_PER_SEGMENT: usize = 220;
const BYTES_PER_HALF_EDGE: usize = 100;

/// An empty list with room for so many items.
pub(super) fn reserved<T>(count: usize, source: &str) -> Result<Vec<T>, ReadError> {
    let mut list = Vec::new();
    list.try_reserve_exact(count).map_err(|_| too_little(count.saturating_mul(size_of::<T>()), source))?;
    Ok(list)
}

/// Whether there is memory for the structure of what was read.
pub(super) fn for_structure(document: &Document, source: &str) -> Result<(), ReadError> {
    let bytes = match document {
        Document::Polygons(soup) => soup.faces.corner_count().saturating_mul(BYTES_PER_CORNER),
        Document::Segments(soup) => return for_segments(soup.segments.len(), source),
        Document::Table(table) => table.half_edges.len().saturating_mul(BYTES_PER_HALF_EDGE),
    };
    reserved::<u8>(bytes, source).map(drop)
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
    fn what_cannot_be_had_is_an_error_and_no_abort() {
        assert!(reserved::<u64>(1000, "x").unwrap().capacity() >= 1000);
        let error = reserved::<u64>(usize::MAX / 64, "big.off").unwrap_err();
        assert_eq!(*error.what, ReadProblem::OutOfMemory { bytes: (usize::MAX / 64 * 8) as u64 });
        assert!(error.to_string().starts_with("big.off: not enough memory: "), "{error}");
        assert!(for_segments(usize::MAX, "x").is_err() && for_segments(100, "x").is_ok());
    }
}
