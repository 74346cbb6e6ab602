//! Formulas: TeX to MathML.

use math_core::{LatexToMathML, MathCoreConfig, MathDisplay};

use crate::error::{Error, Result};

/// The longest formula that stands in a line of text without a box of its own that scrolls.
const INLINE: usize = 70;

/// The classes for `\color{red}` and `\color{green}`: the style sheet also marks both by an underline.
const MARKS: [(&str, &str); 2] = [("#FF0000", "wrong"), ("#03FF00", "right")];

/// A converter of formulas.
pub(crate) struct Tex(LatexToMathML);

impl Tex {
    pub(crate) fn new() -> Result<Self> {
        let config = MathCoreConfig { annotation: true, ..Default::default() };
        LatexToMathML::new(config)
            .map(Tex)
            .map_err(|error| Error::Formula { tex: String::new(), why: format!("{error:?}") })
    }

    fn convert(&self, tex: &str, display: MathDisplay) -> Result<String> {
        let result = self.0.convert_with_local_state(tex, display);
        let mut math = result.map_err(|error| Error::Formula { tex: tex.to_owned(), why: error.to_string() })?.mathml;
        for (colour, class) in MARKS {
            math = math.replace(&format!("mathcolor=\"{colour}\""), &format!("class=\"{class}\""));
            math = math.replace(&format!("style=\"color:{colour};\""), &format!("class=\"{class}\""));
        }
        Ok(primes(&math).replace('\n', " "))
    }

    /// A formula in a line of text.
    pub(crate) fn inline(&self, tex: &str) -> Result<String> {
        let math = self.convert(tex, MathDisplay::Inline)?;
        let long = tex.chars().count() > INLINE;
        Ok(if long { format!("<span class=\"wide\" tabindex=\"0\">{math}</span>") } else { math })
    }

    /// A formula of its own, with its source for whoever copies it. MathML does not break lines, so the box scrolls.
    pub(crate) fn display(&self, tex: &str) -> Result<String> {
        let math = self.convert(tex, MathDisplay::Block)?;
        Ok(format!(
            "<div class=\"formula\"><div class=\"eq\" tabindex=\"0\" role=\"group\" aria-label=\"Formula\">{math}</div>\
             <button class=\"copy\" type=\"button\" hidden>copy TeX</button></div>"
        ))
    }
}

/// A prime beside its letter instead of above it: fonts draw it raised already, and browsers raise it once more.
fn primes(math: &str) -> String {
    const RAISED: &str = "<mo>′</mo></msup>";
    let (mut out, mut rest) = (String::new(), math);
    while let Some((before, after)) = rest.split_once(RAISED) {
        match before.rsplit_once("<msup>") {
            Some((before, base)) => {
                out += &format!("{before}<mrow>{base}<mo lspace=\"0.05em\" rspace=\"0.05em\">′</mo></mrow>");
            }
            None => out += &format!("{before}{RAISED}"),
        }
        rest = after;
    }
    out + rest
}
