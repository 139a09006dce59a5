//! The parts of a picture that are compared.

use super::Truth;
use crate::CliError;
use crate::pipeline::input_error;
use stratiform_imaging::Image;
use stratiform_render::{Contributions, Model};
use stratiform_world::Contribution;

/// The whole, or contributions that a model can draw apart from the others.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// `all`, or names joined by `+`.
    pub name: String,
    /// Empty for the whole.
    of: Vec<Contribution>,
}

impl Part {
    /// The whole picture.
    pub fn all() -> Self {
        Self { name: "all".to_owned(), of: Vec::new() }
    }

    fn joined(of: &[Contribution]) -> Self {
        let names: Vec<_> = of.iter().map(|contribution| contribution.name()).collect();
        Self { name: names.join("+"), of: of.to_vec() }
    }

    /// The whole and every part of `model`. The fitted one has the light of two events in that of more.
    pub fn of_model(model: Model) -> Vec<Self> {
        let lone = |c: &Contribution| match model {
            Model::Angular => true,
            Model::Fitted => !matches!(c, Contribution::Double | Contribution::Multiple),
        };
        let mut parts = vec![Self::all()];
        parts.extend(Contribution::ALL.iter().filter(|c| lone(c)).map(|c| Self::joined(&[*c])));
        if model == Model::Fitted {
            parts.push(Self::joined(&[Contribution::Double, Contribution::Multiple]));
        }
        parts
    }

    /// Whether it is the whole.
    pub fn is_all(&self) -> bool {
        self.of.is_empty()
    }

    /// What the renderer draws of it.
    pub fn contributions(&self) -> Contributions {
        if self.is_all() {
            return Contributions::all();
        }
        self.of.iter().copied().fold(Contributions::none(), Contributions::with)
    }

    /// Its mean and standard error in the truth. Contributions of one path err together: their standard errors are added, which is the most
    /// that it can be.
    ///
    /// # Errors
    /// [`CliError::Input`] if the truth lacks one.
    pub fn truth(&self, truth: &Truth) -> Result<(Image, Image), CliError> {
        if self.is_all() {
            return Ok((truth.mean.clone(), truth.std_error.clone()));
        }
        let mut sum: Option<(Image, Image)> = None;
        for contribution in &self.of {
            let (mean, error) = truth.part(*contribution)?;
            let add = |a: [f32; 3], b: [f32; 3]| std::array::from_fn(|c| a[c] + b[c]);
            sum = Some(match sum {
                None => (mean.clone(), error.clone()),
                Some((m, e)) => {
                    (m.zip(mean, add).map_err(input_error)?, e.zip(error, add).map_err(input_error)?)
                }
            });
        }
        sum.ok_or_else(|| CliError::Input(format!("no contribution in `{}`", self.name)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_cover_the_picture_once() {
        for model in [Model::Angular, Model::Fitted] {
            let parts = Part::of_model(model);
            let sets: Vec<u32> = parts[1..].iter().map(|part| part.contributions().bits()).collect();
            assert_eq!(sets.iter().fold(0, |all, bits| all | bits), Contributions::all().bits());
            assert_eq!(sets.iter().map(|bits| bits.count_ones()).sum::<u32>(), 7);
            assert_eq!(parts[0].contributions(), Contributions::all());
        }
        assert_eq!(
            Part::of_model(Model::Fitted).last().map(|part| part.name.as_str()),
            Some("double+multiple")
        );
    }
}
