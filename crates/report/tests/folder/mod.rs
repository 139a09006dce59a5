//! A synthetic folder of artifacts: made-up numbers of plausible size, the same every time.

#![allow(
    dead_code,
    clippy::unwrap_used,
    missing_docs,
    reason = "test data of which each test file uses a part"
)]

use std::path::Path;
use stratiform_artifact::*;
use stratiform_quantities::{ExtinctionConvention, Medium, Order, Side};
use stratiform_stats::Estimate;

/// θ_l, b, c, κ_c, t, r.
pub const FITTED: [[f64; 6]; 10] = [
    [0.0, 1.163, 0.0169, 0.0251, 0.846, 0.0517],
    [10.0, 1.158, 0.0167, 0.0253, 0.845, 0.0518],
    [20.0, 1.135, 0.0160, 0.0262, 0.838, 0.0525],
    [30.0, 1.090, 0.0142, 0.0281, 0.825, 0.0544],
    [40.0, 1.021, 0.0100, 0.0312, 0.806, 0.0588],
    [50.0, 0.921, 0.0210, 0.0365, 0.781, 0.0689],
    [60.0, 0.792, 0.0248, 0.0455, 0.751, 0.0929],
    [70.0, 0.634, 0.0301, 0.0624, 0.718, 0.1520],
    [80.0, 0.454, 0.0480, 0.1010, 0.681, 0.2890],
    [90.0, 0.262, 0.1560, 0.4100, 0.400, 0.7200],
];
pub const PUBLISHED: [[f64; 6]; 10] = [
    [0.0, 1.1796, 0.0138, 0.0265, 0.8389, 0.0547],
    [10.0, 1.1293, 0.0154, 0.0262, 0.8412, 0.0547],
    [20.0, 1.1382, 0.0131, 0.0272, 0.8334, 0.0552],
    [30.0, 1.0953, 0.0049, 0.0294, 0.8208, 0.0564],
    [40.0, 0.9808, 0.0012, 0.0326, 0.8010, 0.0603],
    [50.0, 0.9077, 0.0047, 0.0379, 0.7774, 0.0705],
    [60.0, 0.7987, 0.0207, 0.0471, 0.7506, 0.0984],
    [70.0, 0.6629, 0.0133, 0.0616, 0.7165, 0.1700],
    [80.0, 0.5043, 0.0280, 0.0700, 0.7149, 0.3554],
    [90.0, 0.3021, 0.0783, 0.0700, 0.1000, 0.9500],
];
const KAPPA_S: f64 = 0.02517;
const WAVELENGTHS: [(f64, f64); 3] = [(0.65, 0.850), (0.55, 0.853), (0.45, 0.857)];

/// Writes all artifacts into `dir`.
pub fn write(dir: &Path) {
    create_folder(&dir.join("optics")).unwrap();
    write_json(&dir.join("optics/optics.json"), &optics()).unwrap();
    for (i, (wavelength, g)) in WAVELENGTHS.iter().enumerate() {
        write_phase(&dir.join(format!("optics/phase-{wavelength}.csv")), *g, 0.02 * i as f64);
    }
    write_phase(&dir.join("optics/sphere.csv"), 0.87, 0.8);
    write_csv(&dir.join("orders.csv"), &orders()).unwrap();
    write_csv(&dir.join("convergence.csv"), &convergence()).unwrap();
    write_csv(&dir.join("solver_cost.csv"), &solver_cost()).unwrap();
    write_csv(&dir.join("optics/quadrature.csv"), &quadrature()).unwrap();
    write_csv(&dir.join("angular-books.csv"), &angular_books()).unwrap();
    create_folder(&dir.join("figures")).unwrap();
    write_csv(&dir.join("figures/principal-plane.csv"), &principal_plane()).unwrap();
    write_json(&dir.join("parameters.json"), &parameters()).unwrap();
    write_csv(&dir.join("published.csv"), &published()).unwrap();
    write_csv(&dir.join("curves.csv"), &curves()).unwrap();
    write_json(&dir.join("notes.json"), &notes()).unwrap();
    write_csv(&dir.join("ladder.csv"), &ladder()).unwrap();
    let rows = agreement();
    write_json(&dir.join("agreement.json"), &verdict(&rows)).unwrap();
    write_csv(&dir.join("agreement.csv"), &rows).unwrap();
}

pub fn ladder() -> Vec<LadderRow> {
    let mut rows = Vec::new();
    for (i, rung) in ["solver", "monte-carlo", "model", "f32", "interpolation", "together"].iter().enumerate()
    {
        for angles in [LadderRow::TO_80, LadderRow::ALL] {
            for (q, quantity) in LadderRow::QUANTITIES.iter().enumerate() {
                let size = [1e-8, 5e-4, 4e-3, 1e-7, 2e-3, 5e-3][i] * (1.0 + 0.2 * q as f64);
                rows.push(LadderRow {
                    rung: (*rung).to_owned(),
                    angles: angles.to_owned(),
                    quantity: (*quantity).to_owned(),
                    rms: Some(size),
                    worst: Some(3.0 * size),
                    worst_theta_l_deg: if q == 3 { "diffuse".to_owned() } else { "70".to_owned() },
                    worst_tau: Some(2.5),
                    points: 180,
                    expected_rms: (i == 1).then_some(0.9 * size),
                    note: String::new(),
                });
            }
        }
    }
    rows.push(LadderRow {
        rung: "shader".to_owned(),
        angles: LadderRow::ALL.to_owned(),
        quantity: String::new(),
        rms: None,
        worst: None,
        worst_theta_l_deg: String::new(),
        worst_tau: None,
        points: 0,
        expected_rms: None,
        note: "not measured: no adapter".to_owned(),
    });
    rows
}

pub fn agreement() -> Vec<AgreementRow> {
    let row = |theta: &str, parameter: &str, z: f64| AgreementRow {
        theta_l_deg: theta.to_owned(),
        parameter: parameter.to_owned(),
        solved: 0.5,
        solved_error: Some(1e-7),
        traced: 0.5 - 1e-3 * z,
        traced_std_error: Some(1e-3),
        z: Some(z),
        differs: false,
    };
    let mut rows = vec![row("all", "beta", 0.3)];
    for (i, angle) in ["0", "45", "90", "diffuse"].iter().enumerate() {
        for (q, parameter) in ["b", "c", "kappa_c", "t", "r"].iter().enumerate() {
            rows.push(row(angle, parameter, 2.0 * noise(31 * i + q)));
        }
    }
    rows
}

pub fn verdict(rows: &[AgreementRow]) -> AgreementDocument {
    AgreementDocument {
        schema: AgreementDocument::SCHEMA.to_owned(),
        provenance: provenance(),
        photons: 1000,
        false_alarm_rate: 1e-4,
        comparisons: rows.len() as u64,
        threshold: 4.56,
        differing: rows.iter().filter(|row| row.differs).count() as u64,
        worst: rows[1].clone(),
    }
}

pub fn provenance() -> Provenance {
    Provenance::new("00112233445566778899aabbccddeeff".to_owned(), Some(7), "made-up numbers")
}

/// Between -1 and 1, the same for the same `i`.
fn noise(i: usize) -> f64 {
    let hash = (i as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    ((hash ^ (hash >> 31)).wrapping_mul(0xbf58_476d_1ce4_e5b9) >> 11) as f64 / (1u64 << 52) as f64 - 1.0
}

pub fn thicknesses() -> Vec<f64> {
    (0..20).map(|i| libm::pow(10.0, 3.0 * f64::from(i) / 19.0)).collect()
}

fn write_phase(path: &Path, g: f64, ripple: f64) {
    let mut text = "theta_deg,p\n".to_owned();
    for i in 0..=1800 {
        let theta = 180.0 * libm::pow(f64::from(i) / 1800.0, 1.5);
        let mu = libm::cos(theta.to_radians());
        let smooth = 0.6 * (1.0 - g * g) / libm::pow(1.0 + g * g - 2.0 * g * mu, 1.5);
        let bump = |at: f64, width: f64| libm::exp(-((theta - at) / width) * ((theta - at) / width));
        let p = smooth + 2500.0 * bump(0.0, 1.0) + 0.12 * bump(141.0, 4.0) + 0.3 * bump(180.0, 1.2);
        let p = p * libm::exp(ripple * libm::sin(theta * 6.0)) * 0.5;
        text += &format!("{theta},{p}\n");
    }
    write_atomic(path, text.as_bytes()).unwrap();
}

pub fn optics() -> OpticsDocument {
    let radius: Vec<f64> = (0..300).map(|i| 0.1 * f64::from(i)).collect();
    let number = radius.iter().map(|r| 300.0 * r / (1.75 * 1.75) * libm::exp(-r / 1.75)).collect();
    OpticsDocument {
        schema: OpticsDocument::SCHEMA.to_owned(),
        provenance: provenance(),
        droplets: "modified gamma distribution, r_e = 7 µm, γ = 2".to_owned(),
        effective_radius_um: 7.0,
        effective_variance: 0.25,
        number_density_per_cm3: 300.0,
        size_density: SizeDensity { radius_um: radius, number_per_cm3_um: number },
        wavelengths: WAVELENGTHS
            .iter()
            .map(|(wavelength_um, asymmetry)| WavelengthOptics {
                wavelength_um: *wavelength_um,
                refractive_index: [1.333, 2e-9],
                extinction_per_m: Extinction { paper: 0.04618, mie: 0.0368 },
                single_scattering_albedo: 0.9999996,
                asymmetry: *asymmetry,
                forward_fraction: ForwardFraction { theta_f_deg: 5.0, value: 0.455 },
                reached_error: ReachedError {
                    radii: 1500,
                    asymmetry: 3e-5,
                    forward_fraction: 2e-5,
                    moments: 8e-5,
                    phase_below_60_deg: 2e-3,
                    phase_beyond_60_deg: 8e-3,
                },
                phase_csv: format!("phase-{wavelength_um}.csv"),
                modified_phase_csv: "unused.csv".to_owned(),
                moments_csv: "unused.csv".to_owned(),
            })
            .collect(),
    }
}

/// T_ms, T_0, T_1, T_2, R_1, R_2 of the one-dimensional model.
fn model([theta, b, c, kappa_c, t, r]: [f64; 6], beta: f64, h: f64) -> [f64; 6] {
    let mu = libm::cos(theta.to_radians()).max(1e-6);
    let x = kappa_c * h;
    let e = libm::exp(-x);
    let t_ms = (b + (1.0 - b) * libm::exp(-c * h)) * beta / (h - (h - 1.0) * beta);
    let t_2 = 0.5 * t * x * t * x * e + 0.25 * r * r * e * (2.0 * x - 1.0 + e * e);
    let r_2 = 0.5 * r * t * (1.0 - (1.0 + 2.0 * x) * e * e);
    [t_ms, libm::exp(-KAPPA_S * h / mu), t * x * e, t_2, 0.5 * r * (1.0 - e * e), r_2]
}

pub fn orders() -> Vec<OrdersRow> {
    let mut rows = Vec::new();
    for (angle, parameters) in FITTED.iter().enumerate() {
        for (i, h) in thicknesses().into_iter().enumerate() {
            let [t_ms, t_0, t_1, t_2, r_1, r_2] = model(*parameters, 0.9961, h);
            let (t_3, r_3) = (t_ms - t_0 - t_1 - t_2, 1.0 - t_ms - r_1 - r_2);
            let parts = [("0", t_0, 0.0), ("1", t_1, r_1), ("2", t_2, r_2), ("tail", t_3, r_3)];
            let modified = parts.map(|(order, t, r)| (Medium::Modified, order, t, r));
            for (j, (medium, order, t, r)) in
                modified.into_iter().chain([(Medium::Full, "total", t_ms, 1.0 - t_ms)]).enumerate()
            {
                let slip = 0.006 * noise(1000 * angle + 10 * i + j);
                rows.push(OrdersRow {
                    theta_l_deg: parameters[0].to_string(),
                    thickness_m: h,
                    medium,
                    order: order.to_owned(),
                    reflectance: (r - slip).max(0.0),
                    reflectance_std_error: 0.004,
                    transmittance: (t + slip).max(0.0),
                    transmittance_std_error: 0.004,
                });
            }
        }
    }
    rows
}

pub fn curves() -> Vec<CurvesRow> {
    use CurveQuantity::{R1, R2, R3Plus, RMs, T0, T1, T2, T3Plus, TMs};
    let mut rows = Vec::new();
    for (model_name, table) in [(CurveModel::Fitted, FITTED), (CurveModel::Published, PUBLISHED)] {
        for parameters in table {
            for i in 0..=60 {
                let thickness_m = libm::pow(10.0, 3.0 * f64::from(i) / 60.0);
                let [t_ms, t_0, t_1, t_2, r_1, r_2] = model(parameters, 0.9961, thickness_m);
                let (t_3, r_3) = (t_ms - t_0 - t_1 - t_2, 1.0 - t_ms - r_1 - r_2);
                let values = [t_ms, 1.0 - t_ms, t_0, t_1, t_2, t_3, r_1, r_2, r_3];
                let names = [TMs, RMs, T0, T1, T2, T3Plus, R1, R2, R3Plus];
                rows.extend(names.into_iter().zip(values).map(|(quantity, value)| CurvesRow {
                    theta_l_deg: parameters[0],
                    thickness_m,
                    quantity,
                    model: model_name,
                    value,
                }));
            }
        }
    }
    rows
}

pub fn published() -> Vec<PublishedRow> {
    PUBLISHED
        .iter()
        .map(|[theta_l_deg, b, c, kappa_c, t, r]| PublishedRow {
            theta_l_deg: *theta_l_deg,
            b: *b,
            c_per_m: *c,
            kappa_c_per_m: *kappa_c,
            t: *t,
            r: *r,
        })
        .collect()
}

fn misfit(scale: f64) -> Vec<Misfit> {
    ["t_ms", "t_1", "t_2", "r_1", "r_2"]
        .iter()
        .enumerate()
        .map(|(i, quantity)| Misfit {
            quantity: (*quantity).to_owned(),
            rms: scale * (1.0 + 0.3 * noise(i)),
            max: 3.0 * scale,
            max_at: 20.0,
        })
        .collect()
}

fn row(theta_l_deg: RowIncidence, [theta, b, c, kappa_c, t, r]: [f64; 6]) -> ParameterRow {
    let fitted = |value: f64, share: f64| FittedParameter {
        value: Some(value),
        std_error: Some(value * share),
        emitted: value,
    };
    let undetermined = theta == 40.0;
    let lone = FittedParameter { value: None, std_error: None, emitted: 0.0155 };
    let flags = match theta {
        40.0 => vec![Flag::CNotIdentifiable],
        80.0 => vec![Flag::NegativeR3Plus],
        90.0 => vec![Flag::BetaFixed, Flag::NegativeT3Plus, Flag::OutsideUnitInterval],
        _ => Vec::new(),
    };
    ParameterRow {
        theta_l_deg,
        b: fitted(b, 0.002),
        c: if undetermined { lone } else { fitted(c, 0.06) },
        kappa_c: fitted(kappa_c, 0.005),
        t: fitted(t, 0.002),
        r: fitted(r, 0.004),
        correlation_b_c: (!undetermined).then_some(-0.71),
        correlation_kappa_c_t_r: Some([-0.4, 0.2, -0.1]),
        misfit: misfit(0.002 + 0.0001 * theta + if theta == 90.0 { 0.07 } else { 0.0 }),
        flags,
        stopped_multiple: "relative reduction below 1e-12 after 9 iterations".to_owned(),
        stopped_orders: "gradient below 1e-12 after 11 iterations".to_owned(),
    }
}

pub fn parameters() -> ParametersDocument {
    let mut rows: Vec<_> = FITTED.iter().map(|p| row(RowIncidence::Degrees(p[0]), *p)).collect();
    rows.push(row(RowIncidence::diffuse(), [45.0, 0.93, 0.021, 0.04, 0.77, 0.08]));
    let beta = Estimate { value: 0.99612, std_error: 1.3e-4 };
    ParametersDocument {
        schema: ParametersDocument::SCHEMA.to_owned(),
        provenance: provenance(),
        medium: MediumRecord {
            wavelength_um: 0.55,
            extinction_convention: ExtinctionConvention::Paper,
            extinction_per_m: 0.04618,
            single_scattering_albedo: 1.0,
            asymmetry: 0.853,
            theta_f_deg: 5.0,
            forward_fraction: 0.455,
        },
        thickness_range_m: [1.0, 1000.0],
        metres: ParameterTable { beta, kappa_s: KAPPA_S, rows: rows.clone() },
        optical: ParameterTable { beta, kappa_s: 0.545, rows },
    }
}

pub fn convergence() -> Vec<ConvergenceRow> {
    let mut rows = Vec::new();
    for (estimator, cost, spread) in [("plain", 3e-6, 0.45), ("half-space", 8e-7, 0.45)] {
        for exponent in 0..5 {
            let photons = 10_000 << (2 * exponent);
            let std_error = spread / (photons as f64).sqrt();
            for (i, order) in ["0", "1", "2", "tail", "total"].iter().enumerate() {
                rows.push(ConvergenceRow {
                    estimator: estimator.to_owned(),
                    theta_l_deg: 40.0,
                    tau: 5.0,
                    order: (*order).to_owned(),
                    photons,
                    seconds: cost * photons as f64,
                    error: std_error * 1.5 * noise(97 * exponent + i).abs(),
                    std_error,
                });
            }
        }
    }
    for (rung, streams) in [4, 8, 16, 32].into_iter().enumerate() {
        rows.push(ConvergenceRow {
            estimator: "solver".to_owned(),
            theta_l_deg: 40.0,
            tau: 5.0,
            order: "total".to_owned(),
            photons: streams,
            seconds: 1e-6 * (streams * streams) as f64,
            error: libm::pow(10.0, -2.0 - rung as f64),
            std_error: libm::pow(10.0, -1.5 - rung as f64),
        });
    }
    rows
}

pub fn solver_cost() -> Vec<SolverCostRow> {
    let mut rows = Vec::new();
    for (against, task) in ["streams", "tau", "thicknesses"].into_iter().zip(["first", "further", "orders"]) {
        for exponent in 0..5 {
            let count = 4 << exponent;
            rows.push(SolverCostRow {
                against: against.to_owned(),
                task: task.to_owned(),
                streams: count,
                tau: 0.1 * count as f64,
                thicknesses: count,
                seconds: 1e-7 * (count * count) as f64,
            });
        }
    }
    rows
}

pub fn principal_plane() -> Vec<PrincipalPlaneRow> {
    use PlaneOrder::{Exactly, From, Total};
    let orders = [Exactly(1), Exactly(2), From(3), Total];
    let curves = [
        (PlaneSource::Mc, Medium::Modified, &orders[..]),
        (PlaneSource::Mc, Medium::Full, &orders[..]),
        (PlaneSource::Model, Medium::Modified, &orders[..]),
        (PlaneSource::Radiance, Medium::Full, &orders[3..]),
        (PlaneSource::Solver, Medium::Full, &orders[3..]),
    ];
    let mut rows = Vec::new();
    for (theta_l_deg, thickness_m) in [(70.0, 100.0), (80.0, 5.0)] {
        for (source, medium, orders) in curves {
            for (n, order) in orders.iter().enumerate() {
                for k in -11..=11 {
                    let theta_v_deg = 8.0 * f64::from(k);
                    let value = [0.1, 0.15, 0.25, 0.5][(n + 4 - orders.len()).min(3)] + 0.001 * theta_v_deg;
                    let std_error = matches!(source, PlaneSource::Mc | PlaneSource::Solver).then_some(0.01);
                    let order = *order;
                    rows.push(PrincipalPlaneRow {
                        medium,
                        theta_l_deg,
                        thickness_m,
                        theta_v_deg,
                        order,
                        value,
                        std_error,
                        source,
                    });
                }
            }
        }
    }
    rows
}

pub fn quadrature() -> Vec<QuadratureRow> {
    let row = |doublings: u32| {
        let radii = 64_u64 << doublings;
        let error = 1.0 / (radii as f64).sqrt();
        QuadratureRow {
            wavelength_um: 0.55,
            radii,
            seconds: 2e-5 * radii as f64,
            asymmetry: 0.01 * error,
            forward_fraction: 0.004 * error,
            moments: 0.03 * error,
            phase_below_60_deg: 0.1 * error,
            phase_beyond_60_deg: error,
        }
    };
    (0..9).map(row).collect()
}

pub fn angular_books() -> Vec<AngularBooksRow> {
    let mut rows = Vec::new();
    for (theta_l_deg, tau) in [0.0, 40.0, 80.0].into_iter().flat_map(|theta| [(theta, 0.05), (theta, 5.0)]) {
        let row = |side, order, form, integral| AngularBooksRow {
            theta_l_deg,
            tau,
            side,
            order,
            form,
            integral,
            one_dimensional_model: 0.2,
            solver: 0.2,
        };
        for side in Side::BOTH {
            rows.push(row(side, Order::Exactly(2), AngularForm::Corrected, 0.21));
            rows.push(row(side, Order::Exactly(2), AngularForm::AsPrintedPerUnit, 2.0));
        }
    }
    rows
}

pub fn notes() -> NotesDocument {
    let bias = |theta: &[f64; 6]| ModifiedBias {
        theta_l_deg: RowIncidence::Degrees(theta[0]),
        thickness_m: 37.9,
        difference: -9e-4,
        std_error: 2.1e-4,
    };
    NotesDocument {
        schema: NotesDocument::SCHEMA.to_owned(),
        provenance: provenance(),
        published_source: "Bouthors, Neyret and Lefebvre 2006, appendix B".to_owned(),
        published_beta: Some(0.9961),
        published_shares: Some(AngularShares { forward: 0.51, wide: 0.48, backward: 0.01 }),
        shares: [(0.65, 0.443, 0.515), (0.55, 0.455, 0.504), (0.45, 0.466, 0.494)]
            .map(|(wavelength_um, forward, wide)| WavelengthShares {
                wavelength_um,
                shares: AngularShares { forward, wide, backward: 1.0 - forward - wide },
            })
            .to_vec(),
        coarse_tabulation: [(0.65, 1.07, 0.478), (0.55, 1.09, 0.501), (0.45, 1.14, 0.529)]
            .map(|(wavelength_um, raw_integral, forward_fraction)| CoarseTabulation {
                wavelength_um,
                step_deg: 1.0,
                raw_integral,
                raw_forward_fraction: raw_integral * forward_fraction,
                forward_fraction,
            })
            .to_vec(),
        modified_bias: FITTED.iter().map(bias).collect(),
        published_misfit: PUBLISHED
            .iter()
            .map(|p| PublishedMisfit { theta_l_deg: p[0], misfit: misfit(0.02 + 0.0008 * p[0]) })
            .collect(),
    }
}
