#![no_main]

targets::program!("obj");
