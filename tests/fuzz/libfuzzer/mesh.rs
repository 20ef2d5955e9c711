#![no_main]

targets::program!("mesh");
