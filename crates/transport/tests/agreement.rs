//! scratch
use std::sync::Arc;
use stratiform_optics::phase::{HenyeyGreenstein, PhaseFunction};
use stratiform_quantities::*;
use stratiform_transport::*;
#[test]
fn quick() {
    let phase: Arc<dyn PhaseFunction> = Arc::new(HenyeyGreenstein::new(Asymmetry::new(0.75).unwrap()));
    for omega in [1.0, 0.9] {
        let m = TraceMedium::full(phase.clone(), SingleScatteringAlbedo::new(omega).unwrap());
        eprintln!("exact share {}", m.table().exact_share());
        let r = TraceRequest {
            tau: vec![8.0, 1.0, 2.0, 0.0],
            incidence: Incidence::beam(1.0).unwrap(),
            stop: Stop::Photons(1_000_000),
            max_order: 2,
            seed: 1,
            stream: 0,
        };
        let a = trace_half_space(&m, &r, Control::default()).unwrap();
        let b = trace_plain(&m, &r, Control::default()).unwrap();
        for i in 0..4 {
            for o in Order::rows(2) {
                let ((r1, t1), (r2, t2)) = (a.estimate(i, o), b.estimate(i, o));
                let z = |a: stratiform_stats::Estimate, b: stratiform_stats::Estimate| {
                    (a.value - b.value) / (a.std_error.powi(2) + b.std_error.powi(2)).sqrt()
                };
                eprintln!(
                    "{} {o} {:.5} {:.5} z {:.2} {:.2}",
                    r.tau[i],
                    r1.value,
                    t1.value,
                    z(r1, r2),
                    z(t1, t2)
                );
            }
            eprintln!(
                "{:?} {:?} {:?} cov {:e} {:e}",
                a.mean_scatterings(i),
                b.mean_scatterings(i),
                a.absorptance(i),
                a.covariance(&[(i, Quantity::Reflectance(Order::Total))])[0][0].sqrt(),
                a.estimate(i, Order::Total).0.std_error
            );
        }
    }
}
