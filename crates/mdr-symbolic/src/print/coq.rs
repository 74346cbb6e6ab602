//! Formulas and statements in Coq, over its real numbers.
//!
//! A derivative is `Derive`, an integral `RInt`, a substituted value a `let`; a real power is `Rpower`, whose base is positive
//! wherever the algebra accepts it. g, g', G and Q are functions of the radius.

use std::collections::BTreeSet;

use rug::Rational;

use super::{Strength, of};
use crate::derivations::Claim;
use crate::domain::Domain;
use crate::formula::{Definition, Formula, Function, Variable};
use crate::relations::PROFILE;
use crate::statement::{Relation, Statement};
use crate::symbol::Symbol;

impl Symbol {
    fn is_of_the_profile(self) -> bool {
        PROFILE.contains(&self.name())
    }
}

impl Definition {
    /// Its definition in Coq, a function of n and of the symbols in it.
    pub(crate) fn coq_definition(self) -> Option<String> {
        let formula = self.formula().ok()?;
        let binders = Free::of(formula).binders();
        let blank = if binders.is_empty() { "" } else { " " };
        Some(format!("Definition {}{blank}{binders} : R := {}.", self.coq(), formula.coq()))
    }
}

/// The names that a formula leaves free.
#[derive(Clone, Debug, Default)]
struct Free {
    n: bool,
    gamma: bool,
    symbols: BTreeSet<Symbol>,
}

impl Free {
    fn of(formula: &Formula) -> Self {
        let mut free = Free::default();
        free.collect(formula);
        free
    }

    fn collect(&mut self, formula: &Formula) {
        match formula {
            Formula::N => self.n = true,
            Formula::Symbol(symbol) => self.insert(*symbol),
            Formula::Derivative(inner, along) => {
                self.collect(inner);
                self.insert(*along);
            }
            Formula::Function(function, parts) => {
                self.gamma |= *function == Function::Gamma;
                parts.iter().for_each(|part| self.collect(part));
            }
            Formula::QuarterTurn(inner) => self.collect_without(inner, "θ"),
            Formula::Integral(inner, along, upper) => {
                self.collect_without(inner, along.name());
                self.collect(upper);
            }
            Formula::At(inner, variable, value) => {
                self.collect_without(inner, of(*variable, Symbol::name));
                self.collect(value);
            }
            other => other.parts().into_iter().for_each(|part| self.collect(part)),
        }
    }

    fn insert(&mut self, symbol: Symbol) {
        let angle = matches!(symbol.name(), "sinθ" | "cosθ").then(|| Symbol::named("θ")).flatten();
        let radius = symbol.is_of_the_profile().then(|| Symbol::named("a")).flatten();
        self.symbols.insert(angle.unwrap_or(symbol));
        self.symbols.extend(radius);
    }

    /// Collects the free variables other than a bound name; if the name is n, the κ that belongs to it is also bound.
    fn collect_without(&mut self, inner: &Formula, bound: &str) {
        let within = Free::of(inner);
        self.n |= within.n && bound != "n";
        self.gamma |= within.gamma;
        let bound = if bound == "n" { "κ" } else { bound };
        self.symbols.extend(within.symbols.into_iter().filter(|symbol| symbol.name() != bound));
    }

    /// The numbers, and the functions.
    fn names(&self) -> [Vec<&'static str>; 2] {
        let n = self.n.then_some("n");
        let (functions, numbers): (Vec<Symbol>, Vec<Symbol>) =
            self.symbols.iter().copied().partition(|symbol| symbol.is_of_the_profile());
        let numbers = n.into_iter().chain(numbers.into_iter().map(|symbol| symbol.coq()));
        let functions = functions.into_iter().map(|symbol| symbol.coq()).chain(self.gamma.then_some("Gamma"));
        [numbers.collect(), functions.collect()]
    }

    /// With their types.
    fn binders(&self) -> String {
        let kinds = self.names().into_iter().zip(["R", "R -> R"]).filter(|(names, _)| !names.is_empty());
        kinds.map(|(names, kind)| format!("({} : {kind})", names.join(" "))).collect::<Vec<_>>().join(" ")
    }
}

impl Formula {
    /// The formula as a term of Coq.
    pub(crate) fn coq(&self) -> String {
        let at_least = |formula: &Formula, needed: Strength| {
            if formula.coq_strength() < needed { format!("({})", formula.coq()) } else { formula.coq() }
        };
        let atom = |formula: &Formula| at_least(formula, Strength::Atom);
        match self {
            Formula::Number(value) => rational(value),
            Formula::N => "n".to_owned(),
            Formula::Pi => "PI".to_owned(),
            Formula::Symbol(symbol) => match symbol.name() {
                "sinθ" => "(sin theta)".to_owned(),
                "cosθ" => "(cos theta)".to_owned(),
                _ if symbol.is_of_the_profile() => format!("({} a)", symbol.coq()),
                _ => symbol.coq().to_owned(),
            },
            Formula::Name(definition) => {
                let names = definition.formula().map(|formula| Free::of(formula).names()).unwrap_or_default();
                let call = std::iter::once(definition.coq()).chain(names.concat());
                format!("({})", call.collect::<Vec<_>>().join(" "))
            }
            Formula::Negative(inner) => format!("- {}", at_least(inner, Strength::Power)),
            Formula::Sum(terms) => {
                let join = |(i, term): (usize, &Formula)| match term {
                    Formula::Negative(inner) if i > 0 => format!(" - {}", at_least(inner, Strength::Product)),
                    term => format!("{}{}", if i > 0 { " + " } else { "" }, at_least(term, Strength::Product)),
                };
                terms.iter().enumerate().map(join).collect()
            }
            Formula::Product(factors) => {
                let factor = |(i, factor)| at_least(factor, if i == 0 { Strength::Product } else { Strength::Power });
                factors.iter().enumerate().map(factor).collect::<Vec<_>>().join(" * ")
            }
            Formula::Quotient(above, below) => {
                format!("{} / {}", at_least(above, Strength::Product), at_least(below, Strength::Power))
            }
            Formula::Power(base, exponent) => match exponent.written_integer() {
                Some(power @ 0..) => format!("{} ^ {power}", atom(base)),
                Some(power) => format!("/ {} ^ {}", atom(base), power.unsigned_abs()),
                None => format!("Rpower {} {}", atom(base), atom(exponent)),
            },
            Formula::Root(inner) => format!("sqrt {}", atom(inner)),
            Formula::Derivative(inner, along) => {
                format!("Derive (fun {0} => {1}) {0}", along.coq(), inner.coq())
            }
            Formula::Integral(inner, along, upper) => {
                format!("RInt (fun {} => {}) 0 {}", along.coq(), inner.coq(), atom(upper))
            }
            Formula::QuarterTurn(inner) => format!("RInt (fun theta => {}) 0 (PI / 2)", inner.coq()),
            Formula::At(inner, Variable::Symbol(symbol), value) if symbol.is_of_the_profile() => {
                format!("let {} := fun a => {} in {}", symbol.coq(), value.coq(), inner.coq())
            }
            Formula::At(inner, Variable::Symbol(symbol), value) => {
                format!("let {} := {} in {}", symbol.coq(), value.coq(), inner.coq())
            }
            // κ is that of the new n.
            Formula::At(inner, Variable::N, value) => {
                format!("let n := {} in let kap := Definitions.kappa n in {}", value.coq(), inner.coq())
            }
            Formula::Function(function, arguments) => {
                let arguments: Vec<_> = arguments.iter().map(atom).collect();
                format!("{} {}", function.spelling().coq, arguments.join(" "))
            }
        }
    }

    fn coq_strength(&self) -> Strength {
        match self {
            Formula::Number(value) if value.is_integer() => Strength::Atom,
            Formula::N | Formula::Pi | Formula::Symbol(_) | Formula::Name(_) => Strength::Atom,
            Formula::Number(_) | Formula::Product(_) | Formula::Quotient(..) => Strength::Product,
            // A let reaches as far as it can, an inverse and a sign bind weakly.
            Formula::At(..) | Formula::Sum(_) | Formula::Negative(_) => Strength::Sum,
            Formula::Power(_, exponent) if exponent.written_integer().is_some_and(|power| power < 0) => Strength::Sum,
            _ => Strength::Power,
        }
    }
}

fn rational(value: &Rational) -> String {
    if value.is_integer() { value.to_string() } else { format!("{} / {}", value.numer(), value.denom()) }
}

impl Statement {
    /// The statement as a proposition of Coq: for all values of its symbols that fulfil the hypotheses.
    ///
    /// κ is any positive number, as the algebra takes it, and has its value where the statement is about numbers; `point` gives
    /// values to names.
    pub(crate) fn coq(&self, domains: &[Domain], claim: Claim, point: &[(&str, &str)]) -> String {
        let mut free = Free::of(&self.left);
        free.collect(&self.right);
        free.n |= claim == Claim::Enclosed && free.symbols.contains(&Symbol::KAPPA);
        let profile = free.symbols.iter().any(|symbol| symbol.is_of_the_profile());
        if profile {
            free.symbols.extend(PROFILE.iter().filter_map(|name| Symbol::named(name)));
        }
        let mut hypotheses = Vec::new();
        if free.n {
            hypotheses.push(of_domains(domains).to_owned());
        }
        hypotheses.extend(free.gamma.then(|| "is_Gamma Gamma".to_owned()));
        hypotheses.extend(profile.then(|| "profile g g1 G Q".to_owned()));
        for symbol in free.symbols.iter().filter(|symbol| !symbol.is_of_the_profile()) {
            hypotheses.push(match (symbol.coq(), claim) {
                ("theta", _) => "0 < theta < PI / 2".to_owned(),
                ("kap", Claim::Enclosed) => "kap = Definitions.kappa n".to_owned(),
                (name, _) => format!("0 < {name}"),
            });
        }
        for (name, value) in point {
            let name = Symbol::named(name).map_or("n", Symbol::coq);
            hypotheses.push(format!(
                "{name} = {}",
                value.parse::<Formula>().map_or_else(|_| (*value).to_owned(), |value| value.coq())
            ));
        }
        hypotheses.extend(self.uncertain_divisors(domains, &free).into_iter().map(|divisor| format!("{divisor} <> 0")));
        hypotheses.push(self.coq_relation(&free));
        let claim = hypotheses.join(" -> ");
        let binders = free.binders();
        if binders.is_empty() { claim } else { format!("forall {binders}, {claim}") }
    }

    /// The divisors of both sides, as written, that are not certainly positive or negative: the statement is about points at
    /// which they are not 0.
    fn uncertain_divisors(&self, domains: &[Domain], free: &Free) -> Vec<String> {
        let has_sign = |divisor: &Formula, domain: Domain| {
            divisor.normalise(domain).is_ok_and(|normal| normal.sign_on(domain).is_some_and(|sign| sign.is_ne()))
        };
        let mut found = Vec::new();
        for divisor in self.left.divisors().iter().chain(&self.right.divisors()) {
            let text = format!("({})", divisor.coq());
            // Under an integral or outside the algebra a divisor is not asked for.
            let bound = !Free::of(divisor).symbols.is_subset(&free.symbols);
            let outside = bound || domains.iter().any(|domain| divisor.is_outside(*domain));
            if !outside && !found.contains(&text) && !domains.iter().all(|domain| has_sign(divisor, *domain)) {
                found.push(text);
            }
        }
        found
    }

    fn coq_relation(&self, free: &Free) -> String {
        // A let would reach over the relation.
        let bracketed = |side: &Formula| match side {
            Formula::At(..) => format!("({})", side.coq()),
            _ => side.coq(),
        };
        let (left, right) = (bracketed(&self.left), bracketed(&self.right));
        match self.relation {
            Relation::Equal => format!("{left} = {right}"),
            Relation::Less => format!("{left} < {right}"),
            Relation::Greater => format!("{left} > {right}"),
            Relation::SameDimension => {
                let scaled: String = free.symbols.iter().map(|symbol| symbol.coq_scaled()).collect();
                format!(
                    "forall l f : R, 0 < l -> 0 < f -> ({scaled}({left})) * ({right}) = ({left}) * ({scaled}({right}))"
                )
            }
        }
    }
}

impl Symbol {
    /// The symbol in other units, those of length and force multiplied by 1/l and 1/f.
    fn coq_scaled(self) -> String {
        let dimension = self.dimension();
        let power = |unit: &str, exponent| format!("Rpower {unit} ({}) * ", Formula::from(exponent).coq());
        let name = self.coq();
        format!("let {name} := {}{}{name} in ", power("l", &dimension.length), power("f", &dimension.force))
    }
}

/// The hypothesis on n.
fn of_domains(domains: &[Domain]) -> &'static str {
    match domains {
        [Domain::Above] => "1 / 2 < n",
        [Domain::Below] => "0 < n < 1 / 2",
        [Domain::Half] => "n = 1 / 2",
        [Domain::Positive] => "0 < n",
        _ => "0 < n -> n <> 1 / 2",
    }
}
