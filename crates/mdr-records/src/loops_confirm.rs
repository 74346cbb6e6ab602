//! The second method for [loops](crate::loops): g from quadrature of the heights, the edges from signs of what is held at the certified
//! radius, and the work as the integral of F over d around the loop. No closed form of a fold, an equilibrium or an energy is used.

use mdr_core::calculus::quadrature::tanh_sinh;
use mdr_core::calculus::roundoff_tolerance;
use mdr_core::contact::Result;
use mdr_core::number::Real;
use rug::Float;

use crate::confirm::{agree, changes_sign};
use crate::media_confirm::transform;

/// The name of the method.
pub(crate) fn name(formula: &str) -> &'static str {
    if formula == "loop-work" { "loop-integral/mp" } else { "quadrature-edges/mp" }
}

/// f = C rⁿ on a half-space, by its g at 1 from quadrature.
struct Loop<'a> {
    n: &'a Float,
    modulus: &'a Float,
    unit: Float,
    is_load: bool,
}

impl Loop<'_> {
    fn g(&self, a: &Float) -> Float {
        self.unit.clone() * a.pow(self.n)
    }

    fn elongation(&self, a: &Float, w: &Float) -> Float {
        (a.pi() * a * w / self.modulus).times(2).sqrt()
    }

    fn depth(&self, a: &Float, w: &Float) -> Float {
        self.g(a) - self.elongation(a, w)
    }

    /// 2E*(ad − ∫g).
    fn force(&self, a: &Float, d: &Float) -> Result<Float> {
        let integral = tanh_sinh(&a.lit(0), a, &roundoff_tolerance(a), |x| Ok(self.g(x)))?;
        Ok((d.clone() * a - integral.value) * self.modulus.lit(2) * self.modulus)
    }

    fn held(&self, a: &Float, w: &Float) -> Result<Float> {
        let d = self.depth(a, w);
        if self.is_load { self.force(a, &d) } else { Ok(d) }
    }

    /// Above 0 outside of the fold: a(g' − λΔl/2a), λ = 3 under a load.
    fn slope(&self, a: &Float, w: &Float) -> Float {
        let lambda = if self.is_load { 3 } else { 1 };
        self.g(a) * self.n - self.elongation(a, w).times(lambda).over(2)
    }

    /// The zero of a function that rises from below 0 at `inner`.
    fn zero(&self, inner: &Float, f: impl Fn(&Float) -> Result<Float>) -> Result<Float> {
        let (mut inner, mut outer) = (inner.clone(), inner.clone().times(2));
        while f(&outer)?.is_sign_negative() {
            outer = outer.times(2);
        }
        for _ in 0..inner.prec() {
            let middle = (inner.clone() + &outer).over(2);
            if f(&middle)?.is_sign_negative() { inner = middle } else { outer = middle }
        }
        Ok(inner)
    }
}

/// Whether the second method has the same values.
pub(crate) fn agrees(formula: &str, is_load: bool, x: &[Float], values: &[Float]) -> Result<bool> {
    let unit = transform(&x[0], &x[1], &x[0].lit(0), -1)?;
    let path = Loop { n: &x[0], modulus: &x[2], unit, is_load };
    let (w1, w2) = (&x[3], &x[4]);
    // Lengths and forces that are added in d and F.
    let length = |a: &Float| path.g(a) + path.elongation(a, w2);
    let load = |a: &Float| length(a) * a * path.modulus.lit(2) * path.modulus;
    match formula {
        "loop-preload" => {
            let fold = path.zero(&x[0].lit(10).powi(-30), |a| Ok(path.slope(a, w2)))?;
            let scale = if is_load { load(&fold) } else { length(&fold) };
            Ok(agree(&path.held(&fold, w1)?, &values[0], &scale))
        }
        "loop-work" => work(&path, w1, w2, &x[5], &values[0]),
        _ => {
            let a = &values[0];
            let turned = changes_sign(a, |a| Ok(path.held(a, w1)? - &x[5]))?;
            let before = (path.held(a, w1)? - &x[5]).is_sign_negative();
            let outer = !path.slope(a, w2).is_sign_negative();
            if formula == "loop-pull-off" {
                // At the fold of w₂, or at a reversal inside of it.
                let fold = changes_sign(a, |a| Ok(path.slope(a, w2)))?;
                let d = path.depth(a, w2);
                let place = if fold { before } else { turned && !outer };
                let force = path.force(a, &d)?;
                return Ok(place && agree(&d, &values[1], &length(a)) && agree(&force, &values[2], &load(a)));
            }
            let d = if is_load { &values[1] } else { &x[6] };
            let (force, given) = (path.force(a, d)?, if is_load { &x[6] } else { &values[1] });
            let drawn = path.g(a) - d;
            let pinned = turned && drawn > path.elongation(a, w1) && drawn < path.elongation(a, w2);
            let receding = before && outer && changes_sign(a, |a| Ok(path.held(a, w2)? - &x[6]))?;
            Ok((pinned || receding) && agree(&force, given, &load(a)))
        }
    }
}

/// ∮F dd: along the advancing edge from where it has d = 0, at the pinned edge of the reversal, and along the receding one to its fold.
fn work(path: &Loop<'_>, w1: &Float, w2: &Float, turn: &Float, value: &Float) -> Result<bool> {
    let nothing = turn.lit(10).powi(-30);
    let fold = |w: &Float| path.zero(&nothing, |a| Ok(path.slope(a, w)));
    let (start, reversal) = if w1.is_zero() {
        (turn.lit(0), path.zero(&nothing, |a| Ok(path.g(a) - turn))?)
    } else {
        let inner = fold(w1)?;
        (path.zero(&inner, |a| Ok(path.depth(a, w1)))?, path.zero(&inner, |a| Ok(path.depth(a, w1) - turn))?)
    };
    // F with ∫g = ag/(n + 1), and d' = (ng − Δl/2)/a.
    let force = |a: &Float, d: &Float| {
        (d.clone() - path.g(a) / (path.n.clone() + path.n.lit(1))) * a * path.modulus.lit(2) * path.modulus
    };
    let along = |from: &Float, to: &Float, w: &Float| {
        let integrand = |a: &Float| Ok(force(a, &path.depth(a, w)) * path.slope(a, w) / a);
        Ok(tanh_sinh(from, to, &roundoff_tolerance(turn), integrand)?.value)
    };
    let drawn = path.depth(&reversal, w2);
    let pinned = (force(&reversal, turn) + force(&reversal, &drawn)) * (drawn - turn);
    let end = fold(w2)?;
    let receding = if end < reversal { along(&reversal, &end, w2)? } else { turn.lit(0) };
    let whole = along(&start, &reversal, w1)? + pinned.over(2) + receding;
    Ok(agree(&whole, value, &(reversal.pi() * reversal.square() * w2)))
}
