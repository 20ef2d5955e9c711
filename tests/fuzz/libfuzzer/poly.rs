#![no_main]

targets::program!("poly");
