//! What of the emitted code a method is.

use serde::{Deserialize, Serialize};

/// A library of `stratiform codegen` and the functions to call.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Emitted {
    /// Stem of the files: `stratiform_shade.wgsl` and so on.
    pub library: String,
    /// Their names.
    pub functions: Vec<String>,
}

/// Where the method called `name` stands in what is emitted; `None` for methods that are not.
pub(crate) fn emitted(name: &str) -> Option<Emitted> {
    let (library, functions) = match stem(name) {
        "fitted" => ("stratiform_shade", "stratiform_shade_top stratiform_shade_bottom"),
        "fitted-halo" => ("stratiform_shade", "stratiform_shade_top stratiform_shade_bottom stratiform_halo"),
        stem if is_refitted(stem) => {
            ("stratiform_radiance", "stratiform_radiance_top stratiform_radiance_bottom")
        }
        _ => return None,
    };
    let functions = functions.split(' ').map(str::to_owned).collect();
    Some(Emitted { library: library.to_owned(), functions })
}

/// The name without its knob.
pub(crate) fn stem(name: &str) -> &str {
    name.split(':').next().unwrap_or(name)
}

/// Whether parameters over θ_l and r_e are fitted for it.
pub(crate) fn is_refitted(stem: &str) -> bool {
    stem == "bouthors-family" || stem.starts_with("bouthors-corrected")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn knobs_do_not_change_what_is_emitted() {
        assert_eq!(emitted("fitted:64").unwrap().library, "stratiform_shade");
        assert_eq!(emitted("bouthors-corrected-escape:256").unwrap().library, "stratiform_radiance");
        assert!(emitted("bouthors-printed").is_none() && emitted("octaves:8").is_none());
    }
}
