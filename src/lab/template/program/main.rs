//! The program `dcel` with this lab in it: `cargo run -- lab verify @NUMBER@`.

fn main() -> std::process::ExitCode {
    // The folder with the lab's `lab.toml`.
    dcel_cli::with_own_lab(concat!(env!("CARGO_MANIFEST_DIR"), "/.."), &judge::JUDGE)
}
