//! Promise: navigation meshes, grid maps and scenarios are read as they are meant, written so that others can read
//! them, and refused with the place where they are wrong.

mod answers;
mod bad_input;
mod faults;
mod grids;
mod meshes;
mod scenarios;

use dcel_kit::io::{Document, Format, LoadOptions, PolygonSoup, ReadOptions, Structure, assemble, read_bytes};
use dcel_kit::plane::Subdivision;

/// The shared folder with the data of others.
fn data(name: &str) -> std::path::PathBuf {
    std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data").join(name)
}

fn soup(text: &[u8], format: Format) -> PolygonSoup {
    match read_bytes(text, format, "file", &ReadOptions::default()).expect("good syntax").document {
        Document::Polygons(soup) => soup,
        other => panic!("not polygons: {other:?}"),
    }
}

fn plane(text: &[u8], format: Format) -> Subdivision {
    let read = read_bytes(text, format, "file", &ReadOptions::default()).expect("good syntax");
    let options = LoadOptions::default();
    match assemble(read, "file", &options).expect("faces that fit").structure {
        Structure::Plane(subdivision) => subdivision,
        other => panic!("not a plane: {other:?}"),
    }
}

/// A reproducible stream of random numbers (xorshift64*, Vigna 2016).
struct Random(u64);

impl Random {
    fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    fn below(&mut self, bound: u64) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 32) % bound
    }
}
