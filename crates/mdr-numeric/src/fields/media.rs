//! Pressure and gap on other media than the half-space, as superpositions of flat punches of growing size.
//!
//! The load without adhesion grows from x to x + dx by S g' dx, under a flat punch of that size, and the adhesion takes the load
//! SΔl of a flat punch of the size of the contact away.

use mdr_core::calculus::quadrature::tanh_sinh_pieces;
use mdr_core::calculus::{Estimate, Tolerance};
use mdr_core::contact::{Error, Quantity, Result};
use mdr_core::number::Special;

use super::{Fields, integrate, leg};
use crate::medium::Medium;

impl<R: Special> Fields<R> {
    /// The pressure; `None` on a half-space.
    pub(super) fn pressure_on_medium(&self, r: &R) -> Result<Option<Estimate<R>>> {
        let a = self.curve.medium().contact_radius(&self.contact_radius);
        if !(*r >= r.lit(0) && *r < a) {
            return Err(Error::domain(Quantity::Radius, r, "within the contact, 0 <= r < a"));
        }
        Ok(match self.curve.medium() {
            Medium::Graded { coefficient, exponent } => Some(self.graded_pressure(coefficient, exponent, r)?),
            Medium::Winkler { modulus } => {
                let g = self.curve.transform().g_within(&self.off_axis(r.clone()), &self.negligible_here())?;
                Some(Estimate::exact((self.indentation.clone() - g) * modulus))
            }
            Medium::Plane { modulus, .. } => Some(self.line_pressure(modulus, r)?),
            Medium::Periodic { modulus, wavelength } => Some(self.periodic_pressure(modulus, wavelength, r)?),
            _ => None,
        })
    }

    /// The gap at r > a; `None` on a half-space.
    pub(super) fn gap_on_medium(&self, r: &R) -> Result<Option<Estimate<R>>> {
        let medium = self.curve.medium();
        if medium.is_half_space() {
            return Ok(None);
        }
        let a = self.beside(r)?;
        let g = |x: &R| self.curve.transform().g_within(x, &self.negligible_here());
        match medium {
            Medium::Winkler { .. } => Ok(Some(Estimate::exact(g(r)? - &self.indentation))),
            Medium::Graded { exponent, .. } => {
                // (2cos(πk/2)/π) ∫ cotᵏφ (g(r cosφ) − d) dφ, in v = φ^(1−k).
                let power = exponent.lit(1) - exponent;
                let angle = |x: &R| (leg(r, x) / x).atan();
                let breaks: Vec<R> = self.kinks(&a, r).iter().map(|kink| angle(kink).pow(&power)).collect();
                let whole = integrate(&r.lit(0), &angle(&a).pow(&power), &breaks, |v| {
                    let phi = v.pow(&power.clone().inv());
                    let shape = if phi > r.lit(0) { (phi.cos() / phi.sin() * &phi).pow(exponent) } else { r.lit(1) };
                    Ok((g(&(phi.cos() * r).greater(&a))? - &self.indentation) * shape)
                })?;
                Ok(Some(whole.scaled(&(inverse_factor(exponent) / &power))))
            }
            Medium::Plane { .. } => self.line_gap(r).map(Some),
            Medium::Periodic { wavelength, .. } => self.periodic_gap(wavelength, r).map(Some),
            _ => Ok(None),
        }
    }

    /// The displacement at r > a; `None` on a half-space.
    pub(super) fn displacement_on_medium(&self, r: &R) -> Result<Option<Estimate<R>>> {
        let a = match self.curve.medium() {
            Medium::Graded { .. } | Medium::Winkler { .. } => self.outside(r)?,
            Medium::Plane { .. } => return self.line_displacement(r).map(Some),
            Medium::Periodic { wavelength, .. } => return self.periodic_displacement(wavelength, r).map(Some),
            _ => return Ok(None),
        };
        let Medium::Graded { exponent, .. } = self.curve.medium() else {
            // Springs that are not touched stay.
            return Ok(Some(Estimate::exact(r.lit(0))));
        };
        // (2cos(πk/2)/π) ∫ tanᵏθ (d − g(r sinθ)) dθ, in v = θ^(1+k).
        let power = exponent.lit(1) + exponent;
        let angle = |x: &R| (x.clone() / &leg(r, x)).atan();
        let breaks: Vec<R> = self.kinks(&r.lit(0), a).iter().map(|kink| angle(kink).pow(&power)).collect();
        let whole = integrate(&r.lit(0), &angle(a).pow(&power), &breaks, |v| {
            let theta = v.pow(&power.clone().inv());
            let shape = if theta > r.lit(0) { (theta.sin() / theta.cos() / &theta).pow(exponent) } else { r.lit(1) };
            let x = self.off_axis(theta.sin() * r);
            let depth = self.indentation.clone() - self.curve.transform().g_within(&x, &self.negligible_here())?;
            Ok(depth * shape)
        })?;
        Ok(Some(whole.scaled(&(inverse_factor(exponent) / &power))))
    }

    /// The contact radius or half-width, for a radius outside it and on a periodic medium within half of a period.
    fn beside(&self, r: &R) -> Result<R> {
        let medium = self.curve.medium();
        let a = medium.contact_radius(&self.contact_radius);
        let (end, requirement) = match medium.period() {
            Some(wavelength) => (wavelength.clone().over(2), "outside the contact, and within half of a period"),
            None => (r.clone(), "finite and outside the contact"),
        };
        if *r > a && r.is_finite() && *r <= end { Ok(a) } else { Err(Error::domain(Quantity::Radius, r, requirement)) }
    }

    /// (c/π)[∫ᵣᵃ g'(x)(x² − r²)^((k−1)/2) dx − Δl(a² − r²)^((k−1)/2)]: in y² = x² − r² the integrand is g'/x yᵏ, in y^(1+k)
    /// smooth.
    fn graded_pressure(&self, coefficient: &R, exponent: &R, r: &R) -> Result<Estimate<R>> {
        let a = &self.contact_radius;
        let (power, reach) = (exponent.lit(1) + exponent, leg(a, r));
        let breaks: Vec<R> = self.kinks(r, a).iter().map(|kink| leg(kink, r).pow(&power)).collect();
        let bulk = integrate(&r.lit(0), &reach.pow(&power), &breaks, |v| {
            let y = v.pow(&power.clone().inv());
            let x = self.off_axis((r.square() + y.square()).sqrt()).lesser(a);
            Ok(self.curve.transform().slope(&x)? / &x)
        });
        let bulk = bulk.map_err(|error| if self.is_infinite_at(r) { super::infinite_at(r) } else { error })?;
        let bulk = bulk.scaled(&power.clone().inv());
        let edge = self.edge.clone() * reach.pow(&(exponent.clone() - exponent.lit(1)));
        Ok(minus(bulk, edge).scaled(&(coefficient.clone() / r.pi())))
    }

    /// (E*/π)[∫ N'(c)/√(c² − x²) dc − (S/E*)Δl/√(b² − x²)] of a line contact, with N' = (S/E*)g'.
    fn line_pressure(&self, modulus: &R, r: &R) -> Result<Estimate<R>> {
        let (b, reach) = (&self.contact_radius, leg(&self.contact_radius, r));
        let breaks: Vec<R> = self.kinks(r, b).iter().map(|kink| leg(kink, r)).collect();
        let bulk = integrate(&r.lit(0), &reach, &breaks, |y| {
            let c = self.off_axis((r.square() + y.square()).sqrt()).lesser(b);
            Ok(self.load_slope(&c)? / &c)
        });
        let bulk = bulk.map_err(|error| if self.is_infinite_at(r) { super::infinite_at(r) } else { error })?;
        Ok(minus(bulk, self.edge_load() / reach).scaled(&(modulus.clone() / r.pi())))
    }

    /// (2/π)[∫_b^x arcosh(x/c) N'(c) dc + arcosh(x/b)(S/E*)Δl] outside a line contact.
    fn line_gap(&self, r: &R) -> Result<Estimate<R>> {
        let b = &self.contact_radius;
        let bulk = tanh_sinh_pieces(b, r, &self.kinks(b, r), tolerance(r), |c| {
            Ok(crate::medium::arcosh_ratio(r, &c.lesser(r)) * self.load_slope(c)?)
        })?;
        let edge = crate::medium::arcosh_ratio(r, b) * self.edge_load();
        Ok(minus(bulk, -edge).scaled(&(r.lit(2) / r.pi())))
    }

    /// d − (2/π)[∫₀ᵇ arcosh(x/c) N'(c) dc − arcosh(x/b)(S/E*)Δl] outside a line contact, against its reference: a flat punch of
    /// half-width c moves the surface at x by (2/πE*)(arcosh(L/c) − arcosh(x/c)) times its load.
    fn line_displacement(&self, r: &R) -> Result<Estimate<R>> {
        let b = self.outside(r)?;
        let medium = self.curve.medium();
        let Some(reference) = medium.outer_size() else {
            let requirement = "left out: without a reference a line contact has no displacements, only gaps";
            return Err(Error::domain(Quantity::Radius, r, requirement));
        };
        if *r > *reference {
            return Err(Error::domain(Quantity::Radius, r, "at most the reference distance"));
        }
        let bulk = tanh_sinh_pieces(&r.lit(0), b, &self.kinks(&r.lit(0), b), tolerance(r), |c| {
            let c = self.off_axis(c.clone());
            Ok(crate::medium::arcosh_ratio(r, &c) * self.load_slope(&c)?)
        })?;
        let edge = crate::medium::arcosh_ratio(r, b) * self.edge_load();
        Ok(from(&self.indentation, minus(bulk, edge).scaled(&(r.lit(2) / r.pi()))))
    }

    /// d − (2λ/π)[∫ F₀' arcosh(sinX/√s) ds/s' − SΔl arcosh(sinX/√s)]/E* beside a strip, against the mean plane.
    fn periodic_displacement(&self, wavelength: &R, r: &R) -> Result<Estimate<R>> {
        self.beside(r)?;
        let sine = crate::medium::phase(r, wavelength).sin();
        let closed = self.closed(wavelength).sqrt();
        let bulk = tanh_sinh_pieces(&r.lit(0), &closed, &[], tolerance(r), |root| {
            let root = root.greater(&(r.unit_roundoff().square() * &closed));
            let open = (root.lit(1) - &root) * (root.lit(1) + &root);
            let load = self.load_per_share(wavelength, &root.square(), &open)? * &root;
            Ok((load * crate::medium::arcosh_ratio(&sine, &root.lesser(&sine))).times(2))
        })?;
        let edge = crate::medium::arcosh_ratio(&sine, &closed.lesser(&sine)) * self.edge_load();
        Ok(from(&self.indentation, minus(bulk, edge).scaled(&(wavelength.clone().times(2) / r.pi()))))
    }

    /// cos X[∫ F₀'/√(s − sin²X) ds/s' − SΔl/√(s − sin²X)] of a strip in each period, with X = πx/λ and s = sin²(πa/λ).
    fn periodic_pressure(&self, modulus: &R, wavelength: &R, r: &R) -> Result<Estimate<R>> {
        let position = crate::medium::phase(r, wavelength);
        let (sine, cosine) = position.sin_and_cos();
        let reach = (self.closed(wavelength) - sine.square()).sqrt();
        let bulk = integrate(&r.lit(0), &reach, &[], |y| {
            let share = (sine.square() + y.square()).greater(&(y.unit_roundoff().square() * &reach));
            let open = cosine.square() - y.square();
            Ok(self.load_per_share(wavelength, &share, &open)?.times(2))
        })?;
        Ok(minus(bulk, self.edge_load() / reach).scaled(&(cosine * modulus)))
    }

    /// (2λ/π)[∫ F₀' arcosh(sinX/√s) ds/s' + SΔl arcosh(sinX/√s)]/E* beside a strip.
    fn periodic_gap(&self, wavelength: &R, r: &R) -> Result<Estimate<R>> {
        let position = crate::medium::phase(r, wavelength);
        let (sine, cosine) = position.sin_and_cos();
        let closed = self.closed(wavelength);
        // In u² = sin²X − s, where arcosh is smooth.
        let width = (sine.square() - &closed).sqrt();
        let height = |share: &R| crate::medium::arcosh_ratio(&sine, &share.sqrt().lesser(&sine));
        let bulk = integrate(&r.lit(0), &width, &[], |u| {
            let share = (sine.square() - u.square()).greater(&closed);
            let open = cosine.square() + u.square();
            Ok((self.load_per_share(wavelength, &share, &open)? * height(&share) * u).times(2))
        })?;
        let edge = height(&closed) * self.edge_load();
        Ok(minus(bulk, -edge).scaled(&(wavelength.clone().times(2) / r.pi())))
    }

    /// s of the contact.
    fn closed(&self, wavelength: &R) -> R {
        let t = crate::medium::phase(&self.contact_radius, wavelength);
        (t.square().inv() + t.lit(1)).inv()
    }

    /// F₀'/(E* s') where s is this and 1 − s is `open`: ds/db = 2t(1 − s)²π/λ.
    fn load_per_share(&self, wavelength: &R, share: &R, open: &R) -> Result<R> {
        let t = (share.clone() / open).sqrt();
        let per_phase = wavelength.clone() / t.pi();
        let b = t.clone() * &per_phase;
        Ok(self.load_slope(&b)? * per_phase / (open.square() * t).times(2))
    }

    /// (S/M)g' at a size, with the modulus M.
    fn load_slope(&self, x: &R) -> Result<R> {
        Ok(self.curve.medium().reduced_stiffness(x) * self.curve.transform().slope(x)?)
    }

    /// (S/M)Δl of the contact.
    fn edge_load(&self) -> R {
        self.curve.medium().reduced_stiffness(&self.contact_radius) * &self.edge
    }

    fn negligible_here(&self) -> R {
        crate::contact::negligible(&self.edge.abs())
    }
}

/// 2cos(πk/2)/π.
fn inverse_factor<R: Special>(exponent: &R) -> R {
    let pi = exponent.pi();
    ((pi.clone() * exponent).over(2).cos() / pi).times(2)
}

/// An integral less an exact number.
fn minus<R: Special>(integral: Estimate<R>, number: R) -> Estimate<R> {
    Estimate { value: integral.value - number, ..integral }
}

/// A number less an integral.
fn from<R: Special>(number: &R, integral: Estimate<R>) -> Estimate<R> {
    Estimate { value: number.clone() - integral.value, ..integral }
}

fn tolerance<R: Special>(like: &R) -> Tolerance<R> {
    Tolerance::of_cancelling(like).or_finest_below(like.unit_roundoff().sqrt().times(16))
}
