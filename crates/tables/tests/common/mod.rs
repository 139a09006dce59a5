//! What several tests share.

#![allow(dead_code, reason = "every test file uses a part of it")]

use std::sync::OnceLock;
use stratiform_optics::ensemble::Ensemble;
use stratiform_optics::{OpticsConfig, compute};

/// The cloud of Bouthors, Neyret & Lefebvre 2006 at 0.55 µm.
pub fn cloud() -> &'static Ensemble {
    static CLOUD: OnceLock<Ensemble> = OnceLock::new();
    CLOUD.get_or_init(|| {
        let config: OpticsConfig = serde_json::from_str(
            r#"{"number_density_per_cm3": 300.0, "wavelengths_um": [0.55],
                "droplets": {"distribution": "modified-gamma", "gamma": 2.0, "effective_radius_um": 7.0}}"#,
        )
        .unwrap();
        compute(&config).unwrap().remove(0)
    })
}

/// v = 1 - cosΘ.
pub fn versine(theta_deg: f64) -> f64 {
    let sine = libm::sin(0.5 * theta_deg.to_radians());
    2.0 * sine * sine
}
