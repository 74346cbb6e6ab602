//! Counting the evaluations of a transform, and stopping them.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use mdr_core::contact::{
    Budget, CountingTransform, Error, EvaluationCounter, Evaluations, Kink, Quantity, Result, Transform,
};

/// Returns a different value from every method, none of them the default of the trait.
struct Peculiar;

impl Transform<f64> for Peculiar {
    fn g(&self, x: &f64) -> Result<f64> {
        Ok(x + 1.0)
    }

    fn slope(&self, x: &f64) -> Result<f64> {
        Ok(x + 2.0)
    }

    fn integral(&self, x: &f64) -> Result<f64> {
        Ok(x + 3.0)
    }

    fn mean(&self, x: &f64) -> Result<f64> {
        Ok(x + 4.0)
    }

    fn above_mean(&self, x: &f64) -> Result<f64> {
        Ok(x + 5.0)
    }

    fn g_within(&self, x: &f64, needed: &f64) -> Result<f64> {
        Ok(x + needed)
    }

    fn mean_within(&self, x: &f64, needed: &f64) -> Result<f64> {
        Ok(x - needed)
    }

    fn mean_square(&self, x: &f64) -> Option<Result<f64>> {
        Some(Ok(x + 9.0))
    }

    fn complete_contact(&self) -> Option<[f64; 2]> {
        Some([10.0, 11.0])
    }

    fn outer_radius(&self) -> Option<f64> {
        Some(6.0)
    }

    fn vertical_edge(&self) -> bool {
        true
    }

    fn kinks(&self) -> Vec<f64> {
        vec![7.0]
    }

    fn kink(&self, index: usize, margin: &f64) -> Result<Option<Kink<f64>>> {
        Err(Error::domain(Quantity::ContactRadius, &(index as f64 + margin), "peculiar"))
    }

    fn rises(&self) -> bool {
        true
    }

    fn rises_beyond(&self, x: &f64) -> bool {
        *x > 10.0
    }

    fn work(&self) -> u64 {
        8
    }
}

/// What a transform answers to each of its methods.
fn answers(transform: &dyn Transform<f64>) -> String {
    let numbers = [transform.g(&10.0), transform.slope(&10.0), transform.integral(&10.0), transform.mean(&10.0)];
    let more = [transform.above_mean(&10.0), transform.g_within(&10.0, &0.5), transform.mean_within(&10.0, &0.5)];
    let ends = (transform.outer_radius(), transform.vertical_edge(), transform.kinks(), transform.kink(2, &0.5));
    let rises = [transform.rises(), transform.rises_beyond(&10.0), transform.rises_beyond(&11.0)];
    let energies = (transform.mean_square(&10.0), transform.complete_contact());
    format!("{numbers:?} {more:?} {ends:?} {rises:?} {energies:?} {}", transform.work())
}

/// A method that a pointer does not pass on answers with the default of the trait, and nothing else would tell.
#[test]
fn pointers_pass_every_question_on() {
    let expected = answers(&Peculiar);
    assert_eq!(answers(&Arc::new(Peculiar)), expected);
    assert_eq!(answers(&Box::new(Peculiar)), expected);
    let shared: Arc<dyn Transform<f64>> = Arc::new(Peculiar);
    assert_eq!(answers(&shared), expected);
    assert_eq!(answers(&CountingTransform::sharing(shared, &Arc::default())), expected);
    // Each method of the trait is among them.
    let source = include_str!("../src/contact/transform.rs");
    let (declared, forwarded) = source.split_once("macro_rules! forward").expect("the macro after the trait");
    let methods = |text: &str| text.matches("  fn ").count();
    assert_eq!((methods(declared), methods(forwarded)), (16, 16));
}

#[test]
fn every_question_is_passed_on_and_counted_once() {
    let tally = Arc::new(EvaluationCounter::default());
    let counted = CountingTransform::new(Box::new(Peculiar), &tally);
    let spent = |work: &dyn Fn() -> Result<f64>| {
        let before = counted.evaluations();
        (work().unwrap(), counted.evaluations() - before)
    };
    let none = Evaluations::default();
    let [g, slope] = [Evaluations { g: 1, ..none }, Evaluations { slope: 1, ..none }];
    let integral = Evaluations { integral: 1, ..none };
    assert_eq!(spent(&|| counted.g(&10.0)), (11.0, g));
    assert_eq!(spent(&|| counted.slope(&10.0)), (12.0, slope));
    assert_eq!(spent(&|| counted.integral(&10.0)), (13.0, integral));
    assert_eq!(spent(&|| counted.mean(&10.0)), (14.0, integral));
    assert_eq!(spent(&|| counted.above_mean(&10.0)), (15.0, integral));
    assert_eq!(spent(&|| counted.mean_square(&10.0).unwrap()), (19.0, integral));
    assert_eq!(spent(&|| counted.g_within(&10.0, &0.5)), (10.5, g));
    assert_eq!(spent(&|| counted.mean_within(&10.0, &0.5)), (9.5, integral));
    assert_eq!((counted.outer_radius(), counted.vertical_edge(), counted.kinks()), (Some(6.0), true, vec![7.0]));
    assert!(counted.rises() && !counted.rises_beyond(&10.0));
    let expected = Peculiar.kink(2, &0.5).unwrap_err().to_string();
    assert_eq!(counted.kink(2, &0.5).unwrap_err().to_string(), expected);
    assert_eq!(tally.read(), Evaluations { g: 2, slope: 1, integral: 5 });
    assert_eq!(tally.read().total(), 8);
}

#[test]
fn a_stop_ends_every_evaluation() {
    let stop = Arc::new(AtomicBool::new(false));
    let counted = CountingTransform::new(Box::new(Peculiar), &Arc::new(EvaluationCounter::until(&stop)));
    assert!(counted.g(&1.0).is_ok());
    stop.store(true, Ordering::Relaxed);
    assert_eq!((counted.g(&1.0), counted.mean(&1.0)), (Err(Error::Stopped), Err(Error::Stopped)));
    assert_eq!(counted.evaluations().total(), 1);
}

#[test]
fn a_count_can_be_shared() {
    let tally = Arc::new(EvaluationCounter::default());
    let [one, other] = [(); 2].map(|()| CountingTransform::new(Box::new(Peculiar), &tally));
    assert!(one.g(&1.0).is_ok() && other.g(&1.0).is_ok());
    assert_eq!((one.evaluations().g, other.evaluations().g), (2, 2));
}

/// Two counts with one budget: what one spends the other lacks, by the weight of each.
#[test]
fn a_budget_can_be_shared() {
    let budget = Arc::new(Budget::default());
    let [light, heavy] = [1, 10].map(|weight| {
        let tally = Arc::new(EvaluationCounter::default().within(&budget));
        CountingTransform::new(Box::new(Peculiar), &tally).weighing(weight)
    });
    assert!((0..20).all(|_| heavy.g(&1.0).is_ok()), "without a limit nothing ends");
    budget.allow(12);
    assert!(heavy.g(&1.0).is_ok() && light.g(&1.0).is_ok() && light.slope(&1.0).is_ok());
    assert_eq!(
        (light.g(&1.0), heavy.mean(&1.0)),
        (Err(Error::BudgetSpent { evaluations: 2 }), Err(Error::BudgetSpent { evaluations: 21 }))
    );
    budget.allow(1);
    assert!(light.g(&1.0).is_ok() && light.g(&1.0).is_err());
}
