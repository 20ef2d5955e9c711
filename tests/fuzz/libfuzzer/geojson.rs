#![no_main]

targets::program!("geojson");
