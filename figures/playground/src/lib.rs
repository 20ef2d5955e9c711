//! The playground for browsers: strings in, strings out. Everything else is [`dcel_kit::play`].

use dcel_kit::play::{Action, Message, Reply, Session, Tone};
use wasm_bindgen::prelude::wasm_bindgen;

/// A session of the playground.
#[wasm_bindgen]
#[derive(Default)]
pub struct Playground(Session);

#[wasm_bindgen]
impl Playground {
    /// A session with the lab's rectangle.
    #[wasm_bindgen(constructor)]
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// An action as JSON; the reply as JSON.
    pub fn act(&mut self, action: &str) -> String {
        let reply = match serde_json::from_str::<Action>(action) {
            Ok(action) => self.0.act(&action),
            Err(error) => strange(&error),
        };
        json(&reply)
    }

    /// A file that was dropped; the reply as JSON.
    pub fn open(&mut self, name: &str, bytes: &[u8]) -> String {
        json(&self.0.open(name, bytes))
    }
}

fn strange(error: &serde_json::Error) -> Reply {
    let text = format!("the page has asked for what the playground does not know: {error}");
    let mut reply = Reply::default();
    reply.message = Some(Message { tone: Tone::Refused, text, elements: Vec::new() });
    reply
}

fn json(reply: &Reply) -> String {
    serde_json::to_string(reply).unwrap_or_else(|_| "{}".to_owned())
}
