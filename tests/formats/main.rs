//! Every format brings back what was written, refuses bad input at the right place, and never panics.

mod bad_input;
mod outputs;
mod round_trips;
mod shared;
mod support;
