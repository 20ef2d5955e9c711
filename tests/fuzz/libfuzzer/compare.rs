#![no_main]

targets::program!("compare");
