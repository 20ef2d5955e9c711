//! Handouts as pages that need nothing from outside and no script.
//!
//! ```text
//!   README.md ─▶ events of Markdown ─▶ headings with ids, links that lead somewhere, figures that can be opened ─▶ HTML
//! ```

use pulldown_cmark::{CowStr, Event, HeadingLevel, LinkType, Options, Parser, Tag, TagEnd, html};
use std::collections::BTreeSet;
use std::fmt::Write;

/// What all pages look like.
pub(super) const CSS: &str = include_str!("site.css");

/// A page: what stands in the tab, the way back, and what is on it.
pub(super) struct Page<'a> {
    pub(super) title: &'a str,
    /// From this page to the folder of the site: empty, or `../`.
    pub(super) up: &'a str,
    /// Links above and below, as HTML.
    pub(super) ways: &'a str,
    /// As HTML.
    pub(super) body: &'a str,
}

impl Page<'_> {
    pub(super) fn html(&self) -> String {
        let Self { title, up, ways, body } = self;
        let title = escaped(title);
        let nav = |label: &str| match ways {
            &"" => String::new(),
            ways => format!("<nav aria-label=\"{label}\">{ways}</nav>\n"),
        };
        let (above, below) = (nav("Labs"), nav("Labs, again"));
        format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <meta name=\"color-scheme\" content=\"light dark\">\n<title>{title}</title>\n\
             <link rel=\"stylesheet\" href=\"{up}style.css\">\n</head>\n<body>\n\
             <a class=\"skip\" href=\"#content\">To the text</a>\n{above}\
             <main id=\"content\">\n{body}</main>\n{below}</body>\n</html>\n"
        )
    }
}

/// Text as it stands in a page.
pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// A handout as HTML. `leads` tells where a link of it leads on the site; a link that would lead nowhere is a text.
/// `width` is that of a figure in pixels.
pub(super) fn of_markdown(
    text: &str,
    leads: &dyn Fn(&str) -> Option<String>,
    width: &dyn Fn(&str) -> Option<f64>,
) -> String {
    let mut options = Options::empty();
    options.insert(Options::ENABLE_TABLES);
    options.insert(Options::ENABLE_STRIKETHROUGH);
    options.insert(Options::ENABLE_FOOTNOTES);
    let mut parser = Parser::new_ext(text, options);
    let mut events = Vec::new();
    let mut ids = Ids::default();
    // Whether each open link leads somewhere.
    let mut open = Vec::new();
    while let Some(event) = parser.next() {
        match event {
            Event::Start(Tag::Heading { level, classes, attrs, .. }) => {
                let inside: Vec<Event> = parser.by_ref().take_while(|event| !ends_heading(event)).collect();
                let id = ids.of(&words(&inside));
                events.push(Event::Start(Tag::Heading { level, id: Some(id.into()), classes, attrs }));
                events.extend(inside);
                events.push(Event::End(TagEnd::Heading(level)));
            }
            Event::Start(Tag::Image { dest_url, .. }) => {
                let inside: Vec<Event> =
                    parser.by_ref().take_while(|event| !matches!(event, Event::End(TagEnd::Image))).collect();
                // A figure inside of a link is opened by that link.
                let figure = figure(&dest_url, &words(&inside), width(&dest_url), open.is_empty());
                events.push(Event::InlineHtml(figure.into()));
            }
            Event::Start(Tag::Link { link_type, dest_url, title, id }) => {
                let to = target(link_type, &dest_url, leads);
                open.push(to.is_some());
                events.extend(to.map(|to| Event::Start(Tag::Link { link_type, dest_url: to, title, id })));
            }
            Event::End(TagEnd::Link) => {
                if open.pop() == Some(true) {
                    events.push(Event::End(TagEnd::Link));
                }
            }
            // A wide table is scrolled by itself, by keyboard, too.
            Event::Start(Tag::Table(columns)) => {
                let scrolled = "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"Table\">\n";
                events.extend([Event::Html(scrolled.into()), Event::Start(Tag::Table(columns))]);
            }
            Event::End(TagEnd::Table) => events.extend([Event::End(TagEnd::Table), Event::Html("</div>\n".into())]),
            event => events.push(event),
        }
    }
    let mut out = String::new();
    html::push_html(&mut out, events.into_iter());
    // So is a wide text.
    out.replace("<pre>", "<pre tabindex=\"0\">")
}

/// The title of a handout: its first heading.
pub(super) fn title(text: &str) -> Option<String> {
    let mut parser = Parser::new(text);
    parser.find(|event| matches!(event, Event::Start(Tag::Heading { level: HeadingLevel::H1, .. })))?;
    Some(words(&parser.take_while(|event| !ends_heading(event)).collect::<Vec<_>>()))
}

fn ends_heading(event: &Event) -> bool {
    matches!(event, Event::End(TagEnd::Heading(_)))
}

/// The letters of a text without its marks.
fn words(events: &[Event]) -> String {
    let word = |event: &Event| match event {
        Event::Text(text) | Event::Code(text) => text.to_string(),
        Event::SoftBreak | Event::HardBreak => " ".to_owned(),
        _ => String::new(),
    };
    events.iter().map(word).collect()
}

fn target<'a>(kind: LinkType, to: &CowStr<'a>, leads: &dyn Fn(&str) -> Option<String>) -> Option<CowStr<'a>> {
    let is_absolute = to.starts_with("https://") || to.starts_with("http://") || kind == LinkType::Email;
    if is_absolute || to.starts_with('#') { Some(to.clone()) } else { leads(to).map(CowStr::from) }
}

/// A figure as wide as it was drawn; a narrower window scrolls it, so that its letters can be read. With `opens` it
/// leads to the drawing alone.
fn figure(address: &str, text: &str, width: Option<f64>, opens: bool) -> String {
    let width = width.map_or_else(String::new, |width| format!(" style=\"--drawn: {width}px\""));
    let mut out = format!("<span class=\"figure\"{width}>");
    let address = escaped(address);
    if opens {
        let _ = write!(out, "<a href=\"{address}\" title=\"The drawing alone\">");
    }
    let _ = write!(out, "<img src=\"{address}\" alt=\"{}\">", escaped(text));
    out.push_str(if opens { "</a></span>" } else { "</span>" });
    out
}

/// The ids of headings as links in handouts name them: lower case, `-` for blanks, other marks left out, and a number
/// behind those that were there before.
#[derive(Default)]
struct Ids {
    used: BTreeSet<String>,
}

impl Ids {
    fn of(&mut self, heading: &str) -> String {
        let letter = |c: char| match c {
            ' ' | '-' => Some('-'),
            c if c.is_alphanumeric() || c == '_' => Some(c),
            _ => None,
        };
        let plain: String = heading.to_lowercase().chars().filter_map(letter).collect();
        let numbered = (1..).map(|number| format!("{plain}-{number}"));
        let id = std::iter::once(plain.clone()).chain(numbered).find(|id| !self.used.contains(id)).unwrap_or(plain);
        self.used.insert(id.clone());
        id
    }
}
