#![no_main]

targets::program!("wkt");
