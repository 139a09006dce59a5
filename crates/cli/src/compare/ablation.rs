//! What each part of a picture costs, and what its absence does to the error.

use super::{Draw, FLOOR_SHARE, Subject, Truth};
use crate::CliError;
use crate::pipeline::input_error;
use stratiform_artifact::AblationRow;
use stratiform_imaging::Image;
use stratiform_imaging::compare::flip::{PIXELS_PER_DEGREE, flip};
use stratiform_imaging::compare::{Band, Sampled, errors};
use stratiform_render::{Depth, Model, Normals, Radiosity, Settings};
use stratiform_world::Contribution;

/// Frames of which a time is the median.
const FRAMES: usize = 5;

/// The settings, their changes one by one, and a row for each.
///
/// # Errors
/// [`CliError::Input`] for what cannot be drawn.
pub fn ablation(
    subject: &Subject<'_>,
    truth: &Truth,
    draw: &mut Draw,
    watch: impl Fn(&str),
) -> Result<Vec<AblationRow>, CliError> {
    let whole = draw.picture(&subject.settings)?;
    let mut rows: Vec<AblationRow> = Vec::new();
    for (change, settings) in changes(&subject.settings) {
        watch(&change);
        let picture = draw.picture(&settings)?;
        let Measured { error, noise, difference, flip } = measured(subject, truth, &picture, &whole)?;
        let times = draw.times(&settings, FRAMES)?;
        let ms = (!times.is_empty()).then(|| times.iter().map(|(_, ms)| ms).sum());
        let first = rows.first();
        let before = (first.map_or(error, |row| row.error), first.map_or(ms, |row| row.ms));
        rows.push(AblationRow {
            scene: subject.name.to_owned(),
            change,
            error,
            noise,
            rise: error - before.0,
            difference,
            flip,
            width: draw.size().0 as u64,
            height: draw.size().1 as u64,
            ms,
            ms_saved: before.1.zip(ms).map(|(before, ms)| before - ms),
        });
    }
    Ok(rows)
}

/// Noise-corrected rms error, the truth's noise and the rms difference from the unchanged picture, all over the truth's mean; mean of FLIP.
struct Measured {
    error: f64,
    noise: f64,
    difference: f64,
    flip: f64,
}

fn measured(
    subject: &Subject<'_>,
    truth: &Truth,
    picture: &Image,
    whole: &Image,
) -> Result<Measured, CliError> {
    let sampled = Sampled { mean: &truth.mean, std_error: &truth.std_error };
    let found = errors(picture, &sampled, Band::Luminance, FLOOR_SHARE).map_err(input_error)?;
    let exact = truth.mean.map(|_| [0.0; 3]);
    let other = Sampled { mean: whole, std_error: &exact };
    let from_whole = errors(picture, &other, Band::Luminance, FLOOR_SHARE).map_err(input_error)?;
    let seen = flip(picture, &truth.mean, &subject.tone, PIXELS_PER_DEGREE).map_err(input_error)?;
    let over = |value: f64| if found.mean_truth > 0.0 { value / found.mean_truth } else { 0.0 };
    Ok(Measured {
        error: over(found.excess_rms),
        noise: over(found.noise),
        difference: over(from_whole.rms),
        flip: seen.mean(),
    })
}

/// Nothing, then one thing at a time.
fn changes(settings: &Settings) -> Vec<(String, Settings)> {
    let mut changes = vec![(AblationRow::NOTHING.to_owned(), *settings)];
    for contribution in Contribution::ALL {
        // The fitted model has no light of two events by itself.
        if settings.model == Model::Angular || contribution != Contribution::Double {
            let contributions = settings.contributions.without(contribution);
            changes
                .push((format!("without {}", contribution.name()), Settings { contributions, ..*settings }));
        }
    }
    for passes in [0, 1, 2] {
        let radiosity = Radiosity { passes: Some(passes), ..settings.radiosity };
        changes.push((format!("radiosity passes {passes}"), Settings { radiosity, ..*settings }));
    }
    let (model, name) = match settings.model {
        Model::Angular => (Model::Fitted, "fitted model"),
        Model::Fitted => (Model::Angular, "angular model"),
    };
    changes.push((name.to_owned(), Settings { model, ..*settings }));
    changes.push(("vertical normals".to_owned(), Settings { normals: Normals::Vertical, ..*settings }));
    changes.push(("thickness along the chord".to_owned(), Settings { depth: Depth::Chord, ..*settings }));
    changes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changes_change_one_thing_each() {
        let changes = changes(&Settings::default());
        assert_eq!(changes[0], ("nothing".to_owned(), Settings::default()));
        for (i, (name, settings)) in changes.iter().enumerate().skip(1) {
            assert_ne!(*settings, Settings::default(), "{name}");
            assert!(changes[..i].iter().all(|(other, _)| other != name), "{name} twice");
        }
        assert!(changes.iter().any(|(name, _)| name == "without multiple"));
        assert!(changes.iter().all(|(name, _)| name != "without double"), "the fitted model cannot");
    }
}
