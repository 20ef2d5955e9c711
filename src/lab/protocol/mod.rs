//! The text that goes to a driver and the text that comes back.
//!
//! ```text
//!   token K7Q2                        @K7Q2 case ears
//!   case ears                         @K7Q2 call split_face 2 8       words resolved to numbers
//!   rectangle                    ──▶  @K7Q2 returned true
//!   split_face h2 h8                  hello from the student          no token: printed by the student
//!   dump                              @K7Q2 dump
//!                                     @K7Q2 outer 0 ... end_dump
//!                                     @K7Q2 end_case ears
//!                                     @K7Q2 done
//! ```
//!
//! A case is a few lines that a student can type: a start, then calls, `dump` where the structure is to be seen.
//! The answer is read strictly: every line must be the one that this case calls for at this place, every number
//! is checked, and sizes are capped. A case that is not answered to its end counts as not answered.

mod answer;
mod case;
mod dump;
mod read;
mod structure;
mod text;
mod value;

pub use answer::{Answers, Broken, CallEnd, Called, CaseAnswer, Many, Pattern, Reply, Stopped, grouped};
pub use case::{Case, Start, Step};
pub use read::read_answers;
pub use structure::{Cell, ColumnSchema, RecordSchema, Records, Schema, Structure, TableSchema};
pub use value::Value;
