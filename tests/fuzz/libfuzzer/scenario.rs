#![no_main]

targets::program!("scenario");
