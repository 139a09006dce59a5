//! Bad input: exit code 2, one message that names the value, the range and the place, nothing on stdout, nothing
//! written.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::{command, config, refused, run};
use std::fs;
use std::path::Path;
use std::process::{Output, Stdio};

#[test]
fn numbers_out_of_domain() {
    let dir = tempfile::tempdir().unwrap();
    let trace = |phase: &str, tau: &str, mu0: &str, photons: &str, more: &[&str]| {
        let args = ["trace", "--phase", phase, "--tau", tau, "--mu0", mu0, "--photons", photons];
        run(dir.path(), &[&args, more].concat())
    };
    let cases: &[(&str, Output, &[&str])] = &[
        ("tau negative", trace("isotropic", "-1", "1", "10", &[]), &["tau = -1", "[0, 1000000]"]),
        ("tau nan", trace("isotropic", "nan", "1", "10", &[]), &["nan", "finite"]),
        ("tau huge", trace("isotropic", "1e300", "1", "10", &[]), &["tau = 1", "[0, 1000000]"]),
        ("mu0 beyond 1", trace("isotropic", "1", "1.5", "10", &[]), &["mu0 = 1.5", "[0, 1]"]),
        ("mu0 negative", trace("isotropic", "1", "-0.5", "10", &[]), &["mu0 = -0.5", "[0, 1]"]),
        ("mu0 a word", trace("isotropic", "1", "noon", "10", &[]), &["noon", "diffuse"]),
        ("photons 0", trace("isotropic", "1", "1", "0", &[]), &["`0`", "[1, 2^53]"]),
        ("photons 1.5", trace("isotropic", "1", "1", "1.5", &[]), &["`1.5`"]),
        ("g 1", trace("hg:1", "1", "1", "10", &[]), &["g = 1", "(-1, 1)"]),
        ("g missing", trace("hg:", "1", "1", "10", &[]), &["hg:"]),
        ("phase unknown", trace("mei", "1", "1", "10", &[]), &["mei", "isotropic", "table:FILE"]),
        ("omega 1.1", trace("isotropic", "1", "1", "10", &["--omega", "1.1"]), &["omega = 1.1", "[0, 1]"]),
        ("modified 0", trace("hg:0.8", "1", "1", "10", &["--modified", "0"]), &["= 0", "(0, 90]"]),
        ("orders huge", trace("isotropic", "1", "1", "10", &["--orders", "4000000000"]), &["rows"]),
        (
            "threads 0",
            run(dir.path(), &["mie", "--x", "1", "--m", "1.3,0", "--threads", "0"]),
            &["threads = 0"],
        ),
        ("x 0", run(dir.path(), &["mie", "--x", "0", "--m", "1.3,0"]), &["x = 0", "100000"]),
        ("x huge", run(dir.path(), &["mie", "--x", "1e6", "--m", "1.3,0"]), &["x = 1000000"]),
        ("k negative", run(dir.path(), &["mie", "--x", "1", "--m", "1.3,-1"]), &["-1"]),
        ("angle 181", run(dir.path(), &["mie", "--x", "1", "--m", "1.3,0", "--angles", "181"]), &["181"]),
        ("unknown flag", run(dir.path(), &["mie", "--y", "1"]), &["--y"]),
        ("unknown command", run(dir.path(), &["mei"]), &["mei"]),
    ];
    for (what, output, says) in cases {
        refused(what, output, says);
    }
}

#[test]
fn damaged_phase_files() {
    let dir = tempfile::tempdir().unwrap();
    let table = |rows: &str| format!("theta_deg,p\n{rows}");
    let files: &[(&str, Vec<u8>, &[&str])] = &[
        ("empty", vec![], &["empty"]),
        ("binary", vec![0xff, 0x00, 0xfe, 0x80], &["not a text file"]),
        ("header only", table("").into(), &[]),
        ("one row", table("0,1\n").into(), &[]),
        ("not reaching 180", table("0,1\n90,1\n").into(), &["180"]),
        ("unsorted", table("0,1\n90,1\n45,1\n180,1\n").into(), &["45"]),
        ("negative", table("0,1\n90,-0.5\n180,1\n").into(), &["-0.5"]),
        ("nan", table("0,1\n90,NaN\n180,1\n").into(), &["NaN"]),
        ("infinite", table("0,1\n90,inf\n180,1\n").into(), &["inf"]),
        ("truncated", table("0,1\n90").into(), &[":3"]),
        ("a word", table("0,one\n180,1\n").into(), &[":2"]),
        ("unnormalised", table("0,2\n180,2\n").into(), &["norm", "2"]),
        ("all zero", table("0,0\n180,0\n").into(), &["norm"]),
    ];
    for (what, bytes, says) in files {
        fs::write(dir.path().join("p.csv"), bytes).unwrap();
        let args = ["trace", "--phase", "table:p.csv", "--tau", "1", "--mu0", "1", "--photons", "10"];
        refused(what, &run(dir.path(), &args), &[&["p.csv"], *says].concat());
    }
    for (what, text, says) in [
        ("moments empty", "", "empty"),
        ("first is not 1", "0.9\n0.5\n", "0.9"),
        ("beyond 1", "1\n1.5\n", "1.5"),
        ("negative sum", "1\n0.9\n0\n0\n0\n", "describe no phase function"),
        ("a word", "1\nx\n", "2"),
    ] {
        fs::write(dir.path().join("m.txt"), text).unwrap();
        let args = ["trace", "--phase", "moments:m.txt", "--tau", "1", "--mu0", "1", "--photons", "10"];
        refused(what, &run(dir.path(), &args), &["m.txt", says]);
    }
    for phase in ["table:missing.csv", "moments:missing.txt", "config:missing.toml", "table:."] {
        let args = ["trace", "--phase", phase, "--tau", "1", "--mu0", "1", "--photons", "10"];
        refused(phase, &run(dir.path(), &args), &["cannot read"]);
    }
}

#[test]
fn families_without_order_or_sense_are_refused() {
    let dir = tempfile::tempdir().unwrap();
    let law = "distribution = \"modified-gamma\"\neffective_radius_um = 7.0\ngamma = 2.0";
    let table = "distribution = \"tabulated\"\nfile = \"sizes.csv\"";
    fs::write(dir.path().join("sizes.csv"), "radius_um,number\n1,1\n2,1\n").unwrap();
    let cases: &[(&str, &str, &str, &[&str])] = &[
        ("[]", law, law, &["has 0 radii", "at least 2"]),
        ("[7.0]", law, law, &["has 1 radii"]),
        ("[7.0, 4.0]", law, law, &["effective_radius_um = 4 is outside (7, 50]"]),
        ("[7.0, 7.0]", law, law, &["= 7 is outside (7, 50]"]),
        ("[0.5, 7.0]", law, law, &["= 0.5 is outside [1, 50]"]),
        ("[4.0, 51.0]", law, law, &["= 51 is outside (4, 50]"]),
        ("[4.0, nan]", law, law, &["= NaN is outside (4, 50]"]),
        ("[4.0, 7.0]", law, table, &["tabulated"]),
        (
            "[4.0, 7.0]",
            "source = \"solve\"",
            "source = \"trace\"\nphotons_between = 10",
            &["needs transport.source"],
        ),
    ];
    for (radii, from, to, says) in cases {
        let text = config(&[(from, to)])
            .replace("\n[codegen]", &format!("\n[family]\neffective_radius_um = {radii}\n\n[codegen]"));
        let line = 1 + text[..text.find("[family]").unwrap()].matches('\n').count();
        fs::write(dir.path().join("c.toml"), &text).unwrap();
        let place = format!("c.toml:{}", line + 1);
        let output = run(dir.path(), &["fit", "c.toml", "--out", "out"]);
        refused(radii, &output, &[&[place.as_str()], *says].concat());
        assert!(!dir.path().join("out").exists());
    }
}

#[test]
fn configs_with_a_fault_name_file_and_line() {
    let dir = tempfile::tempdir().unwrap();
    let faults: &[(&str, &str, &[&str])] = &[
        ("gamma = 2.0", "gama = 2.0", &["gama", "c.toml:"]),
        ("gamma = 2.0", "gamma = -2.0", &["gamma = -2", "LINE"]),
        ("theta_f_deg = 5.0", "theta_f_deg = 95.0", &["theta_f_deg = 95", "LINE"]),
        ("theta_f_deg = 5.0", "theta_f_deg = nan", &["theta_f_deg = NaN", "LINE"]),
        (
            "wavelength_um = 0.55",
            "wavelength_um = 0.56",
            &["wavelength_um = 0.56", "[0.65, 0.55, 0.45]", "LINE"],
        ),
        ("photons = 1_000_000", "photons = 1 #", &["transport.photons = 1", "[2, ", "LINE"]),
        ("seed = 2006", "seed = 2006\nphotons_between = 1", &["photons_between = 1", "LINE"]),
        ("tolerance = 1e-6", "tolerance = 1e-13", &["transport.tolerance", "[0.000000000001, 1)", "LINE"]),
        ("source = \"solve\"", "source = \"guess\"", &["guess", "LINE"]),
        (
            "source = \"solve\"",
            "source = \"trace\"",
            &["transport.photons_between is missing", "trace", "LINE"],
        ),
        (
            "photons = 1_000_000\nseed = 2006",
            "photons = 1_000_000",
            &["transport.seed is missing", "photons", "LINE"],
        ),
        ("source = \"solve\"", "source = \"solve\"\nsource = \"trace\"", &["duplicate", "LINE"]),
        ("photons = 200_000", "photons = 0 #", &["check.tracer.photons = 0", "LINE"]),
        ("seed = 1894", "seed = 1729 #", &["check.tracer.seed = 1729", "LINE"]),
        ("tau = [0.05, 0.1", "tau = [0.05, 0.05", &["check.tracer.tau = 0.05", "LINE"]),
        ("false_alarm_rate = 1e-5", "false_alarm_rate = 1.0", &["check.false_alarm_rate = 1", "LINE"]),
        ("tolerance = 1e-4", "tolerance = 0.0", &["check.tolerance = 0", "LINE"]),
        ("up_to_deg = 80.0", "up_to_deg = 91.0", &["check.model.up_to_deg = 91", "LINE"]),
        ("t_ms = 0.015", "t_ms = -0.015", &["check.model.t_ms = -0.015", "LINE"]),
        ("r_2 = 0.015", "r_3 = 0.015", &["r_3", "LINE"]),
        ("[check.values.reflectance]", "[check.values.reflectivity]", &["reflectivity", "LINE"]),
        ("any = { absolute = 0.025 }", "any = { absolute = nan }", &["absolute = NaN", "LINE"]),
        ("any = { absolute = 0.025 }", "all = { absolute = 0.025 }", &["`all`", "LINE"]),
        (
            "[convergence]\ntheta_l_deg = 0.0",
            "[convergence]\ntheta_l_deg = 5.0",
            &["convergence.theta_l_deg = 5"],
        ),
        ("thickness_m = 5.0 }", "thickness_m = -5.0 }", &["principal_plane.scenes.thickness_m = -5"]),
        ("80.0, 90.0]", "80.0]", &["does not run from 0 to 90"]),
        ("max = 1000.0", "max = 1e9", &["fit.thickness_m.max = 1000000000", "LINE"]),
        ("plain_photons = [300", "plain_photons = [1", &["convergence.plain_photons = 1", "LINE"]),
        ("photons = 1_000_000", "photons = -5", &["LINE"]),
        ("\"paper\"", "\"papper\"", &["papper", "LINE"]),
        ("albedo = 1.0", "albedo = 1.5", &["1.5", "[0, 1]", "LINE"]),
        ("theta_l_deg = [0.0, 10.0", "theta_l_deg = [0.0, -10.0", &["theta_l_deg = -10", "LINE"]),
        ("min = 1.0", "min = 0.0", &["min = 0", "LINE"]),
        ("stratiform/config/1", "stratiform/config/9", &["stratiform/config/9", "LINE"]),
        ("[fit]", "[fitt]", &["fitt"]),
        ("[fit]", "[fit", &["LINE"]),
    ];
    for (from, to, says) in faults {
        let text = config(&[(from, to)]);
        let line = text.lines().position(|line| line.contains(to.lines().last().unwrap())).unwrap() + 1;
        fs::write(dir.path().join("c.toml"), text).unwrap();
        let place = format!("c.toml:{line}");
        let says: Vec<_> = says.iter().map(|part| if *part == "LINE" { &place } else { *part }).collect();
        refused(to, &run(dir.path(), &["reproduce", "c.toml", "--out", "out"]), &says);
        assert!(!dir.path().join("out").exists(), "{to}: something was written");
    }
    for (what, bytes) in
        [("empty", &b""[..]), ("binary", &[0xff, 0xfe][..]), ("truncated", &b"schema = \"stra"[..])]
    {
        fs::write(dir.path().join("c.toml"), bytes).unwrap();
        refused(what, &run(dir.path(), &["fit", "c.toml", "--out", "out"]), &["c.toml"]);
    }
}

/// Targets that are none, and tables that generation refuses: nothing is written.
#[test]
fn code_that_cannot_be_generated() {
    let dir = tempfile::tempdir().unwrap();
    let accepted = common::root().join("fit-configs/appendix-b/accepted");
    let copy = dir.path().join("accepted");
    fs::create_dir(&copy).unwrap();
    for entry in fs::read_dir(accepted).unwrap() {
        let entry = entry.unwrap();
        fs::copy(entry.path(), copy.join(entry.file_name())).unwrap();
    }
    let output = "output = \"appendix-b/generated\"";
    let attempt = |targets: &str| {
        let accepted = ("appendix-b/accepted", copy.to_str().unwrap());
        fs::write(
            dir.path().join("c.toml"),
            config(&[accepted, (output, &format!("output = \"out\"\n{targets}"))]),
        )
        .unwrap();
        run(dir.path(), &["codegen", "c.toml"])
    };
    for (targets, says) in [
        ("targets = [\"cuda\"]", "cuda"),
        ("targets = []", "targets is empty"),
        ("targets = [\"c\", \"wgsl\", \"c\"]", "twice"),
        ("targets = \"c\"", "sequence"),
    ] {
        refused(targets, &attempt(targets), &["c.toml:", says]);
        assert!(!dir.path().join("out").exists(), "{targets}: something was written");
    }
    let parameters = copy.join("parameters.json");
    let text = fs::read_to_string(&parameters).unwrap();
    let mut document: serde_json::Value = serde_json::from_str(&text).unwrap();
    document["medium"]["extinction_per_m"] = serde_json::json!(1e39);
    fs::write(&parameters, document.to_string()).unwrap();
    refused("extinction", &attempt("targets = [\"c\"]"), &["extinction_per_m = 1"]);
    assert!(!dir.path().join("out").exists(), "something was written");
}

#[test]
fn places_that_cannot_be_written() {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("c.toml"), config(&[])).unwrap();
    fs::write(dir.path().join("file"), "").unwrap();
    for out in ["file", "file/inside", "/proc/stratiform"] {
        refused(out, &run(dir.path(), &["reproduce", "c.toml", "--out", out]), &["cannot", out]);
    }
    refused("report of nothing", &run(dir.path(), &["report", "nowhere"]), &["nowhere"]);
    if Path::new("/dev/full").exists() {
        let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let mut mie = command(dir.path(), &["mie", "--x", "1", "--m", "1.3,0"]);
        let output = mie.stdout(full).stderr(Stdio::piped()).spawn().unwrap().wait_with_output().unwrap();
        refused("a full disk", &output, &["standard output"]);
    }
}
