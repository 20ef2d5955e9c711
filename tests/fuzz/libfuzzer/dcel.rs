#![no_main]

targets::program!("dcel");
