//! Reading what a process prints without ever waiting for it: threads fill buffers up to a cap.
//!
//! A child of the process may keep a pipe open after its end. So the buffers are shared, and whoever reads them
//! takes what is there.

use std::io::{Read, Write};
use std::sync::mpsc::Sender;
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

/// What happened on a pipe.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Event {
    /// It was closed on the other side.
    Closed,
    /// More came than may come.
    Full,
}

/// A pipe that is being read.
pub(crate) struct Pipe {
    bytes: Arc<Mutex<Vec<u8>>>,
}

impl Pipe {
    /// Starts reading. After `cap` bytes the rest is thrown away; the first such byte sends `Full`.
    pub(crate) fn read(mut from: impl Read + Send + 'static, cap: usize, events: Sender<Event>) -> Self {
        let bytes = Arc::new(Mutex::new(Vec::new()));
        let into = Arc::clone(&bytes);
        thread::spawn(move || {
            let mut chunk = [0; 16 * 1024];
            let mut full = false;
            while let Ok(n @ 1..) = from.read(&mut chunk) {
                let mut bytes = into.lock().unwrap_or_else(PoisonError::into_inner);
                let room = cap - bytes.len();
                bytes.extend_from_slice(&chunk[..n.min(room)]);
                if n > room && !full {
                    full = true;
                    let _ = events.send(Event::Full);
                }
            }
            let _ = events.send(Event::Closed);
        });
        Self { bytes }
    }

    /// What has come so far.
    pub(crate) fn take(&self) -> Vec<u8> {
        std::mem::take(&mut self.bytes.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

/// Writes the input and closes the pipe. A process that ends without reading it is no error.
pub(crate) fn feed(mut to: impl Write + Send + 'static, input: String) {
    thread::spawn(move || {
        let _ = to.write_all(input.as_bytes());
    });
}
