//! Shards and their sum: the bytes of one process, or a refusal that says what is wrong.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::{refused, run, stdout};
use std::fs;
use std::path::Path;

const TRACE: [&str; 9] =
    ["trace", "--phase", "hg:0.85", "--tau", "1,16", "--mu0", "1,0.5,diffuse", "--photons", "30001"];

fn trace(more: &[&str]) -> Vec<String> {
    TRACE.iter().chain(more).map(|word| (*word).to_owned()).collect()
}

/// Traces shard `k` of `n` into `part{k}.bin`; prints nothing.
fn shard(dir: &Path, k: usize, n: usize, more: &[&str]) -> String {
    let (share, file) = (format!("{k}/{n}"), format!("part{k}.bin"));
    let args = trace(&[&["--shard", &share, "--out", &file][..], more].concat());
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    assert_eq!(stdout(dir, &args), "");
    file
}

#[test]
fn shards_sum_up_to_the_bytes_of_one_process() {
    let dir = tempfile::tempdir().unwrap();
    let whole = stdout(dir.path(), &TRACE);
    let json = stdout(dir.path(), &[&TRACE[..], &["--json"]].concat());
    for n in [1, 3] {
        let threads = ["1", "2"][n % 2];
        let mut files: Vec<String> =
            (1..=n).map(|k| shard(dir.path(), k, n, &["--threads", threads])).collect();
        files.rotate_left(n / 2);
        let merge: Vec<&str> = ["merge"].into_iter().chain(files.iter().map(String::as_str)).collect();
        assert_eq!(stdout(dir.path(), &merge), whole);
        assert_eq!(stdout(dir.path(), &[&merge[..], &["--json"]].concat()), json);
    }
    let head = fs::read(dir.path().join("part1.bin")).unwrap();
    let line = head.split(|byte| *byte == b'\n').next().unwrap();
    let header: serde_json::Value = serde_json::from_slice(line).unwrap();
    assert_eq!(header["schema"], "stratiform/trace-part/1");
    assert_eq!(header["about"]["shard"], "1/3");
}

/// Two halves and two quarters, a shard under a checkpoint, and a tracer that is not the default.
#[test]
fn shards_of_any_cut_make_the_whole() {
    let dir = tempfile::tempdir().unwrap();
    let trace = |more: &[&str]| {
        let args = ["trace", "--phase", "rayleigh", "--tau", "2", "--mu0", "0.3", "--photons", "999"];
        stdout(dir.path(), &[&args[..], &["--estimator", "plain"], more].concat())
    };
    trace(&["--shard", "1/2", "--out", "a"]);
    trace(&["--shard", "3/4", "--out", "b", "--checkpoint", "b.ckpt", "--checkpoint-every", "0"]);
    trace(&["--shard", "3/4", "--out", "b2", "--checkpoint", "b.ckpt"]);
    trace(&["--shard", "4/4", "--out", "c"]);
    assert_eq!(fs::read(dir.path().join("b")).unwrap(), fs::read(dir.path().join("b2")).unwrap());
    assert_eq!(stdout(dir.path(), &["merge", "c", "a", "b.ckpt"]), trace(&[]));
    let overlap = run(dir.path(), &["merge", "a", "b", "c", "b2"]);
    refused("a file twice", &overlap, &["b2: ", "shard 3/4", "so is b"]);
    trace(&["--shard", "2/3", "--out", "d"]);
    let overlap = run(dir.path(), &["merge", "a", "d", "c"]);
    refused("overlap", &overlap, &["d: mu0 = 0.3", "photons 333 to 498 would be counted twice"]);
    let gap = run(dir.path(), &["merge", "a", "c"]);
    refused("a gap", &gap, &["mu0 = 0.3", "250 photons are missing, from photon 499 to 748 first"]);
}

#[test]
fn what_does_not_belong_together_is_refused_by_name() {
    let dir = tempfile::tempdir().unwrap();
    let dir = dir.path();
    (1..=3).for_each(|k| drop(shard(dir, k, 3, &[])));
    let merge = |files: &[&str]| run(dir, &[&["merge"], files].concat());
    refused("nothing", &merge(&[]), &["FILE"]);
    refused("one of three", &merge(&["part2.bin"]), &["2 of 3 shards are missing: 1/3, 3/3"]);
    refused("no file", &merge(&["part1.bin", "missing.bin"]), &["cannot read missing.bin"]);
    fs::write(dir.join("table.csv"), "tau,mu0\n1,1\n").unwrap();
    refused("a table", &merge(&["table.csv"]), &["table.csv: it is no part of a trace"]);
    let foreign: [(&[&str], &str); 4] = [
        (&["--seed", "8"], "its seed is 8, not 1"),
        (&["--orders", "3"], "its orders is 3, not 2"),
        (&["--omega", "0.5"], "its medium.single_scattering_albedo is 0.5, not 1.0"),
        (&["--estimator", "plain"], "its estimator is \"plain\", not \"half-space\""),
    ];
    for (more, difference) in foreign {
        shard(dir, 3, 3, more);
        let says = ["part3.bin: it belongs to another trace", difference];
        refused(difference, &merge(&["part1.bin", "part2.bin", "part3.bin"]), &says);
    }
}

#[test]
fn shards_that_are_none_are_refused() {
    let dir = tempfile::tempdir().unwrap();
    let cases: [(&[&str], &str); 10] = [
        (&["--shard", "0/4", "--out", "x"], "`0/4` is not K/N with whole numbers 1 <= K <= N"),
        (&["--shard", "5/4", "--out", "x"], "`5/4`"),
        (&["--shard", "1/0", "--out", "x"], "`1/0`"),
        (&["--shard", "one", "--out", "x"], "`one`"),
        (&["--shard", "1/2"], "--out"),
        (&["--out", "x"], "--shard"),
        (&["--shard", "1/2", "--out", "x", "--std-error", "1e-3"], "cannot be split"),
        (&["--shard", "1/2", "--out", "x", "--checkpoint", "x"], "same file"),
        (&["--checkpoint", "x", "--checkpoint-every", "-1"], "`-1`"),
        (&["--checkpoint", "missing/x"], "missing/x"),
    ];
    for (more, says) in cases {
        refused(says, &run(dir.path(), &[&TRACE[..], more].concat()), &[says]);
        assert!(!dir.path().join("x").exists(), "{says}: something was written");
    }
    let radiance =
        ["trace", "--phase", "isotropic", "--tau", "1", "--mu0", "1", "--photons", "9", "--view-mu", "1"];
    for more in [&["--checkpoint", "x"][..], &["--shard", "1/2", "--out", "x"]] {
        refused("radiance", &run(dir.path(), &[&radiance[..], more].concat()), &["for fluxes"]);
    }
    assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 0);
}
