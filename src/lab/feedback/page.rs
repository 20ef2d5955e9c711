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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_shows_the_three_drawings_in_their_order_under_an_escaped_title() {
        let drawing = |name: &str| format!("<?xml version=\"1.0\"?>\n<svg><title>{name}</title></svg>");
        let [before, expected, yours] = ["b", "e", "y"].map(drawing);
        let page = page("a < b", "h3 <- h4 & more", &Picture { before, expected, yours, ascii: String::new() });
        let place = |text: &str| page.find(text).unwrap_or_else(|| panic!("no {text} in {page}"));
        assert!(page.starts_with("<!DOCTYPE html>") && page.contains("<title>a &lt; b</title>"));
        let order = ["before</", "<title>b", "expected</", "<title>e", "yours</", "<title>y"].map(place);
        assert!(order.is_sorted() && !page.contains("<?xml"), "{page}");
        assert!(place("h3 &lt;- h4 &amp; more") > order[5], "{page}");
    }
}
