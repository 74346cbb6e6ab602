//! Closed forms of elastic media other than the half-space.
//!
//! A contact on any elastic medium is three functions of one size a: the stiffness S(a) = dF/dd of a flat punch of that
//! size, the area A(a), and the depth g(a) without adhesion. Independent springs of the stiffness S'(x)dx under the profile
//! g(x) give
//!
//! * F' = S d' − S'Δl along the equilibria, with Δl = √(2wA'/S') and d = g − Δl;
//! * the energy Π = ½∫₀ᵃ S'(x)(d − g(x))² dx − wA(a), and the energy release rate w(g − d)²/Δl²;
//! * folds g' = Δl' at fixed grips, F' = 0 under a dead load, d'(K + S) = S'Δl on a machine of the stiffness K.
//!
//! | medium | size | item |
//! |---|---|---|
//! | half-space | contact radius | [`PowerLawContact`](crate::PowerLawContact) |
//! | half-space with a modulus E ∝ zᵏ | contact radius | [`GradedHalfSpace`], [`GradedContact`] |
//! | Winkler foundation | contact radius | [`GradedHalfSpace::winkler`] |
//! | half-plane under an even profile | half-width | [`LineContact`] |
//! | half-plane under a wave (Johnson 1995) | half-width | [`JohnsonWave`] |

mod graded;
mod graded_folds;
mod line;
mod wave;
mod wave_folds;
mod wave_losses;

pub use graded::{GradedContact, GradedHalfSpace, graded_kappa};
pub use graded_folds::graded_threshold;
pub use line::{LineContact, cylinder_depth, line_factor, line_stiffness, line_threshold};
pub use wave::{JohnsonWave, WaveState};
pub use wave_folds::{
    WaveControl, WaveFold, least_compliance_for_complete_contact, wave_approach_threshold, wave_energy_threshold,
    wave_load_threshold, wave_touch_threshold,
};
