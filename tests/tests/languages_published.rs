//! Another table than the committed one, the published Appendix B, through a language of each kind.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

#[path = "../../crates/codegen/tests/common/mod.rs"]
mod common;

use stratiform_codegen::{Target, generate, write};
use stratiform_tests::languages::Emitted;
use stratiform_tests::languages::comparator::{errors, wrong};
use stratiform_tests::languages::library::{FLUXES, Run};
use stratiform_tests::languages::ways::ways;

#[test]
fn the_published_table_is_reproduced() {
    let folder = tempfile::tempdir().unwrap();
    write(&generate(&common::inputs(), &Target::ALL).unwrap(), folder.path()).unwrap();
    let emitted = Emitted::at(folder.path().to_owned());
    let input = emitted.input();
    let run = Run { library: &FLUXES, table: None, input: &input, beside: &[] };
    for ending in ["wgsl", "450.glsl", "h", "rs"] {
        let text = emitted.text(&format!("stratiform.{ending}"));
        let way = ways(ending).next().unwrap();
        let Some(output) = way.execute(&run, &text) else { continue };
        let measured = errors(&emitted.test, &output.values);
        assert!(wrong(&measured).is_empty() && output.wrong == 0, "{}: {measured:?}", way.name);
        // A rounded constant.
        let planted = text.replacen("0.545", "0.5451", 1);
        assert_ne!(planted, text);
        let output = way.execute(&run, &planted).unwrap();
        assert!(!wrong(&errors(&emitted.test, &output.values)).is_empty(), "{}: planted", way.name);
    }
}
