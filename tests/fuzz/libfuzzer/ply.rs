#![no_main]

targets::program!("ply");
