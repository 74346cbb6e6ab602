//! The program `mdr`: verify the theory, ask for critical quantities, solve whole scenes, prove the derivations.

#![forbid(unsafe_code)]

mod critical;
mod derive;
mod error;
mod figures;
mod flags;
mod judge;
mod output;
mod plot;
mod reference;
mod report;
mod solve;
mod table;
mod verify;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

use crate::error::Result;
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

#[derive(Debug, Subcommand)]
enum Command {
    Verify(verify::Verify),
    Critical(critical::Critical),
    Solve(solve::Solve),
    Report(report::Report),
    Figures(figures::Figures),
    Reference(reference::Reference),
    Judge(judge::Judge),
    Derive(derive::Derive),
}

fn main() -> ExitCode {
    let program = Program::parse();
    let mut out = Output::stdout();
    match program.command.run(&mut out) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(failure) => {
            // A closed standard error changes nothing.
            let _ = std::io::Write::write_fmt(&mut std::io::stderr(), format_args!("error: {failure}\n"));
            ExitCode::from(2)
        }
    }
}

impl Command {
    /// Whether everything that was checked holds.
    fn run(&self, out: &mut Output<impl std::io::Write>) -> Result<bool> {
        match self {
            Command::Verify(verify) => verify.run(out),
            Command::Critical(critical) => critical.run(out).map(|()| true),
            Command::Solve(solve) => solve.run(out).map(|()| true),
            Command::Report(report) => report.run(out),
            Command::Figures(figures) => figures.run(out).map(|()| true),
            Command::Reference(reference) => reference.run(out),
            Command::Judge(judge) => judge.run(out),
            Command::Derive(derive) => derive.run(out),
        }
    }
}
