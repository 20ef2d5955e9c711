#![no_main]

targets::program!("script");
