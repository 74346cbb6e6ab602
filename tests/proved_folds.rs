//! All folds of a contact, with proof, from the closed forms and the independent route together.

use mdr_analytic::profiles::{Paraboloid, TruncatedCone, WavyParaboloid};
use mdr_core::contact::{Control, FoldKind, Instability, Material, Result, Transform};
use mdr_core::number::{Dual, Interval, Literal, Precision, Real};
use mdr_numeric::curve::Curve;
use mdr_numeric::proof::{EnclosedCurve, ProvedFolds};
use rug::Float;

fn number<R: Real>(ctx: R::Ctx, text: &str) -> R {
    R::from_literal(ctx, &text.parse::<Literal>().expect("a number"))
}

/// What is asked: a profile in both arithmetics, w/E*, the control and the range.
struct Question {
    plain: Box<dyn Transform<Interval>>,
    moving: Box<dyn Transform<Dual<Interval>>>,
    work: &'static str,
    range: (f64, f64),
}

impl Question {
    fn ask<T>(&self, bits: u32, answer: impl FnOnce(EnclosedCurve<'_>) -> Result<T>) -> Result<T> {
        let ctx = Precision::new(bits);
        let material = Material::new(number(ctx, "1"), number(ctx, self.work))?;
        let moving_material = Material::new(number(ctx, "1"), number(ctx, self.work))?;
        let plain = Curve::new(self.plain.as_ref(), &material, &Control::Indentation);
        let moving = Curve::new(self.moving.as_ref(), &moving_material, &Control::Indentation);
        answer(EnclosedCurve::new(plain, moving))
    }

    fn folds(&self, bits: u32) -> Result<ProvedFolds> {
        let [lower, upper] = [self.range.0, self.range.1].map(|end| Float::with_val(bits, end));
        self.ask(bits, |curve| curve.folds(&lower, &upper, 10_000_000))
    }
}

/// R = 1, A = 5·10⁻⁴ and the given wavelength, over any arithmetic.
fn wavy<R: mdr_analytic::struve::Struve>(ctx: R::Ctx, wavelength: &str) -> Result<WavyParaboloid<R>> {
    WavyParaboloid::new(number(ctx, "1"), number(ctx, "5e-4"), number(ctx, wavelength))
}

fn waves(bits: u32, wavelength: &str, range: (f64, f64)) -> Result<Question> {
    let ctx = Precision::new(bits);
    Ok(Question {
        plain: Box::new(wavy::<Interval>(ctx, wavelength)?),
        moving: Box::new(wavy::<Dual<Interval>>(ctx, wavelength)?),
        work: "1e-4",
        range,
    })
}

#[test]
fn figure_4_of_the_paper() -> Result<()> {
    let question = waves(64, "0.1", (1e-6, 1e3))?;
    let proved = question.folds(64)?;
    assert!(proved.is_complete(), "{:?}", proved.undecided);
    // The jump 0.0645 → 0.0474 at d ≈ −0.00185, and the end at 0.0189, d ≈ −0.00249.
    let minima: Vec<_> = proved.folds.iter().filter(|fold| fold.kind == FoldKind::Minimum).collect();
    let near = |fold: &Instability<Interval>, a: f64, d: f64| {
        (fold.contact_radius.approx() - a).abs() < 1e-4 && (fold.indentation.approx() - d).abs() < 1e-5
    };
    assert!(minima.iter().any(|fold| near(fold, 0.0645, -0.00185)), "{minima:?}");
    assert!(minima.iter().any(|fold| near(fold, 0.0189, -0.00249)), "{minima:?}");
    // Minima and maxima take turns along the curve.
    assert!(proved.folds.windows(2).all(|pair| pair[0].kind != pair[1].kind));

    // The same folds to 300 bits, inside the first enclosures.
    let fine = waves(300, "0.1", (1e-6, 1e3))?;
    for fold in &proved.folds {
        let sharp = fine.ask(300, |curve| curve.sharpen(fold))?;
        assert!(sharp.contact_radius.accuracy_bits() > 280 && sharp.contact_radius.overlaps(&fold.contact_radius));
        assert!(sharp.indentation.accuracy_bits() > 270);
    }
    Ok(())
}

#[test]
fn hundreds_of_folds() -> Result<()> {
    let question = waves(64, "1e-3", (1e-6, 0.1))?;
    let proved = question.folds(64)?;
    // Two to a wave as soon as the slope of the waves beats 2x/R: about 200 up to a = 100 λ, and the end.
    assert!((195..=205).contains(&proved.folds.len()), "{}", proved.folds.len());
    assert!(proved.is_complete(), "{:?}", &proved.undecided[..3.min(proved.undecided.len())]);
    assert!(proved.folds.windows(2).all(|pair| pair[0].kind != pair[1].kind));
    Ok(())
}

#[test]
fn a_kink_is_not_passed_over_in_silence() -> Result<()> {
    let ctx = Precision::new(64);
    let cone = |ctx| -> Result<TruncatedCone<Interval>> { TruncatedCone::new(number(ctx, "0.5"), number(ctx, "0.01")) };
    let moving = TruncatedCone::new(number::<Dual<Interval>>(ctx, "0.5"), number(ctx, "0.01"))?;
    let question = Question { plain: Box::new(cone(ctx)?), moving: Box::new(moving), work: "1e-4", range: (1e-6, 1e3) };
    let proved = question.folds(64)?;
    // Flat up to b: it comes off at its edge, a = b, where g has a kink. Elsewhere there is no fold.
    let gap = |(lower, upper): &(Float, Float)| *lower < 0.01 && *upper > 0.01;
    assert!(!proved.is_complete() && proved.undecided.iter().all(gap), "{:?}", proved.undecided);
    Ok(())
}

#[test]
fn one_fold_of_a_ball() -> Result<()> {
    let ctx = Precision::new(200);
    let question = Question {
        plain: Box::new(Paraboloid::new(number::<Interval>(ctx, "1"))?),
        moving: Box::new(Paraboloid::new(number::<Dual<Interval>>(ctx, "1"))?),
        work: "1",
        range: (1e-12, 1e12),
    };
    let proved = question.folds(200)?;
    // a³ = πwR²/8E* (Johnson, Kendall and Roberts 1971, fixed grips)
    let cube = proved.folds[0].contact_radius.powi(3);
    assert!(proved.is_complete() && proved.folds.len() == 1 && cube.overlaps(&cube.pi().over(8)));
    Ok(())
}
