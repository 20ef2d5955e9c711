//! How many records a call looks at, and what to say of one that looks at too many.
//!
//! ```text
//!   begin(records) ──▶ one, one, one, …        20 × records + 1,000 reads: the call is ended
//!                               └── the last of them are kept: in which circle did it run?
//!
//!   h3 h7 h3 h7 h3 h7      circle    a walk that does not come back to where it began
//!   h0 h1 h2 … h0 h1 h2    scan      everything is looked at, again and again
//! ```
//!
//! Counting is off except while a function of yours runs, so that dumps cost nothing. Nothing here can be reached from
//! your file.

use std::cell::{Cell, RefCell};
use std::panic::Location;

/// So many reads a call has for each record, and so many besides.
const EACH: u64 = 20;
const BESIDES: u64 = 1000;
/// How many of the last reads are kept.
const KEPT: u64 = 4000;
/// So many moves a pen can make.
const MOVES: u32 = 2000;
/// How many elements are named.
const NAMED: usize = 12;

/// Whether a record was asked for by its number or came from an iterator over all of them.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Origin {
    Number,
    Iterator,
}

/// A read: the letter of the kind, the number, and how it came.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Read {
    letter: char,
    number: usize,
    origin: Origin,
}

/// The count of a thread.
struct Count {
    on: Cell<bool>,
    reads: Cell<u64>,
    /// From this count on, reads are kept.
    watched: Cell<u64>,
    limit: Cell<u64>,
    moves: Cell<u32>,
    /// Reads before the last move of the pen.
    before: Cell<u64>,
    stopped: Cell<bool>,
    place: Cell<Option<&'static Location<'static>>>,
    last: RefCell<Vec<Read>>,
}

thread_local! {
    static COUNT: Count = const {
        Count {
            on: Cell::new(false),
            reads: Cell::new(0),
            watched: Cell::new(u64::MAX),
            limit: Cell::new(u64::MAX),
            moves: Cell::new(0),
            before: Cell::new(0),
            stopped: Cell::new(false),
            place: Cell::new(None),
            last: RefCell::new(Vec::new()),
        }
    };
}

/// What is thrown to end a call. It is no panic with a message: the call did nothing wrong but go on.
pub(super) struct TooManyReads;

/// Counts a read.
#[inline]
pub(super) fn one(letter: char, number: usize, origin: Origin, place: &'static Location<'static>) {
    COUNT.with(|count| {
        if count.on.get() {
            let reads = count.reads.get() + 1;
            count.reads.set(reads);
            if reads >= count.watched.get() {
                count.keep(Read { letter, number, origin }, place);
            }
        }
    });
}

/// Counts a look at all of `length` records.
pub(super) fn many(letter: char, length: usize, place: &'static Location<'static>) {
    COUNT.with(|count| {
        if count.on.get() && length > 0 {
            count.reads.set(count.reads.get() + length as u64 - 1);
            for number in length.saturating_sub(KEPT as usize)..length - 1 {
                count.last.borrow_mut().push(Read { letter, number, origin: Origin::Iterator });
            }
            one(letter, length - 1, Origin::Iterator, place);
        }
    });
}

impl Count {
    fn keep(&self, read: Read, place: &'static Location<'static>) {
        let mut last = self.last.borrow_mut();
        if last.len() >= 2 * KEPT as usize {
            let half = last.len() - KEPT as usize;
            last.drain(..half);
        }
        last.push(read);
        if self.reads.get() > self.limit.get() {
            if !self.stopped.replace(true) {
                self.place.set(Some(place));
            }
            // A second panic while the first is on its way would end the whole program.
            if !std::thread::panicking() {
                drop(last);
                std::panic::resume_unwind(Box::new(TooManyReads));
            }
        }
    }

    fn restart(&self, limit: u64) {
        self.reads.set(0);
        self.limit.set(limit);
        self.watched.set(limit.saturating_sub(KEPT));
        self.last.borrow_mut().clear();
    }
}

/// How many reads a call may make in a structure of so many records.
fn limit_of(records: usize) -> u64 {
    records as u64 * EACH + BESIDES
}

/// Counts from now on, for one call in a structure of so many records.
pub(super) fn begin(records: usize) {
    begin_within(limit_of(records));
}

/// Counts from now on, for one call that may make so many reads.
///
/// # Panics
/// If a call is being counted already: none can give itself more by running a case inside it.
pub(super) fn begin_within(limit: u64) {
    COUNT.with(|count| {
        assert!(!count.on.get(), "a case cannot be run inside a call");
        count.restart(limit);
        count.moves.set(0);
        count.before.set(0);
        count.stopped.set(false);
        count.place.set(None);
        count.on.set(true);
    });
}

/// Stops counting. Returns how many reads there were, and the end of the call if it was ended by them.
pub(super) fn end() -> (u64, Option<Stop>) {
    COUNT.with(|count| {
        count.on.set(false);
        let reads = count.before.get() + count.reads.get();
        let stop = count.stopped.get().then(|| {
            let last = count.last.borrow();
            Stop { reads, place: count.place.get(), pattern: pattern(&last) }
        });
        (reads, stop)
    })
}

/// Gives a call that is made of several moves its reads anew with each move. Only the program has one.
#[derive(Clone, Copy)]
pub struct Meter {
    _private: (),
}

impl Meter {
    pub(super) fn new() -> Self {
        Self { _private: () }
    }

    /// The call may make so many reads: for a function that has to look at its records many times.
    pub fn allow(self, reads: u64) {
        COUNT.with(|count| {
            if count.on.get() && !count.stopped.get() {
                count.restart(reads);
            }
        });
    }

    /// A move begins or ends, in a structure of so many records: the count starts anew. The number of moves is limited.
    #[track_caller]
    pub fn next_move(self, records: usize) {
        let place = Location::caller();
        COUNT.with(|count| {
            if !count.on.get() || count.stopped.get() {
                return;
            }
            count.before.set(count.before.get() + count.reads.get());
            count.restart(limit_of(records));
            count.moves.set(count.moves.get() + 1);
            if count.moves.get() > MOVES {
                count.stopped.set(true);
                count.place.set(Some(place));
                std::panic::resume_unwind(Box::new(TooManyReads));
            }
        });
    }
}

/// A call that was ended because it looked at too many records.
pub(super) struct Stop {
    reads: u64,
    place: Option<&'static Location<'static>>,
    pattern: (&'static str, Vec<String>),
}

impl Stop {
    /// Where the last read came from.
    pub(super) fn place(&self) -> String {
        self.place.map_or_else(|| "-".to_owned(), place)
    }

    /// `1401 circle src/lab.rs:95:13 h3 h7`
    pub(super) fn words(&self) -> String {
        let place = self.place();
        let (pattern, elements) = &self.pattern;
        let blank = if elements.is_empty() { "" } else { " " };
        format!("{} {pattern} {place}{blank}{}", self.reads, elements.join(" "))
    }
}

/// `src/lab.rs:95:13`
pub(super) fn place(place: &Location) -> String {
    let file = place.file().replace('\\', "/");
    let file = file.rfind("src/").map_or(file.as_str(), |at| &file[at..]);
    format!("{file}:{}:{}", place.line(), place.column())
}

/// How the last reads follow each other, and the elements to name.
fn pattern(last: &[Read]) -> (&'static str, Vec<String>) {
    let is_scan = last.iter().filter(|read| read.origin == Origin::Iterator).count() > last.len() / 2;
    // An element that is read twice in a row is one station of the walk.
    let mut walk: Vec<Read> = last.to_vec();
    walk.dedup_by(|a, b| (a.letter, a.number) == (b.letter, b.number));
    let name = |read: &Read| format!("{}{}", read.letter, read.number);
    if is_scan || runs_through_all(&walk) {
        return ("scan", Vec::new());
    }
    let n = walk.len();
    let same = |a: &Read, b: &Read| (a.letter, a.number) == (b.letter, b.number);
    let is_period = |p: usize| (n - 2 * p..n).all(|i| same(&walk[i], &walk[i - p]));
    match (1..=n / 3).find(|&p| is_period(p)) {
        Some(period) => {
            let circle = &walk[n - period..];
            let first = (0..period).min_by_key(|&i| (circle[i].letter, circle[i].number)).unwrap_or(0);
            ("circle", circle.iter().cycle().skip(first).take(period.min(NAMED)).map(name).collect())
        }
        None => ("open", walk[n.saturating_sub(NAMED)..].iter().map(name).collect()),
    }
}

/// Whether the numbers of one kind go up by one, from 0 or for a long while, most of the time.
fn runs_through_all(walk: &[Read]) -> bool {
    const LONG: usize = 500;
    let Some(most) = walk.last().map(|read| read.letter) else { return false };
    let numbers: Vec<usize> = walk.iter().filter(|read| read.letter == most).map(|read| read.number).collect();
    let steps = numbers.windows(2).filter(|pair| pair[1] == pair[0] + 1 || pair[1] == 0).count();
    let from_the_first = numbers.contains(&0) && numbers.windows(2).any(|pair| pair[1] == 0 && pair[0] > 16);
    steps + 1 >= numbers.len().max(2) && (from_the_first || numbers.len() > LONG && !numbers.contains(&0))
}
