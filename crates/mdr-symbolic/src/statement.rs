//! Statements about formulas, and their decision.

use std::cmp::Ordering;
use std::str::FromStr;

use rug::Rational;

use crate::dimension::Dimension;
use crate::domain::Domain;
use crate::error::{Error, Result};
use crate::formula::Formula;
use crate::print::square;
use crate::quotient::Quotient;
use crate::symbol::Symbol;

/// The relation between the two sides of a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// The two sides are the same function.
    Equal,
    /// The left side is smaller everywhere.
    Less,
    /// The left side is larger everywhere.
    Greater,
    /// The two sides have the same dimension.
    SameDimension,
}

/// Two formulas and a relation.
///
/// ```
/// use mdr_symbolic::{Decision, Domain, Statement};
/// let corrected: Statement = "at(diff(d_n, a), a, (B/N^2)^(1/(2*n - 1))) = 0".parse()?;
/// let printed: Statement = "at(diff(d_n, a), a, (B/N^2)^(1/(1 - 2*n))) = 0".parse()?;
/// assert!(matches!(corrected.decide(Domain::Above), Decision::Proved { .. }));
/// assert!(matches!(printed.decide(Domain::Above), Decision::Refuted { .. }));
/// # Ok::<(), mdr_symbolic::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Statement {
    /// The left side.
    pub left: Formula,
    /// The relation.
    pub relation: Relation,
    /// The right side.
    pub right: Formula,
}

/// The result of exact algebra for a statement on a domain.
#[derive(Clone, Debug)]
pub enum Decision {
    /// The statement is true.
    Proved {
        /// The witness.
        because: Witness,
    },
    /// The statement is false.
    Refuted {
        /// The witness.
        because: Witness,
    },
    /// Not decided by algebra: a part lies outside it, or not all terms have one sign.
    Undecided(Undecided),
}

/// The witness that a statement is true, or false.
#[derive(Clone, Debug)]
pub enum Witness {
    /// The normal form of both sides; that of the left side if the other one is equal to it by cos²θ = 1 − sin²θ only.
    Both(Quotient),
    /// The difference of the two sides, which is not 0 or has a sign.
    Difference(Quotient),
    /// The dimensions of the two sides; `None` if the terms of a side differ in theirs.
    Dimensions(Option<Dimension>, Option<Dimension>),
}

impl Witness {
    /// A description. `math` chooses between a formula as text and in TeX.
    pub fn describe(&self, math: &dyn Fn(&str, &str) -> String) -> String {
        let of = |form: &Quotient| {
            let formula = Formula::from(form);
            math(&formula.text(), &formula.tex())
        };
        let unit = |dimension: &Option<Dimension>| match dimension {
            Some(dimension) => math(&dimension.text(), &dimension.tex()),
            None => "none".to_owned(),
        };
        match self {
            Witness::Both(form) => format!("both sides are {}", of(form)),
            Witness::Difference(form) => format!("left minus right is {}", of(form)),
            Witness::Dimensions(left, right) if left == right => {
                format!("both sides have the dimension {}", unit(left))
            }
            Witness::Dimensions(left, right) => format!("the dimensions are {} and {}", unit(left), unit(right)),
        }
    }
}

impl Decision {
    /// The decision and its reason, as text.
    pub fn text(&self) -> String {
        let plain = |because: &Witness| because.describe(&|text, _| text.to_owned());
        match self {
            Decision::Proved { because } => format!("proved: {}", plain(because)),
            Decision::Refuted { because } => format!("refuted: {}", plain(because)),
            Decision::Undecided(Undecided::NoNormalForm(error)) => format!("undecided: {error}"),
            Decision::Undecided(Undecided::MixedSigns) => "undecided: the terms have different signs".to_owned(),
            Decision::Undecided(Undecided::HiddenRelation(symbols)) => {
                let symbols: Vec<_> = symbols.iter().map(|symbol| symbol.text()).collect();
                format!("undecided: the terms differ in {}, which are not independent", symbols.join(" and "))
            }
        }
    }
}

/// Why algebra does not decide a statement.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Undecided {
    /// One side has no normal form.
    NoNormalForm(Error),
    /// The terms of the difference have different signs.
    MixedSigns,
    /// The terms of the difference have different powers of symbols that are related in a way the algebra does not
    /// include.
    HiddenRelation(Vec<Symbol>),
}

impl FromStr for Statement {
    type Err = Error;

    /// `left = right`, `left < right`, `left > right`, or `left ~ right` for the same dimension.
    fn from_str(text: &str) -> Result<Self> {
        let relations =
            [('=', Relation::Equal), ('<', Relation::Less), ('>', Relation::Greater), ('~', Relation::SameDimension)];
        for (sign, relation) in relations {
            if let Some((left, right)) = text.split_once(sign) {
                return Ok(Statement { left: left.parse()?, relation, right: right.parse()? });
            }
        }
        Err(Error::Syntax { why: "no relation".to_owned(), text: text.to_owned() })
    }
}

impl Statement {
    /// Decides the statement on a domain, for all positive values of the symbols.
    pub fn decide(&self, domain: Domain) -> Decision {
        self.try_decide(domain).unwrap_or_else(|error| Decision::Undecided(Undecided::NoNormalForm(error)))
    }

    fn try_decide(&self, domain: Domain) -> Result<Decision> {
        let (left, right) = (self.left.normalise(domain)?, self.right.normalise(domain)?);
        self.left.refuse_divisors(domain)?;
        self.right.refuse_divisors(domain)?;
        if self.relation == Relation::SameDimension {
            return Ok(same_dimension(self.left.dimension(domain), self.right.dimension(domain)));
        }
        let difference = left.minus(&right)?;
        if self.relation == Relation::Equal {
            return equality(left, &right, difference, domain);
        }
        let wanted = if self.relation == Relation::Less { Ordering::Less } else { Ordering::Greater };
        let sign = difference.sign_on(domain);
        let because = Witness::Difference(difference);
        Ok(match sign {
            Some(sign) if sign == wanted => Decision::Proved { because },
            Some(_) => Decision::Refuted { because },
            None => Decision::Undecided(Undecided::MixedSigns),
        })
    }

    /// Whether a divisor in one of the sides, as written, is 0 everywhere on the domain: that side then has no value,
    /// and the statement is neither true nor false. Decided by normal forms even if the rest of the side has none.
    ///
    /// ```
    /// use mdr_symbolic::{Domain, Statement};
    /// let statement: Statement = "H0(a)/(2 - 2*sin(π/2)^2) = 1".parse()?;
    /// assert!(statement.divides_by_zero(Domain::Positive));
    /// # Ok::<(), mdr_symbolic::Error>(())
    /// ```
    pub fn divides_by_zero(&self, domain: Domain) -> bool {
        [&self.left, &self.right].into_iter().any(|side| side.divides_by_zero(domain))
    }

    /// The statement with a positive number substituted for n, for an arithmetic with the same n. An integral may exist
    /// there that does not exist on a whole domain.
    ///
    /// ```
    /// use mdr_symbolic::{Decision, Domain, Statement};
    /// let statement: Statement = "int(x^(-n), x, a) = a^(1 - n)/(1 - n)".parse()?;
    /// assert!(matches!(statement.decide(Domain::Positive), Decision::Undecided(_)));
    /// let there = statement.at_exponent(&(1, 3).into());
    /// assert!(matches!(there.decide(Domain::Positive), Decision::Proved { .. }));
    /// # Ok::<(), mdr_symbolic::Error>(())
    /// ```
    pub fn at_exponent(&self, n: &Rational) -> Statement {
        Statement { left: self.left.at_exponent(n), relation: self.relation, right: self.right.at_exponent(n) }
    }

    /// The distinct statements with one small error in one of the sides of an equality, with the opposite sense of an
    /// inequality, or with an additional length in a dimension. If an equality has no place for an error, its
    /// definitions are expanded first.
    ///
    /// ```
    /// use mdr_symbolic::Statement;
    /// let statement: Statement = "a - x = d".parse()?;
    /// let mutants: Vec<_> = statement.mutants().iter().map(Statement::text).collect();
    /// assert_eq!(mutants, ["−a − x = d", "a + x = d"]);
    /// # Ok::<(), mdr_symbolic::Error>(())
    /// ```
    pub fn mutants(&self) -> Vec<Statement> {
        let with = |left: Formula, relation, right: Formula| Statement { left, relation, right };
        match self.relation {
            // An inequality with another number may still be true, which says nothing about this one.
            Relation::Less => vec![with(self.left.clone(), Relation::Greater, self.right.clone())],
            Relation::Greater => vec![with(self.left.clone(), Relation::Less, self.right.clone())],
            Relation::SameDimension => {
                let longer = Symbol::named("a").map(|a| Formula::Product(vec![self.left.clone(), Formula::Symbol(a)]));
                longer.into_iter().map(|left| with(left, self.relation, self.right.clone())).collect()
            }
            Relation::Equal => {
                let mutants = self.mutated_sides();
                let written_out = || with(self.left.written_out(), self.relation, self.right.written_out());
                if mutants.is_empty() { written_out().mutated_sides() } else { mutants }
            }
        }
    }

    fn mutated_sides(&self) -> Vec<Statement> {
        let left = self.left.mutants().into_iter().map(|left| Statement { left, ..self.clone() });
        let right = self.right.mutants().into_iter().map(|right| Statement { right, ..self.clone() });
        let mut distinct: Vec<Statement> = Vec::new();
        for mutant in left.chain(right) {
            if mutant != *self && !distinct.contains(&mutant) {
                distinct.push(mutant);
            }
        }
        distinct
    }

    /// The statement as one line of text.
    pub fn text(&self) -> String {
        match self.relation {
            Relation::Equal => format!("{} = {}", self.left.text(), self.right.text()),
            Relation::Less => format!("{} < {}", self.left.text(), self.right.text()),
            Relation::Greater => format!("{} > {}", self.left.text(), self.right.text()),
            Relation::SameDimension => format!("dim {} = dim {}", self.left.text(), self.right.text()),
        }
    }

    /// The statement in TeX, without the dollars.
    pub fn tex(&self) -> String {
        let (left, right) = (self.left.tex(), self.right.tex());
        match self.relation {
            Relation::Equal => format!("{left} = {right}"),
            Relation::Less => format!(r"{left} \lt {right}"),
            Relation::Greater => format!(r"{left} \gt {right}"),
            Relation::SameDimension => format!(r"{}_{{\dim}} = {}_{{\dim}}", square(&left), square(&right)),
        }
    }
}

fn equality(left: Quotient, right: &Quotient, difference: Quotient, domain: Domain) -> Result<Decision> {
    if left.equals(right)? {
        return Ok(Decision::Proved { because: Witness::Both(left) });
    }
    let rest = difference.numerator().with_one_cosine()?;
    if rest.is_zero() {
        return Ok(Decision::Proved { because: Witness::Both(left) });
    }
    Ok(match rest.related_symbols(domain) {
        Some(symbols) => Decision::Undecided(Undecided::HiddenRelation(symbols)),
        None => Decision::Refuted { because: Witness::Difference(difference) },
    })
}

fn same_dimension(left: Option<Dimension>, right: Option<Dimension>) -> Decision {
    let same = left.is_some() && left == right;
    let because = Witness::Dimensions(left, right);
    if same { Decision::Proved { because } } else { Decision::Refuted { because } }
}
