//! `stratiform trace --device gpu`: the numbers of the processor where there is a device, and clear words where there is none.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::{refused, run};

const TRACE: [&str; 12] = [
    "trace",
    "--phase",
    "hg:0.85",
    "--tau",
    "4,1",
    "--mu0",
    "1,diffuse",
    "--photons",
    "30000",
    "--device",
    "gpu",
    "--quiet",
];

#[cfg(not(feature = "gpu"))]
#[test]
fn without_the_feature_it_says_how_to_get_it() {
    let dir = tempfile::tempdir().unwrap();
    refused("no feature", &run(dir.path(), &TRACE), &["--device gpu", "--features gpu"]);
}

#[test]
fn what_no_device_does_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let with = |more: &[&str]| run(dir.path(), &[&TRACE[..], more].concat());
    refused("plain", &with(&["--estimator", "plain"]), &["--device gpu", "plain"]);
    refused("radiance", &with(&["--view-mu", "0.5"]), &["--device gpu", "fluxes"]);
}

#[cfg(feature = "gpu")]
mod traced {
    use super::*;
    use common::stdout;
    use stratiform_gpu::{Gpu, GpuError};

    /// A loud skip without a device, a failure where one is demanded.
    fn device() -> Option<Gpu> {
        match Gpu::new() {
            Ok(gpu) => Some(gpu),
            Err(error @ GpuError::NoAdapter { .. })
                if std::env::var_os("STRATIFORM_REQUIRE_GPU").is_none() =>
            {
                use std::io::Write as _;
                let _ = std::io::stderr().write_all(format!("SKIPPED: {error}\n").as_bytes());
                None
            }
            Err(error) => panic!("{error}"),
        }
    }

    /// Every number of the table's rows.
    fn numbers(csv: &str) -> Vec<f64> {
        let fields =
            csv.lines().filter(|line| !line.starts_with('#')).skip(1).flat_map(|line| line.split(','));
        fields.filter_map(|field| field.parse().ok()).collect()
    }

    /// 4 photons of 30000, where 2 per counter and standard deviation would be chance.
    #[test]
    fn the_device_traces_the_photons_of_the_processor() {
        let Some(gpu) = device() else { return };
        let dir = tempfile::tempdir().unwrap();
        let on_cpu = TRACE.map(|word| if word == "gpu" { "cpu" } else { word });
        let (device, cpu) = (numbers(&stdout(dir.path(), &TRACE)), numbers(&stdout(dir.path(), &on_cpu)));
        assert_eq!(device.len(), cpu.len());
        assert!(device.len() > 50 && device.iter().zip(&cpu).all(|(a, b)| (a - b).abs() <= 4.0 / 30_000.0));
        let json = stdout(dir.path(), &[&TRACE[..], &["--json"]].concat());
        assert!(json.contains(gpu.adapter()), "the method names the adapter");
    }

    /// Shards of the device merge to the bytes of one process; one of the processor's is foreign.
    #[test]
    fn shards_merge_to_the_whole() {
        if device().is_none() {
            return;
        }
        let dir = tempfile::tempdir().unwrap();
        let shard = |shard: &str, out: &str| {
            stdout(dir.path(), &[&TRACE[..], &["--shard", shard, "--out", out]].concat());
        };
        shard("1/2", "a.bin");
        shard("2/2", "b.bin");
        assert_eq!(stdout(dir.path(), &["merge", "a.bin", "b.bin"]), stdout(dir.path(), &TRACE));
        let on_cpu = TRACE.map(|word| if word == "gpu" { "cpu" } else { word });
        stdout(dir.path(), &[&on_cpu[..], &["--shard", "2/2", "--out", "c.bin"]].concat());
        refused("foreign", &run(dir.path(), &["merge", "a.bin", "c.bin"]), &["device"]);
    }

    #[test]
    fn deep_slabs_are_refused_by_name() {
        if device().is_none() {
            return;
        }
        let dir = tempfile::tempdir().unwrap();
        let deep = TRACE.map(|word| if word == "4,1" { "301" } else { word });
        refused("deep", &run(dir.path(), &deep), &["301", "300"]);
    }
}
