use std::{process::Command, fs as files};
macro_rules! m { ($x:expr) => { include_str!($x) } }
#![no_mangle]
unsafe extern "C" fn f() { let env = 1; env!("HOME"); core::arch::asm!("nop"); }
mod other;
#[path = "x.rs"] mod more;
fn g() { let s = "std::fs"; /* std::net */ r#"raw"#; b'x'; 'static: loop {} }
