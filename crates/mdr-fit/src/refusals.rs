//! Input that is no problem of fitting, and records that no contact explains.

use super::observation::{Leg, Loss};
use super::parameter::Parameter;
use super::problem::{Kind, Problem};
use mdr::Result;
use mdr::reading::Location;
use mdr::scene::Profile;
use mdr_core::contact::Edge;

/// The reason why no row is in contact.
pub(super) fn out_of_contact(problem: &Problem) -> String {
    let given = problem.parameters.iter().filter(|parameter| {
        !parameter.free
            && matches!(parameter.kind, Kind::EffectiveModulus | Kind::WorkOfAdhesion | Kind::Work(_) | Kind::Stiffness)
    });
    let given: Vec<String> = given
        .filter_map(|parameter| {
            Some(format!("`{}` = {:e} {}", parameter.name, parameter.value?, parameter.unit_name()))
        })
        .collect();
    if given.is_empty() {
        return "all rows are out of contact for every E* and w that was tried: nothing of the contact is in the data; check the signs of x \
                and y (pressing in and pressing are positive) and their units"
            .to_owned();
    }
    format!(
        "all rows are out of contact for all free numbers that were tried, with {} as given: check what is given, the signs of x and y \
         (pressing in and pressing are positive) and their units",
        given.join(", ")
    )
}

/// Rejects input that is not a problem of fitting.
pub(super) fn check(problem: &Problem) -> Result<()> {
    let refuse = |key: &str, why: String| Err(Location::built(key).refuse(why));
    let free = problem.parameters.iter().filter(|parameter| parameter.free).count();
    if problem.range_of_adhesion.is_some() && !problem.medium.is_half_space() {
        let why = format!(
            "the theory of a finite range of adhesion is not available on kind = \"{}\": leave it out",
            problem.medium.name()
        );
        return refuse("output.range_of_adhesion", why);
    }
    if free == 0 {
        return refuse("fit.free", "nothing is free".to_owned());
    }
    let priors = problem.priors();
    if problem.rows.len() + priors <= free {
        let why = format!("{} rows cannot determine {free} numbers and their errors", problem.rows.len());
        return Err(problem.place.refuse(why));
    }
    let two = problem.has_two_works();
    let has_retract = problem.rows.iter().any(|row| row.leg == Leg::Retract);
    for parameter in &problem.parameters {
        let name = &parameter.name;
        if !parameter.free && parameter.start.is_some() {
            let why = "is not free, so that it has no start: add it to `free`, or give it as a known number";
            return refuse("fit.start", format!("`{name}` {why}"));
        }
        if two && parameter.free && parameter.kind == Kind::WorkOfAdhesion {
            let why = "is one number for both directions: free it, or `work_of_adhesion.advancing` and `work_of_adhesion.receding`";
            return refuse("fit.free", format!("`{name}` {why}"));
        }
        if parameter.free && parameter.kind == Kind::Work(Edge::Receding) && !has_retract {
            return refuse("fit.free", format!("no leg retracts, so that nothing is known of `{name}`"));
        }
    }
    let counts = |parameter: &Parameter| match parameter.kind {
        Kind::WorkOfAdhesion => !two,
        Kind::Work(_) => two,
        _ => true,
    };
    let missing =
        problem.parameters.iter().find(|parameter| !parameter.free && parameter.value.is_none() && counts(parameter));
    if let Some(parameter) = missing {
        let name = &parameter.name;
        let where_to = match parameter.kind {
            Kind::Stiffness => "[control]",
            _ => "[material]",
        };
        return refuse(
            "fit.free",
            format!("`{name}` is neither free nor given: add it to `free`, or give it in {where_to}"),
        );
    }
    let has_sigma = problem.sigma[1].is_some() || problem.rows.iter().all(|row| row.sigma[1].get().is_some());
    if !has_sigma && (priors > 0 || problem.loss == Loss::Huber) {
        let what = if priors > 0 { "a prior is weighed against the rows" } else { "the loss `huber` counts in σ" };
        return refuse(
            "data.sigma",
            format!("{what}, so it needs the standard deviation of y: sigma = {{ y = \"…\" }}"),
        );
    }
    let of_profile = |parameter: &Parameter| parameter.free && matches!(parameter.kind, Kind::Profile(_));
    if let Profile::Formula(formula) = &problem.profile
        && !formula.is_smooth()
        && problem.parameters.iter().any(of_profile)
    {
        return refuse(
            "fit.free",
            "a number of a formula with `abs`, `min` or `max` cannot be free: its kinks move".to_owned(),
        );
    }
    Ok(())
}
