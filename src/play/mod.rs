//! A session of the playground: what the page in the browser is a shell round.
//!
//! ```text
//!   page: clicks, keys, text ──▶ Action ──▶ Session ──▶ Reply ──▶ page: SVG, tables, sentences
//! ```
//!
//! Everything is decided here, by the same kernel as everywhere; the page sends places and words and shows what it gets.
//! A session never panics: what cannot be done is a sentence, and the scene is as it was.
//!
//! ```text
//!   session/     the session: what is asked for, what has changed        reply.rs   words between page and session
//!   scene.rs     what is played with, and where it comes from            points.rs  points and their triangulation
//!   edits.rs     a structure with its history and its script             film.rs    edits as a page that plays them
//!   canvas.rs    places of the picture and points of the plane           tables.rs  records as HTML and in words
//!   walk.rs      paths of links                                          broken.rs  pointers led elsewhere by hand
//!   link.rs      the scene in the address of the page                    dice.rs    numbers from a seed
//!   page.rs      a file inside the page
//!   quizzes/     four kinds of questions                                 tests.rs   what holds for every session
//! ```
//!
//! ```
//! use dcel_kit::play::{Action, Session};
//! let mut session = Session::new();
//! let reply = session.act(&Action::Script { text: "split_face h2 h8".to_owned() });
//! assert_eq!(reply.message.unwrap().text, "split_face h2 h8 returned h12, f2");
//! let refused = session.act(&Action::Script { text: "split_face h2 h12".to_owned() }).message.unwrap();
//! assert!(refused.elements.contains(&"h12".to_owned()), "{}", refused.text);
//! ```

mod broken;
mod canvas;
mod dice;
mod edits;
mod film;
mod link;
mod page;
mod points;
mod quizzes;
mod reply;
mod scene;
mod session;
mod tables;
#[cfg(test)]
mod tests;
mod walk;

pub use page::page_with;
pub use reply::{Action, File, Message, Question, Reply, Selected, Status, Tone};
pub use session::Session;
