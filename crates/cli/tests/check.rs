//! `stratiform check` on this project's own table and tracer.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::{command, config, root, run, stdout};
use serde_json::Value;
use std::fs;
use std::path::Path;
use stratiform_reference_data::sha256;

/// The paper's config as `c.toml`, with absolute paths to what it names; `keys` are set to other paths instead.
fn write_config(dir: &Path, keys: &[(&str, &str)]) {
    let accepted = root().join("fit-configs/appendix-b/accepted");
    let counts = stratiform_reference_data::root().join("paper-cloud-counts/counts.csv");
    let named = [("accepted", accepted.to_str().unwrap()), ("counts", counts.to_str().unwrap())];
    let path = |key: &str| keys.iter().chain(&named).find(|(name, _)| *name == key).map(|(_, path)| *path);
    let line = |line: &str| match line.split_once(" = ").map(|(key, _)| (key, path(key))) {
        Some((key, Some(path))) => format!("{key} = \"{path}\"\n"),
        _ => format!("{line}\n"),
    };
    let text: String = config(&[("[0.65, 0.55, 0.45]", "[0.55]")]).lines().map(line).collect();
    fs::write(dir.join("c.toml"), text).unwrap();
}

fn parsed(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

#[test]
fn the_committed_table_and_the_tracer_pass_in_every_format_with_any_number_of_threads() {
    let dir = tempfile::tempdir().unwrap();
    write_config(dir.path(), &[]);
    let outputs = ["1", "2"].map(|threads| {
        let (xml, page) = (format!("{threads}.xml"), format!("{threads}.md"));
        let args = ["check", "c.toml", "--photons", "4e3", "--threads", threads];
        let text = stdout(dir.path(), &[&args[..], &["--junit", &xml, "--markdown", &page]].concat());
        let json = stdout(dir.path(), &[&args[..], &["--json"]].concat());
        [
            text,
            json,
            fs::read_to_string(dir.path().join(xml)).unwrap(),
            fs::read_to_string(dir.path().join(page)).unwrap(),
        ]
    });
    assert_eq!(outputs[0], outputs[1]);
    let [text, json, xml, page] = &outputs[0];
    assert!(text.ends_with("comparisons, all within their bounds\n"), "{text}");
    assert!(page.starts_with("## stratiform check passed\n"), "{page}");
    let document = parsed(json);
    assert_eq!(document["schema"], "stratiform/check/1");
    assert_eq!((&document["passed"], &document["failed"]), (&Value::Bool(true), &Value::from(0)));
    let compared: Vec<_> =
        document["parts"].as_array().unwrap().iter().map(|part| part["compared"].as_u64().unwrap()).collect();
    assert!(compared[0] > 1500 && compared[1] > 1500, "guard against checking nothing: {compared:?}");
    let tree = roxmltree::Document::parse(xml).unwrap();
    let cases: Vec<_> = tree.descendants().filter(|node| node.has_tag_name("testcase")).collect();
    assert!(cases.iter().any(|case| case.attribute("name") == Some("transmittance order total")));
    assert_eq!(tree.descendants().filter(|node| node.has_tag_name("failure")).count(), 0);
}

/// `accepted` in `dir`: a copy of the committed table, edited.
fn copy_table(dir: &Path, edit: impl Fn(&mut Value)) {
    let folder = dir.join("accepted");
    fs::create_dir_all(&folder).unwrap();
    for entry in fs::read_dir(root().join("fit-configs/appendix-b/accepted")).unwrap() {
        let path = entry.unwrap().path();
        fs::copy(&path, folder.join(path.file_name().unwrap())).unwrap();
    }
    let file = folder.join("parameters.json");
    let mut table = parsed(&fs::read_to_string(&file).unwrap());
    edit(&mut table);
    fs::write(&file, table.to_string()).unwrap();
}

/// Multiplies a number.
fn scale(number: &mut Value, factor: f64) {
    *number = Value::from(number.as_f64().unwrap() * factor);
}

/// Value and emitted number of a parameter, in both tables.
fn scale_everywhere(document: &mut Value, row: usize, parameter: &str, factor: f64) {
    for table in ["optical", "metres"] {
        for field in ["value", "emitted"] {
            scale(&mut document[table]["rows"][row][parameter][field], factor);
        }
    }
}

/// The quantities that a check of the edited table finds wrong.
fn wrong(dir: &Path, edit: impl Fn(&mut Value)) -> Vec<String> {
    copy_table(dir, edit);
    let args = ["check", "c.toml", "--photons", "10", "--json", "--worst", "99"];
    let output = run(dir, &args);
    let document = parsed(&String::from_utf8(output.stdout).unwrap());
    let offenders = document["offenders"].as_array().unwrap().iter();
    let wrong: Vec<_> = offenders.map(|one| one["quantity"].as_str().unwrap().to_owned()).collect();
    assert_eq!(output.status.code(), Some(i32::from(!wrong.is_empty())));
    wrong
}

/// What is emitted is held, whatever stands beside it. Row 4 is 40 degrees, row 5 is 50 degrees, without a c.
#[test]
fn what_is_emitted_is_held() {
    let dir = tempfile::tempdir().unwrap();
    write_config(dir.path(), &[("accepted", "accepted")]);
    assert!(wrong(dir.path(), |_| ()).is_empty());
    for (parameter, factor) in
        [("kappa_c", 1.05), ("t", 1.05), ("r", 1.05), ("c", 1.05), ("b", 1.05), ("c", 2.0)]
    {
        let edit = |table: &mut Value| scale(&mut table["optical"]["rows"][4][parameter]["emitted"], factor);
        let wrong = wrong(dir.path(), edit);
        for name in ["parameter", "optical", "metres"] {
            let expected = format!("{name} {parameter}");
            // b, t and r are the same in both tables, so that the one in metres does not follow from either.
            assert!(wrong.contains(&expected), "{factor} {parameter}: no {expected} in {wrong:?}");
        }
    }
    for parameter in ["b", "c", "kappa_c", "t", "r"] {
        let wrong = wrong(dir.path(), |table| scale_everywhere(table, 4, parameter, 1.02));
        assert!(wrong.contains(&format!("parameter {parameter}")), "{parameter}: {wrong:?}");
        assert!(!wrong.iter().any(|name| name.starts_with("optical") || name.starts_with("metres")));
    }
    // Without a value c is held by what it makes of T_ms.
    let undetermined = wrong(dir.path(), |table| {
        for table_of in ["optical", "metres"] {
            let c = &mut table[table_of]["rows"][4]["c"];
            c["value"] = Value::Null;
            c["std_error"] = Value::Null;
            scale(&mut c["emitted"], 2.0);
        }
    });
    assert!(undetermined.contains(&"t_ms of b and c".to_owned()), "{undetermined:?}");
    let at_50 = wrong(dir.path(), |table| {
        for of in ["optical", "metres"] {
            scale(&mut table[of]["rows"][5]["c"]["emitted"], 2.0);
        }
    });
    assert!(at_50.contains(&"t_ms of b and c".to_owned()), "{at_50:?}");
}

/// The table in metres is the optical one times the extinction, in every number; and the medium is the config's.
#[test]
fn the_table_in_metres_follows_from_the_optical_one() {
    let dir = tempfile::tempdir().unwrap();
    write_config(dir.path(), &[("accepted", "accepted")]);
    let kappa_c = wrong(dir.path(), |table| {
        for row in table["metres"]["rows"].as_array_mut().unwrap() {
            for field in ["value", "std_error", "emitted"] {
                scale(&mut row["kappa_c"][field], 1.05);
            }
        }
    });
    assert!(kappa_c.len() == 33 && kappa_c.iter().all(|name| name == "metres kappa_c"), "{kappa_c:?}");
    let error = wrong(dir.path(), |table| scale(&mut table["metres"]["rows"][9]["t"]["std_error"], 1.05));
    assert_eq!(error, ["metres t"]);
    for (name, field) in [("metres beta", "value"), ("metres beta", "std_error")] {
        assert_eq!(wrong(dir.path(), |table| scale(&mut table["metres"]["beta"][field], 1.001)), [name]);
    }
    assert_eq!(wrong(dir.path(), |table| scale(&mut table["metres"]["kappa_s"], 1.001)), ["metres kappa_s"]);
    let optical = wrong(dir.path(), |table| scale(&mut table["optical"]["kappa_s"], 1.001));
    assert_eq!(optical, ["metres kappa_s", "optical kappa_s"]);
    let beta = wrong(dir.path(), |table| scale(&mut table["optical"]["beta"]["value"], 1.001));
    assert!(beta.contains(&"parameter beta".to_owned()), "{beta:?}");
    let medium = wrong(dir.path(), |table| scale(&mut table["medium"]["extinction_per_m"], 1.001));
    assert!(medium.contains(&"extinction_per_m".to_owned()), "{medium:?}");
}

/// 2 % in t at 40 degrees: exit 1, everything printed and written all the same.
#[test]
fn a_slip_in_the_table_is_named() {
    let dir = tempfile::tempdir().unwrap();
    copy_table(dir.path(), |table| scale_everywhere(table, 4, "t", 1.02));
    write_config(dir.path(), &[("accepted", "accepted")]);
    let args = ["check", "c.toml", "--photons", "1e3", "--json", "--worst", "1"];
    let output = run(dir.path(), &[&args[..], &["--junit", "a.xml", "--markdown", "a.md"]].concat());
    assert_eq!(output.status.code(), Some(1), "{}", String::from_utf8_lossy(&output.stderr));
    let document = parsed(&String::from_utf8(output.stdout).unwrap());
    assert_eq!((&document["passed"], &document["failed"]), (&Value::Bool(false), &Value::from(1)));
    let offender = &document["offenders"][0];
    assert_eq!((&offender["quantity"], &offender["theta_l_deg"]), (&"parameter t".into(), &40.0.into()));
    let xml = fs::read_to_string(dir.path().join("a.xml")).unwrap();
    let tree = roxmltree::Document::parse(&xml).unwrap();
    let failed: Vec<_> = tree.descendants().filter(|node| node.has_tag_name("failure")).collect();
    assert_eq!(failed.len(), 1);
    assert_eq!(failed[0].parent().unwrap().attribute("name"), Some("parameter t"));
    let page = fs::read_to_string(dir.path().join("a.md")).unwrap();
    assert!(
        page.starts_with("## stratiform check FAILED\n")
            && page.contains("- model: parameter t at theta_l 40")
    );
}

/// Stored counts come out the same for any number of threads. Counts that were edited are refused by their hash; with a
/// new hash the tracer differs from them, and says where.
#[test]
fn stored_counts_are_reproducible_and_guarded() {
    let dir = tempfile::tempdir().unwrap();
    write_config(dir.path(), &[("counts", "counts/counts.csv")]);
    let folder = dir.path().join("counts");
    fs::create_dir(&folder).unwrap();
    for (name, threads) in [("counts/counts.csv", "1"), ("other.csv", "2")] {
        let args = ["check", "c.toml", "--store-counts", name, "--photons", "4e3", "--threads", threads];
        assert_eq!(stdout(dir.path(), &args), format!("{name}\n"));
    }
    let text = fs::read_to_string(folder.join("counts.csv")).unwrap();
    assert_eq!(text, fs::read_to_string(dir.path().join("other.csv")).unwrap());
    assert!(text.starts_with("medium,theta_l_deg,tau,order,photons,reflected,transmitted\n"));
    let source = |text: &str| {
        let hash = sha256(text.as_bytes());
        let source = format!(
            "title='t'\ncitation='c'\norigin='o'\nlicence='l'\ndigits='d'\n[files]\n'counts.csv'='{hash}'\n"
        );
        fs::write(folder.join("SOURCE.toml"), source).unwrap();
    };
    source(&text);
    let check = ["check", "c.toml", "--photons", "4e3"];
    stdout(dir.path(), &check);

    // Transmitted at theta_l = 0, tau = 1, order 1 of the full medium: one and a half times as many.
    let row = text.lines().find(|line| line.starts_with("full,0.0,1.0,1,")).unwrap();
    let (front, hits) = row.rsplit_once(',').unwrap();
    let more = format!("{front},{}", hits.parse::<u64>().unwrap() * 3 / 2);
    let edited = text.replace(row, &more);
    fs::write(folder.join("counts.csv"), &edited).unwrap();
    let refused = run(dir.path(), &check);
    assert_eq!(refused.status.code(), Some(2));
    assert!(refused.stdout.is_empty() && String::from_utf8_lossy(&refused.stderr).contains("SHA-256"));
    source(&edited);
    let differs = run(dir.path(), &check);
    assert_eq!(differs.status.code(), Some(1));
    let said = String::from_utf8(differs.stdout).unwrap();
    assert!(said.contains("tracer: transmittance order 1 at theta_l 0, tau 1, medium full"), "{said}");

    let shorter = text.replacen(&format!("{row}\n"), "", 1);
    fs::write(folder.join("counts.csv"), &shorter).unwrap();
    source(&shorter);
    let missing = run(dir.path(), &check);
    assert_eq!(missing.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&missing.stderr).contains("no counts at theta_l 0, tau 1"));
}

#[test]
fn misuse_is_exit_2() {
    let dir = tempfile::tempdir().unwrap();
    write_config(dir.path(), &[("counts", "nowhere/counts.csv")]);
    for (args, says) in [
        (&["check"][..], "CONFIG"),
        (&["check", "nowhere.toml"], "nowhere.toml"),
        (&["check", "c.toml", "--photons", "1e3"], "nowhere/SOURCE.toml"),
        (&["check", "c.toml", "--photons", "0"], "`0`"),
        (&["check", "c.toml", "--seed", "1729"], "not be fresh"),
        (&["check", "c.toml", "--values", "v.csv", "--photons", "9"], "cannot be used with"),
        (&["check", "c.toml", "--points", "p.csv", "--values", "v.csv"], "cannot be used with"),
        (
            &["check", "c.toml", "--points", "nowhere/p.csv"],
            "cannot write nowhere/p.csv: its folder does not exist",
        ),
    ] {
        let output = run(dir.path(), args);
        let error = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{args:?}: {error}");
        assert!(output.stdout.is_empty() && error.contains(says), "{args:?}: {error}");
    }
}

#[cfg(unix)]
#[test]
fn an_interrupted_check_prints_and_writes_nothing() {
    use std::process::{Command, Stdio};
    let dir = tempfile::tempdir().unwrap();
    write_config(dir.path(), &[]);
    let args = ["check", "c.toml", "--photons", "1e12", "--junit", "a.xml"];
    let child = command(dir.path(), &args).stdout(Stdio::piped()).stderr(Stdio::null()).spawn().unwrap();
    std::thread::sleep(std::time::Duration::from_millis(1500));
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130));
    assert!(output.stdout.is_empty() && !dir.path().join("a.xml").exists());
}
