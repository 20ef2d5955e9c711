#![no_main]

targets::program!("figure_files");
