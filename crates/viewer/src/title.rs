//! What the window's title says.

use crate::state::State;
use stratiform_render::Model;
use stratiform_world::Contribution;

/// Scene, sun, time, exposure, model, and what is left out; then the note.
pub fn title(name: &str, state: &State, note: &str) -> String {
    let model = match state.settings.model {
        Model::Angular => "angular",
        Model::Fitted => "fitted",
    };
    let time = if state.running { format!("x{}", state.rate) } else { "paused".to_owned() };
    let less: String = Contribution::ALL
        .into_iter()
        .filter(|contribution| !state.settings.contributions.has(*contribution))
        .map(|contribution| format!(", no {}", contribution.name()))
        .collect();
    let note = if note.is_empty() { String::new() } else { format!(" | {note}") };
    format!(
        "{name} | sun {:.1}° from zenith at {:.0}° | {:.0} s {time} | {:+.2} EV | {model}{less}{note}",
        state.sun_theta_deg, state.sun_azimuth_deg, state.moment_s, state.exposure_ev
    )
}
