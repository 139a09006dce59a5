//! What the scene says to tracer and renderer.

use crate::args::ComparedModels;
use crate::commands::render::said;
use stratiform_render::{Model, Settings};
use stratiform_scene::Scene;

/// As the scene says, by the first of the models.
pub fn settings(scene: &Scene, models: &[Model]) -> Settings {
    let usual = said(scene);
    Settings { model: models.first().copied().unwrap_or(usual.model), ..usual }
}

/// The models in their order.
pub fn models(asked: ComparedModels) -> &'static [Model] {
    match asked {
        ComparedModels::Angular => &[Model::Angular],
        ComparedModels::Fitted => &[Model::Fitted],
        ComparedModels::Both => &[Model::Fitted, Model::Angular],
    }
}
