//! Legendre coefficients per effective radius, as SHDOM's make_mie_table and libRadtran's mie write them.
//!
//! A line of effective radius (or humidity), extinction, albedo and N, marked `Nleg`, stands before the coefficients (2l+1)χ_l,
//! l = 0 … N, on one or more lines; libRadtran follows with the other elements of the phase matrix, which are not read.

use super::{AngleUnit, Choice, Fault, Layout, RawTable};
use stratiform_optics::phase::PhaseTable;

/// The mark of the line before the coefficients.
const MARK: &str = "nleg";

/// Highest degree of a listing.
const MOST: usize = 100_000;

/// One block of a listing.
struct Block {
    line: u64,
    radius: f64,
    last: usize,
}

/// Whether `text` is such a listing.
pub(super) fn is_listing(text: &str) -> bool {
    text.lines().any(|line| block(0, line).is_some())
}

/// The line before the coefficients: four numbers and the mark.
fn block(line: u64, text: &str) -> Option<Block> {
    let lower = text.to_lowercase();
    let fields: Vec<&str> = text.split_whitespace().take(4).collect();
    let [radius, _, _, last] = fields[..] else { return None };
    let (radius, last) = (radius.parse().ok()?, last.parse().ok()?);
    lower.contains(MARK).then_some(Block { line, radius, last })
}

/// Sums the coefficients of the effective radius that is meant.
pub(super) fn assemble(text: &str, choice: &Choice) -> Result<RawTable, Fault> {
    if choice.column.is_some() || choice.wavelength.is_some() {
        return Err(Fault::whole("Legendre coefficients have neither columns nor wavelengths to choose"));
    }
    let blocks: Vec<Block> =
        text.lines().enumerate().filter_map(|(i, line)| block(i as u64 + 1, line)).collect();
    let meant = match (choice.effective_radius, &blocks[..]) {
        (None, [only]) => only,
        (radius, _) => blocks.iter().find(|block| Some(block.radius) == radius).ok_or_else(|| {
            let radii: Vec<String> = blocks.iter().take(8).map(|block| block.radius.to_string()).collect();
            Fault::whole(match radius {
                Some(radius) => format!("no effective radius {radius}; there are {}", radii.join(", ")),
                None => {
                    format!("several effective radii ({}): one of them must be named", radii.join(", "))
                }
            })
        })?,
    };
    let moments = moments(text, meant)?;
    let table =
        PhaseTable::from_moments(&moments).map_err(|error| Fault::at(meant.line, error.to_string()))?;
    Ok(RawTable {
        layout: Layout::Legendre,
        unit: AngleUnit::Degrees,
        stated_unit: None,
        value_name: format!("{} Legendre coefficients", moments.len()),
        left_out: Vec::new(),
        theta_deg: table.theta_deg().to_vec(),
        value: table.values().to_vec(),
    })
}

/// χ_l of a block.
fn moments(text: &str, block: &Block) -> Result<Vec<f64>, Fault> {
    if block.last > MOST {
        return Err(Fault::at(block.line, format!("Nleg = {} is above {MOST}", block.last)));
    }
    let count = block.last + 1;
    let mut moments = Vec::with_capacity(count);
    for (index, line) in text.lines().enumerate().skip(block.line as usize) {
        let at = index as u64 + 1;
        for field in line.split_whitespace().take(count - moments.len()) {
            let coefficient: f64 =
                field.parse().map_err(|_| Fault::at(at, format!("`{field}` is not a number")))?;
            moments.push(coefficient / (2 * moments.len() + 1) as f64);
        }
        if moments.len() == count {
            return Ok(moments);
        }
    }
    Err(Fault::at(block.line, format!("{} coefficients follow, not {count}", moments.len())))
}
