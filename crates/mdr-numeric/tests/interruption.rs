//! What is said where the evaluations of a transform are ended, by a stop or by a budget.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use mdr_core::contact::{Control, CountingTransform, Error, EvaluationCounter, Material, Result, Shape, Transform};
use mdr_numeric::admissible::{Admissibility, Basis, GapVerdict};
use mdr_numeric::contact::Contact;
use mdr_numeric::folds;
use mdr_numeric::transform::Quadrature;

const WAVES: Shape<f64> = Shape::WavyParaboloid { radius: 1.0, amplitude: 5e-4, wavelength: 0.1 };

/// The waves, which raise a flag at an evaluation of g'.
struct Flagged {
    inner: Quadrature<f64, mdr_numeric::profiles::Heights<f64>>,
    tally: Arc<EvaluationCounter>,
    at: u64,
    stop: Arc<AtomicBool>,
}

impl Transform<f64> for Flagged {
    fn g(&self, x: &f64) -> Result<f64> {
        self.inner.g(x)
    }

    fn slope(&self, x: &f64) -> Result<f64> {
        if self.tally.read().total() >= self.at {
            self.stop.store(true, Ordering::Relaxed);
        }
        self.inner.slope(x)
    }

    fn integral(&self, x: &f64) -> Result<f64> {
        self.inner.integral(x)
    }
}

fn contact(transform: CountingTransform<f64>) -> Result<Contact<f64>> {
    Ok(Contact::half_space(&Arc::new(transform), &Material::new(1.0, 1e-4)?, &Control::Indentation))
}

/// A search that is stopped after any number of evaluations is no search that found less.
#[test]
fn a_stopped_search_has_no_folds() -> Result<()> {
    for at in [0, 1, 5, 20, 50, 100, 200] {
        let stop = Arc::new(AtomicBool::new(false));
        let tally = Arc::new(EvaluationCounter::until(&stop));
        let inner = Quadrature::of([WAVES])?;
        let flagged = Flagged { inner, tally: Arc::clone(&tally), at, stop };
        let found = folds::find(&contact(CountingTransform::new(Box::new(flagged), &tally))?);
        assert_eq!(found.map(|folds| folds.len()), Err(Error::Stopped), "{at}");
    }
    Ok(())
}

#[test]
fn a_spent_budget_leaves_no_folds() -> Result<()> {
    let whole = {
        let tally = Arc::new(EvaluationCounter::default());
        let found = folds::find(&contact(CountingTransform::new(Box::new(Quadrature::of([WAVES])?), &tally))?)?;
        assert_eq!(found.len(), 3);
        tally.read().total()
    };
    for part in [0.0, 0.01, 0.1, 0.5, 0.9, 0.99] {
        let tally = Arc::new(EvaluationCounter::default());
        let heights = {
            let counted = CountingTransform::new(Box::new(Quadrature::of([WAVES])?), &tally);
            folds::find(&contact(counted)?)?;
            tally.read().total()
        };
        assert_eq!(heights, whole);
        let tally = Arc::new(EvaluationCounter::default());
        // Every evaluation costs at least one height.
        tally.allow((part * whole as f64) as u64);
        let found = folds::find(&contact(CountingTransform::new(Box::new(Quadrature::of([WAVES])?), &tally))?);
        assert!(matches!(found, Err(Error::BudgetSpent { .. })), "{part}: {found:?}");
    }
    Ok(())
}

/// Nothing is called admissible by a search for the extrema of g that was ended on its way, wherever that was.
#[test]
fn a_spent_budget_leaves_no_state_admissible() -> Result<()> {
    let search = |work: Option<u64>| -> Result<(Admissibility, u64)> {
        let tally = Arc::new(EvaluationCounter::default());
        if let Some(work) = work {
            tally.allow(work);
        }
        let counted = CountingTransform::new(Box::new(Quadrature::of([WAVES])?), &tally);
        let found = Admissibility::new(Arc::new(counted), [1e-6, 0.3]);
        // The search is made when something needs it; what the states cost is allowed again.
        found.basis();
        let spent = tally.spent();
        tally.allow(u64::MAX / 2);
        Ok((found, spent))
    };
    let (whole, work) = search(None)?;
    assert_eq!((whole.basis(), whole.of(0.3, 0.01)), (Basis::Searched, GapVerdict::Admissible));
    for part in [0.0, 0.01, 0.3, 0.6, 0.9, 0.95, 0.99] {
        let (ended, _) = search(Some((part * work as f64) as u64))?;
        assert_eq!(ended.basis(), Basis::Doubtful, "{part}");
        assert_ne!(ended.of(0.3, 0.01), GapVerdict::Admissible, "{part}");
    }
    Ok(())
}
