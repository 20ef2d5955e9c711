#![no_main]

targets::program!("triangle");
