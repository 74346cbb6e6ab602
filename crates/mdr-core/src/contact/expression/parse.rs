//! The grammar of formulas, by precedence climbing.

use std::str::FromStr;

use super::{Constant, EXTREMES, Expression, ExpressionError, Function, Node, Operator};
use crate::number::Literal;
use crate::text::excerpt;

/// Deeper nesting, and longer formulas, are rejected to protect the stack.
const DEEPEST: usize = 200;
const LONGEST: usize = 2000;

/// The most characters of a formula, so that none is read for long before it is refused.
const LONGEST_TEXT: usize = 1_000_000;

#[derive(Clone, Debug, PartialEq)]
enum Token {
    Number(Literal),
    Name(String),
    /// One of `+ - * / ^ ( ) ,`.
    Symbol(char),
    End,
}

impl FromStr for Expression {
    type Err = ExpressionError;

    fn from_str(formula: &str) -> Result<Self, ExpressionError> {
        let mut parser = Parser { tokens: tokens(formula)?, next: 0, depth: 0 };
        let root = parser.sum()?;
        match parser.peek() {
            Token::End => Ok(Expression { root }),
            Token::Symbol(')') => Err(parser.error("a `)` without its `(`")),
            _ => Err(parser.error("expected an operator `+ - * / ^` or the end of the formula")),
        }
    }
}

/// The tokens with their columns; the last is `End`.
fn tokens(formula: &str) -> Result<Vec<(Token, usize)>, ExpressionError> {
    let length = formula.chars().take(LONGEST_TEXT + 1).count();
    if length > LONGEST_TEXT {
        return Err(ExpressionError { column: length, reason: format!("longer than {LONGEST_TEXT} characters") });
    }
    let text: Vec<char> = formula.chars().collect();
    let mut tokens = Vec::new();
    let mut at = 0;
    while at < text.len() {
        let start = at;
        let is_name = |c: char| c.is_alphanumeric() || c == '_';
        let token = match text[at] {
            c if c.is_whitespace() => {
                at += 1;
                continue;
            }
            c if c.is_ascii_digit() || c == '.' => {
                at = end_of_number(&text, at);
                let number: String = text[start..at].iter().collect();
                let literal = number.parse();
                Token::Number(literal.map_err(|error| ExpressionError {
                    column: start + 1,
                    reason: format!("`{}` is {error}", excerpt(&number)),
                })?)
            }
            c if is_name(c) => {
                at += text[at..].iter().take_while(|c| is_name(**c)).count();
                Token::Name(text[start..at].iter().collect())
            }
            c if "+-*/^(),".contains(c) => {
                at += 1;
                Token::Symbol(c)
            }
            c => {
                return Err(ExpressionError {
                    column: start + 1,
                    reason: format!("unexpected character `{}`", excerpt(c.encode_utf8(&mut [0; 4]))),
                });
            }
        };
        if tokens.len() == LONGEST {
            return Err(ExpressionError { column: start + 1, reason: format!("longer than {LONGEST} symbols") });
        }
        tokens.push((token, start + 1));
    }
    tokens.push((Token::End, text.len() + 1));
    Ok(tokens)
}

/// The end of the decimal that starts at `at`; an exponent belongs to it only when digits follow.
fn end_of_number(text: &[char], mut at: usize) -> usize {
    let digits = |from: usize| text[from..].iter().take_while(|c| c.is_ascii_digit()).count();
    while at < text.len() && (text[at].is_ascii_digit() || text[at] == '.') {
        at += 1;
    }
    if at < text.len() && matches!(text[at], 'e' | 'E') {
        let sign = usize::from(matches!(text.get(at + 1), Some('+' | '-')));
        let count = if at + 1 + sign < text.len() { digits(at + 1 + sign) } else { 0 };
        if count > 0 {
            at += 1 + sign + count;
        }
    }
    at
}

struct Parser {
    tokens: Vec<(Token, usize)>,
    next: usize,
    depth: usize,
}

type Parsed = Result<Node<Constant>, ExpressionError>;

impl Parser {
    fn peek(&self) -> &Token {
        &self.tokens[self.next].0
    }

    fn column(&self) -> usize {
        self.tokens[self.next].1
    }

    fn error(&self, reason: impl Into<String>) -> ExpressionError {
        ExpressionError { column: self.column(), reason: reason.into() }
    }

    /// Takes the next token when it is one of these symbols.
    fn take(&mut self, symbols: &str) -> Option<char> {
        match *self.peek() {
            Token::Symbol(c) if symbols.contains(c) => {
                self.next += 1;
                Some(c)
            }
            _ => None,
        }
    }

    fn deeper(&mut self, parse: fn(&mut Self) -> Parsed) -> Parsed {
        if self.depth == DEEPEST {
            return Err(self.error(format!("nested deeper than {DEEPEST} levels")));
        }
        self.depth += 1;
        let node = parse(self);
        self.depth -= 1;
        node
    }

    /// sum = product { (+|−) product }
    fn sum(&mut self) -> Parsed {
        let mut node = self.product()?;
        while let Some(symbol) = self.take("+-") {
            let operator = if symbol == '+' { Operator::Add } else { Operator::Subtract };
            node = Node::Operation(operator, Box::new(node), Box::new(self.product()?));
        }
        Ok(node)
    }

    /// product = signed { (*|/) signed }
    fn product(&mut self) -> Parsed {
        let mut node = self.signed()?;
        while let Some(symbol) = self.take("*/") {
            let operator = if symbol == '*' { Operator::Multiply } else { Operator::Divide };
            node = Node::Operation(operator, Box::new(node), Box::new(self.signed()?));
        }
        Ok(node)
    }

    /// signed = { +|− } power
    fn signed(&mut self) -> Parsed {
        match self.take("+-") {
            Some('-') => Ok(Node::Negative(Box::new(self.deeper(Self::signed)?))),
            Some(_) => self.deeper(Self::signed),
            None => self.power(),
        }
    }

    /// power = atom [ ^ signed ]; an integer exponent is an integer power.
    fn power(&mut self) -> Parsed {
        let base = self.atom()?;
        if self.take("^").is_none() {
            return Ok(base);
        }
        let exponent = self.deeper(Self::signed)?;
        Ok(match integer(&exponent) {
            Some(n) => Node::Power(Box::new(base), n),
            None => Node::Operation(Operator::Power, Box::new(base), Box::new(exponent)),
        })
    }

    /// atom = number | r | pi | parameter | function ( sum ) | ( sum )
    fn atom(&mut self) -> Parsed {
        let column = self.column();
        match self.peek().clone() {
            Token::Number(literal) => {
                self.next += 1;
                Ok(Node::Constant(Constant::Literal(literal)))
            }
            Token::Name(name) => {
                self.next += 1;
                self.named(name, column)
            }
            Token::Symbol('(') => self.parenthesis(),
            Token::Symbol(c) => Err(self.error(format!("expected a number, a name or `(` before `{c}`"))),
            Token::End => Err(self.error("the formula ends where a number, a name or `(` is expected")),
        }
    }

    fn named(&mut self, name: String, column: usize) -> Parsed {
        let function = Function::ALL.iter().find(|(known, _)| *known == name).map(|(_, function)| *function);
        let extreme = EXTREMES.iter().find(|(known, _)| *known == name).map(|(_, operator)| *operator);
        match (self.peek(), function, extreme) {
            (Token::Symbol('('), Some(function), _) => Ok(function_of(function, self.parenthesis()?)),
            (Token::Symbol('('), _, Some(operator)) => self.extreme(&name, operator),
            (Token::Symbol('('), None, None) => Err(ExpressionError { column, reason: unknown_function(&name) }),
            (_, None, None) => Ok(match name.as_str() {
                "r" => Node::Variable,
                "pi" => Node::Constant(Constant::Pi),
                _ => Node::Constant(Constant::Parameter { name, column }),
            }),
            _ => Err(self.error(format!("expected `(` after the function `{name}`"))),
        }
    }

    /// ( sum , sum { , sum } ): the least or the greatest of them.
    fn extreme(&mut self, name: &str, operator: Operator) -> Parsed {
        let opened = self.column();
        self.next += 1;
        let mut node = self.deeper(Self::sum)?;
        if *self.peek() == Token::Symbol(')') {
            return Err(self.error(format!("`{name}` needs two arguments at least, separated by commas")));
        }
        while self.take(",").is_some() {
            node = Node::Operation(operator, Box::new(node), Box::new(self.deeper(Self::sum)?));
        }
        match self.take(")") {
            Some(_) => Ok(node),
            None => Err(self.error(format!("expected `,` or `)` to close the `(` of column {opened}"))),
        }
    }

    fn parenthesis(&mut self) -> Parsed {
        let opened = self.column();
        self.next += 1;
        let inside = self.deeper(Self::sum)?;
        match self.take(")") {
            Some(_) => Ok(inside),
            None => Err(self.error(format!("expected `)` to close the `(` of column {opened}"))),
        }
    }
}

/// A function of an argument. √x² becomes |x|, whose derivatives are exact up to the kink.
fn function_of(function: Function, argument: Node<Constant>) -> Node<Constant> {
    match (function, argument) {
        (Function::Sqrt, Node::Power(x, n)) if n % 2 == 0 => {
            let modulus = Node::Function(Function::Abs, x);
            if n == 2 { modulus } else { Node::Power(Box::new(modulus), n / 2) }
        }
        (function, argument) => Node::Function(function, Box::new(argument)),
    }
}

/// The message for an unknown function.
fn unknown_function(name: &str) -> String {
    let known: Vec<&str> =
        Function::ALL.iter().map(|(known, _)| *known).chain(EXTREMES.map(|(known, _)| known)).collect();
    match name {
        "log" => "unknown function `log`; the natural logarithm is `ln`, the decimal one `log10`".to_owned(),
        _ => format!("unknown function `{}`; known: {}", excerpt(name), known.join(", ")),
    }
}

/// The value of a small integer literal, signed or not.
fn integer(node: &Node<Constant>) -> Option<i64> {
    match node {
        Node::Negative(x) => integer(x).map(|n| -n),
        Node::Constant(Constant::Literal(literal)) => literal.small_integer(),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_exponent_close_to_an_integer_is_no_integer() {
        let near = "r^2.00000000000000000000001".parse::<Expression>().unwrap();
        assert!(matches!(near.root, Node::Operation(Operator::Power, ..)));
    }
}
