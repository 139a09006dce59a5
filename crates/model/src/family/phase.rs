//! Phase functions over (Θ, r_e): P at equal steps of the angle map, linear in its coordinate and in ln r_e.
//!
//! P itself, not ln P: a mean of two functions of mean 1 has mean 1, and texture filters do the same. Where glory and fogbow
//! stand changes with r_e too, but in a cloud of many sizes they are wider than they move between neighbouring radii.

use super::check_radii;
use crate::{ModelError, Real};
use stratiform_quantities::{DomainError, Range};

/// P that a family may hold.
const PHASE: Range = Range::closed(0.0, 1e12);

/// P at one effective radius.
#[derive(Clone, Debug, PartialEq)]
pub struct PhaseMember {
    /// r_e, µm.
    pub effective_radius_um: f64,
    /// P at equal steps of the angle map's coordinate, from 0 to 1.
    pub values: Vec<f64>,
}

/// A row, ready to be looked up.
#[derive(Clone, Debug, PartialEq)]
struct Row<F> {
    radius: F,
    place: F,
    values: Vec<F>,
}

/// P for every Θ and every r_e between the first and the last.
#[derive(Clone, Debug, PartialEq)]
pub struct PhaseFamily<F> {
    rows: Vec<Row<F>>,
}

impl<F: Real> PhaseFamily<F> {
    /// A family of at least two members with rising radii and equally many values, two at least.
    ///
    /// # Errors
    /// [`ModelError`] if a number is out of domain, radii do not rise, or there are too few.
    pub fn new(members: &[PhaseMember]) -> Result<Self, ModelError> {
        check_radii(&members.iter().map(|member| member.effective_radius_um).collect::<Vec<_>>())?;
        let texels = members[0].values.len().max(2) as f64;
        let row = |member: &PhaseMember| -> Result<Row<F>, ModelError> {
            let count = member.values.len() as f64;
            Range::closed(texels, texels).check("number of values of a phase function", count)?;
            let checked = |p: &f64| PHASE.check("p", *p).map(F::of);
            let values = member.values.iter().map(checked).collect::<Result<_, DomainError>>()?;
            let radius = F::of(member.effective_radius_um);
            Ok(Row { radius, place: radius.ln(), values })
        };
        Ok(Self { rows: members.iter().map(row).collect::<Result<_, _>>()? })
    }

    /// P at `coordinate` of the angle map in a cloud of effective radius `radius` in µm.
    ///
    /// # Errors
    /// [`ModelError::Domain`] for a coordinate outside \[0, 1\] or a radius outside the family's.
    pub fn at(&self, coordinate: F, radius: F) -> Result<F, ModelError> {
        Range::closed(0.0, 1.0).check("coordinate", coordinate.to_f64())?;
        let (first, last) = (&self.rows[0], &self.rows[self.rows.len() - 1]);
        Range::closed(first.radius.to_f64(), last.radius.to_f64())
            .check("effective_radius_um", radius.to_f64())?;
        let i = self.rows[1..self.rows.len() - 1].iter().filter(|row| radius > row.radius).count();
        let (a, b) = (&self.rows[i], &self.rows[i + 1]);
        let weight = (radius.ln() - a.place) / (b.place - a.place);
        let place = coordinate * F::of((a.values.len() - 1) as f64);
        let cell = (place.to_f64() as usize).min(a.values.len() - 2);
        let share = place - F::of(cell as f64);
        let of = |row: &Row<F>| {
            let (left, right) = (row.values[cell], row.values[cell + 1]);
            left + (right - left) * share
        };
        let (from, to) = (of(a), of(b));
        Ok(from + (to - from) * weight)
    }
}
