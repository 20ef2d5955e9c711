#![no_main]

targets::program!("lab_files");
