//! Truths that earlier data hold: a new method needs no new solution.

use super::truth::Truth;
use std::collections::HashMap;
use stratiform_artifact::{ErrorData, ErrorRow, ErrorTable};

/// Truths by where they are.
#[derive(Default)]
pub(super) struct Known {
    errors: HashMap<String, Truth>,
    colour: Vec<ErrorRow>,
}

impl Known {
    /// Of data that were made before.
    pub(super) fn of(data: &ErrorData) -> Self {
        let ErrorTable { rows, .. } = &data.errors;
        let order = |row: &ErrorRow, place: usize| {
            row.values.get(place).copied().flatten().map_or(0.0, |share| f64::from(share) / 1000.0)
        };
        let truth = |row: &ErrorRow| row.truth.map(|total| (total, [order(row, 0), order(row, 1)]));
        Self {
            errors: rows.iter().map(|row| (place(row), truth(row))).collect(),
            colour: data.colour.rows.clone(),
        }
    }

    /// The truths of all `rows`; `None` if one of them is new.
    pub(super) fn truths(&self, rows: &[ErrorRow]) -> Option<Vec<Truth>> {
        rows.iter().map(|row| self.errors.get(&place(row)).copied()).collect()
    }

    /// Rows of colour at that radius; `None` if there are none.
    pub(super) fn hues(&self, radius: f64) -> Option<Vec<ErrorRow>> {
        let rows: Vec<ErrorRow> =
            self.colour.iter().filter(|row| row.effective_radius_um == radius).cloned().collect();
        (!rows.is_empty()).then_some(rows)
    }
}

fn place(row: &ErrorRow) -> String {
    format!(
        "{:?} {} {} {} {} {} {} {:?}",
        row.block,
        row.effective_radius_um,
        row.tau,
        row.theta_l_deg,
        row.theta_v_deg,
        row.phi_deg,
        row.scattering_deg,
        row.side
    )
}
