//! The program `dcel`; all of it is in the library beside it.

fn main() -> std::process::ExitCode {
    dcel_cli::main()
}
