//! The job scripts in `scripts/`, as far as they go without a cluster: what one element does, out of order and twice,
//! killed half-way, and the merging.
#![cfg(unix)]
#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::{root, stdout};
use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use yaml_rust2::{Yaml, YamlLoader};

const TRACE: [&str; 9] =
    ["trace", "--phase", "hg:0.85", "--tau", "1,16", "--mu0", "1,diffuse", "--photons", "20001"];

fn slurm(dir: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(root().join("scripts/slurm-array.sh"));
    command.args(args).current_dir(dir).env("STRATIFORM", env!("CARGO_BIN_EXE_stratiform"));
    command
}

/// Element `k` of `n`, as Slurm starts it.
fn task(dir: &Path, k: &str, n: &str, options: &[&str]) -> Command {
    let mut command = slurm(dir, &[&["task", "."], options].concat());
    command.envs([("SLURM_ARRAY_TASK_ID", k), ("SLURM_ARRAY_TASK_COUNT", n)]);
    command
}

fn ok(output: &Output) {
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn elements_of_an_array_in_any_order_merge_to_the_bytes_of_one_process() {
    let dir = tempfile::tempdir().unwrap();
    let dir = dir.path();
    for k in ["3", "1", "2", "1"] {
        ok(&task(dir, k, "3", &TRACE[1..]).output().unwrap());
    }
    ok(&slurm(dir, &["merge", "3", "."]).output().unwrap());
    assert_eq!(fs::read_to_string(dir.join("result.csv")).unwrap(), stdout(dir, &TRACE));
    ok(&slurm(dir, &["merge", "3", "."]).env("JSON", "1").output().unwrap());
    let json = stdout(dir, &[&TRACE[..], &["--json"]].concat());
    assert_eq!(fs::read_to_string(dir.join("result.json")).unwrap(), json);
    let other = task(dir, "2", "3", &[&TRACE[1..], &["--seed", "2"]].concat()).output().unwrap();
    assert_eq!(other.status.code(), Some(2), "a folder is for one trace");
}

#[test]
fn a_lost_element_is_named_and_nothing_is_written() {
    let dir = tempfile::tempdir().unwrap();
    for k in ["1", "3"] {
        ok(&task(dir.path(), k, "3", &TRACE[1..]).output().unwrap());
    }
    let output = slurm(dir.path(), &["merge", "3", "."]).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("part-2.bin"));
    assert!(!dir.path().join("result.csv").exists());
}

/// A stand-in for `scontrol` sees that a task that is told to end asks to be queued again; started again, it goes on.
#[test]
fn a_task_that_is_told_to_end_queues_again_and_goes_on() {
    let dir = tempfile::tempdir().unwrap();
    let long = [&TRACE[1..8], &["5e5", "--estimator", "plain"]].concat();
    common::program(dir.path(), "scontrol", "echo \"$@\" >>scontrol.log");
    let path = format!("{}:{}", dir.path().display(), std::env::var("PATH").unwrap());
    let mut first = task(dir.path(), "1", "2", &long);
    let mut first = first.envs([("SLURM_ARRAY_JOB_ID", "17"), ("PATH", &path)]).spawn().unwrap();
    common::wait_for(&dir.path().join("part-1.ckpt"));
    let told = Command::new("kill").args(["-TERM", &first.id().to_string()]).status().unwrap();
    assert!(told.success() && first.wait().unwrap().success());
    assert_eq!(fs::read_to_string(dir.path().join("scontrol.log")).unwrap(), "requeue 17_1\n");
    assert!(!dir.path().join("part-1.bin").exists());
    for k in ["1", "2"] {
        ok(&task(dir.path(), k, "2", &long).output().unwrap());
    }
    ok(&slurm(dir.path(), &["merge", "2", "."]).output().unwrap());
    let whole = stdout(dir.path(), &[&["trace"], &long[..]].concat());
    assert_eq!(fs::read_to_string(dir.path().join("result.csv")).unwrap(), whole);
}

/// A stand-in for `sbatch` sees the two submissions.
#[test]
fn submitting_makes_an_array_and_a_merge_that_waits_for_it() {
    let dir = tempfile::tempdir().unwrap();
    common::program(dir.path(), "sbatch", "echo \"$@\" >>sbatch.log; echo 17");
    let path = format!("{}:{}", dir.path().display(), std::env::var("PATH").unwrap());
    let submit = [&["submit", "40", "out"], &TRACE[1..]].concat();
    ok(&slurm(dir.path(), &submit).env("PATH", &path).env("SBATCH_OPTIONS", "--time=5").output().unwrap());
    let log = fs::read_to_string(dir.path().join("sbatch.log")).unwrap();
    let lines: Vec<&str> = log.lines().collect();
    assert_eq!(lines.len(), 2);
    for word in ["--array=1-40", "--requeue", "--time=5", " task ", "/out --phase hg:0.85 --tau 1,16"] {
        assert!(lines[0].contains(word), "{word}: {log}");
    }
    for word in ["--dependency=afterok:17", " merge 40 ", "--time=5"] {
        assert!(lines[1].contains(word), "{word}: {log}");
    }
    for args in [&["submit", "0", "out"][..], &["submit", "x", "out"], &[], &["other"]] {
        let refused = slurm(dir.path(), args).env("PATH", &path).output().unwrap();
        assert_eq!((refused.status.code(), refused.stdout.len()), (Some(2), 0), "{args:?}");
    }
}

/// The container of job `index`: its command line, and the number of shards in its environment.
fn container(job: &Yaml) -> (Vec<String>, String) {
    let container = &job["spec"]["template"]["spec"]["containers"][0];
    let words = ["command", "args"].into_iter().flat_map(|key| container[key].as_vec().unwrap());
    let shards = container["env"][0]["value"].as_str().unwrap().to_owned();
    assert_eq!(container["env"][0]["name"].as_str(), Some("SHARDS"));
    (words.map(|word| word.as_str().unwrap().to_owned()).collect(), shards)
}

/// The shell lines of the manifest itself, with fewer photons, one pod after the other from the last to the first.
#[test]
fn the_pods_of_kubernetes_merge_to_the_bytes_of_one_process() {
    let dir = tempfile::tempdir().unwrap();
    let text = fs::read_to_string(root().join("scripts/kubernetes-job.yaml")).unwrap();
    let jobs = YamlLoader::load_from_str(&text.replace("--photons 1e10", "--photons 3001")).unwrap();
    let [trace, merge] = &jobs[..] else { panic!("two jobs") };
    let (line, shards) = container(trace);
    assert_eq!(trace["spec"]["completionMode"].as_str(), Some("Indexed"));
    assert_eq!(trace["spec"]["completions"].as_i64().map(|n| n.to_string()), Some(shards.clone()));
    let bin = Path::new(env!("CARGO_BIN_EXE_stratiform")).parent().unwrap();
    let path = format!("{}:{}", bin.display(), std::env::var("PATH").unwrap());
    let pod = |line: &[String], index: i64| {
        let mut pod = Command::new(&line[0]);
        pod.args(&line[1..]).current_dir(dir.path()).envs([("PATH", &path), ("SHARDS", &shards)]);
        let output = pod.env("JOB_COMPLETION_INDEX", index.to_string()).output().unwrap();
        ok(&output);
        String::from_utf8(output.stdout).unwrap()
    };
    for index in (0..shards.parse().unwrap()).rev().chain([3]) {
        assert_eq!(pod(&line, index), "");
    }
    let (line, same) = container(merge);
    assert_eq!(same, shards);
    let whole = ["trace", "--phase", "hg:0.85", "--tau", "16", "--mu0", "1,diffuse", "--photons", "3001"];
    assert_eq!(pod(&line, 0), stdout(dir.path(), &whole));
}
