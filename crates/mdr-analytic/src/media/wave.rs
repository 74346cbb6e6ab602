//! An elastic half-plane on a rigid wave (K. L. Johnson, Int. J. Solids Struct. 32 (1995) 423): states, energy, pressure, gap.

use mdr_core::contact::{Error, Material, Quantity, Result};
use mdr_core::number::{Real, Special};

const AMPLITUDE: Quantity = Quantity::Parameter("the amplitude h₀ of the wave");
const WAVELENGTH: Quantity = Quantity::Parameter("the wavelength λ");
const ANGLE: Quantity = Quantity::Parameter("the angle ψ = πa/λ");
const HALF_WIDTH: Quantity = Quantity::Parameter("the half-width a");
const FLAW: Quantity = Quantity::Parameter("the half-width of the flaw");
const POSITION: Quantity = Quantity::Parameter("the angle X = πx/λ");

/// A half-plane in adhesive contact with the wave h₀(1 − cos 2πx/λ), in plane strain, over |x| ≤ a in each period.
///
/// States are given without units: mean pressure P over p* = πE*h₀/λ, which closes the wave without adhesion, mean gap H over
/// h₀, energies per area over p*h₀, angles πx/λ. Then one number is left, α = √(2λw/(π²h₀²E*)), and with ψ = πa/λ,
/// s = sin²ψ and t = tan ψ the equilibria are P = s − α√t, H = 1 − s + P ln s.
///
/// ```
/// use mdr_analytic::media::JohnsonWave;
/// use mdr_core::contact::Material;
/// let wave = JohnsonWave::new(1e-6, 1e-4, Material::new(1e6, 0.01)?)?;
/// // Without adhesion the wave is closed by p* = πE*h₀/λ.
/// assert!((wave.closing_pressure() / 31415.92653589793 - 1.0).abs() < 1e-15);
/// assert!((wave.alpha() - 0.4501581580785531).abs() < 1e-15);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct JohnsonWave<R> {
    amplitude: R,
    wavelength: R,
    material: Material<R>,
    pub(super) alpha: R,
}

/// A state of the [wave](JohnsonWave), in equilibrium or not, without units.
#[derive(Clone, Debug, PartialEq)]
pub struct WaveState<R> {
    /// ψ = πa/λ, from 0 to π/2.
    pub angle: R,
    /// s = sin²ψ.
    pub share: R,
    /// cos²ψ.
    pub rest: R,
    /// P, the mean pressure over p*; positive when pressed.
    pub pressure: R,
    /// H, the mean gap over h₀. The approach of the mean planes is h₀(1 − H).
    pub mean_gap: R,
    /// tan ψ.
    pub(super) tangent: R,
    /// ln s.
    pub(super) ln_share: R,
    /// α.
    pub(super) alpha: R,
}

impl<R: Real> JohnsonWave<R> {
    /// From h₀ (half of the height from trough to crest) and λ in m, E* and w.
    ///
    /// # Errors
    /// [`Error::Domain`] unless h₀ and λ are positive and finite; [`Error::OutOfRange`] when α is not representable.
    pub fn new(amplitude: R, wavelength: R, material: Material<R>) -> Result<Self> {
        let amplitude = Error::require_positive(AMPLITUDE, amplitude)?;
        let wavelength = Error::require_positive(WAVELENGTH, wavelength)?;
        let (e, w) = (material.effective_modulus(), material.work_of_adhesion());
        let ratio = w.clone() / e / &amplitude * (wavelength.clone() / &amplitude);
        let alpha = ratio.times(2).sqrt() / amplitude.pi();
        let alpha = crate::range::representable(Quantity::Parameter("α of the wave"), alpha, || {
            (w.ln() - e.ln() + wavelength.ln() + w.lit(2).ln()).over(2) - amplitude.ln() - w.pi().ln()
        })?;
        Ok(JohnsonWave { amplitude, wavelength, material, alpha })
    }

    /// The wave of the given α, with h₀ = 1 m, λ = π m and E* = 1/α Pa, so that p* = E*.
    ///
    /// # Errors
    /// [`Error::Domain`] unless α is positive and finite.
    pub fn of_alpha(alpha: R) -> Result<Self> {
        let alpha = Error::require_positive(Quantity::Parameter("α of the wave"), alpha)?;
        let material = Material::new(alpha.clone().inv(), alpha.pi().over(2) * &alpha)?;
        Ok(JohnsonWave { amplitude: alpha.lit(1), wavelength: alpha.pi(), material, alpha })
    }

    /// α = √(2λw/(π²h₀²E*)).
    pub fn alpha(&self) -> &R {
        &self.alpha
    }

    /// h₀, in m.
    pub fn amplitude(&self) -> &R {
        &self.amplitude
    }

    /// λ, in m.
    pub fn wavelength(&self) -> &R {
        &self.wavelength
    }

    /// E* and w.
    pub fn material(&self) -> &Material<R> {
        &self.material
    }

    /// p* = πE*h₀/λ, the mean pressure that closes the wave without adhesion, in Pa.
    pub fn closing_pressure(&self) -> R {
        self.amplitude.pi() * self.material.effective_modulus() * &self.amplitude / &self.wavelength
    }

    /// κ = πE*/(Kλ), the compliance without units of a spring of the stiffness K per area (Pa/m) in series.
    ///
    /// # Errors
    /// [`Error::Domain`] unless K is positive and finite.
    pub fn compliance(&self, stiffness: &R) -> Result<R> {
        let stiffness = Error::require_positive(Quantity::Stiffness, stiffness.clone())?;
        Ok(self.amplitude.pi() * self.material.effective_modulus() / stiffness / &self.wavelength)
    }
}

impl<R: Special> JohnsonWave<R> {
    /// The equilibrium at ψ: P = s − α√t.
    ///
    /// # Errors
    /// [`Error::Domain`] unless 0 < ψ < π/2.
    pub fn state(&self, angle: &R) -> Result<WaveState<R>> {
        let mut state = self.at_angle(angle)?;
        let elongation = self.alpha.clone() * state.tangent.sqrt();
        state.set_pressure(state.share.clone() - &elongation, state.rest.clone() + elongation);
        Ok(state)
    }

    /// The equilibrium of the half-width a in m.
    ///
    /// # Errors
    /// [`Error::Domain`] unless 0 < a < λ/2.
    pub fn state_at_half_width(&self, a: &R) -> Result<WaveState<R>> {
        let a = Error::require_positive(HALF_WIDTH, a.clone())?;
        if !(a.clone().times(2) < self.wavelength) {
            return Err(Error::domain(HALF_WIDTH, &a, "below half of the wavelength"));
        }
        self.state(&(a.pi() * &a / &self.wavelength))
    }

    /// The equilibrium in which complete contact is broken by a flaw of the half-width c in m in each trough: P = cos²(πc/λ) −
    /// α√cot(πc/λ). Below that mean pressure the flaw grows; without a flaw complete contact never breaks.
    ///
    /// # Errors
    /// [`Error::Domain`] unless 0 < c < λ/2.
    pub fn state_with_flaw(&self, half_width: &R) -> Result<WaveState<R>> {
        let c = Error::require_positive(FLAW, half_width.clone())?;
        if !(c.clone().times(2) < self.wavelength) {
            return Err(Error::domain(FLAW, &c, "below half of the wavelength"));
        }
        let angle = c.pi() * &c / &self.wavelength;
        let (sine, cosine) = angle.sin_and_cos();
        let mut state = self.at(angle.pi().over(2) - &angle, cosine.square(), sine.square(), cosine / sine);
        let elongation = self.alpha.clone() * state.tangent.sqrt();
        state.set_pressure(state.share.clone() - &elongation, state.rest.clone() + elongation);
        Ok(state)
    }

    /// The state at ψ under the mean pressure P, in equilibrium or not.
    ///
    /// # Errors
    /// [`Error::Domain`] unless 0 < ψ < π/2 and P is finite.
    pub fn held(&self, angle: &R, pressure: &R) -> Result<WaveState<R>> {
        Error::require_finite(Quantity::Parameter("the mean pressure"), pressure)?;
        let mut state = self.at_angle(angle)?;
        state.set_pressure(pressure.clone(), pressure.lit(1) - pressure);
        Ok(state)
    }

    fn at_angle(&self, angle: &R) -> Result<WaveState<R>> {
        if !(*angle > angle.lit(0) && *angle < angle.pi().over(2)) {
            return Err(Error::domain(ANGLE, angle, "between 0 and π/2"));
        }
        let (sine, cosine) = angle.sin_and_cos();
        Ok(self.at(angle.clone(), sine.square(), cosine.square(), sine / cosine))
    }

    fn at(&self, angle: R, share: R, rest: R, tangent: R) -> WaveState<R> {
        let ln_share = if share > share.ratio(1, 2) { (-rest.clone()).ln_1p() } else { share.ln() };
        let zero = angle.lit(0);
        WaveState {
            alpha: self.alpha.clone(),
            pressure: zero.clone(),
            mean_gap: zero,
            angle,
            share,
            rest,
            tangent,
            ln_share,
        }
    }

    /// The equilibrium at v = ln tan²ψ, where neither sin²ψ nor cos²ψ cancels.
    pub(super) fn at_logarithm(&self, v: &R) -> WaveState<R> {
        let tangent = v.clone().over(2).exp();
        let (share, rest) = ((-v.clone()).exp() + v.lit(1), v.exp() + v.lit(1));
        let mut state = self.at(tangent.atan(), share.inv(), rest.inv(), tangent);
        let elongation = v.clone().over(4).exp() * &self.alpha;
        state.set_pressure(state.share.clone() - &elongation, state.rest.clone() + elongation);
        state
    }
}

impl<R: Special> WaveState<R> {
    /// P with 1 − P, and H = 1 − s + P ln s. Towards complete contact it is cos²ψ(1 − P) − P Σ_{j≥2} cos^{2j}ψ/j, whose terms do
    /// not cancel.
    fn set_pressure(&mut self, pressure: R, deficit: R) {
        self.mean_gap = if self.rest.approx() < SMALL {
            deficit * &self.rest - log_tail(&self.rest, 2) * &pressure
        } else {
            self.ln_share.clone() * &pressure + &self.rest
        };
        self.pressure = pressure;
    }

    /// U/(p*h₀) = s²/4 − ½P² ln s.
    pub fn elastic_energy(&self) -> R {
        (self.share.square() - (self.pressure.square() * &self.ln_share).times(2)).over(4)
    }

    /// Π/(p*h₀) = U/(p*h₀) − α²ψ, the energy with that of the surfaces in contact; 0 without contact.
    pub fn energy(&self) -> R {
        self.elastic_energy() - self.alpha.square() * &self.angle
    }

    /// The potential under a dead load over p*h₀, Π/(p*h₀) + PH = s²/4 + ½P² ln s − α²ψ + P(1 − s).
    pub fn load_potential(&self) -> R {
        self.energy() + self.pressure.clone() * &self.mean_gap
    }

    /// G/w = cot ψ (s − P)²/α², the energy release rate over the work of adhesion; 1 in equilibrium.
    pub fn release_rate(&self) -> R {
        ((self.share.clone() - &self.pressure) / &self.alpha).square() / &self.tangent
    }

    /// The pressure over p* at X = πx/λ in the contact, cos X (s + P − 2 sin²X)/√(s − sin²X); tension is negative, and without
    /// bound at the edge.
    ///
    /// # Errors
    /// [`Error::Domain`] unless |X| < ψ.
    pub fn pressure_at(&self, position: &R) -> Result<R> {
        if !(position.abs() < self.angle) {
            return Err(Error::domain(POSITION, position, "within the contact, below ψ"));
        }
        // sin²ψ − sin²X = sin(ψ − X) sin(ψ + X).
        let leg = (self.angle.clone() - position).sin() * (self.angle.clone() + position).sin();
        let above = self.pressure.clone() - &self.share + leg.clone().times(2);
        Ok(position.cos() * above / leg.sqrt())
    }

    /// The gap over h₀ at X = πx/λ outside of the contact, 2[y√(y² − s) − P arcosh(y/√s)] with y = sin X.
    ///
    /// # Errors
    /// [`Error::Domain`] unless ψ ≤ X ≤ π/2.
    pub fn gap_at(&self, position: &R) -> Result<R> {
        if !(*position >= self.angle && *position <= position.pi().over(2)) {
            return Err(Error::domain(POSITION, position, "outside of the contact, from ψ to π/2"));
        }
        let sine = position.sin();
        let square = (position.clone() - &self.angle).sin() * (self.angle.clone() + position).sin();
        let leg = square.sqrt();
        // arcosh z = ln(1 + u + u²/(1 + √(1 + u²))) with u = √(z² − 1).
        let u = leg.clone() / self.share.sqrt();
        let root = (u.square() + u.lit(1)).sqrt() + u.lit(1);
        let arcosh = (u.square() / root + u).ln_1p();
        Ok((sine * leg - arcosh * &self.pressure).times(2))
    }
}

/// Below it a logarithm is a series of three bits a term.
const SMALL: f64 = 0.125;

/// Σ_{j≥m} xʲ/j = −ln(1 − x) − x − … − x^{m−1}/(m−1) for 0 ≤ x < 1, without cancellation for small x.
pub(super) fn log_tail<R: Real>(x: &R, from: i64) -> R {
    let size = x.approx();
    if size > SMALL {
        let head = (1..from).fold(x.lit(0), |sum, j| sum + x.powi(j).over(j));
        return -(-x.clone()).ln_1p() - head;
    }
    // Each term has at least three bits less than the one before it.
    let bits = (-size.max(f64::MIN_POSITIVE).log2()).max(3.0);
    let terms = (f64::from(x.precision()) / bits).ceil() as i64 + 1;
    let last = from + terms;
    let mut sum = x.lit(1).over(last);
    for j in (from..last).rev() {
        sum = sum * x + x.lit(1).over(j);
    }
    let scale = x.powi(from);
    // Beyond 1/last there is less than twice x/last.
    let bound = x.powi(terms + 1).times(2).over(last);
    (sum.inflate_with_slope(&bound)) * scale
}
