//! scratch
use std::sync::Arc;
use stratiform_optics::phase::*;
use stratiform_quantities::*;
use stratiform_transport::*;
fn main() {
    rayon::ThreadPoolBuilder::new().num_threads(1).build_global().unwrap();
    let tau: f64 = std::env::args().nth(1).unwrap().parse().unwrap();
    let m = TraceMedium::full(
        Arc::new(HenyeyGreenstein::new(Asymmetry::new(0.85).unwrap())),
        SingleScatteringAlbedo::CONSERVATIVE,
    );
    let n = (4e8 / 2.0 / tau) as u64;
    let r = TraceRequest {
        tau: vec![tau],
        incidence: Incidence::Diffuse,
        stop: Stop::Photons(n),
        max_order: 2,
        seed: 1,
        stream: 0,
    };
    let t = std::time::Instant::now();
    let a = trace_half_space(&m, &r, Control::default()).unwrap();
    println!("{}", t.elapsed().as_secs_f64() * 1e9 / (a.mean_scatterings(0).value * n as f64));
}
