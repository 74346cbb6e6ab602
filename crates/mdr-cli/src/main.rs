//! The program `mdr`: verify the theory, compute critical quantities, solve whole scenes, prove the derivations.

#![forbid(unsafe_code)]

mod cite;
mod columns;
mod converter;
mod critical;
mod derive;
mod error;
mod figures;
mod files;
mod fit;
mod flags;
mod judge;
mod output;
mod plot;
mod progress;
mod reference;
mod report;
mod solve;
mod table;
mod validity;
mod verify;

use std::io::{ErrorKind, Write};
use std::process::ExitCode;

use clap::error::{ContextKind, ContextValue};
use clap::{CommandFactory, Parser, Subcommand};
use mdr_core::text::excerpt;

use crate::error::{Failure, Result, complain};
use crate::output::Output;

/// Reference software for adhesion instabilities of axisymmetric contacts.
///
/// Popov's theory of the critical states of adhesive contacts by the method of dimensionality reduction: closed forms
/// with certified digits, and their verification against an independent computation.
#[derive(Debug, Parser)]
#[command(name = "mdr", version, max_term_width = 110, arg_required_else_help = true)]
struct Program {
    #[command(subcommand)]
    command: Command,
}

/// In the order in which a user comes to need them.
#[derive(Debug, Subcommand)]
enum Command {
    Critical(Box<critical::Critical>),
    Solve(solve::Solve),
    Fit(fit::Fit),
    Reference(reference::Reference),
    Judge(judge::Judge),
    Verify(verify::Verify),
    Derive(derive::Derive),
    Figures(figures::Figures),
    Report(report::Report),
    Cite(cite::Cite),
    /// Print a completion script for a shell: mdr completions bash > /etc/bash_completion.d/mdr
    Completions {
        /// Which shell
        #[arg(value_enum)]
        shell: clap_complete::Shell,
    },
    /// Print the manual page: mdr man | man -l -
    Man,
}

fn main() -> ExitCode {
    let program = match Program::try_parse() {
        Ok(program) => program,
        Err(error) if error.use_stderr() => return usage(error),
        Err(help) => return ending(print_help(&help)),
    };
    let mut out = Output::stdout();
    ending(program.command.run(&mut out).and_then(|holds| out.close().map(|()| holds)))
}

/// The exit status of a command; a failure is said on standard error.
fn ending(result: Result<bool>) -> ExitCode {
    match result {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(failure) => {
            complain(failure);
            ExitCode::from(2)
        }
    }
}

/// The help or the version, on standard output.
fn print_help(help: &clap::Error) -> Result<bool> {
    match help.print().and_then(|()| std::io::stdout().flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Failure::file("standard output", error)),
        _ => Ok(true),
    }
}

/// Arguments that make no command: they are repeated as in every other message.
fn usage(mut error: clap::Error) -> ExitCode {
    let given: Vec<_> = error.context().map(|(kind, value)| (kind, value.clone())).collect();
    let mut changed = false;
    let mut shown = |text: String| {
        let short = excerpt(&text).to_string();
        changed |= short != text;
        short
    };
    let shown: Vec<_> = given
        .into_iter()
        .filter_map(|(kind, value)| match value {
            ContextValue::String(text) => Some((kind, ContextValue::String(shown(text)))),
            ContextValue::Strings(texts) => {
                Some((kind, ContextValue::Strings(texts.into_iter().map(&mut shown).collect())))
            }
            _ => None,
        })
        .collect();
    for (kind, value) in shown {
        error.insert(kind, value);
    }
    if changed {
        // A suggestion repeats the argument as it is.
        error.insert(ContextKind::Suggested, ContextValue::None);
    }
    // A closed standard error changes nothing.
    let _ = error.print();
    ExitCode::from(2)
}

impl Command {
    /// Whether everything that was checked holds.
    fn run(&self, out: &mut Output<impl Write>) -> Result<bool> {
        match self {
            Command::Verify(verify) => verify.run(out),
            Command::Critical(critical) => critical.run(out),
            Command::Solve(solve) => solve.run(out).map(|()| true),
            Command::Fit(fit) => fit.run(out),
            Command::Report(report) => report.run(out),
            Command::Figures(figures) => figures.run(out).map(|()| true),
            Command::Reference(reference) => reference.run(out),
            Command::Judge(judge) => judge.run(out),
            Command::Derive(derive) => derive.run(out),
            Command::Cite(cite) => cite.run(out).map(|()| true),
            Command::Completions { shell } => {
                // The writer of scripts panics where it cannot write.
                let mut script = Vec::new();
                clap_complete::generate(*shell, &mut Program::command(), "mdr", &mut script);
                out.bytes(&script).map(|()| true)
            }
            Command::Man => {
                let mut page = Vec::new();
                let rendered = clap_mangen::Man::new(Program::command()).render(&mut page);
                rendered.map_err(|error| Failure::file("standard output", error))?;
                out.bytes(&page).map(|()| true)
            }
        }
    }
}
