//! From a picture to its SVG: one file for screens, light or dark, and for print.

mod frame;
mod layout;
mod room;
mod style;
mod words;

pub use layout::Sheet;

use crate::chart::{Picture, Theme};
use crate::markup::{SIZE, escaped};
use frame::Frame;
use layout::{BELOW, Layout, MARGIN};

/// Height of a line of text.
const LINE: f64 = 16.0;

/// Between a point's mark and its label.
const GAP: f64 = 4.0;

/// The width of a page in pixels below which panels stand below each other.
const NARROW: f64 = 700.0;

impl Picture {
    /// The SVG, well-formed XML whose sizes are in points, with the title and the description of the picture in it.
    ///
    /// It is a function of the picture alone: the same bytes on every run. It needs no font of its own. In a page narrower than
    /// 700 px its panels stand below each other, and it is never wider than the page.
    pub fn svg(&self) -> String {
        self.svg_on(&Sheet::default())
    }

    /// The SVG in fixed colours, for print, or for a page that is light or dark whatever the system of the reader is. See
    /// [`svg`](Picture::svg).
    pub fn svg_in(&self, theme: Theme) -> String {
        self.svg_on(&Sheet { theme, ..Sheet::default() })
    }

    /// The SVG of a given width and size of text. See [`svg`](Picture::svg).
    ///
    /// ```
    /// use mdr_plot::{Axis, Panel, Picture, Sheet, Unit};
    /// let panel = |heading: &str| Panel::new(heading, Axis::linear("x", Unit::One, 0.0, 1.0), Axis::linear("y", Unit::One, 0.0, 1.0));
    /// let picture = Picture { title: "two".into(), description: String::new(), panels: vec![panel("(a)"), panel("(b)")] };
    /// // A column of a journal, 85 mm, with text of 8 points: the panels stand below each other.
    /// let column = Sheet { width: Some(85.0 / 25.4 * 72.0), font: 8.0, ..Sheet::default() };
    /// assert!(picture.svg_on(&column).contains("width=\"240.9pt\""));
    /// ```
    pub fn svg_on(&self, sheet: &Sheet) -> String {
        let layout = Layout::new(self, sheet);
        let (mut top, mut body, mut heads) = (MARGIN, String::new(), Vec::new());
        for row in self.panels.chunks(layout.columns) {
            let head = row.iter().map(|panel| layout.head(panel)).fold(0.0, f64::max);
            for (column, panel) in row.iter().enumerate() {
                let corner = [column as f64 * layout.cell() + layout.left, top + head];
                let (class, [x, y]) = (heads.len(), corner);
                body.push_str(&format!("<g class=\"panel p{class}\" transform=\"translate({x:.0} {y:.0})\">\n"));
                let mut frame = Frame { panel, size: layout.frame, left: layout.left, svg: &mut body };
                frame.head(head);
                frame.draw();
                body.push_str("</g>\n");
                heads.push(head);
            }
            top += head + layout.frame[1] + BELOW;
        }
        let [title, description] = [&self.title, &self.description].map(|text| escaped(text));
        let (width, height) = (layout.columns as f64 * layout.cell(), top);
        let points = |length: f64| {
            let length = format!("{:.1}", length * layout.unit);
            length.strip_suffix(".0").map_or(length.clone(), str::to_owned)
        };
        let name = format!("m{:08x}", hash(&body));
        let stacked = match sheet.width {
            Some(_) => String::new(),
            None => stacked(&name, &layout, &heads, [width, height]),
        };
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"mdr {name}\" width=\"{}pt\" height=\"{}pt\" viewBox=\"0 0 {width:.0} {height:.0}\" \
             preserveAspectRatio=\"xMinYMin meet\" role=\"img\" font-family=\"Inter, Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif\" \
             font-size=\"{SIZE}\" xml:space=\"preserve\">\n<title>{title}</title>\n<desc>{description}</desc>\n\
             <style>{}@media screen{{.mdr{{max-width:100%;height:auto}}}}{stacked}</style>\n\
             <rect class=\"page\" width=\"100%\" height=\"100%\"/>\n<g class=\"all\">\n{body}</g>\n</svg>\n",
            points(width),
            points(height),
            style::sheet(sheet.theme)
        )
    }
}

/// The rules by which the panels of a picture stand below each other in a narrow page. An image of the proportions of the sheet
/// has no room for that and stays as it is.
fn stacked(name: &str, layout: &Layout, heads: &[f64], [width, height]: [f64; 2]) -> String {
    if layout.columns == 1 {
        return String::new();
    }
    let (cell, mut top, mut rules) = (layout.cell(), MARGIN, String::new());
    for (panel, head) in heads.iter().enumerate() {
        top += head;
        rules.push_str(&format!(".{name} .p{panel}{{transform:translate({:.0}px,{top:.0}px)}}", layout.left));
        top += layout.frame[1] + BELOW;
    }
    let scale = width / cell;
    format!(
        "@media screen and (max-width:{NARROW}px) and (max-aspect-ratio:{:.0}/{:.0}){{.{name}{{width:100%;aspect-ratio:{cell:.0}/{top:.0}}}\
         .{name} .page{{width:{width:.0}px;height:{:.0}px}}.{name} .all{{transform:scale({scale:.4})}}{rules}}}",
        90.0 * width,
        100.0 * height,
        scale * top,
    )
}

/// Tells pictures in one page apart (FNV-1a).
fn hash(text: &str) -> u32 {
    text.bytes().fold(0x811c_9dc5, |hash, byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193))
}
