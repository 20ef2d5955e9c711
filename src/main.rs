//! The `dcel` command.

mod cli;

fn main() -> std::process::ExitCode {
    // Behind walls the command starts itself again to put them up.
    dcel_kit::lab::launched().unwrap_or_else(cli::main)
}
