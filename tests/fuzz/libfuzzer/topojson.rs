#![no_main]

targets::program!("topojson");
