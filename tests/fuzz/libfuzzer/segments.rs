#![no_main]

targets::program!("segments");
