//! `stratiform mie`: one homogeneous sphere.

use crate::CliError;
use crate::args::MieArgs;
use crate::output::Data;
use std::fmt::Write;
use stratiform_artifact::to_json;
use stratiform_optics::mie::{self, document::MieDocument};

/// Runs the command.
///
/// # Errors
/// [`CliError::Input`] for numbers out of domain.
pub fn run(args: &MieArgs) -> Result<Data, CliError> {
    let sphere = mie::scatter(args.x, args.m, &args.angles)?;
    let document = MieDocument::new(args.x, args.m, &sphere);
    if args.json {
        return Ok(to_json(&document)?);
    }
    let mut text = format!("q_ext {}\nq_sca {}\ng     {}\n", document.q_ext, document.q_sca, document.g);
    if !document.angles.is_empty() {
        text.push_str("theta_deg,s1_re,s1_im,s2_re,s2_im\n");
    }
    for angle in &document.angles {
        let _ = writeln!(
            text,
            "{},{},{},{},{}",
            angle.theta_deg, angle.s1[0], angle.s1[1], angle.s2[0], angle.s2[1]
        );
    }
    Ok(text)
}
