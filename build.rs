//! Sets the cfg `shared_data` where the test data stand beside the checkout.

fn main() {
    println!("cargo::rustc-check-cfg=cfg(shared_data)");
    if std::path::Path::new("../shared/data").is_dir() {
        println!("cargo::rustc-cfg=shared_data");
    }
}
