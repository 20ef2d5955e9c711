//! The `dcel` command.

fn main() {}
