//! A fit-config that emits what is advised.

use std::path::Path;
use stratiform_advise::{Advice, Channels};
use stratiform_scene::{Interval, Scene};

/// N0 where the scene does not say; it turns thickness into metres and back.
const NUMBER_PER_CM3: f64 = 300.0;

/// Bounds as those of the paper's cloud.
const CHECK: &str = "[check.model]\nup_to_deg = 80.0\nparameters_relative = 0.005\nt_ms = 0.015\nt_1 = 0.025\nt_2 = 0.045\nr_1 = 0.015\n\
                     r_2 = 0.015\n";

/// The text.
pub fn text(advice: &Advice, scene: &Scene, tau: Interval, path: &Path) -> String {
    let radius = radius(advice, scene);
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let number = scene.droplets.number_density_per_cm3.unwrap_or(NUMBER_PER_CM3);
    let kappa = 1e-6 * number * std::f64::consts::PI * radius * radius;
    let waves = wavelengths(advice, scene);
    let middle = waves[waves.len() / 2];
    let omega = scene.droplets.single_scattering_albedo;
    let omega =
        omega.map_or(String::new(), |omega| format!("single_scattering_albedo = {:?}\n", omega.get()));
    format!(
        "{}schema = \"stratiform/config/1\"\ntitle = {:?}\n\n[optics]\nwavelengths_um = {waves:?}\nrefractive_index = \
         \"hale-querry-1973\"\ntheta_f_deg = {:?}\nnumber_density_per_cm3 = {number:?}\n\n[optics.droplets]\ndistribution = \
         \"modified-gamma\"\neffective_radius_um = {radius:?}\ngamma = {:?}\n\n[transport]\nwavelength_um = {middle:?}\n\
         extinction_convention = \"paper\"\n{omega}totals_medium = \"full\"\norders_medium = \"modified\"\nsource = \"solve\"\n\n\
         [fit]\ntheta_l_deg = {:?}\nthickness_m = {{ min = {:?}, max = {:?}, count = 20 }}\n\n{}[codegen]\naccepted = {:?}\n\
         output = {:?}\n\n[check]\ntolerance = 1e-4\nfalse_alarm_rate = 1e-5\n\n{CHECK}",
        comment(advice, &stem),
        advice.title,
        scene.droplets.theta_f_deg,
        scene.droplets.gamma(),
        suns(advice),
        tau.min / kappa,
        tau.max / kappa,
        radiance(advice),
        format!("{stem}-accepted"),
        format!("{stem}-generated"),
    )
}

/// The section that fits the radiance model, where that is what is emitted; its thicknesses are those of the paper's cloud.
fn radiance(advice: &Advice) -> &'static str {
    match &advice.emitted {
        Some(emitted) if emitted.library == "stratiform_shade" => {
            "[radiance]\ntau_min = 0.1\ntau_max = 300.0\ntau_count = 12\nsuns = 24\nviews = 14\n\n"
        }
        _ => "",
    }
}

/// The droplets of the config: in the middle of those that the method needs tables of.
fn radius(advice: &Advice, scene: &Scene) -> f64 {
    let radii = &advice.phase_radii_um;
    let range = scene.droplets.effective_radius_um;
    radii.get(radii.len() / 2).copied().unwrap_or((range.min * range.max).sqrt())
}

/// Suns of the fit; every 10 degrees where the method does not say.
fn suns(advice: &Advice) -> Vec<f64> {
    let every_ten = || (0..10).map(|i| 10.0 * f64::from(i)).collect();
    if advice.theta_l_nodes_deg.is_empty() { every_ten() } else { advice.theta_l_nodes_deg.clone() }
}

/// What the config cannot say.
fn comment(advice: &Advice, stem: &str) -> String {
    let call = advice.emitted.as_ref().map_or("No emitted library has this method.".to_owned(), |emitted| {
        format!("Call {} of {stem}-generated/{}.*.", emitted.functions.join(", "), emitted.library)
    });
    let texels =
        advice.phase_texels.map_or(String::new(), |count| format!("# {count} texels of phase suffice.\n"));
    let radii = &advice.phase_radii_um;
    let others =
        if radii.len() > 1 { format!("# One config for each r_e of {radii:?} um.\n") } else { String::new() };
    format!(
        "# Made by `stratiform advise`: {}. {call}\n{texels}{others}# First `stratiform reproduce` this file with --out OUT, then copy \
         OUT/accepted to {stem}-accepted.\n",
        advice.method
    )
}

/// All, or the middle one.
fn wavelengths(advice: &Advice, scene: &Scene) -> Vec<f64> {
    let mut sorted = scene.wavelengths_um.clone();
    sorted.sort_by(f64::total_cmp);
    match advice.channels {
        Channels::Grey => vec![sorted[sorted.len() / 2]],
        Channels::Rgb => sorted,
    }
}
