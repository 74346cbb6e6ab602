//! Measured curves whose fits are certified, as NIST's Statistical Reference Datasets for nonlinear regression.

use crate::catalogue::records;
use crate::difficulty::Difficulty;
use crate::record::Record;

/// A curve, the fit to it, and its certified answer: estimates, their standard errors and the sum of squares.
///
/// ```
/// let set = mdr_reference::data_sets().iter().find(|set| set.name == "sphere1").expect("a data set");
/// let e_star = set.records().find(|record| record.quantity == "e_star").expect("a record");
/// assert_eq!(e_star.nearest(), 2000352.3798209159);
/// assert!(set.fit.contains("kind = \"paraboloid\"") && set.curve.starts_with("indentation,force"));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct DataSet {
    /// Its name, such as `sphere1`.
    pub name: &'static str,
    /// `Lower`: two or three numbers of one arc. `Average`: with offsets and the tail after pull-off. `Higher`: several arcs, or
    /// numbers that the data hardly distinguish.
    pub level: Difficulty,
    /// The fit: a file for `mdr fit`, in TOML. Its comments have two starts.
    pub fit: &'static str,
    /// The rows: CSV with a header and a row of units.
    pub curve: &'static str,
}

macro_rules! data_sets {
    ($($level:ident: $($name:literal)+;)+) => {
        [$($(DataSet {
            name: $name,
            level: Difficulty::$level,
            fit: include_str!(concat!("../data/fits/", $name, ".toml")),
            curve: include_str!(concat!("../data/fits/", $name, ".csv")),
        },)+)+]
    };
}

const DATA_SETS: [DataSet; 16] = data_sets! {
    Lower: "sphere1" "sphere2" "cone2" "rounded1" "jkrtest1" "jkrtest2";
    Average: "cone1" "hyper1" "power1" "flat1" "ball1";
    Higher: "soft1" "tip1" "wavy1" "ball2" "beyond1";
};

/// All data sets, from lower to higher level.
pub fn data_sets() -> &'static [DataSet] {
    &DATA_SETS
}

impl DataSet {
    /// How many rows the curve has.
    pub fn rows(&self) -> usize {
        self.curve.lines().count() - 2
    }

    /// Its certified values: quantities `e_star`, `e_star_stderr`, …, `rss`. Standard errors are those of NIST: from the Jacobian and
    /// the residual variance.
    pub fn records(&self) -> impl Iterator<Item = &'static Record> {
        let prefix = format!("fit/{}/", self.name);
        records().iter().filter(move |record| record.id.starts_with(&prefix))
    }
}
