#![no_main]

targets::program!("points");
