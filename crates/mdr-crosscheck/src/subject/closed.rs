//! The closed forms under test, reached through one type so that a deliberate fault can be put into any of them.

use mdr_analytic::certified::{self, Question};
use mdr_analytic::media::{self, GradedContact, GradedHalfSpace, JohnsonWave, LineContact, WaveControl, WaveState};
use mdr_analytic::{Kappa, LoopWork, MaugisState, PowerLaw, PowerLawContact, ScaleFreeOutcome, State};
use mdr_core::contact::{Control, Equilibrium, Error, Fold, Material, Quantity, Result, Transform};
use mdr_core::number::certify::Decimal;
use mdr_core::number::{Gamma, Precision, Real, Special};
use rug::{Float, Rational};

use super::mutation::Fault;
use super::{Part, Subject};

/// The closed forms of mdr-analytic, as they are or with one deliberate fault.
///
/// Every method is the closed form of the same name; each of its numbers passes through the fault, if it is the one meant.
#[derive(Clone, Debug, Default)]
pub struct ClosedForms {
    fault: Option<Fault>,
}

/// A result with one number or more.
trait Numbers<R> {
    /// Each number, with the place of its id among those of its subject.
    fn numbers(&mut self) -> Vec<(usize, &mut R)>;
}

impl<R: Real> Numbers<R> for R {
    fn numbers(&mut self) -> Vec<(usize, &mut R)> {
        vec![(0, self)]
    }
}

/// d and F of a state whose radius is an input.
impl<R: Real> Numbers<R> for [R; 2] {
    fn numbers(&mut self) -> Vec<(usize, &mut R)> {
        self.iter_mut().enumerate().collect()
    }
}

/// States of three numbers, alone and in a list.
macro_rules! states {
    ($($state:ident: $($number:ident)*;)*) => {$(
        impl<R: Real> Numbers<R> for $state<R> {
            fn numbers(&mut self) -> Vec<(usize, &mut R)> {
                (0..).zip([$(&mut self.$number),*]).collect()
            }
        }

        impl<R: Real> Numbers<R> for Vec<$state<R>> {
            fn numbers(&mut self) -> Vec<(usize, &mut R)> {
                self.iter_mut().flat_map(Numbers::numbers).collect()
            }
        }
    )*};
}

states! {
    MaugisState: balance indentation force;
    LoopWork: jump_in hysteresis pull_off;
    State: contact_radius indentation force;
    Fold: contact_radius indentation force;
    Equilibrium: contact_radius indentation force;
}

/// The numbers of a certified answer with their ids and names: κ, then a, d and F, or at n = 1/2 the threshold and the ratio.
pub(crate) fn numbers(answer: certified::Answer) -> impl Iterator<Item = (SubjectId, &'static str, Decimal)> {
    let [radius, indentation, force] = answer
        .critical
        .map_or([None, None, None], |state| [state.contact_radius, state.indentation, state.force].map(Some));
    let all = [
        (SubjectId::CertifiedKappa, "κ", Some(answer.kappa)),
        (SubjectId::CertifiedRadius, "a", radius),
        (SubjectId::CertifiedIndentation, "d", indentation),
        (SubjectId::CertifiedForce, "F", force),
        (SubjectId::CertifiedThreshold, "threshold", answer.threshold),
        (SubjectId::CertifiedRatio, "ratio", answer.ratio),
    ];
    all.into_iter().filter_map(|(id, name, number)| Some((id, name, number?)))
}

impl ClosedForms {
    /// The closed forms with one fault.
    pub fn with(fault: Fault) -> Self {
        ClosedForms { fault: Some(fault) }
    }

    /// The result, with the number that the fault is meant for changed. `ids` are those of its numbers; `inputs` are the
    /// ones that the table of subjects names.
    fn perturb<R: Real, T: Numbers<R>>(&self, ids: &[SubjectId], inputs: &[&R], mut result: T) -> T {
        if let Some(Fault { id, mutation }) = &self.fault {
            for (_, number) in result.numbers().into_iter().filter(|(place, _)| ids[*place] == *id) {
                *number = mutation.apply(number.clone(), inputs);
            }
        }
        result
    }

    /// A value of the profile with this name at radius x.
    pub(crate) fn profile<R: Real>(&self, name: &'static str, part: Part, value: R, x: &R) -> R {
        self.perturb(&[SubjectId::Library(name, part)], &[x], value)
    }

    /// A result of the function of that name in `mdr_analytic::double`.
    pub(crate) fn double(&self, name: &'static str, value: f64) -> f64 {
        self.perturb(&[SubjectId::Double(name)], &[], value)
    }

    /// Middle and radius of the enclosure of κ_n.
    pub(crate) fn kappa_enclosure(&self, precision: Precision, n: &Rational) -> (Float, Float) {
        let enclosure = mdr_analytic::kappa_enclosure(precision, n);
        (self.perturb(&[SubjectId::KappaEnclosure], &[], enclosure.mid()), enclosure.radius())
    }

    /// The numbers of a certified answer: names, decimals, and floats that hold their digits.
    pub(crate) fn certified(
        &self,
        question: &Question,
        digits: u32,
    ) -> Result<impl Iterator<Item = (&'static str, Decimal, Float)>> {
        let bits = Precision::from_digits(digits).bits() + 96;
        Ok(numbers(question.answer(digits)?).map(move |(id, name, decimal)| {
            let parsed = Float::parse(decimal.to_string()).map(|text| Float::with_val(bits, text));
            let value = parsed.unwrap_or_else(|_| Float::with_val(bits, f64::NAN));
            (name, decimal, self.perturb(&[id], &[], value))
        }))
    }
}

/// The ids, their table, and the methods of [`ClosedForms`]. A line of `closed` is a method, the call that it makes, the public
/// function of mdr-analytic, the ids of its numbers, and the names and values of the inputs whose powers a fault may change;
/// one of `certified`, a function and the ids of its numbers.
macro_rules! subjects {
    (
        closed {$(
            fn $name:ident<R: $bound:ident $(+ $more:ident)?>($($argument:ident: $type:ty),*) -> $result:ty =
                $call:expr, $function:literal [$($id:ident),+] of $names:expr => $inputs:expr;
        )*}
        certified { $($answer:literal: $($certified:ident)+;)* }
        double { $($double:literal)* }
    ) => {
        /// A number among the results of a function of mdr-analytic.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[expect(missing_docs, reason = "named after the function and its result")]
        #[non_exhaustive]
        pub enum SubjectId {
            $($($id,)+)*
            $($($certified,)+)*
            Library(&'static str, Part),
            Double(&'static str),
        }

        pub(super) const NAMED: &[Subject] = &[
            $($(Subject { id: SubjectId::$id, function: $function, inputs: &$names },)+)*
            $($(Subject { id: SubjectId::$certified, function: $answer, inputs: &[] },)+)*
        ];

        /// The functions of `mdr_analytic::double` that give numbers.
        pub(super) const DOUBLE_IDS: &[SubjectId] = &[$(SubjectId::Double(concat!("double::", $double))),*];

        impl ClosedForms {
            $(pub(crate) fn $name<R: $bound $(+ $more)?>(&self, $($argument: $type),*) -> Result<$result> {
                Ok(self.perturb::<R, _>(&[$(SubjectId::$id),+], &$inputs, $call?))
            })*
        }
    };
}

/// The names of [`given`].
const GIVEN: [&str; 3] = ["C", "E*", "w"];
/// The names of [`along`].
const ALONG: [&str; 4] = ["a", "C", "E*", "w"];
/// The names of [`graded`].
const GRADED: [&str; 3] = ["C", "c", "w"];
/// The names of [`graded_along`].
const GRADED_ALONG: [&str; 4] = ["a", "C", "c", "w"];

subjects! {
    closed {
        fn kappa<R: Kappa>(n: &R) -> R = mdr_analytic::kappa(n), "kappa" [Kappa] of ["n"] => [n];
        fn g<R: Real>(law: &PowerLaw<R>, x: &R) -> R = law.g(x),
            "PowerLaw::g" [Transform] of ["x", "C"] => [x, law.coefficient()];
        fn slope<R: Real>(law: &PowerLaw<R>, x: &R) -> R = law.slope(x),
            "PowerLaw::slope" [TransformSlope] of ["x", "C"] => [x, law.coefficient()];
        fn integral<R: Real>(law: &PowerLaw<R>, x: &R) -> R = law.integral(x),
            "PowerLaw::integral" [TransformIntegral] of ["x", "C"] => [x, law.coefficient()];
        fn paraboloid<R: Kappa>(radius: &R, x: &R) -> R = PowerLaw::paraboloid(radius.clone())?.g(x),
            "PowerLaw::paraboloid" [ParaboloidProfile] of ["R"] => [radius];
        fn cone<R: Kappa>(slope: &R, x: &R) -> R = PowerLaw::cone(slope.clone())?.g(x),
            "PowerLaw::cone" [ConeProfile] of ["tan θ"] => [slope];
        fn cone_with_half_angle<R: Kappa + Special>(angle: &R, x: &R) -> R =
            PowerLaw::cone_with_half_angle(angle.clone())?.g(x),
            "PowerLaw::cone_with_half_angle" [ConeAngleProfile] of ["α"] => [angle];
        fn detachment_elongation<R: Real>(material: &Material<R>, a: &R) -> R =
            mdr_analytic::detachment_elongation(material, a),
            "detachment_elongation" [DetachmentElongation]
            of ["a", "E*", "w"] => [a, material.effective_modulus(), material.work_of_adhesion()];
        fn indentation<R: Real>(contact: &PowerLawContact<R>, a: &R) -> R = contact.indentation(a),
            "PowerLawContact::indentation" [Indentation] of ALONG => along(contact, a);
        fn indentation_slope<R: Real>(contact: &PowerLawContact<R>, a: &R) -> R = contact.indentation_slope(a),
            "PowerLawContact::indentation_slope" [IndentationSlope] of ALONG => along(contact, a);
        fn force<R: Real>(contact: &PowerLawContact<R>, a: &R) -> R = contact.force(a),
            "PowerLawContact::force" [Force] of ALONG => along(contact, a);
        fn force_slope<R: Real>(contact: &PowerLawContact<R>, a: &R) -> R = contact.force_slope(a),
            "PowerLawContact::force_slope" [ForceSlope] of ALONG => along(contact, a);
        fn energy<R: Real>(contact: &PowerLawContact<R>, a: &R, d: &R) -> R = contact.energy(a, d),
            "PowerLawContact::energy" [Energy] of ALONG => along(contact, a);
        fn critical<R: Real>(contact: &PowerLawContact<R>, control: &Control<R>) -> State<R> = contact.critical(control),
            "PowerLawContact::critical" [CriticalRadius, CriticalIndentation, CriticalForce] of GIVEN => given(contact);
        fn ln_critical<R: Real>(contact: &PowerLawContact<R>, control: &Control<R>) -> State<R> = contact.ln_critical(control),
            "PowerLawContact::ln_critical" [LnCriticalRadius, LnCriticalIndentation, LnCriticalForce] of GIVEN => given(contact);
        fn machine_folds<R: Real>(contact: &PowerLawContact<R>, stiffness: &R) -> Vec<Fold<R>> =
            contact.machine_folds(stiffness),
            "PowerLawContact::machine_folds" [MachineFoldRadius, MachineFoldIndentation, MachineFoldForce]
            of GIVEN => given(contact);
        fn universal_indentation<R: Real>(n: &R, scaled: &R) -> R = mdr_analytic::universal_indentation(n, scaled),
            "universal_indentation" [UniversalIndentation] of ["a/a_c"] => [scaled];
        fn universal_force<R: Real>(n: &R, scaled: &R) -> R = mdr_analytic::universal_force(n, scaled),
            "universal_force" [UniversalForce] of ["a/a_c"] => [scaled];
        fn equilibria<R: Real>(contact: &PowerLawContact<R>, control: &Control<R>, value: &R) -> Vec<Equilibrium<R>> =
            contact.equilibria(control, value).map(|found| found.as_slice().to_vec()),
            "PowerLawContact::equilibria" [EquilibriumRadius, EquilibriumIndentation, EquilibriumForce] of GIVEN => given(contact);
        fn equilibria_at_distance<R: Real>(contact: &PowerLawContact<R>, control: &Control<R>, distance: &R) -> Vec<Equilibrium<R>> =
            contact.equilibria_at_distance(control, distance).map(|found| found.as_slice().to_vec()),
            "PowerLawContact::equilibria_at_distance" [DistanceRadius, DistanceIndentation, DistanceForce]
            of GIVEN => given(contact);
        fn radius_at_zero_indentation<R: Real>(contact: &PowerLawContact<R>) -> R = contact.radius_at_zero_indentation(),
            "PowerLawContact::radius_at_zero_indentation" [ZeroIndentationRadius] of GIVEN => given(contact);
        fn energy_lost_at_pull_off<R: Real>(contact: &PowerLawContact<R>) -> R = contact.energy_lost_at_pull_off(),
            "PowerLawContact::energy_lost_at_pull_off" [PullOffLoss] of GIVEN => given(contact);
        fn energy_lost_at_jump_in<R: Real>(contact: &PowerLawContact<R>) -> R = contact.energy_lost_at_jump_in(),
            "PowerLawContact::energy_lost_at_jump_in" [JumpInLoss] of GIVEN => given(contact);
        fn barrier_to_complete_contact<R: Real>(contact: &PowerLawContact<R>) -> R = contact.barrier_to_complete_contact(),
            "PowerLawContact::barrier_to_complete_contact" [CompleteContactBarrier] of GIVEN => given(contact);
        fn least_ratio_for_full_pull_off<R: Real>(n: &R, control: &Control<R>) -> R =
            mdr_analytic::least_ratio_for_full_pull_off(n, control),
            "least_ratio_for_full_pull_off" [FullPullOffRatio] of [] => [];
        fn preload_for_full_pull_off<R: Real>(contact: &PowerLawContact<R>, advancing: &R, control: &Control<R>) -> R =
            contact.preload_for_full_pull_off(advancing, control),
            "PowerLawContact::preload_for_full_pull_off" [FullPullOffPreload] of GIVEN => given(contact);
        fn pull_off_from<R: Real>(contact: &PowerLawContact<R>, radius: &R, control: &Control<R>) -> State<R> =
            contact.pull_off_from(radius, control),
            "PowerLawContact::pull_off_from" [PullOffRadius, PullOffIndentation, PullOffForce] of GIVEN => given(contact);
        fn loop_work<R: Real>(contact: &PowerLawContact<R>, advancing: &R, radius: &R) -> LoopWork<R> =
            contact.loop_work(advancing, radius),
            "PowerLawContact::loop_work" [LoopJumpIn, LoopHysteresis, LoopPullOff] of GIVEN => given(contact);
        fn lemniscate_constant<R: Real>(like: &R) -> R = Result::Ok(mdr_analytic::lemniscate_constant(like)),
            "lemniscate_constant" [LemniscateConstant] of [] => [];
        fn threshold<R: Real>(material: &Material<R>, control: &Control<R>) -> R =
            mdr_analytic::threshold(material, control),
            "threshold" [Threshold] of ["E*", "w"] => [material.effective_modulus(), material.work_of_adhesion()];
        fn ratio<R: Real>(contact: &PowerLawContact<R>) -> R = contact.ratio(),
            "PowerLawContact::ratio" [ScaleFreeRatio] of GIVEN => given(contact);
        fn scale_free_state<R: Real>(contact: &PowerLawContact<R>, a: &R) -> [R; 2] =
            contact.scale_free_state(a).map(|state| [state.indentation, state.force]),
            "PowerLawContact::scale_free_state" [ScaleFreeIndentation, ScaleFreeForce] of ALONG => along(contact, a);
        fn fate<R: Real>(contact: &PowerLawContact<R>, control: &Control<R>) -> R =
            contact.fate(control).map(|fate| contact.profile().exponent().lit(sign(fate))),
            "PowerLawContact::fate" [ScaleFreeOutcome] of [] => [];
        fn flat_punch_pull_off<R: Real>(radius: &R, material: &Material<R>) -> [R; 2] =
            mdr_analytic::flat_punch_pull_off(radius, material).map(|state| [state.indentation, state.force]),
            "flat_punch_pull_off" [FlatPunchIndentation, FlatPunchForce]
            of ["b", "E*", "w"] => [radius, material.effective_modulus(), material.work_of_adhesion()];
        fn tabor_number<R: Special>(radius: &R, material: &Material<R>, range: &R) -> R =
            mdr_analytic::tabor_number(radius, material, range),
            "tabor_number" [TaborNumber]
            of ["R", "E*", "w", "z0"] => [radius, material.effective_modulus(), material.work_of_adhesion(), range];
        fn maugis_state<R: Special>(radius: &R, material: &Material<R>, separation: &R, ring: [&R; 2]) -> MaugisState<R> =
            mdr_analytic::maugis_state(radius, material, separation, ring[0], ring[1]),
            "maugis_state" [MaugisBalance, MaugisIndentation, MaugisForce]
            of ["R", "E*", "w", "h0", "a", "c"]
            => [radius, material.effective_modulus(), material.work_of_adhesion(), separation, ring[0], ring[1]];
        fn flat_punch_limit<R: Real>(contact: &PowerLawContact<R>) -> R =
            contact.flat_punch_limit().map(|state| state.contact_radius),
            "PowerLawContact::flat_punch_limit" [FlatPunchLimit] of ["C"] => [contact.profile().coefficient()];
        fn graded_kappa<R: Kappa + Gamma>(n: &R, k: &R) -> R = media::graded_kappa(n, k),
            "graded_kappa" [GradedKappa] of ["n"] => [n];
        fn graded_threshold<R: Kappa + Gamma>(medium: &GradedHalfSpace<R>, control: &Control<R>) -> R =
            media::graded_threshold(medium, control),
            "graded_threshold" [GradedThreshold] of ["c", "w"] => [medium.coefficient(), medium.work_of_adhesion()];
        fn graded_stiffness<R: Real>(medium: &GradedHalfSpace<R>, a: &R) -> R = medium.punch_stiffness(a),
            "GradedHalfSpace::punch_stiffness" [GradedStiffness] of ["a", "c"] => [a, medium.coefficient()];
        fn graded_elongation<R: Real>(medium: &GradedHalfSpace<R>, a: &R) -> R = medium.detachment_elongation(a),
            "GradedHalfSpace::detachment_elongation" [GradedElongation]
            of ["a", "c", "w"] => [a, medium.coefficient(), medium.work_of_adhesion()];
        fn graded_indentation<R: Real>(contact: &GradedContact<R>, a: &R) -> R = contact.indentation(a),
            "GradedContact::indentation" [GradedIndentation] of GRADED_ALONG => graded_along(contact, a);
        fn graded_indentation_slope<R: Real>(contact: &GradedContact<R>, a: &R) -> R = contact.indentation_slope(a),
            "GradedContact::indentation_slope" [GradedIndentationSlope] of GRADED_ALONG => graded_along(contact, a);
        fn graded_force<R: Real>(contact: &GradedContact<R>, a: &R) -> R = contact.force(a),
            "GradedContact::force" [GradedForce] of GRADED_ALONG => graded_along(contact, a);
        fn graded_force_slope<R: Real>(contact: &GradedContact<R>, a: &R) -> R = contact.force_slope(a),
            "GradedContact::force_slope" [GradedForceSlope] of GRADED_ALONG => graded_along(contact, a);
        fn graded_energy<R: Real>(contact: &GradedContact<R>, a: &R, d: &R) -> R = contact.energy(a, d),
            "GradedContact::energy" [GradedEnergy] of GRADED_ALONG => graded_along(contact, a);
        fn graded_critical<R: Real>(contact: &GradedContact<R>, control: &Control<R>) -> State<R> = contact.critical(control),
            "GradedContact::critical" [GradedCriticalRadius, GradedCriticalIndentation, GradedCriticalForce]
            of GRADED => graded(contact);
        fn graded_machine_folds<R: Real>(contact: &GradedContact<R>, stiffness: &R) -> Vec<Fold<R>> =
            contact.machine_folds(stiffness),
            "GradedContact::machine_folds" [GradedMachineRadius, GradedMachineIndentation, GradedMachineForce]
            of GRADED => graded(contact);
        fn line_factor<R: Kappa>(n: &R) -> R = media::line_factor(n), "line_factor" [LineFactor] of ["n"] => [n];
        fn line_threshold<R: Real>(material: &Material<R>) -> R = media::line_threshold(material),
            "line_threshold" [LineThreshold] of ["E*", "w"] => [material.effective_modulus(), material.work_of_adhesion()];
        fn line_stiffness<R: Real>(material: &Material<R>, b: &R, reference: &R) -> R =
            media::line_stiffness(material, b, reference),
            "line_stiffness" [LineStiffness] of ["E*"] => [material.effective_modulus()];
        fn cylinder_depth<R: Real>(radius: &R, b: &R, force: &R, reference: &R) -> R =
            media::cylinder_depth(radius, b, force, reference),
            "cylinder_depth" [CylinderDepth] of ["R", "b"] => [radius, b];
        fn line_force<R: Real>(contact: &LineContact<R>, b: &R) -> R = contact.force(b),
            "LineContact::force" [LineForce] of ["b"] => [b];
        fn line_force_slope<R: Real>(contact: &LineContact<R>, b: &R) -> R = contact.force_slope(b),
            "LineContact::force_slope" [LineForceSlope] of ["b"] => [b];
        fn line_critical<R: Real>(contact: &LineContact<R>) -> [R; 2] =
            contact.critical().map(|(half_width, force)| [half_width, force]),
            "LineContact::critical" [LineCriticalWidth, LineCriticalForce] of [] => [];
        fn line_half_width<R: Real>(contact: &LineContact<R>, force: &R) -> R =
            contact.half_widths(force).and_then(|found| {
                found.last().map(|(half_width, _)| half_width.clone()).ok_or_else(|| missing(force))
            }),
            "LineContact::half_widths" [LineHalfWidth] of [] => [];
        fn line_release_rate<R: Real>(contact: &LineContact<R>, b: &R, force: &R) -> R = contact.energy_release_rate(b, force),
            "LineContact::energy_release_rate" [LineReleaseRate] of ["b"] => [b];
        fn line_jump_in<R: Real>(contact: &LineContact<R>) -> R = contact.energy_lost_at_jump_in(),
            "LineContact::energy_lost_at_jump_in" [LineJumpInLoss] of [] => [];
        fn wave_alpha<R: Real>(amplitude: &R, wavelength: &R, material: &Material<R>) -> R =
            JohnsonWave::new(amplitude.clone(), wavelength.clone(), material.clone()).map(|wave| wave.alpha().clone()),
            "JohnsonWave::new" [WaveAlpha]
            of ["h0", "λ", "E*", "w"]
            => [amplitude, wavelength, material.effective_modulus(), material.work_of_adhesion()];
        fn wave_closing_pressure<R: Real>(wave: &JohnsonWave<R>) -> R = Result::Ok(wave.closing_pressure()),
            "JohnsonWave::closing_pressure" [WaveClosingPressure]
            of ["h0", "λ", "E*"] => [wave.amplitude(), wave.wavelength(), wave.material().effective_modulus()];
        fn wave_compliance<R: Real>(wave: &JohnsonWave<R>, stiffness: &R) -> R = wave.compliance(stiffness),
            "JohnsonWave::compliance" [WaveCompliance]
            of ["K", "λ", "E*"] => [stiffness, wave.wavelength(), wave.material().effective_modulus()];
        fn wave_state<R: Special>(wave: &JohnsonWave<R>, angle: &R) -> [R; 2] =
            wave.state(angle).map(|state| [state.pressure, state.mean_gap]),
            "JohnsonWave::state" [WavePressure, WaveMeanGap] of ["ψ", "α"] => [angle, wave.alpha()];
        fn wave_state_at_half_width<R: Special>(wave: &JohnsonWave<R>, a: &R) -> [R; 2] =
            wave.state_at_half_width(a).map(|state| [state.pressure, state.mean_gap]),
            "JohnsonWave::state_at_half_width" [WaveWidthPressure, WaveWidthMeanGap] of ["a"] => [a];
        fn wave_state_with_flaw<R: Special>(wave: &JohnsonWave<R>, c: &R) -> [R; 2] =
            wave.state_with_flaw(c).map(|state| [state.pressure, state.mean_gap]),
            "JohnsonWave::state_with_flaw" [WaveFlawPressure, WaveFlawMeanGap] of ["c"] => [c];
        fn wave_held_gap<R: Special>(wave: &JohnsonWave<R>, angle: &R, pressure: &R) -> R =
            wave.held(angle, pressure).map(|state| state.mean_gap),
            "JohnsonWave::held" [WaveHeldGap] of ["ψ"] => [angle];
        fn wave_folds<R: Special>(wave: &JohnsonWave<R>, control: &WaveControl<R>) -> Vec<State<R>> =
            wave.folds(control).map(|folds| folds.into_iter().map(|fold| wave_numbers(fold.state)).collect()),
            "JohnsonWave::folds" [WaveFoldAngle, WaveFoldMeanGap, WaveFoldPressure] of ["α"] => [wave.alpha()];
        fn wave_touching<R: Special>(wave: &JohnsonWave<R>, control: &WaveControl<R>) -> State<R> =
            wave.touching(control).and_then(|state| {
                state.map(wave_numbers).ok_or_else(|| missing(wave.alpha()))
            }),
            "JohnsonWave::touching" [WaveTouchAngle, WaveTouchMeanGap, WaveTouchPressure] of ["α"] => [wave.alpha()];
        fn wave_lost_at_touch<R: Special>(wave: &JohnsonWave<R>, control: &WaveControl<R>) -> R = wave.energy_lost_at_touch(control),
            "JohnsonWave::energy_lost_at_touch" [WaveTouchLoss] of ["α"] => [wave.alpha()];
        fn wave_lost_at_pull_off<R: Special>(wave: &JohnsonWave<R>, compliance: &R) -> R = wave.energy_lost_at_pull_off(compliance),
            "JohnsonWave::energy_lost_at_pull_off" [WavePullOffLoss] of ["α"] => [wave.alpha()];
        fn wave_lost_at_complete_contact<R: Special>(wave: &JohnsonWave<R>) -> R = wave.energy_lost_at_complete_contact(),
            "JohnsonWave::energy_lost_at_complete_contact" [WaveCompleteLoss] of ["α"] => [wave.alpha()];
        fn wave_elastic_energy<R: Special>(state: &WaveState<R>) -> R = Result::Ok(state.elastic_energy()),
            "WaveState::elastic_energy" [WaveElasticEnergy] of ["ψ"] => [&state.angle];
        fn wave_energy<R: Special>(state: &WaveState<R>) -> R = Result::Ok(state.energy()),
            "WaveState::energy" [WaveEnergy] of ["ψ"] => [&state.angle];
        fn wave_load_potential<R: Special>(state: &WaveState<R>) -> R = Result::Ok(state.load_potential()),
            "WaveState::load_potential" [WaveLoadPotential] of ["ψ"] => [&state.angle];
        fn wave_release_rate<R: Special>(state: &WaveState<R>) -> R = Result::Ok(state.release_rate()),
            "WaveState::release_rate" [WaveReleaseRate] of ["ψ"] => [&state.angle];
        fn wave_pressure_at<R: Special>(state: &WaveState<R>, position: &R) -> R = state.pressure_at(position),
            "WaveState::pressure_at" [WavePressureAt] of ["ψ"] => [&state.angle];
        fn wave_gap_at<R: Special>(state: &WaveState<R>, position: &R) -> R = state.gap_at(position),
            "WaveState::gap_at" [WaveGapAt] of ["X"] => [position];
        fn wave_load_threshold<R: Real>(like: &R) -> R = Result::Ok(media::wave_load_threshold(like)),
            "wave_load_threshold" [WaveLoadThreshold] of [] => [];
        fn wave_touch_threshold<R: Real>(like: &R) -> R = Result::Ok(media::wave_touch_threshold(like)),
            "wave_touch_threshold" [WaveTouchThreshold] of [] => [];
        fn wave_energy_threshold<R: Real>(like: &R) -> R = Result::Ok(media::wave_energy_threshold(like)),
            "wave_energy_threshold" [WaveEnergyThreshold] of [] => [];
        fn least_compliance<R: Real>(like: &R) -> R = Result::Ok(media::least_compliance_for_complete_contact(like)),
            "least_compliance_for_complete_contact" [WaveLeastCompliance] of [] => [];
        fn wave_approach_threshold<R: Real>(compliance: &R) -> R = media::wave_approach_threshold(compliance),
            "wave_approach_threshold" [WaveApproachThreshold] of ["κ"] => [compliance];
    }
    certified {
        "kappa_enclosure": KappaEnclosure;
        "Question::answer": CertifiedKappa CertifiedRadius CertifiedIndentation CertifiedForce CertifiedThreshold CertifiedRatio;
    }
    double {
        "critical" "kappa" "g" "g_slope" "g_integral" "detachment_elongation" "indentation" "force" "indentation_slope"
        "force_slope" "energy" "universal_indentation" "universal_force" "radius_at_zero_indentation"
        "energy_lost_at_pull_off" "energy_lost_at_jump_in" "barrier_to_complete_contact" "flat_punch_pull_off"
        "machine_folds" "equilibria" "equilibria_at_distance" "Inverse::equilibria" "Inverse::branches"
        "scale_free_state" "ratio" "threshold" "critical_states"
    }
}

/// The fate as +1 (shrinks), −1 (complete contact) or 0.
fn sign(fate: ScaleFreeOutcome) -> i64 {
    match fate {
        ScaleFreeOutcome::Shrinks => 1,
        ScaleFreeOutcome::CompleteContact => -1,
        ScaleFreeOutcome::Indifferent => 0,
    }
}

/// ψ, H and P of a state of the wave, in the places of a, d and F.
fn wave_numbers<R>(state: WaveState<R>) -> State<R> {
    State { contact_radius: state.angle, indentation: state.mean_gap, force: state.pressure }
}

/// The error of a check whose state does not exist.
fn missing<R: Real>(at: &R) -> Error {
    Error::no_equilibrium(Quantity::Force, at)
}

/// C, c, w: the parameters of a critical state on a graded half-space beside n and k.
fn graded<R: Real>(contact: &GradedContact<R>) -> [&R; 3] {
    let medium = contact.medium();
    [contact.profile().coefficient(), medium.coefficient(), medium.work_of_adhesion()]
}

/// a, C, c, w: the parameters of a state along the equilibria on a graded half-space beside n and k.
fn graded_along<'a, R: Real>(contact: &'a GradedContact<R>, a: &'a R) -> [&'a R; 4] {
    let [c, coefficient, work] = graded(contact);
    [a, c, coefficient, work]
}

/// C, E*, w: the parameters of a critical state beside n.
fn given<R: Real>(contact: &PowerLawContact<R>) -> [&R; 3] {
    let (profile, material) = (contact.profile(), contact.material());
    [profile.coefficient(), material.effective_modulus(), material.work_of_adhesion()]
}

/// a, C, E*, w: the parameters of a state along the equilibria beside n.
fn along<'a, R: Real>(contact: &'a PowerLawContact<R>, a: &'a R) -> [&'a R; 4] {
    let [c, e_star, work] = given(contact);
    [a, c, e_star, work]
}
