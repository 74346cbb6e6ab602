//! The program that computed an answer: its release and commit, for the heads of JSON, CSV and SVG.
//!
//! The commit is known when the program is built: from the variable `MDR_COMMIT` of the build's environment, or from the
//! repository that is built. A `+` behind it says that a source file differed from that commit. A build from a registry or from
//! an archive without a repository has no commit. The same sources at the same commit give the same text.

#![forbid(unsafe_code)]

use std::borrow::Cow;

/// The commit that was built, if it is known; a `+` behind it stands for changes that are in no commit.
pub const COMMIT: Option<&str> = option_env!("MDR_COMMIT");

/// The program as a citation names it: `mdr 0.1.0 (0123456789ab)`, or `mdr 0.1.0` without a commit.
///
/// ```
/// assert!(mdr_provenance::program().starts_with("mdr "));
/// ```
pub fn program() -> String {
    let release = env!("CARGO_PKG_VERSION");
    COMMIT.map_or_else(|| format!("mdr {release}"), |commit| format!("mdr {release} ({commit})"))
}

/// Lines of JSON with [`program`] in the head of each, under the key `program` behind the schema. A line without a schema of mdr
/// stays as it is.
///
/// ```
/// let line = mdr_provenance::json(r#"{"schema":"mdr.fit/1","status":"ok"}"#);
/// let program = mdr_provenance::program();
/// assert_eq!(line, format!(r#"{{"schema":"mdr.fit/1","program":"{program}","status":"ok"}}"#));
/// assert_eq!(mdr_provenance::json("{}"), "{}");
/// ```
pub fn json(lines: &str) -> Cow<'_, str> {
    // A quotation mark within a text of JSON is escaped, so that only a key matches.
    if !lines.contains(SCHEMA) {
        return lines.into();
    }
    let program = program();
    lines.split_inclusive('\n').map(|line| with_program(line, &program)).collect::<String>().into()
}

/// The beginning of the entry that names a schema of mdr.
const SCHEMA: &str = "\"schema\":\"mdr.";

fn with_program(line: &str, program: &str) -> String {
    let behind = line.find(SCHEMA).map(|start| start + SCHEMA.len());
    let end = behind.and_then(|behind| Some(behind + line[behind..].find('"')? + 1));
    match end.map(|end| line.split_at(end)) {
        Some((head, rest)) => format!("{head},\"program\":\"{program}\"{rest}"),
        None => line.to_owned(),
    }
}

/// The content of a CSV file below a comment that names [`program`].
///
/// ```
/// let file = mdr_provenance::csv("x,g\n1,0.5\n");
/// assert_eq!(file, format!("# {}\nx,g\n1,0.5\n", mdr_provenance::program()));
/// ```
pub fn csv(content: &str) -> String {
    format!("# {}\n{content}", program())
}

/// A drawing with [`program`] in its metadata. A text that is no SVG stays as it is.
///
/// ```
/// let drawing = mdr_provenance::svg("<svg width=\"1\">\n<path/></svg>");
/// let program = mdr_provenance::program();
/// assert_eq!(drawing, format!("<svg width=\"1\"><metadata>{program}</metadata>\n<path/></svg>"));
/// ```
pub fn svg(drawing: &str) -> Cow<'_, str> {
    let head = drawing.find("<svg").and_then(|start| Some(start + drawing[start..].find('>')? + 1));
    match head.map(|head| drawing.split_at(head)) {
        Some((head, rest)) => format!("{head}<metadata>{}</metadata>{rest}", program()).into(),
        None => drawing.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A release of three numbers, and a commit of twelve digits where there is one.
    #[test]
    fn the_program_is_a_release_and_a_commit() {
        let program = program();
        let release = program.strip_prefix("mdr ").map(|rest| rest.split(' ').next().unwrap_or_default());
        assert!(release.is_some_and(|release| release.split('.').all(|part| part.parse::<u32>().is_ok())), "{program}");
        if let Some(commit) = COMMIT {
            let digits = commit.trim_end_matches('+');
            assert!(digits.len() >= 7 && digits.chars().all(|digit| digit.is_ascii_hexdigit()), "{program}");
            assert!(program.ends_with(&format!("({commit})")), "{program}");
        }
    }

    /// Each line has it once; the names of a schema within a text or without a head are no schema.
    #[test]
    fn only_heads_have_a_program() {
        let head = format!("\"program\":\"{}\"", program());
        let two = json("{\"schema\":\"mdr.verify/1\",\"a\":1}\n{\"schema\":\"mdr.verify/1\"}\n").into_owned();
        assert_eq!(two.matches(&head).count(), 2);
        assert_eq!(
            two,
            format!("{{\"schema\":\"mdr.verify/1\",{head},\"a\":1}}\n{{\"schema\":\"mdr.verify/1\",{head}}}\n")
        );
        let named = r#"{"file":"\"schema\":\"mdr.fit/1\"","schema":"mdr.fit/1","status":"ok"}"#;
        assert_eq!(json(named), named.replace("mdr.fit/1\",\"s", &format!("mdr.fit/1\",{head},\"s")));
        for other in ["", "{}", "no JSON", r#"{"schema":"other/1"}"#, r#"{"why":"\"schema\":\"mdr.solve/1\""}"#] {
            assert_eq!(json(other), other);
        }
    }
}

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
