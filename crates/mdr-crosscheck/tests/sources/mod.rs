//! The public functions of a crate, read from its sources.

use std::fs;
use std::path::{Path, PathBuf};

/// The Rust files below a folder.
pub(crate) fn sources(directory: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(directory).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(sources(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files
}

/// `Type::function` for each `pub fn` in an `impl`, the bare name outside; and what implements `Transform`.
pub(crate) fn public_functions(source: &str) -> Vec<String> {
    let mut names = Vec::new();
    let mut owner: Option<String> = None;
    for line in source.lines() {
        // Items begin in the first column; tests come last in a file.
        if line.starts_with("#[cfg(test)]") {
            break;
        }
        if let Some(header) = line.strip_prefix("impl") {
            let subject = header.split(" for ").last().unwrap_or(header);
            let subject =
                if header.contains(" for ") || !header.starts_with('<') { subject } else { after_generics(subject) };
            owner = Some(subject.trim().chars().take_while(|c| c.is_alphanumeric()).collect());
            if header.contains("Transform<") {
                let owner = owner.clone().unwrap_or_default();
                names.extend(["g", "slope", "integral"].map(|method| format!("{owner}::{method}")));
            }
        } else if line.starts_with('}') {
            owner = None;
        }
        if let Some((_, rest)) = line.split_once("pub fn ").or_else(|| line.split_once("pub const fn ")) {
            if line.trim_start().starts_with("//") {
                continue;
            }
            let name: String = rest.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
            names.push(owner.as_ref().map_or(name.clone(), |owner| format!("{owner}::{name}")));
        }
    }
    names
}

/// What follows the balanced `<…>` at the start of an impl header.
fn after_generics(header: &str) -> &str {
    let mut depth = 0;
    for (i, c) in header.char_indices() {
        depth += i32::from(c == '<') - i32::from(c == '>');
        if depth == 0 {
            return &header[i + 1..];
        }
    }
    header
}
