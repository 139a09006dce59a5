//! The parameters over θ_l: published, refitted for the paper's cloud, or of a family of droplet sizes.
//!
//! From the family the ten rows at r_e are worked out once for a cloud, by its own interpolation (`stratiform_model::family`); between
//! rows it interpolates as any table does. κ_S in the table's unit of thickness. Errors: [`MethodError`] if a built-in table is damaged,
//! or the family is asked for droplets without r_e.

use crate::{Cloud, MethodError};
use stratiform_artifact::{FamilyDocument, ParameterRow, ParameterTable, ParametersDocument, PublishedRow};
use stratiform_model::Values;
use stratiform_model::family::{Member, ParameterFamily, RadiusCoordinate};
use stratiform_model::table::{Angle, cos_degrees};
use stratiform_quantities::Range;

pub(super) const APPENDIX_B: &str =
    include_str!("../../../../../reference-data/bouthors-2006/appendix-b.csv");
const REFITTED: &str = include_str!("../../../../../fit-configs/appendix-b/accepted/parameters.json");
const FAMILY: &str = include_str!("../../../../../fit-configs/family/accepted/family.json");

/// r_e of the family's members, µm.
const FAMILY_RADIUS_UM: Range = Range::closed(4.0, 20.0);
/// β of appendix B.
const BETA: f64 = 0.9961;
/// N0 π r_e² of the paper's cloud, 1/m.
pub(super) const KAPPA_PER_M: f64 = 300e6 * std::f64::consts::PI * 49e-12;

/// Which parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Table {
    Published,
    Refitted,
    Family,
}

impl Table {
    /// r_e it was made for, µm.
    pub(super) fn radius_um(self) -> Range {
        match self {
            Self::Published | Self::Refitted => Range::closed(7.0, 7.0),
            Self::Family => FAMILY_RADIUS_UM,
        }
    }

    /// Its rows for `cloud`, whose κ_S per τ is `kept`, and its unit of thickness per τ.
    pub(super) fn angles(self, cloud: &Cloud, kept: f64) -> Result<(Vec<Angle>, f64), MethodError> {
        Ok(match self {
            Self::Published => (published(kept * KAPPA_PER_M)?, 1.0 / KAPPA_PER_M),
            Self::Refitted => (refitted()?, 1.0),
            Self::Family => (of_family(cloud.r_eff_um().unwrap_or(f64::NAN))?, 1.0),
        })
    }
}

pub(super) fn damaged(error: &dyn std::fmt::Display) -> MethodError {
    MethodError::Failed { method: "bouthors".to_owned(), reason: format!("built-in table: {error}") }
}

/// Appendix B with κ_S per metre.
pub(super) fn published(kappa_s_per_m: f64) -> Result<Vec<Angle>, MethodError> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(APPENDIX_B.as_bytes());
    let angle = |row: Result<PublishedRow, csv::Error>| {
        let PublishedRow { theta_l_deg, b, c_per_m, kappa_c_per_m, t, r } = row.map_err(|e| damaged(&e))?;
        let (c, kappa_c) = (c_per_m, kappa_c_per_m);
        let values = Values { beta: BETA, b, c, kappa_c, t, r, kappa_s: kappa_s_per_m };
        Ok(Angle { theta_l_deg, values })
    };
    reader.deserialize().map(angle).collect()
}

fn values(table: &ParameterTable, row: &ParameterRow) -> Values<f64> {
    let (b, c, kappa_c) = (row.b.emitted, row.c.emitted, row.kappa_c.emitted);
    let (t, r, beta, kappa_s) = (row.t.emitted, row.r.emitted, table.beta.value, table.kappa_s);
    Values { beta, b, c, kappa_c, t, r, kappa_s }
}

fn angles(table: &ParameterTable) -> Vec<Angle> {
    let angle = |row: &ParameterRow| {
        row.theta_l_deg.degrees().map(|theta_l_deg| Angle { theta_l_deg, values: values(table, row) })
    };
    table.rows.iter().filter_map(angle).collect()
}

/// The accepted fit, per τ.
pub(super) fn refitted() -> Result<Vec<Angle>, MethodError> {
    let document: ParametersDocument = serde_json::from_str(REFITTED).map_err(|e| damaged(&e))?;
    Ok(angles(&document.optical))
}

/// The accepted family at r_e, per τ.
pub(super) fn of_family(radius_um: f64) -> Result<Vec<Angle>, MethodError> {
    FAMILY_RADIUS_UM.check("r_eff_um", radius_um)?;
    let document: FamilyDocument = serde_json::from_str(FAMILY).map_err(|e| damaged(&e))?;
    let coordinate = RadiusCoordinate::ALL.into_iter().find(|one| one.to_string() == document.coordinate);
    let coordinate = coordinate.ok_or_else(|| damaged(&document.coordinate))?;
    let members = document.members.iter().map(|one| {
        let table = &one.parameters.optical;
        let diffuse = table.rows.iter().find(|row| row.theta_l_deg.degrees().is_none());
        let diffuse = values(table, diffuse.ok_or_else(|| damaged(&"no row of diffuse light"))?);
        Ok(Member { effective_radius_um: one.effective_radius_um, angles: angles(table), diffuse })
    });
    let members = members.collect::<Result<Vec<_>, MethodError>>()?;
    let family = ParameterFamily::<f64>::new(coordinate, &members).map_err(|e| damaged(&e))?;
    let row = |angle: &Angle| {
        let there = family.at(cos_degrees(angle.theta_l_deg), radius_um).map_err(|e| damaged(&e))?;
        // r of two members that are both 1 comes back rounded.
        let values = Values { r: there.values().r.min(1.0), ..*there.values() };
        Ok(Angle { theta_l_deg: angle.theta_l_deg, values })
    };
    members[0].angles.iter().map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use stratiform_model::table::ParameterGrid;

    #[test]
    fn the_built_in_tables_are_the_committed_ones() {
        assert_eq!(APPENDIX_B, stratiform_reference_data::read("bouthors-2006", "appendix-b.csv").unwrap());
        assert_eq!((published(0.02).unwrap().len(), refitted().unwrap().len()), (10, 10));
    }

    /// Both fits of 7 µm saw the same cloud; between members the table lies between theirs; outside it is refused.
    #[test]
    fn the_family_has_a_table_for_every_radius() {
        for (family, own) in of_family(7.0).unwrap().iter().zip(refitted().unwrap()) {
            let (family, own) = (family.values, own.values);
            assert!(
                (family.t / own.t - 1.0).abs() < 0.02 && (family.kappa_s / own.kappa_s - 1.0).abs() < 1e-3
            );
        }
        let [small, between, large] =
            [10.0, 12.0, 14.0].map(|radius| of_family(radius).unwrap()[3].values.kappa_s);
        assert!((small - between) * (between - large) > 0.0, "{small} {between} {large}");
        for radius in (0..=40).map(|i| 4.0 + 0.4 * f64::from(i)).filter(|radius| *radius <= 20.0) {
            ParameterGrid::<f64>::new(&of_family(radius).unwrap()).unwrap();
        }
        for radius in [3.99, 20.01, f64::NAN] {
            assert!(matches!(of_family(radius), Err(MethodError::Domain(_))), "{radius}");
        }
    }
}
