//! The feedback on one test as a page of its own, with its pictures: what a terminal cannot show.

use crate::Picture;
use dcel_kit::figure::escaped;
use std::fmt::Write;

/// The page.
pub(super) fn page(title: &str, text: &str, picture: &Picture) -> String {
    let mut out = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>{title}</title>\n<style>\n\
         body {{ font-family: sans-serif; margin: 2em; max-width: 80em }}\n\
         div {{ display: flex; flex-wrap: wrap; gap: 1em }}\nfigure {{ margin: 0; flex: 1 1 24em }}\n\
         svg {{ max-width: 100%; height: auto }}\npre {{ overflow-x: auto }}\n</style>\n</head>\n<body>\n\
         <h1>{title}</h1>\n<div>\n",
        title = escaped(title)
    );
    for (name, svg) in [("before", &picture.before), ("expected", &picture.expected), ("yours", &picture.yours)] {
        // An SVG inside a page begins with its element.
        let svg = svg.find("<svg").map_or("", |at| &svg[at..]);
        let _ = writeln!(out, "<figure>\n<figcaption>{name}</figcaption>\n{svg}</figure>");
    }
    let _ = write!(out, "</div>\n<pre>{}</pre>\n</body>\n</html>\n", escaped(text));
    out
}
