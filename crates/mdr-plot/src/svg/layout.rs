//! How many panels stand beside each other, and how large they are.

use super::LINE;
use super::frame::NUMBERS;
use crate::chart::{Panel, Picture, Theme};
use crate::markup::{SIZE, lines, width};

/// Width and height of the frame of a panel: alone, one of two or more, one of three.
const ALONE: [f64; 2] = [420.0, 260.0];
const PAIRED: [f64; 2] = [320.0, 220.0];
const ONE_OF_THREE: [f64; 2] = [250.0, 210.0];

/// The height of a row, where an axis has names.
const ROW: f64 = 20.0;

/// Room around a frame: for the numbers of the ticks, the next panel, the name of the horizontal axis.
const LEFT: f64 = 54.0;
const RIGHT: f64 = 24.0;
pub(super) const BELOW: f64 = 46.0;
pub(super) const MARGIN: f64 = 14.0;

/// The narrowest frame of several beside each other, and of one alone.
const NARROWEST_BESIDE: f64 = 200.0;
const NARROWEST: f64 = 110.0;

/// What a picture is drawn on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sheet {
    /// Its colours.
    pub theme: Theme,
    /// Its width in points, of which 72 are an inch. Panels that have no room beside each other stand below each other. `None`:
    /// as wide as its panels need, and as the page allows.
    pub width: Option<f64>,
    /// The size of its text in points, above 0.
    pub font: f64,
}

impl Default for Sheet {
    fn default() -> Self {
        Sheet { theme: Theme::Auto, width: None, font: SIZE }
    }
}

impl Sheet {
    /// The narrowest sheet with room for one panel at this size of text, in points.
    pub fn narrowest(font: f64) -> f64 {
        (LEFT + RIGHT + NARROWEST) * font / SIZE
    }
}

/// The parts of a sheet, in units of which the text is [`SIZE`] high.
pub(super) struct Layout {
    /// The points of a unit.
    pub(super) unit: f64,
    pub(super) columns: usize,
    /// Width and height of each frame.
    pub(super) frame: [f64; 2],
    /// What stands to the left of a frame.
    pub(super) left: f64,
}

impl Layout {
    pub(super) fn new(picture: &Picture, sheet: &Sheet) -> Self {
        let unit = sheet.font / SIZE;
        let names = picture.panels.iter().flat_map(|panel| panel.y.names());
        let left = names.map(|name| width(name) + NUMBERS + 6.0).fold(LEFT, f64::max);
        // Three panels fill a row; of other numbers two do.
        let mut columns = if picture.panels.len() == 3 { 3 } else { picture.panels.len().clamp(1, 2) };
        let mut frame = [ALONE, PAIRED, ONE_OF_THREE][columns - 1];
        if let Some(width) = sheet.width {
            let room = |columns: usize| width / unit / columns as f64 - left - RIGHT;
            while columns > 1 && room(columns) < NARROWEST_BESIDE {
                columns -= 1;
            }
            let [natural, height] = [ALONE, PAIRED, ONE_OF_THREE][columns - 1];
            let room = room(columns).max(NARROWEST);
            frame = [room, (height * room / natural).clamp(0.8 * room.min(160.0), room)];
        }
        let rows = picture.panels.iter().map(|panel| panel.y.names().len()).max().unwrap_or_default();
        if rows > 0 {
            frame[1] = ROW * rows as f64;
        }
        Layout { unit, columns, frame, left }
    }

    /// The width of a panel with what stands beside it.
    pub(super) fn cell(&self) -> f64 {
        self.left + self.frame[0] + RIGHT
    }

    /// The height of what stands above the frame of a panel: heading, notes, the name of the vertical axis.
    pub(super) fn head(&self, panel: &Panel) -> f64 {
        let above: usize = above(panel, self.frame[0]).iter().map(|(_, lines)| lines.len()).sum();
        LINE * (above as f64 + 1.0) + 4.0
    }
}

/// The heading and the notes of a panel in lines, each with its class.
pub(super) fn above(panel: &Panel, room: f64) -> Vec<(&'static str, Vec<String>)> {
    let heading = ("heading", lines(&panel.heading, room));
    let notes =
        panel.layers.iter().filter(|layer| layer.points.is_empty()).filter_map(|layer| layer.meaning.as_deref());
    [heading].into_iter().chain(notes.map(|note| ("note", lines(note, room)))).collect()
}
