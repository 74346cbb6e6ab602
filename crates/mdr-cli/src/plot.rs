//! A picture as a file, with its data beside it: the flag `--plot`.

use std::fs::File;
use std::path::{Path, PathBuf};

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use mdr_plot::{Picture, Sheet, Theme};

use crate::error::{Failure, Result};
use crate::{converter, files};

/// The flags of a command that draws its answer; the help of each command describes the picture.
#[derive(Debug, Args)]
pub(crate) struct PictureFlags {
    #[arg(long, value_name = "OUT.svg")]
    plot: Option<PathBuf>,

    /// Draw these panels alone, by their letters: a, or a,c. The data are those of all panels
    #[arg(long, value_name = "LETTERS", value_delimiter = ',')]
    panel: Vec<char>,

    #[command(flatten)]
    sheet: SheetFlags,
}

/// The flags of the sheet that pictures are drawn on.
#[derive(Debug, Args)]
pub(crate) struct SheetFlags {
    /// Colours of the picture
    #[arg(long, value_parser = theme(), default_value = THEMES[0].0)]
    theme: Theme,

    /// Width of the picture: 85mm, 17cm, 3.4in, 240pt. Panels without room beside each other stand below each other
    #[arg(long, value_name = "WIDTH", value_parser = length)]
    size: Option<f64>,

    /// Size of the text: 8pt
    #[arg(long, value_name = "SIZE", value_parser = length)]
    font: Option<f64>,
}

/// Sizes of text in points that can be read, and the widest sheet, two metres.
const FONTS: std::ops::RangeInclusive<f64> = 4.0..=72.0;
const WIDEST: f64 = 5670.0;

/// Reads a length with its unit, in points.
fn length(text: &str) -> std::result::Result<f64, String> {
    const UNITS: [(&str, f64); 5] = [("mm", 72.0 / 25.4), ("cm", 72.0 / 2.54), ("in", 72.0), ("pt", 1.0), ("px", 0.75)];
    let read = UNITS.iter().find_map(|(unit, points)| {
        let number: f64 = text.trim().strip_suffix(unit)?.trim_end().parse().ok()?;
        Some(number * points)
    });
    read.filter(|points| points.is_finite() && *points > 0.0)
        .ok_or_else(|| "must be a length above 0 with its unit, such as 85mm, 17cm, 3.4in or 240pt".to_owned())
}

impl SheetFlags {
    /// The sheet.
    ///
    /// # Errors
    /// Text too small or too large to be read; a sheet without room for one panel, or wider than two metres.
    pub(crate) fn sheet(&self) -> Result<Sheet> {
        let font = self.font.unwrap_or(Sheet::default().font);
        if !FONTS.contains(&font) {
            let got = format!("{font:.1}pt");
            return Err(Failure::flag("--font", "must be between 4pt and 72pt", &got));
        }
        let narrowest = Sheet::narrowest(font);
        if let Some(width) = self.size.filter(|width| *width < narrowest || *width > WIDEST) {
            let least = narrowest / 72.0 * 25.4;
            let why = format!("must be between {:.0}mm, with text of {font:.1}pt, and 2000mm", least.ceil());
            return Err(Failure::flag("--size", why, &format!("{:.1}mm", width / 72.0 * 25.4)));
        }
        Ok(Sheet { theme: self.theme, width: self.size, font })
    }
}

impl PictureFlags {
    /// Whether a picture is asked for, into a file that may be written.
    ///
    /// # Errors
    /// Errors of [`check`] for a file that cannot or must not be written, of a sheet, and flags of a picture without one.
    pub(crate) fn wanted(&self) -> Result<bool> {
        self.sheet.sheet()?;
        match &self.plot {
            Some(to) => check(to).map(|()| true),
            None if !self.panel.is_empty() => Err(Failure::refused("--panel", "there is no picture without --plot")),
            None => Ok(false),
        }
    }

    /// Draws the picture if one is wanted, and computes it only then.
    ///
    /// # Errors
    /// When a file cannot be written, or nothing can be drawn.
    pub(crate) fn draw(&self, picture: impl FnOnce() -> Result<Picture>) -> Result<()> {
        let Some(to) = &self.plot else { return Ok(()) };
        let picture = picture()?;
        let csv = picture.csv();
        let picture = match &self.panel[..] {
            [] => picture,
            letters => picture.only(letters.iter().copied()).map_err(|there| {
                let there: Vec<String> = there.iter().map(char::to_string).collect();
                let given: String = letters.iter().collect();
                Failure::flag("--panel", format_args!("the picture has the panels {}", there.join(", ")), &given)
            })?,
        };
        write(&picture, &csv, &self.sheet.sheet()?, to, "--plot")
    }
}

/// The values of the flag `--theme`, each with its purpose.
const THEMES: [(&str, Theme, &str); 4] = [
    ("auto", Theme::Auto, "Light or dark as the reader's system is"),
    ("light", Theme::Light, "For a light page"),
    ("dark", Theme::Dark, "For a dark page"),
    ("paper", Theme::Paper, "Black and grey, for print"),
];

/// Reads the flag `--theme`.
pub(crate) fn theme() -> impl TypedValueParser<Value = Theme> {
    let values = THEMES.map(|(name, _, help)| PossibleValue::new(name).help(help));
    PossibleValuesParser::new(values)
        .map(|given| THEMES.into_iter().find(|(name, ..)| *name == given).map_or(Theme::Auto, |(_, theme, _)| theme))
}

/// The kinds of pictures, by the ends of their names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Svg,
    /// Made of the SVG by a program of the system.
    Made(&'static str),
}

impl Kind {
    fn of(to: &Path) -> Option<Self> {
        let end = to.extension()?.to_str()?.to_ascii_lowercase();
        [("svg", Kind::Svg), ("png", Kind::Made("png")), ("pdf", Kind::Made("pdf"))]
            .into_iter()
            .find_map(|(name, kind)| (name == end).then_some(kind))
    }
}

/// Refuses a file whose name would be that of its own data, or whose data would take the place of another file.
///
/// # Errors
/// Unless the name ends in `.svg`, `.png` or `.pdf`, both files can be made in their folder, the CSV file beside it is not there, or is the
/// data of a picture, and for PNG and PDF rsvg-convert is there.
fn check(to: &Path) -> Result<()> {
    let refuse = |why: &str| Err(Failure::flag("--plot", why, &to.display().to_string()));
    let Some(kind) = Kind::of(to) else { return refuse("must be the name of an .svg, .png or .pdf file") };
    let beside = to.with_extension("csv");
    // A pipe of this name is not opened: it may never be written to.
    if beside.is_file() && File::open(&beside).is_ok_and(|file| !mdr_plot::is_data(file)) {
        return refuse(&format!(
            "the data of the picture would replace {}, which was not written with a picture: choose another name",
            beside.display()
        ));
    }
    [to, &beside].into_iter().try_for_each(|file| files::check("--plot", file))?;
    match kind {
        Kind::Made(_) => converter::check(),
        Kind::Svg => Ok(()),
    }
}

/// Writes the picture to the file `to`, and a CSV file of its data beside it; names in complaints follow the `flag` that asked for
/// it.
///
/// # Errors
/// When a file cannot be written, or not be made of the SVG.
pub(crate) fn write(picture: &Picture, csv: &str, sheet: &Sheet, to: &Path, flag: &str) -> Result<()> {
    let kind = Kind::of(to).unwrap_or(Kind::Svg);
    // Paper and pixels do not follow the reader's screen.
    let theme = if kind != Kind::Svg && sheet.theme == Theme::Auto { Theme::Light } else { sheet.theme };
    let svg = mdr_provenance::svg(&picture.svg_on(&Sheet { theme, ..*sheet })).into_owned();
    match kind {
        Kind::Svg => files::write(flag, to, svg.as_bytes())?,
        Kind::Made(format) => files::write(flag, to, converter::convert(&svg, format)?)?,
    }
    files::write(flag, &to.with_extension("csv"), mdr_provenance::csv(csv))
}
