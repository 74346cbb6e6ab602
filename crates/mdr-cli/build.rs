//! Data on the build for the footer of a report: the compiler, and a hash of Cargo.lock.

#![allow(clippy::print_stdout, reason = "this is how a build script answers")]

use std::env;
use std::path::Path;
use std::process::Command;

fn main() {
    let version = env::var_os("RUSTC").and_then(|rustc| Command::new(rustc).arg("--version").output().ok());
    let version = version.and_then(|output| String::from_utf8(output.stdout).ok());
    println!("cargo::rustc-env=MDR_COMPILER={}", version.as_deref().map_or("an unknown rustc", str::trim));

    let lock = Path::new("../../Cargo.lock");
    println!("cargo::rerun-if-changed={}", lock.display());
    if let Ok(bytes) = std::fs::read(lock) {
        println!("cargo::rustc-env=MDR_LOCK={:016x}", fnv(&bytes));
    }
}

/// FNV-1a (Fowler, Noll & Vo), 64 bits.
fn fnv(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x100_0000_01b3))
}
