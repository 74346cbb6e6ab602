//! The program `mdr`: verify the theory, ask for critical quantities, solve whole scenes, prove the derivations.

#![forbid(unsafe_code)]

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

use std::process::ExitCode;

use clap::{CommandFactory, Parser, Subcommand};

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
            Command::Critical(critical) => critical.run(out),
            Command::Solve(solve) => solve.run(out).map(|()| true),
            Command::Fit(fit) => fit.run(out),
            Command::Report(report) => report.run(out),
            Command::Figures(figures) => figures.run(out).map(|()| true),
            Command::Reference(reference) => reference.run(out),
            Command::Judge(judge) => judge.run(out),
            Command::Derive(derive) => derive.run(out),
            Command::Completions { shell } => {
                clap_complete::generate(*shell, &mut Program::command(), "mdr", out);
                Ok(true)
            }
            Command::Man => {
                let page = clap_mangen::Man::new(Program::command()).render(out);
                page.map(|()| true).map_err(|error| error::Failure::file("standard output", error))
            }
        }
    }
}
