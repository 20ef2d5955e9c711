#![no_main]

targets::program!("protocol");
