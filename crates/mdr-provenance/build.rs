//! The commit of the repository that is built, if there is one: `MDR_COMMIT` from outside, or what git says.

#![allow(clippy::print_stdout, reason = "this is how a build script answers")]

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed=MDR_COMMIT");
    let given = env::var("MDR_COMMIT").ok().filter(|commit| !commit.is_empty());
    if let Some(commit) = given.or_else(|| commit(Path::new("../.."))) {
        println!("cargo::rustc-env=MDR_COMMIT={commit}");
    }
}

/// The commit of the repository of this workspace, with a `+` where a source file differs from it.
fn commit(root: &Path) -> Option<String> {
    // Cargo leaves this file in a package from a registry, whose folder may lie within somebody else's repository.
    let packaged = Path::new("Cargo.toml.orig").exists();
    let here = root.join("crates/mdr-provenance/build.rs").canonicalize().ok()?;
    if packaged || here != Path::new("build.rs").canonicalize().ok()? {
        return None;
    }
    let top = PathBuf::from(git(root, &["rev-parse", "--show-toplevel"])?);
    if top.canonicalize().ok()? != root.canonicalize().ok()? {
        return None;
    }
    // What a commit changes, in any layout of a repository: HEAD and its branch.
    for name in ["HEAD", "logs/HEAD", "packed-refs"] {
        watch(&root.join(git(root, &["rev-parse", "--git-path", name])?));
    }
    if let Some(branch) = git(root, &["symbolic-ref", "-q", "HEAD"]) {
        watch(&root.join(git(root, &["rev-parse", "--git-path", &branch])?));
    }
    let sources = ["crates", "Cargo.toml", "Cargo.lock"];
    sources.iter().for_each(|source| watch(&root.join(source)));
    let commit = git(root, &["rev-parse", "--short=12", "HEAD"])?;
    let changed = git(root, &[&["status", "--porcelain", "--"], &sources[..]].concat())?;
    Some(if changed.is_empty() { commit } else { format!("{commit}+") })
}

/// Runs this script again when a file changes. A file that is not there would run it always.
fn watch(path: &Path) {
    if path.exists() {
        println!("cargo::rerun-if-changed={}", path.display());
    }
}

/// What git prints, if it can be asked.
fn git(root: &Path, arguments: &[&str]) -> Option<String> {
    let mut git = Command::new("git");
    // A hook of git has these set for its own purposes.
    git.env_remove("GIT_DIR").env_remove("GIT_WORK_TREE").env_remove("GIT_INDEX_FILE");
    let output = git.arg("-C").arg(root).args(["--no-optional-locks"]).args(arguments).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    output.status.success().then(|| text.trim().to_owned())
}
