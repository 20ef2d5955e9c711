#![no_main]

targets::program!("from_segments");
