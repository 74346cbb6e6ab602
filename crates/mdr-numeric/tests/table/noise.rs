//! Scatter of rows, and smoothing.

use mdr_numeric::table::Table;

use super::sample::{noise, radii};

/// A table of doubles.
fn table(points: impl IntoIterator<Item = (f64, f64)>) -> Table {
    let rows: String = points.into_iter().map(|(r, f)| format!("{r:e},{f:e}\n")).collect();
    Table::from_csv(rows.as_bytes()).unwrap()
}

fn heights(table: &Table) -> Vec<f64> {
    table.rows().iter().map(|row| row.height.nearest_f64()).collect()
}

/// Rows that resolve a profile scatter by no more than their rounding, and noise is measured to a factor of two, in any unit.
#[test]
fn scatter_is_that_of_the_noise() {
    let smooth: [fn(f64) -> f64; 4] = [
        |r| r * r / 2.0,
        |r| (1.0 + r * r).sqrt() - 1.0,
        |r| if r < 1.0 { 0.0 } else { r * r - 1.0 },
        |r| r * r / 2.0 + 0.05 * (1.0 - (3.0 * r).cos()),
    ];
    for f in smooth {
        for (rows, jitter) in [(40, 0.0), (300, 0.0), (300, 0.3)] {
            for unit in [1e-100, 1.0, 1e100] {
                let radii = radii(rows, 3.0, jitter);
                let exact = table(radii.iter().map(|r| (r * unit, f(*r) * unit)));
                assert!(exact.scatter().of_rows().iter().all(|sigma| *sigma < 1e-14 * unit));
                // Uniform in ±0.01 √3, of standard deviation 0.01.
                let mut noise = noise(7);
                let rough =
                    radii.iter().map(|r| (r * unit, unit * if *r > 0.0 { f(*r) + 0.01732 * noise() } else { 0.0 }));
                let mut sigmas = table(rough).scatter().of_rows().to_vec();
                sigmas.sort_by(f64::total_cmp);
                let median = sigmas[rows / 2] / (0.01 * unit);
                assert!((0.5..2.0).contains(&median), "{rows} rows, off the grid by {jitter}: {median}");
            }
        }
    }
}

/// Local parabolas reproduce a paraboloid, for any zero and any spacing of the rows.
#[test]
fn smoothing_keeps_paraboloids() {
    for unit in [1e-100, 1.0, 1e100] {
        let radii = radii(60, 3.0, 0.3);
        let raised: String = radii.iter().map(|r| format!("{:e},{:e}\n", r * unit, (r * r + 5.0) * unit)).collect();
        let (smooth, tip) = Table::from_csv_above_any_zero(raised.as_bytes()).unwrap().smoothed(0.2 * unit).unwrap();
        assert!((tip / unit - 5.0).abs() < 1e-14);
        for (r, f) in radii.iter().zip(heights(&smooth)) {
            assert!((f / unit - r * r).abs() < 1e-13, "{r}: {f}");
        }
        assert!(smooth.rows()[0].height.is_zero());
    }
}

/// Noise is reduced to √(0.39 Δr/ℓ), a wave of 4.2ℓ to one half; a wave of 11ℓ keeps all but 2 %.
#[test]
fn smoothing_is_a_filter() {
    let radii: Vec<f64> = (0..=3000).map(|i| f64::from(i) / 100.0).collect();
    let mut noise = noise(3);
    let rough = table(radii.iter().map(|r| (*r, if *r > 0.0 { 3f64.sqrt() * noise() } else { 0.0 })));
    let (smooth, tip) = rough.smoothed(0.2).unwrap();
    let left = heights(&smooth).iter().map(|f| (f + tip).powi(2)).sum::<f64>() / 3001.0;
    assert!((left.sqrt() / f64::sqrt(0.389 * 0.01 / 0.2) - 1.0).abs() < 0.15, "{left}");
    for (wavelength, share) in [(4.22, 0.5), (11.0, 0.98), (2.5, 0.0)] {
        let wave = |r: &f64| 1.0 - (std::f64::consts::TAU * r / wavelength).cos();
        let (smooth, _) = table(radii.iter().map(|r| (*r, wave(r)))).smoothed(1.0).unwrap();
        let inner = |heights: Vec<f64>| heights[..1500].iter().copied().fold(0.0, f64::max);
        assert!((inner(heights(&smooth)) / 2.0 - share).abs() < 0.02, "{wavelength}");
    }
}
