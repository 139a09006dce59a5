//! From what was typed and what the scene says to what the renderer is told.

use crate::CliError;
use crate::args::{RadianceModel, RenderArgs, SlabDepth, SlabNormals};
use stratiform_render::{Contributions, Depth, Model, Normals, Radiosity, RingRule, Settings};
use stratiform_scene::{Rings, Scene};
use stratiform_world::Contribution;

/// The settings.
///
/// # Errors
/// [`CliError::Input`] for a contribution that does not exist.
pub fn settings(args: &RenderArgs, scene: &Scene) -> Result<Settings, CliError> {
    Ok(Settings {
        model: match args.model {
            RadianceModel::Angular => Model::Angular,
            RadianceModel::Fitted => Model::Fitted,
        },
        contributions: contributions(&args.only, &args.without)?,
        depth: match args.depth {
            SlabDepth::Local => Depth::Local,
            SlabDepth::Chord => Depth::Chord,
        },
        normals: match args.normals {
            SlabNormals::Local => Normals::Local,
            SlabNormals::Vertical => Normals::Vertical,
        },
        ..said(scene)
    })
}

/// What the scene says; the rest as usual.
pub fn said(scene: &Scene) -> Settings {
    let usual = Settings::default();
    let said = &scene.radiosity;
    let rings = match said.rings {
        Rings::AsPrinted => RingRule::AsPrinted,
        Rings::WiderSquares => RingRule::WiderSquares,
        Rings::SquareWeights => RingRule::SquareWeights,
        Rings::Exact => RingRule::Exact,
        Rings::LeastSquares => RingRule::LeastSquares,
    };
    let radiosity =
        Radiosity { side: said.side, passes: said.passes, error: said.error, rings, ..usual.radiosity };
    Settings { radiosity, ..usual }
}

/// Those named by `only`, or all but those named by `without`.
fn contributions(only: &[String], without: &[String]) -> Result<Contributions, CliError> {
    if only.is_empty() {
        let less = |set: Contributions, name: &String| Ok(set.without(named(name)?));
        return without.iter().try_fold(Contributions::all(), less);
    }
    only.iter().try_fold(Contributions::none(), |set, name| Ok(set.with(named(name)?)))
}

fn named(name: &str) -> Result<Contribution, CliError> {
    Contribution::ALL.into_iter().find(|contribution| contribution.name() == name).ok_or_else(|| {
        let known = Contribution::ALL.map(Contribution::name).join(", ");
        CliError::Input(format!("no contribution is called `{name}`; there are {known}"))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contributions_are_named_or_left_out() {
        let words = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect::<Vec<_>>();
        let only = contributions(&words(&["halo", "sky"]), &[]).unwrap();
        let without = contributions(&[], &words(&["halo", "sky"])).unwrap();
        assert_eq!(only.bits() & without.bits(), 0);
        assert_eq!(only.bits() | without.bits(), Contributions::all().bits());
        assert!(contributions(&words(&["glory"]), &[]).is_err());
    }
}
