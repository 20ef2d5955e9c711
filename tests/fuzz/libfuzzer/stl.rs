#![no_main]

targets::program!("stl");
