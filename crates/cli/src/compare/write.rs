//! The pictures of a comparison: SVG with title and scale for the page, PNG of the pixels alone.

use super::rows::{Compared, FLOOR_SHARE};
use super::{Subject, model_name};
use crate::CliError;
use crate::pipeline::input_error;
use std::path::Path;
use stratiform_artifact::{ComparisonPicture, write_atomic};
use stratiform_imaging::compare::flip::{PIXELS_PER_DEGREE, flip};
use stratiform_imaging::compare::{Band, Sampled, relative, signed, significance};
use stratiform_imaging::draw::{Colours, ErrorMap, Scale, picture_svg};
use stratiform_imaging::{Grey, Image, Tone};

/// Writes them all into `dir` and lists them in the order of the page.
///
/// # Errors
/// [`CliError::Input`] if one cannot be written.
pub fn pictures(
    dir: &Path,
    subject: &Subject<'_>,
    compared: &[Compared],
) -> Result<Vec<ComparisonPicture>, CliError> {
    let mut written = Vec::new();
    for one in compared {
        let sheet = Sheet { dir, one, tone: tone(subject, one) };
        if !written.iter().any(|p: &ComparisonPicture| p.kind == "truth" && p.contribution == one.part.name) {
            written.push(sheet.picture("truth", &one.mean)?);
        }
        written.push(sheet.picture("picture", &one.picture)?);
        written.extend(sheet.maps(subject)?);
    }
    Ok(written)
}

/// The scene's exposure; parts, which are dim, are shown at one of their own.
fn tone(subject: &Subject<'_>, one: &Compared) -> Tone {
    let own = Tone { curve: subject.tone.curve, ..Tone::fitting(&one.mean) };
    if one.part.is_all() { subject.tone } else { own }
}

struct Sheet<'a> {
    dir: &'a Path,
    one: &'a Compared,
    tone: Tone,
}

impl Sheet<'_> {
    fn entry(&self, kind: &str) -> ComparisonPicture {
        let model = if kind == "truth" { "" } else { model_name(self.one.model) };
        let stem: Vec<&str> =
            [self.one.part.name.as_str(), model, kind].into_iter().filter(|s| !s.is_empty()).collect();
        ComparisonPicture {
            model: model.to_owned(),
            contribution: self.one.part.name.clone(),
            kind: kind.to_owned(),
            file: format!("{}.svg", stem.join("-")),
        }
    }

    fn write(&self, entry: &ComparisonPicture, svg: &str) -> Result<(), CliError> {
        Ok(write_atomic(&self.dir.join(&entry.file), svg.as_bytes())?)
    }

    fn png(&self, entry: &ComparisonPicture) -> std::path::PathBuf {
        self.dir.join(&entry.file).with_extension("png")
    }

    fn picture(&self, kind: &str, image: &Image) -> Result<ComparisonPicture, CliError> {
        let entry = self.entry(kind);
        let who =
            if kind == "truth" { "Truth".to_owned() } else { format!("Picture, {} model", entry.model) };
        let title = format!("{who} ({} EV)", self.tone.exposure_ev);
        self.write(&entry, &picture_svg(&title, image, &self.tone).map_err(input_error)?)?;
        image.write_png(&self.png(&entry), &self.tone).map_err(input_error)?;
        Ok(entry)
    }

    fn maps(&self, subject: &Subject<'_>) -> Result<Vec<ComparisonPicture>, CliError> {
        let Compared { picture, mean, std_error, .. } = self.one;
        let truth = Sampled { mean, std_error };
        let difference = signed(picture, &truth, Band::Luminance).map_err(input_error)?;
        let label = "luminance, picture - truth, in units of the sun's irradiance / sr";
        let mut maps = vec![self.map(
            "difference",
            ("Signed difference", label),
            &difference,
            Scale::covering(Colours::Diverging, &difference),
        )?];
        if !self.one.part.is_all() {
            return Ok(maps);
        }
        let share = relative(picture, &truth, Band::Luminance, FLOOR_SHARE).map_err(input_error)?;
        let label = "|picture - truth| / truth, luminance";
        maps.push(self.map(
            "relative",
            ("Relative error", label),
            &share,
            Scale { colours: Colours::Sequential, most: 1.0 },
        )?);
        let z = significance(picture, &truth, Band::Luminance, 3.0).map_err(input_error)?.map;
        let label = "(picture - truth) / standard error of the truth";
        maps.push(self.map(
            "z",
            ("Difference over noise", label),
            &z,
            Scale { colours: Colours::Diverging, most: 5.0 },
        )?);
        let seen = flip(picture, mean, &subject.tone, PIXELS_PER_DEGREE).map_err(input_error)?;
        let title = format!("FLIP, mean {:.4}", seen.mean());
        maps.push(self.map(
            "flip",
            (&title, "FLIP: 0 not seen, 1 black for white"),
            &seen,
            Scale::covering(Colours::Sequential, &seen),
        )?);
        Ok(maps)
    }

    fn map(
        &self,
        kind: &str,
        (title, label): (&str, &str),
        values: &Grey,
        scale: Scale,
    ) -> Result<ComparisonPicture, CliError> {
        let entry = self.entry(kind);
        let title = format!("{title}, {} model", entry.model);
        let map = ErrorMap { title: &title, label, values, scale };
        self.write(&entry, &map.to_svg().map_err(input_error)?)?;
        map.write_png(&self.png(&entry)).map_err(input_error)?;
        Ok(entry)
    }
}
