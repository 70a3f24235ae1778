//! Leaves the symbols out of the program where the linker of the target is known to take the option, and names the commit.

use std::env;
use std::path::Path;
use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let is = |name: &str, value: &str| env::var(name).is_ok_and(|found| found == value);
    let released = is("PROFILE", "release");
    if released && is("CARGO_CFG_TARGET_OS", "linux") {
        println!("cargo::rustc-link-arg-bins=-Wl,--strip-all");
    }
    let version = env::var("CARGO_PKG_VERSION").unwrap_or_default();
    // Only where it is released: otherwise each commit would compile all again.
    let commit = commit().filter(|_| released).map(|commit| format!(" ({commit})"));
    println!("cargo::rustc-env=ASSUR_VERSION={version}{}", commit.unwrap_or_default());
}

/// The commit that is checked out; `None` outside of a repository of git.
fn commit() -> Option<String> {
    let log = Path::new("../.git/logs/HEAD");
    if log.exists() {
        // Grows with each commit and each change of the branch.
        println!("cargo::rerun-if-changed={}", log.display());
    }
    let output = Command::new("git").args(["rev-parse", "--short=12", "HEAD"]).output().ok()?;
    let commit = String::from_utf8(output.stdout).ok()?.trim().to_owned();
    Some(commit).filter(|commit| output.status.success() && !commit.is_empty())
}
