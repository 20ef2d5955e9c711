#![no_main]

targets::program!("off");
