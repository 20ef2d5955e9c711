#![no_main]

targets::program!("submission");
