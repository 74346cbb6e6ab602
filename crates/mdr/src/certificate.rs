//! Certificates: what a small program needs to check an answer without trust in this one.
//!
//! The controlled quantity C(a) of the equilibria with contact radius a is given by the definitions (1.1) and (1.4) to (1.6)
//! alone, or by those of another medium. A certificate divides the range of radii into cells and says of each that C rises,
//! falls, or does one after the other. Each is a claim about a function that its reader computes, from the heights f(r), by
//! integrals of his own; that the cells leave no gap is seen by their ends. Folds are the cells where C turns, equilibria the
//! cells at whose ends C is on either side of the value, and a path follows from both. `scripts/check_certificates.py` is such a
//! reader.

use std::cmp::Ordering;

use mdr_core::contact::{Control, Flank, Shape};
use mdr_core::number::{Interval, Literal, Precision, Real};
use mdr_numeric::path::{EventKind, Start as PathStart};
use mdr_numeric::proof::{ProvedBranches, Trend};
use rug::Float;
use serde_json::{Map, Value, json};

use crate::answer::{Answer, PathEvent, Promise};
use crate::error::{Error, Result};
use crate::run::Stop;
use crate::scene::{ExactMedium, Profile, Scene};
use crate::solve::certified::Certified;
use crate::solve::proof::{Enclosed, FoldProof};

/// Names the keys of a certificate and their meaning.
const SCHEMA: &str = "mdr.certificate/1";
/// How far the cells of a certificate extend beyond the contact radii of the answer.
const REACH: f64 = 16.0;
/// Bits of the ends of cells on a periodic medium: a half-width may be so close to half of a period that no double tells them apart.
const HALF_WIDTH: u32 = 96;

impl Scene {
    /// The certificate of an answer to this scene, as one line of JSON, schema `mdr.certificate/1`; docs/certificates.md has its
    /// keys.
    ///
    /// ```
    /// use mdr::prelude::*;
    /// let ball = Scene::new(Shape::Paraboloid { radius: 1 }, Elasticity::effective(1)?, "0.01")?.want(Want::Folds { range: None });
    /// let certificate = ball.certificate(&ball.solve()?)?;
    /// assert!(certificate.contains(r#""trend":"minimum""#));
    /// # Ok::<(), mdr::Error>(())
    /// ```
    ///
    /// # Errors
    /// A scene without folds, equilibria or a path; an answer in f64, or one that is not proved; a profile of measured rows, two
    /// works of adhesion, or a graded half-space without its coefficient; a path to complete contact on a periodic medium; folds
    /// that are not proved to be all.
    pub fn certificate(&self, answer: &Answer) -> Result<String> {
        let refuse = |key: &'static str, why: &str| self.places.of(key).refuse(why.to_owned());
        if self.has_two_works() {
            return Err(refuse("material.work_of_adhesion", "a certificate speaks of one work of adhesion"));
        }
        let certified = |output: &&crate::answer::Output| {
            matches!(output.kind().name(), "folds" | "equilibria" | "path") && output.promise() == Promise::Certified
        };
        let outputs: Map<String, Value> = answer
            .outputs
            .iter()
            .filter(certified)
            .map(|output| (output.kind().name().to_owned(), json!(output.rows())))
            .collect();
        let is_complete = |event: &PathEvent| event.event == EventKind::CompleteContact;
        let completes = answer.path().is_some_and(|path| path.events.items.iter().any(is_complete));
        if completes && self.pressed_into().is_periodic() {
            let why =
                "a certificate speaks of no path to complete contact on a periodic medium; end the path before it";
            return Err(refuse("control.path", why));
        }
        if outputs.is_empty() {
            let why = "a certificate needs certified folds, equilibria or a path among the outputs";
            return Err(refuse("output.want", why));
        }
        let mut certificate = Map::new();
        certificate.insert("schema".to_owned(), json!(SCHEMA));
        certificate.extend(self.contact_in_words()?);
        certificate.insert("digits".to_owned(), json!(answer.arithmetic.digits()));
        let radii = radii(&outputs).ok_or_else(|| {
            refuse(
                "output.want",
                "a certificate needs every contact radius as a number, and one is known by its logarithm alone",
            )
        })?;
        let cells = self.cells(&radii)?;
        let range = [cells.first().map(|cell| &cell["from"]), cells.last().map(|cell| &cell["to"])];
        certificate.insert("range".to_owned(), json!(range));
        certificate.insert("cells".to_owned(), cells.into());
        certificate.extend(outputs);
        Ok(Value::Object(certificate).to_string())
    }

    /// The contact by its definitions.
    fn contact_in_words(&self) -> Result<Map<String, Value>> {
        let text = |number: &Literal| json!(number.to_string());
        let mut contact = Map::new();
        let mut terms = Vec::new();
        let mut edge = None;
        describe(&self.profile, self.pressed_into(), &mut terms, &mut edge)
            .map_err(|why| self.places.of("profile").refuse(why.to_owned()))?;
        contact.insert("profile".to_owned(), terms.into());
        contact.insert("edge".to_owned(), edge.as_ref().map_or(Value::Null, text));
        match medium_in_words(self.pressed_into()) {
            Ok(medium) => contact.extend(medium.map(|medium| ("medium".to_owned(), medium))),
            Err(why) => return Err(self.places.of("medium").refuse(why.to_owned())),
        }
        if self.pressed_into().needs_modulus() {
            contact.insert("e_star".to_owned(), text(&self.effective_modulus));
        }
        contact.insert("work_of_adhesion".to_owned(), text(&self.work_of_adhesion));
        contact.insert("control".to_owned(), json!(self.control.kind().name()));
        if let Control::Machine { stiffness } = &self.control {
            contact.insert("stiffness".to_owned(), text(stiffness));
        }
        if !self.path.is_empty() {
            contact.insert("way".to_owned(), self.path.iter().map(text).collect::<Vec<_>>().into());
            let start = match &self.start {
                PathStart::Largest => json!("largest"),
                PathStart::Smallest => json!("smallest"),
                PathStart::Nearest(radius) => text(radius),
                PathStart::Detached => json!("detached"),
            };
            contact.insert("start".to_owned(), start);
        }
        Ok(contact)
    }

    /// The one cell of a power law that is not on a machine, with its only fold: g' is a power of a, and so is Δl/a. On a Winkler
    /// foundation at fixed grips, where Δl is constant, there is none.
    fn cells_of_law(&self, radii: &[Float]) -> Option<Vec<Value>> {
        let [n, _] = self.profile.exact_power_law(Literal::to_rational)?;
        let threshold = self.pressed_into().threshold()?;
        let trend = match n.to_rational().cmp(&threshold) {
            Ordering::Greater if threshold.is_zero() && self.control == Control::Indentation => Trend::Rises,
            Ordering::Greater => Trend::Minimum,
            Ordering::Less => Trend::Maximum,
            Ordering::Equal => return None,
        };
        let last = Float::with_val(53, largest(radii)?) * REACH;
        let usable = last.is_normal() && !matches!(self.control, Control::Machine { .. });
        usable.then(|| vec![json!({"from": "0", "to": exact(&last), "trend": trend.name()})])
    }

    /// The cells of the proof of all folds; one below the range, to the tip, where C is known to be monotone there.
    ///
    /// They end at [`REACH`] times the largest of the `radii` in the answer and of the kinks, since a reader's integrals over many
    /// waves are slow; and before the end of a profile, where they converge slowly.
    fn cells(&self, radii: &[Float]) -> Result<Vec<Value>> {
        if let Some(cells) = self.cells_of_law(radii) {
            return Ok(cells);
        }
        let doubles: Vec<f64> = radii.iter().map(Float::to_f64).collect();
        if !doubles.iter().all(|a| a.is_normal()) {
            let why = "a certificate needs contact radii in the range of f64, except for a power law at fixed grips or under a dead load";
            return Err(self.places.of("output.want").refuse(why.to_owned()));
        }
        let counts = Stop::default().counts();
        let certified = Certified::new(self, answer_digits(self), &counts);
        let open = "the folds are not proved to be all, and a certificate would be incomplete";
        let refuse = |why: &str| self.places.of("output.want").refuse(why.to_owned());
        let proof = certified.fold_proof().map_err(Error::from)?.ok_or_else(|| refuse(open))?;
        let FoldProof { proved, complete, .. } = proof;
        if !complete.proved {
            return Err(refuse(&format!("{open}: {}", complete.why)));
        }
        let enclosed = Enclosed::new(&certified, Precision::new(HALF_WIDTH))?;
        let curve = enclosed.curve();
        let size = |a: &f64| curve.plain().medium().size(&Interval::from_f64(Precision::new(HALF_WIDTH), *a)).approx();
        let transform = curve.plain().transform();
        let kinks = transform.kinks().iter().map(Real::approx).collect::<Vec<_>>();
        let edge = curve.plain().vertical_edge().map(|edge| edge.approx());
        let folds = proved.folds.iter().map(|fold| fold.contact_radius.approx());
        let largest = doubles.iter().map(size).chain(kinks).chain(edge).chain(folds).fold(0.0, f64::max);
        let outer = transform.outer_radius().map(|outer| outer.approx());
        let largest = if largest > 0.0 { largest } else { proved.range.1.to_f64() / REACH };
        let last = outer.map_or(f64::MAX, |outer| largest + 0.875 * (outer - largest)).min(REACH * largest);
        let pole = proved.poles.first().map_or(f64::MAX, |pole| 0.999 * pole.contact_radius.lower().to_f64());
        if proved.folds.iter().any(|fold| fold.contact_radius.approx() >= pole) {
            return Err(refuse("a certificate speaks of radii below a pole of g, and there are folds beyond one"));
        }
        let last = Float::with_val(53, last.min(pole));
        let cell = |from: Value, to: Value, trend: Trend| json!({"from": from, "to": to, "trend": trend.name()});
        let end = |end: &Float| {
            if !self.pressed_into().is_periodic() {
                return json!(exact(end));
            }
            let size = Interval::point(Float::with_val(HALF_WIDTH, end));
            json!(exact(enclosed.value.contact_radius(&size).midpoint().lower()))
        };
        let mut cells: Vec<Value> = proved
            .cells
            .iter()
            .filter(|known| known.from < last)
            .map(|known| cell(end(&known.from), end(if known.to < last { &known.to } else { &last }), known.trend))
            .collect();
        if let Ok(branches) = ProvedBranches::new(curve, proved)
            && let Ok(Some(trend)) = branches.inwards()
        {
            cells.insert(0, cell(json!("0"), end(&proved.range.0), trend));
        }
        Ok(cells)
    }
}

/// All contact radii but that of a point, at any depth; `None` if one has a logarithm alone.
fn radii(outputs: &Map<String, Value>) -> Option<Vec<Float>> {
    let mut found = Vec::new();
    let mut open: Vec<&Value> = outputs.values().collect();
    while let Some(value) = open.pop() {
        match value {
            Value::Array(rows) => open.extend(rows),
            Value::Object(row) => {
                if row.keys().any(|key| key.starts_with("log10_")) {
                    return None;
                }
                let keys = ["contact_radius", "to_contact_radius"].into_iter();
                for text in keys.filter_map(|key| row.get(key)?.as_str()) {
                    let a = Float::with_val(64, Float::parse(text).ok()?);
                    found.extend(Some(a).filter(|a| !a.is_zero()));
                }
                open.extend(row.values());
            }
            _ => {}
        }
    }
    Some(found)
}

/// The largest of some radii.
fn largest(radii: &[Float]) -> Option<&Float> {
    radii.iter().max_by(|one, other| one.total_cmp(other))
}

/// The medium with its exact numbers, but for its modulus E*; `None` of a half-space.
fn medium_in_words(medium: &ExactMedium) -> std::result::Result<Option<Value>, &'static str> {
    if medium.is_half_space() {
        return Ok(None);
    }
    let numbers = medium.numbers();
    if numbers.iter().any(|(key, _)| *key == "medium.depth") {
        return Err(
            "a certificate has c of a graded half-space as a number; give coefficient in place of modulus and depth",
        );
    }
    let mut words = Map::new();
    words.insert("kind".to_owned(), json!(medium.name()));
    // A flaw plays no part in what a certificate says.
    for (key, number) in numbers.into_iter().filter(|(key, _)| *key != "medium.flaw") {
        words.insert(key.trim_start_matches("medium.").to_owned(), json!(number.to_string()));
    }
    Ok(Some(Value::Object(words)))
}

/// The working digits of a scene, of which the cells do not depend.
fn answer_digits(scene: &Scene) -> u32 {
    scene.arithmetic.digits().unwrap_or(crate::scene::DEFAULT_DIGITS)
}

/// A binary number as the decimal that it is, so that neighbours have one end.
fn exact(number: &Float) -> String {
    number.to_string_radix(10, None)
}

/// The heights of a profile as terms of a sum, each a formula with its parameters, and the radius of a vertical edge.
fn describe(
    profile: &Profile,
    medium: &ExactMedium,
    terms: &mut Vec<Value>,
    edge: &mut Option<Literal>,
) -> std::result::Result<(), &'static str> {
    match profile {
        Profile::Shape(shape) => {
            if let Shape::FlatPunch { radius } = shape {
                *edge = Some(radius.clone());
            }
            let values = shape.parameters().into_iter().map(|(key, value)| match (key, shape.flank()) {
                ("half_angle_degrees", Some(Flank::HalfAngleDegrees(_))) => {
                    format!("cos(pi*({value})/180)/sin(pi*({value})/180)")
                }
                _ => value.to_string(),
            });
            let parameters: Map<String, Value> =
                shape.symbols().iter().map(|symbol| (*symbol).to_owned()).zip(values.map(Value::from)).collect();
            terms.push(json!({"f": shape.text(), "parameters": parameters}));
        }
        Profile::Sum(parts) => parts.iter().try_for_each(|part| describe(part, medium, terms, edge))?,
        Profile::Formula(formula) => {
            let parameters: Map<String, Value> =
                formula.parameters.iter().map(|(name, value)| (name.clone(), json!(value.to_string()))).collect();
            terms.push(json!({"f": formula.text, "parameters": parameters}));
        }
        Profile::Table(_) => return Err("a certificate speaks of formulas, not of measured rows"),
        Profile::Function(_) => return Err("a certificate speaks of formulas, not of closures"),
        Profile::Wave(amplitude) => {
            let wavelength = medium.period().ok_or("a wave is on a periodic medium")?;
            let parameters = json!({"h": amplitude.to_string(), "l": wavelength.to_string()});
            terms.push(json!({"f": "h*(1 - cos(2*pi*r/l))", "parameters": parameters}));
        }
    }
    Ok(())
}
