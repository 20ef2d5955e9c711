//! What a lab's file may not say: the ways out of it.
//!
//! ```text
//!   std::process::exit(0)          refused: `std::process`                 use std::{fs as f, fmt};
//!   let process = 3;               fine: a name is no path                 // std::process, "std::fs": fine
//!   m!(process exit)               refused where m's body says std::$a     r#include!("x"): refused
//!   #[$a = $p] mod $n;             refused: write the attribute in full    let path = vec![h]: fine
//! ```
//!
//! The scan goes over tokens, not over a syntax tree: so it sees the inside of every macro call and of every macro's
//! body, and needs to know nothing of the grammar around. Comments and strings are no names. It is the friendly half
//! of the defence, which says at line and column what to take out; what it overlooks meets the barriers, and the list of
//! files that the compiler read.
//!
//! The macros that read files die by their names, wherever these stand, so that no other name can be given to them.
//! Two of these names are ordinary words, `include` and `env`: a variable or a field may be called so, but not in a
//! `use`, not before `!`, and not inside a macro call or a macro's body of a file that defines macros of its own.
//!
//! Refused are paths into the parts of the standard library that reach out of the program, other names for the
//! library as a whole, macros that read files or variables at compile time or hold machine code, `unsafe` and
//! `extern`, attributes that change what is linked or compiled, and modules in other files.

use proc_macro2::{Delimiter, LineColumn, Spacing, TokenStream, TokenTree};
use std::str::FromStr;

/// Groups may be nested this deep; the compiler itself gives up not much later.
const DEEPEST: usize = 120;
/// So many findings are told at once.
const MOST: usize = 5;

/// Names of the standard library as a whole.
const LIBRARIES: [&str; 3] = ["std", "core", "alloc"];
/// Modules of it that a lab has no use for, with what they are for.
const MODULES: [(&str, &str); 7] = [
    ("process", "it starts and ends programs"),
    ("fs", "it reaches files"),
    ("path", "it reaches files"),
    ("net", "it reaches the network"),
    ("env", "it reads the environment"),
    ("os", "it reaches the operating system"),
    ("arch", "it is for machine code"),
];
/// Functions of modules that are otherwise fine.
const FUNCTIONS: [(&str, &str); 3] = [("panic", "set_hook"), ("panic", "take_hook"), ("panic", "update_hook")];
/// Macros that look beyond the file when it is compiled, or hold machine code.
const MACROS: [&str; 8] =
    ["include", "include_str", "include_bytes", "env", "option_env", "asm", "global_asm", "naked_asm"];
/// Those of them whose names are ordinary words: refused only where a macro can be meant.
const WORDS: [&str; 2] = ["include", "env"];
/// Attributes that change what is linked or compiled.
const ATTRIBUTES: [&str; 16] = [
    "debugger_visualizer",
    "no_mangle",
    "export_name",
    "link",
    "link_section",
    "link_name",
    "link_ordinal",
    "linkage",
    "used",
    "naked",
    "global_allocator",
    "panic_handler",
    "proc_macro",
    "proc_macro_derive",
    "proc_macro_attribute",
    "unsafe_code",
];
/// Attributes of the whole file that change nothing but warnings and documentation.
const OF_THE_FILE: [&str; 8] = ["allow", "warn", "deny", "expect", "doc", "rustfmt", "clippy", "cfg_attr"];

/// Something that the file may not say, or a place where it cannot be read.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Forbidden {
    /// From 1.
    pub line: usize,
    /// From 1, in characters.
    pub column: usize,
    /// What it is and why, as a sentence.
    pub what: String,
}

/// Why a file is not taken.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ScanError {
    /// It is no Rust: a quote or a bracket without its partner, a character that means nothing.
    NotRust(Forbidden),
    /// It holds forbidden constructs, in their order; the first few.
    Forbidden(Vec<Forbidden>),
}

/// Looks for what a lab's file may not say.
///
/// Cost: linear in the length of the text.
///
/// # Errors
/// [`ScanError`] with line and column.
pub fn scan(text: &str) -> Result<(), ScanError> {
    let stream = TokenStream::from_str(text).map_err(|error| {
        let what = "this cannot be read as Rust: a quote, a bracket or a character is out of place".to_owned();
        ScanError::NotRust(at(error.span().start(), what))
    })?;
    let mut scan = Scan { found: Vec::new(), has_macros: false };
    let tokens = scan.tokens(stream, 0);
    scan.has_macros = mentions(&tokens, &|token| token.name() == Some("macro_rules"));
    scan.walk(&tokens, Around::default());
    scan.found.sort();
    scan.found.dedup();
    scan.found.truncate(MOST);
    if scan.found.is_empty() { Ok(()) } else { Err(ScanError::Forbidden(scan.found)) }
}

fn at(place: LineColumn, what: String) -> Forbidden {
    Forbidden { line: place.line.max(1), column: place.column + 1, what }
}

/// A token as far as it matters here.
#[derive(Clone, Debug)]
enum Token {
    /// A name, without `r#`.
    Name(String, LineColumn),
    /// `::`
    Path,
    Mark(char, LineColumn),
    Group(Delimiter, Vec<Token>, LineColumn),
    /// A literal or a lifetime.
    Other,
}

impl Token {
    fn name(&self) -> Option<&str> {
        if let Self::Name(name, _) = self { Some(name) } else { None }
    }

    fn is(&self, mark: char) -> bool {
        matches!(self, Self::Mark(c, _) if *c == mark)
    }
}

/// Whether there is such a token among these, however deep.
fn mentions(tokens: &[Token], is_it: &dyn Fn(&Token) -> bool) -> bool {
    tokens.iter().any(|token| is_it(token) || matches!(token, Token::Group(_, inner, _) if mentions(inner, is_it)))
}

/// Where a token stands.
#[derive(Clone, Copy, Default)]
struct Around {
    /// Within a macro's body or the arguments of a call.
    in_macro: bool,
    /// Within a `use`.
    in_use: bool,
}

struct Scan {
    found: Vec<Forbidden>,
    /// Whether the file defines macros, which could put paths together.
    has_macros: bool,
}

impl Scan {
    fn refuse(&mut self, place: LineColumn, what: impl Into<String>) {
        self.found.push(at(place, what.into()));
    }

    fn tokens(&mut self, stream: TokenStream, depth: usize) -> Vec<Token> {
        let mut out: Vec<Token> = Vec::new();
        let mut joint = false;
        for tree in stream {
            let mut now_joint = false;
            match tree {
                TokenTree::Ident(ident) => {
                    let name = ident.to_string();
                    let name = name.strip_prefix("r#").unwrap_or(&name).to_owned();
                    out.push(Token::Name(name, ident.span().start()));
                }
                TokenTree::Punct(punct) if punct.as_char() == ':' && joint && out.last().is_some_and(|t| t.is(':')) => {
                    out.pop();
                    out.push(Token::Path);
                }
                TokenTree::Punct(punct) => {
                    now_joint = punct.spacing() == Spacing::Joint;
                    out.push(Token::Mark(punct.as_char(), punct.span().start()));
                }
                TokenTree::Group(group) => {
                    let place = group.span_open().start();
                    if depth < DEEPEST {
                        let inner = self.tokens(group.stream(), depth + 1);
                        // A group without brackets stands for what is in it.
                        out.push(Token::Group(group.delimiter(), inner, place));
                    } else {
                        self.refuse(place, format!("brackets are nested deeper than {DEEPEST}"));
                    }
                }
                TokenTree::Literal(_) => out.push(Token::Other),
            }
            joint = now_joint;
        }
        out
    }

    fn walk(&mut self, tokens: &[Token], around: Around) {
        let mut in_use = around.in_use;
        for (i, token) in tokens.iter().enumerate() {
            match token {
                Token::Name(name, place) => {
                    // Not the `use<'a>` of a type.
                    in_use |= name == "use" && !tokens.get(i + 1).is_some_and(|t| t.is('<'));
                    self.name(tokens, i, name, *place, Around { in_use, ..around });
                }
                Token::Mark('#', place) => self.attribute(&tokens[i + 1..], *place),
                Token::Mark(';', _) => in_use = around.in_use,
                Token::Group(delimiter, inner, place) => {
                    let called = i > 0 && tokens[i - 1].is('!');
                    let defined = i > 1 && tokens[i - 2].is('!') && tokens[i - 1].name().is_some();
                    // An attribute in the making: a macro may put the `#` before it.
                    if *delimiter == Delimiter::Bracket && sets_path(inner) {
                        self.refuse(*place, PATH);
                    }
                    self.walk(inner, Around { in_macro: around.in_macro || called || defined, in_use });
                }
                _ => {}
            }
        }
    }

    fn name(&mut self, tokens: &[Token], i: usize, name: &str, place: LineColumn, around: Around) {
        let next = tokens.get(i + 1);
        let after = tokens.get(i + 2);
        match name {
            "unsafe" => self.refuse(place, "`unsafe` is not for this lab: nothing in it needs it"),
            "extern" => self.refuse(place, "`extern` is not for this lab: it needs nothing but the standard library"),
            "mod" if after.is_some_and(|t| t.is(';')) || next.is_some_and(|t| t.is('$')) => {
                self.refuse(place, "a module of another file: only this file is handed in, so write it here in braces");
            }
            _ if MACROS.contains(&name) => {
                let called = next.is_some_and(|t| t.is('!')) && !after.is_some_and(|t| t.is('='));
                let by_macro = around.in_macro && self.has_macros;
                if called || around.in_use || by_macro || !WORDS.contains(&name) {
                    self.refuse(place, beyond(name, called));
                }
            }
            // Wherever it stands: a path may begin after `return ::` as well as after `0..`.
            _ if LIBRARIES.contains(&name) => {
                match next {
                    Some(Token::Path) => {
                        self.path(&tokens[i + 2..], &mut vec![name.to_owned()], place, around.in_macro);
                    }
                    Some(next) if next.name() == Some("as") => self.another_name(name, place),
                    // `use std;` and a call such as m!(std), whose body goes on with the path.
                    _ if around.in_macro && self.has_macros => self.put_together(name, place),
                    _ => {}
                }
            }
            _ => {}
        }
    }

    /// What follows `std::`.
    fn path(&mut self, rest: &[Token], so_far: &mut Vec<String>, place: LineColumn, in_macro: bool) {
        let root = so_far[0].clone();
        match rest.first() {
            Some(Token::Name(name, here)) => {
                so_far.push(name.clone());
                let is_self = so_far.len() == 2 && name == "self";
                if is_self {
                    self.another_name(&root, *here);
                }
                let known = self.found.len();
                self.judge(so_far, *here);
                if self.found.len() == known && matches!(rest.get(1), Some(Token::Path)) {
                    self.path(&rest[2..], so_far, *here, in_macro);
                }
                so_far.pop();
            }
            Some(Token::Group(Delimiter::Brace, inner, here)) => {
                for part in inner.split(|token| token.is(',')).filter(|part| !part.is_empty()) {
                    self.path(part, so_far, *here, in_macro);
                }
            }
            Some(Token::Mark('*', _)) => {
                let is_function_of = |(module, _): &(&str, &str)| so_far.len() == 2 && so_far[1] == *module;
                if so_far.len() == 1 || FUNCTIONS.iter().any(is_function_of) {
                    self.refuse(place, format!("`{}::*` brings in too much: name what you use", so_far.join("::")));
                }
            }
            Some(Token::Mark('$', _)) => self.put_together(&root, place),
            None if in_macro => self.put_together(&root, place),
            _ => {}
        }
    }

    fn judge(&mut self, path: &[String], place: LineColumn) {
        if let [root, module] = path {
            if let Some((_, why)) = MODULES.iter().find(|(name, _)| name == module) {
                self.refuse(place, format!("`{root}::{module}` is not for this lab: {why}"));
            }
        } else if let [root, module, function] = path
            && FUNCTIONS.iter().any(|(m, f)| m == module && f == function)
        {
            let path = format!("{root}::{module}::{function}");
            self.refuse(place, format!("`{path}` is not for this lab: the given program reports panics itself"));
        }
    }

    fn another_name(&mut self, library: &str, place: LineColumn) {
        self.refuse(place, format!("another name for `{library}` is not for this lab: write `{library}::` in full"));
    }

    fn put_together(&mut self, library: &str, place: LineColumn) {
        let what = format!("a macro puts a path into `{library}` together: write the path in full where it is used");
        self.refuse(place, what);
    }

    /// What follows `#`.
    fn attribute(&mut self, rest: &[Token], mark: LineColumn) {
        let of_the_file = rest.first().is_some_and(|t| t.is('!'));
        let Some(Token::Group(Delimiter::Bracket, inner, place)) = rest.get(usize::from(of_the_file)) else {
            self.refuse(mark, "a `#` that no attribute follows: write the attribute in full, `#[...]`");
            return;
        };
        let head = inner.first().and_then(Token::name).unwrap_or_default();
        if mentions(inner, &|token| token.is('$')) {
            self.refuse(*place, "a macro puts an attribute together: write the attribute in full where it is used");
        } else if of_the_file && !OF_THE_FILE.contains(&head) {
            self.refuse(*place, format!("`#![{head}]` is not for this lab: it changes how the whole is compiled"));
        }
        self.words(inner);
    }

    fn words(&mut self, attribute: &[Token]) {
        for (i, token) in attribute.iter().enumerate() {
            match token {
                Token::Name(name, place) if name == "path" && attribute.get(i + 1).is_some_and(|t| t.is('=')) => {
                    self.refuse(*place, PATH);
                }
                Token::Name(name, place) if ATTRIBUTES.contains(&name.as_str()) => {
                    let what = format!("the attribute `{name}` is not for this lab: it changes what is compiled");
                    self.refuse(*place, what);
                }
                Token::Group(_, inner, _) => self.words(inner),
                _ => {}
            }
        }
    }
}

/// What is said of `#[path = "..."]`, however it comes about.
const PATH: &str = "the attribute `path` is not for this lab: only this file is handed in, so write the module here";

/// What is said of a macro that reads when the file is compiled.
fn beyond(name: &str, called: bool) -> String {
    match (called, WORDS.contains(&name)) {
        (true, _) => format!("`{name}!` is not for this lab: it looks beyond the file"),
        (false, false) => format!("`{name}` is not for this lab: it looks beyond the file; use another name"),
        (false, true) => {
            format!("`{name}` can stand for the macro `{name}!` here, which looks beyond the file; use another name")
        }
    }
}

/// `path = ...`
fn sets_path(tokens: &[Token]) -> bool {
    tokens.first().and_then(Token::name) == Some("path") && tokens.get(1).is_some_and(|t| t.is('='))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first finding as `line:column what`.
    fn first(text: &str) -> Option<String> {
        match scan(text) {
            Ok(()) => None,
            Err(ScanError::NotRust(found)) => Some(format!("{}:{} {}", found.line, found.column, found.what)),
            Err(ScanError::Forbidden(found)) => {
                Some(format!("{}:{} {}", found[0].line, found[0].column, found[0].what))
            }
        }
    }

    #[test]
    fn ways_out_are_refused() {
        for text in [
            "fn f() { std::process::exit(0) }",
            "fn f() { ::std::process::exit(0) }",
            "fn f() { std :: /* */ process :: exit(0) }",
            "fn f() { r#std::r#process::exit(0) }",
            "use std::process; fn f() { process::exit(0) }",
            "use std::{fmt, process::exit};",
            "fn f() -> ! { return ::std::process::exit(0) }",
            "fn f() { for _ in 0..std::process::exit(0) {} }",
            "use std::{fmt, {{process as p}}};",
            "use {std::fs, std::fmt};",
            "use std as s;",
            "use ::std as s;",
            "use std::{self as s};",
            "use core::{fmt, self};",
            "use std::*;",
            "use std::{fmt, *};",
            "use std::panic::*;",
            "use std::panic::{catch_unwind, set_hook};",
            "fn f() { std::panic::set_hook(Box::new(|_| ())) }",
            "type C = std::process::Command;",
            "fn f() -> <std::process::Command as X>::Y {}",
            "fn f() { println!(\"{}\", std::env::args().count()) }",
            "const S: &str = include_str!(\"../solution/lab.rs\");",
            "r#include!(\"x.rs\");",
            "use std::include_str as i;",
            "use core::{include_bytes as i, fmt};",
            "const S: &str = env!(\"HOME\");",
            "fn f() { core::option_env!(\"HOME\"); }",
            "core::arch::global_asm!(\"nop\");",
            "fn f() { asm!(\"nop\") }",
            "extern crate std as s;",
            "extern \"C\" { fn exit(c: i32) -> !; }",
            "extern \"C\" fn f() {}",
            "fn f() { unsafe { f() } }",
            "#[no_mangle] fn memcmp() {}",
            "#[unsafe(no_mangle)] fn memcmp() {}",
            "#[cfg_attr(all(), export_name = \"x\")] fn f() {}",
            "#[unsafe(link_section = \".init_array\")] static A: fn() = f;",
            "#[path = \"../solution/lab.rs\"] mod solution;",
            "#[path = \"../solution/lab.rs\"] mod solution {}",
            "mod helper;",
            "#![feature(asm)]",
            "#![no_main]",
            "#![recursion_limit = \"1000000\"]",
            "#![allow(unsafe_code)]",
            "#[allow(unsafe_code)] fn f() {}",
            "#![doc = include_str!(\"x\")]",
            "macro_rules! m { ($a:ident) => { std::$a::exit(0) } } fn f() { m!(process) }",
            "macro_rules! m { ($a:ident $b:ident) => { $a::$b::exit(0) } } fn f() { m!(std process) }",
            "macro_rules! m { ($($a:tt)*) => { $($a)* process::exit(0) } } fn f() { m!(std::) }",
            "macro_rules! m { () => { std::process::exit(0) } }",
            "macro_rules! m { ($p:path) => { $p(0) } } fn f() { m!(std::process::exit) }",
            "fn f() { vec![{ std::process::exit(0) }] }",
            // An attribute that a macro makes.
            "macro_rules! m { ($a:ident $p:literal $n:ident $s:tt) => { #[$a = $p] mod $n $s } } m!(path \"/x.rs\" a ;);",
            "macro_rules! m { ($a:meta) => { #[$a] mod a {} } }",
            "macro_rules! m { ($a:ident) => { #[cfg_attr(all(), $a = \"x\")] mod a {} } }",
            "macro_rules! m { ($($t:tt)*) => { $($t)* } } m!(#[path = \"x\"] mod a {});",
            "macro_rules! m { ($h:tt $n:ident $g:tt) => { $h $g mod a {} } } m!(# x [path = \"x\"]);",
            "macro_rules! m { ($h:tt) => { $h[inline] fn f() {} } } m!(#);",
            "macro_rules! m { ($n:ident $s:tt) => { mod $n $s } } m!(a ;);",
            "macro_rules! m { ($n:ident) => { mod $n; } } m!(a);",
            "#[cfg_attr(all(), path = \"x\")] mod a {}",
            "#[r#path = \"x\"] mod a {}",
            "#[debugger_visualizer(natvis_file = \"/x\")] mod a {}",
            // Other names for the macros that read files.
            "use std::prelude::v1::include_str as p; const S: &str = p!(\"x\");",
            "use include_str as p;",
            "use r#include_str as p;",
            "use include as p; p!(\"x\");",
            "use core::prelude::rust_2024::{fmt, include as p};",
            "use {include as p};",
            "pub use env as e;",
            "use std::prelude::v1::option_env;",
            "macro_rules! m { ($p:ident) => { $p!(\"x\") } } fn f() { m!(include_str); }",
            "macro_rules! m { ($p:ident) => { $p!(\"x\") } } fn f() { m!(include); }",
            "macro_rules! m { ($p:ident) => { $p!(\"x\") } } fn f() { m!(r#env); }",
            "macro_rules! m { ($p:path) => { $p!(\"x\") } } fn f() { m!(self::env); }",
            "macro_rules! m { () => { n! { include } } } macro_rules! n { ($p:ident) => { $p!(\"x\") } }",
            "fn f() { println!(\"{}\", include_bytes!(\"x\").len()) }",
        ] {
            assert!(first(text).is_some(), "let through: {text}");
        }
    }

    #[test]
    fn ordinary_code_is_let_through() {
        for text in [
            "",
            "//! std::process::exit(0)\n/* include_str!(\"x\") */ /// unsafe extern\nfn f() {}",
            "fn f() { let s = \"std::process::exit(0) unsafe\"; let r = r#\"#[no_mangle]\"#; }",
            "fn process(path: u32, env: u32, fs: u32) -> u32 { path + env + fs }",
            "struct Net { process: u32, path: Vec<u32>, link: u32, used: bool } fn f(n: Net) { n.path.len(); n.process; }",
            "fn f() { let std = 1.0; println!(\"{}\", std); }",
            "use std::collections::{BTreeMap, HashSet}; use std::fmt; use std::{cmp::Ordering, mem};",
            "use std::collections::*; use super::*; use crate::dcel::*;",
            "fn f(a: bool) -> bool { let include = a; include != false }",
            "fn f() { let mut path = vec![1]; path = vec![path[0]]; let env = [path.len()]; println!(\"{env:?} {}\", env[0]); }",
            "struct S { include: bool, path: u8 } fn f(s: &mut S) { s.include = true; s.path = 1; }",
            "use std::fmt; fn f(env: u8) -> u8 { env }",
            "fn f<'a>(a: &'a u8) -> impl Fn() -> u8 + use<'a> { let env = *a; move || env }",
            "macro_rules! next { ($d:ident, $path:expr) => { $d.next($path) } } fn f(env: u8) -> u8 { env }",
            "#[cfg(test)] mod tests { use super::*; #[test] fn t() { assert_eq!(1, 1, \"path = {}\", 2); } }",
            "#[derive(Debug)] #[allow(clippy::all)] struct A; /** path = x */ fn f() {}",
            "#![allow(dead_code)]\n#![warn(missing_docs)]\nfn f() {}",
            "#[derive(Clone, Debug)] #[must_use] struct A; #[inline] fn f() { todo!(\"x\") }",
            "mod helpers { pub fn walk() {} } fn f() { self::helpers::walk(); }",
            "macro_rules! m { ($t:ty) => { <$t>::new() } } fn f() { let v: Vec<u8> = m!(Vec<u8>); std::mem::drop(v); }",
            "macro_rules! walk { ($d:expr, $h:expr) => { std::iter::successors(Some($h), |&h| $d.next(h)) } }",
            "fn f() { std::iter::repeat(1).take(2); std::mem::swap::<u8>(&mut 1, &mut 2); let x = 1..=2; 'a: loop {} }",
            "fn f() { let _ = std::panic::catch_unwind(|| ()); std::thread::yield_now(); }",
            "fn f() -> char { '\"' }",
        ] {
            assert_eq!(first(text), None, "{text}");
        }
    }

    #[test]
    fn what_looks_beyond_the_file_is_named_with_what_to_do() {
        for (text, said) in [
            ("fn f() { include_str!(\"a\"); }", "`include_str!` is not for this lab: it looks beyond the file"),
            ("fn f() { env!(\"HOME\"); }", "`env!` is not for this lab: it looks beyond the file"),
            (
                "use std::include_str as s;",
                "`include_str` is not for this lab: it looks beyond the file; use another name",
            ),
            (
                "use std::env as e;",
                "`env` can stand for the macro `env!` here, which looks beyond the file; use another name",
            ),
        ] {
            let found = first(text).unwrap();
            assert!(found.ends_with(said), "{text}: {found}");
        }
    }

    #[test]
    fn findings_name_their_place() {
        assert_eq!(
            first("fn f() {\r\n    std::fs::read(\"x\");\r\n}").unwrap(),
            "2:10 `std::fs` is not for this lab: it reaches files"
        );
        assert!(first("fn f() {\n  \"open").unwrap().starts_with("2:"), "{:?}", first("fn f() {\n  \"open"));
        let deep = format!("fn f() {{ {}{} }}", "(".repeat(500), ")".repeat(500));
        assert!(first(&deep).unwrap().contains("nested"));
        let many = "fn f() { std::fs::a(); }\n".repeat(100);
        assert!(matches!(scan(&many), Err(ScanError::Forbidden(found)) if found.len() == MOST));
    }
}
