#![allow(missing_docs, clippy::all, clippy::print_stdout, clippy::unwrap_used)]
use mdr_core::contact::*;
use mdr_numeric::{curve::Curve, folds, profiles::Power, transform::Quadrature};
fn main() {
    for (n, c, e, w, force) in [(1e-3, 7.1172037905656087e19, 1.4213126882584355e-7, 2.8062993463512386e23, false), (3.0673306397301947e-1, 108781553.23134066, 4.541979686929078e1, 1.4919226142594696e18, true)] {
        let t = Quadrature::new(Power::new(n, c).unwrap());
        let m = Material::new(e, w).unwrap();
        let control = if force { Control::Force } else { Control::Indentation };
        let curve = Curve::new(&t, &m, &control);
        let closed = mdr_analytic::Contact::new(mdr_analytic::PowerLaw::new(n, c).unwrap(), m.clone()).critical(&control);
        println!("{closed:?}");
        let start = std::time::Instant::now();
        println!("{:?} {:?}", folds::find(&curve), start.elapsed());
        for k in -10..=10 { let a = 10f64.powi(30 * k); println!("{a:e} tangency {:?} state {:?}", curve.tangency(&a), curve.state(&a)); }
    }
}
