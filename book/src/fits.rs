//! A page for each data set of the certified fits, as NIST has for nonlinear regression.

use maud::{Markup, PreEscaped, html};
use mdr_fit::Problem;
use mdr_reference::{DataSet, Record};

use crate::error::{Error, Result};
use crate::values;

/// The page of a data set: the fit, its picture, the certified values, and the data to copy.
///
/// # Errors
/// When the library refuses the data.
pub(crate) fn page(set: &DataSet) -> Result<Markup> {
    let file = |_: &str| Ok(set.curve.as_bytes().to_vec());
    let fit = Problem::from_toml(set.fit, set.name, &file).and_then(|problem| problem.fit());
    let fit = fit.map_err(|error| Error::page(set.name, error.to_string()))?;
    let picture = mdr_plot::fit(&format!("{} of a {}", fit.observation.name(), fit.profile), &fit).svg();
    let about: Vec<&str> = set.fit.lines().map_while(|line| line.strip_prefix("# ")).collect();
    let records: Vec<&Record> = set.records().collect();
    Ok(html! {
        p.lede { (about.join(" ")) }
        p { (fit.rows.len()) " rows, " (fit.distance) " distances, " (fit.dof) " degrees of freedom. Standard errors are from the Jacobian and the residual variance, as in NIST’s sets for nonlinear regression; what is not free is known exactly. " a href="values-fit.html" { "All data sets" } }
        figure.wide tabindex="0" role="group" aria-label="Data, residuals and contact radius" { (PreEscaped(picture)) }
        h2 { "Certified values" }
        p.hint { "Every digit is proved by Krawczyk’s operator on the normal equations, and confirmed with residuals from quadrature of the heights. The condition is the factor by which a relative error of the data grows at least." }
        (values::table(&records))
        h2 { "What is fitted" }
        p { "A file for " code { "mdr fit" } "; " code { "mdr reference --data-sets DIR" } " writes this and the data." }
        pre tabindex="0" { (set.fit) }
        h2 { "Data" }
        details { summary { (set.name) ".csv" } pre tabindex="0" { (set.curve) } }
    })
}
