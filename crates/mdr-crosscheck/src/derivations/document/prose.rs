//! Prose with formulas between backquotes.

use mdr_symbolic::{Formula, Statement};

/// A piece of prose.
pub(super) enum Piece<'a> {
    Words(&'a str),
    Formula(Box<Formula>),
    Statement(Box<Statement>),
}

/// The pieces of a text. What stands between backquotes is a statement or a formula.
pub(super) fn pieces(text: &str) -> Vec<Piece<'_>> {
    text.split('`')
        .enumerate()
        .filter(|(_, part)| !part.is_empty())
        .map(|(i, part)| match (i % 2, part.parse::<Statement>(), part.parse::<Formula>()) {
            (1, Ok(statement), _) => Piece::Statement(Box::new(statement)),
            (1, _, Ok(formula)) => Piece::Formula(Box::new(formula)),
            _ => Piece::Words(part),
        })
        .collect()
}

/// The text with each kind of piece rendered.
pub(super) fn render(
    text: &str,
    words: impl Fn(&str) -> String,
    formula: impl Fn(&Formula) -> String,
    statement: impl Fn(&Statement) -> String,
) -> String {
    pieces(text)
        .into_iter()
        .map(|piece| match piece {
            Piece::Words(part) => words(part),
            Piece::Formula(part) => formula(&part),
            Piece::Statement(part) => statement(&part),
        })
        .collect()
}
