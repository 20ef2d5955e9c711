#![no_main]

targets::program!("map");
