//! Parses formulas.
//!
//! ```text
//! sum     = ["-"] product (("+" | "-") product)*
//! product = power (("*" | "/") power)*
//! power   = primary ["^" power]
//! primary = number | name | name "(" sum ("," sum)* ")" | "(" sum ")"
//! ```
//!
//! Further functions: sqrt(u), diff(u, a), int(u, x, upper), at(u, a, value) and turn(u) = ∫₀^{π/2} u dθ.

use std::iter::Peekable;
use std::str::{Chars, FromStr};

use rug::{Integer, Rational};

use super::{Definition, Formula, Function, Variable};
use crate::error::{Error, Result};
use crate::symbol::Symbol;

impl FromStr for Formula {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let mut parser = Parser { text, rest: text.chars().peekable() };
        let formula = parser.sum()?;
        match parser.peek() {
            None => Ok(formula),
            Some(c) => Err(parser.error(format!("unexpected {c}"))),
        }
    }
}

struct Parser<'a> {
    text: &'a str,
    rest: Peekable<Chars<'a>>,
}

impl Parser<'_> {
    fn error(&self, why: String) -> Error {
        Error::Syntax { why, text: self.text.to_owned() }
    }

    /// The next character that is not blank.
    fn peek(&mut self) -> Option<char> {
        while self.rest.next_if(|c| c.is_whitespace()).is_some() {}
        self.rest.peek().copied()
    }

    fn eat(&mut self, expected: char) -> bool {
        let found = self.peek() == Some(expected);
        if found {
            self.rest.next();
        }
        found
    }

    fn expect(&mut self, expected: char) -> Result<()> {
        if self.eat(expected) { Ok(()) } else { Err(self.error(format!("missing {expected}"))) }
    }

    fn sum(&mut self) -> Result<Formula> {
        let mut terms = Vec::new();
        let mut negative = self.eat('-');
        loop {
            let product = self.product()?;
            terms.push(if negative { Formula::Negative(Box::new(product)) } else { product });
            if self.eat('+') {
                negative = false;
            } else if self.eat('-') {
                negative = true;
            } else if terms.len() == 1 {
                return Ok(terms.remove(0));
            } else {
                return Ok(Formula::Sum(terms));
            }
        }
    }

    fn product(&mut self) -> Result<Formula> {
        let mut factors = vec![self.power()?];
        loop {
            if self.eat('*') {
                factors.push(self.power()?);
                continue;
            }
            let product = if factors.len() == 1 { factors.remove(0) } else { Formula::Product(factors) };
            if !self.eat('/') {
                return Ok(product);
            }
            factors = vec![Formula::Quotient(Box::new(product), Box::new(self.power()?))];
        }
    }

    fn power(&mut self) -> Result<Formula> {
        let base = self.primary()?;
        if !self.eat('^') {
            return Ok(base);
        }
        Ok(Formula::Power(Box::new(base), Box::new(self.power()?)))
    }

    fn primary(&mut self) -> Result<Formula> {
        match self.peek() {
            Some('(') => {
                self.expect('(')?;
                let inner = self.sum()?;
                self.expect(')')?;
                Ok(inner)
            }
            Some(c) if c.is_ascii_digit() => self.number(),
            Some(c) if c.is_alphabetic() => self.name(),
            Some(c) => Err(self.error(format!("unexpected {c}"))),
            None => Err(self.error("it ends too early".to_owned())),
        }
    }

    /// An integer or a decimal, exactly.
    fn number(&mut self) -> Result<Formula> {
        let mut digits = String::new();
        let mut places = None;
        while let Some(c) = self.rest.next_if(|c| c.is_ascii_digit() || *c == '.') {
            if c == '.' {
                if places.is_some() {
                    return Err(self.error("two decimal points".to_owned()));
                }
                places = Some(0u32);
            } else {
                digits.push(c);
                places = places.map(|places| places + 1);
            }
        }
        let value: Integer = digits.parse().map_err(|_| self.error("a number without digits".to_owned()))?;
        let scale = Integer::from(Integer::u_pow_u(10, places.unwrap_or(0)));
        Ok(Formula::Number(Rational::from((value, scale))))
    }

    fn name(&mut self) -> Result<Formula> {
        let mut name = String::new();
        while let Some(c) = self.rest.next_if(|c| c.is_alphanumeric() || *c == '_' || *c == '\'') {
            name.push(c);
        }
        if self.rest.peek() == Some(&'(') {
            self.rest.next();
            return self.call(&name);
        }
        match name.as_str() {
            "n" => Ok(Formula::N),
            "π" => Ok(Formula::Pi),
            name => Symbol::named(name)
                .map(Formula::Symbol)
                .or_else(|| Definition::named(name).map(Formula::Name))
                .ok_or_else(|| self.error(format!("unknown name {name}"))),
        }
    }

    /// The arguments of a function, after the opening bracket.
    fn call(&mut self, name: &str) -> Result<Formula> {
        let first = Box::new(self.sum()?);
        let formula = match name {
            "sqrt" => Formula::Root(first),
            "turn" => Formula::QuarterTurn(first),
            "diff" => Formula::Derivative(first, self.symbol()?),
            "int" => {
                let variable = self.symbol()?;
                self.expect(',')?;
                Formula::Integral(first, variable, Box::new(self.sum()?))
            }
            "at" => {
                self.expect(',')?;
                let variable = match self.power()? {
                    Formula::N => Variable::N,
                    Formula::Symbol(symbol) => Variable::Symbol(symbol),
                    _ => return Err(self.error("only a symbol or n can be replaced".to_owned())),
                };
                self.expect(',')?;
                Formula::At(first, variable, Box::new(self.sum()?))
            }
            name => self.function(name, *first)?,
        };
        self.expect(')')?;
        Ok(formula)
    }

    fn function(&mut self, name: &str, first: Formula) -> Result<Formula> {
        let known = Function::ALL.into_iter().find(|known| known.spelling().parsed == name);
        let function = known.ok_or_else(|| self.error(format!("unknown function {name}")))?;
        let mut arguments = vec![first];
        while arguments.len() < function.spelling().arity {
            self.expect(',')?;
            arguments.push(self.sum()?);
        }
        Ok(Formula::Function(function, arguments))
    }

    /// A comma and a symbol.
    fn symbol(&mut self) -> Result<Symbol> {
        self.expect(',')?;
        match self.primary()? {
            Formula::Symbol(symbol) => Ok(symbol),
            _ => Err(self.error("the variable is no symbol".to_owned())),
        }
    }
}
