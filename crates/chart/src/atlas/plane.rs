//! Planes through a base point: two inputs run, the rest is held.

use super::clouds::{BASE_RADIUS_UM, CloudAt};
use stratiform_methods::Point;
use stratiform_quantities::Side;

/// What can run along an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Input {
    /// κH.
    Tau,
    /// μ_l.
    MuL,
    /// μ_v.
    MuV,
    /// μ_v/μ_l - 1.
    Detuning,
    /// φ.
    PhiDeg,
    /// r_e.
    EffectiveRadius,
    /// θ_f.
    ThetaF,
    /// ω.
    Omega,
}

impl Input {
    /// Its name in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Tau => "tau",
            Self::MuL => "mu_l",
            Self::MuV => "mu_v",
            Self::Detuning => "mu_v/mu_l-1",
            Self::PhiDeg => "phi_deg",
            Self::EffectiveRadius => "r_eff_um",
            Self::ThetaF => "theta_f_deg",
            Self::Omega => "omega",
        }
    }

    /// The values that run, from end to end.
    pub fn values(self) -> &'static [f64] {
        match self {
            Self::Tau => &[1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0, 1e3, 1e4],
            Self::MuL | Self::MuV => &[1e-4, 1e-3, 0.01, 0.03, 0.1, 0.2, 0.3, 0.45, 0.6, 0.8, 0.95, 1.0],
            Self::Detuning => {
                &[-0.1, -1e-2, -1e-3, -1e-4, -1e-5, -1e-7, 0.0, 1e-7, 1e-5, 1e-4, 1e-3, 1e-2, 0.1]
            }
            Self::PhiDeg => &[0.0, 1.0, 3.0, 6.0, 12.0, 30.0, 60.0, 90.0, 120.0, 150.0, 170.0, 178.0, 180.0],
            Self::EffectiveRadius => &[1.0, 2.0, 4.0, 7.0, 10.0, 15.0, 20.0, 30.0, 50.0],
            Self::ThetaF => &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 7.0, 10.0, 15.0],
            Self::Omega => &[0.5, 0.7, 0.8, 0.9, 0.99, 0.999, 0.999_99, 1.0],
        }
    }
}

/// Where everything else is held.
const BASE: Spot = Spot { tau: 3.0, mu_l: 0.6, mu_v: 0.8, phi_deg: 60.0 };

/// Without a face and a cloud.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Spot {
    tau: f64,
    mu_l: f64,
    mu_v: f64,
    phi_deg: f64,
}

/// Which values of a plane are asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Density {
    /// All.
    Full,
    /// The ends and about two between.
    Thin,
}

impl Density {
    fn of(self, values: &[f64]) -> Vec<f64> {
        let step = match self {
            Self::Full => 1,
            Self::Thin => values.len().div_ceil(4),
        };
        let last = values.len() - 1;
        (0..=last).filter(|i| i % step == 0 || *i == last).map(|i| values[i]).collect()
    }
}

/// Two inputs that run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Plane {
    /// Along x.
    pub x: Input,
    /// Along y.
    pub y: Input,
}

/// A place in a plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Along x.
    pub x: f64,
    /// Along y.
    pub y: f64,
    /// The droplets there.
    pub cloud: CloudAt,
    /// The slab and the line of sight, leaving above.
    pub point: Point,
}

impl Plane {
    /// The planes of the atlas.
    pub const ALL: [Self; 7] = [
        Self { x: Input::Tau, y: Input::MuL },
        Self { x: Input::Tau, y: Input::MuV },
        Self { x: Input::Detuning, y: Input::MuL },
        Self { x: Input::Tau, y: Input::PhiDeg },
        Self { x: Input::Tau, y: Input::EffectiveRadius },
        Self { x: Input::Tau, y: Input::ThetaF },
        Self { x: Input::Tau, y: Input::Omega },
    ];

    /// Its name in files.
    pub fn name(&self) -> String {
        format!("{}:{}", self.x.name(), self.y.name())
    }

    /// Whether fluxes differ within it beyond what its other axis says.
    pub fn has_fluxes(&self) -> bool {
        !matches!(self.y, Input::MuV | Input::PhiDeg) && self.x != Input::Detuning
    }

    /// What is held, in words.
    pub fn held(&self) -> String {
        let runs = |input: Input| self.x == input || self.y == input;
        let held = [
            (Input::Tau, BASE.tau),
            (Input::MuL, BASE.mu_l),
            (Input::MuV, self.base().mu_v),
            (Input::PhiDeg, self.base().phi_deg),
            (Input::EffectiveRadius, BASE_RADIUS_UM),
            (Input::ThetaF, CloudAt::BASE.theta_f_deg),
            (Input::Omega, CloudAt::BASE.omega),
        ];
        let names = held.iter().filter(|(input, _)| !runs(*input));
        let names = names.filter(|(input, _)| *input != Input::MuV || !runs(Input::Detuning));
        names.map(|(input, value)| format!("{} = {value}", input.name())).collect::<Vec<_>>().join(", ")
    }

    /// The glory and the aureole lie where φ runs at equal cosines; μ_v → μ_l matters in the sun's vertical plane.
    fn base(&self) -> Spot {
        match (self.x, self.y) {
            (_, Input::PhiDeg) => Spot { mu_v: BASE.mu_l, ..BASE },
            _ => BASE,
        }
    }

    /// Every place, x inside y.
    pub fn places(&self, density: Density) -> Vec<Place> {
        let (across, up) = (density.of(self.x.values()), density.of(self.y.values()));
        let pairs = up.iter().flat_map(|y| across.iter().map(move |x| (*x, *y)));
        pairs.map(|(x, y)| self.place(x, y)).collect()
    }

    fn place(&self, x: f64, y: f64) -> Place {
        let (mut spot, mut cloud) = (self.base(), CloudAt::BASE);
        // The second one first: the detuning is relative to it.
        for (input, value) in [(self.y, y), (self.x, x)] {
            match input {
                Input::Tau => spot.tau = value,
                Input::MuL => spot.mu_l = value,
                Input::MuV => spot.mu_v = value,
                Input::Detuning => spot.mu_v = spot.mu_l * (1.0 + value),
                Input::PhiDeg => spot.phi_deg = value,
                Input::EffectiveRadius => cloud.r_eff_um = value,
                Input::ThetaF => cloud.theta_f_deg = value,
                Input::Omega => cloud.omega = value,
            }
        }
        let Spot { tau, mu_l, mu_v, phi_deg } = spot;
        Place { x, y, cloud, point: Point { tau, mu_l, mu_v, phi_deg, side: Side::Top } }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thin_planes_keep_the_ends() {
        let plane = Plane { x: Input::Tau, y: Input::Omega };
        let places = plane.places(Density::Thin);
        let (first, last) = (places.first().unwrap(), places.last().unwrap());
        assert_eq!((first.point.tau, first.cloud.omega), (1e-6, 0.5));
        assert_eq!((last.point.tau, last.cloud.omega), (1e4, 1.0));
        assert!(places.len() <= 25 && plane.places(Density::Full).len() == 14 * 8);
    }

    #[test]
    fn detuning_is_relative_to_the_sun() {
        let place = Plane { x: Input::Detuning, y: Input::MuL }.place(-0.1, 0.3);
        assert!((place.point.mu_v - 0.27).abs() < 1e-15 && place.point.mu_l == 0.3);
    }
}
