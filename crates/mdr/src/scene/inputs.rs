//! The inputs of a scene as columns of a spreadsheet.

use mdr_core::contact::Control;

use super::{Profile, Scene};

impl Scene {
    /// The inputs on which the states depend, as written: name, SI unit (empty for a pure number) and value. The terms of a sum
    /// are counted from 1; the rows of a table stay in their file.
    pub fn inputs(&self) -> Vec<(String, &'static str, String)> {
        let mut inputs = Vec::new();
        of_profile(&self.profile, "", &mut inputs);
        let mut add = |name: &str, unit, value: String| inputs.push((name.to_owned(), unit, value));
        if !self.medium.is_half_space() {
            add("medium", "", self.medium.name().to_owned());
            for (key, number) in self.medium.numbers() {
                add(&key.replace('.', "_"), self.medium.unit_symbol(key), number.to_string());
            }
        }
        if self.has_material && self.medium.needs_modulus() {
            add("e_star", "Pa", self.effective_modulus.to_string());
        }
        if self.has_material {
            match &self.works {
                None => add("work_of_adhesion", "J/m²", self.work_of_adhesion.to_string()),
                Some(works) => {
                    add("advancing_work_of_adhesion", "J/m²", works[0].to_string());
                    add("receding_work_of_adhesion", "J/m²", works[1].to_string());
                }
            }
        }
        if self.names_control() {
            add("control", "", self.control.kind().name().to_owned());
        }
        if let Control::Machine { stiffness } = &self.control {
            // That of a contact is a result.
            add("machine_stiffness", self.medium.unit_of_stiffness().symbol(), stiffness.to_string());
        }
        inputs
    }
}

fn of_profile(profile: &Profile, prefix: &str, inputs: &mut Vec<(String, &'static str, String)>) {
    inputs.push((format!("{prefix}profile"), "", profile.name().to_owned()));
    match profile {
        Profile::Shape(shape) => {
            let parameters = shape.parameters().into_iter().zip(shape.units());
            inputs.extend(
                parameters
                    .map(|((key, value), (_, unit))| (format!("{prefix}{key}"), unit.symbol(), value.to_string())),
            );
        }
        Profile::Sum(terms) => {
            for (index, term) in terms.iter().enumerate() {
                of_profile(term, &format!("{prefix}term{}.", index + 1), inputs);
            }
        }
        Profile::Formula(formula) => {
            let parameters = formula.parameters.iter();
            inputs.extend(parameters.map(|(name, value)| (format!("{prefix}{name}"), "", value.to_string())));
        }
        Profile::Table(_) | Profile::Function(_) => {}
        Profile::Wave(amplitude) => inputs.push((format!("{prefix}amplitude"), "m", amplitude.to_string())),
    }
}
