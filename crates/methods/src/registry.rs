//! Every method by its name.
//!
//! A name is a stem, or a stem and a knob: `octaves:8`, `monte-carlo:1e4`. [`by_name`] takes both, [`all`] gives each stem once with its
//! usual knob, [`knobs`] the values that a curve of a knob runs through.

use crate::rivals::bouthors::{self, Reading, Table};
use crate::rivals::monte_carlo::{self, Geometry};
use crate::rivals::two_stream::{self, Closure};
use crate::rivals::{
    asymptotic, beer_powder, fitted, multiple_forward, octaves, single_scattering, solver, successive,
};
use crate::{Method, MethodError};
use stratiform_model::angular::Emission;
use stratiform_quantities::{Medium, Range};

type Made = Result<Box<dyn Method>, MethodError>;

/// A number that trades cost for accuracy.
#[derive(Clone, Debug, PartialEq)]
pub struct Knob {
    /// What it counts.
    pub counts: &'static str,
    /// Where it may be; whole numbers.
    pub range: Range,
    /// The values of a curve, rising in cost.
    pub values: &'static [f64],
    /// Its value in [`all`]; `None` where the method without knob is another one.
    pub usual: Option<f64>,
}

struct Entry {
    stem: &'static str,
    knob: Option<Knob>,
    make: Box<dyn Fn(Option<f64>) -> Box<dyn Method>>,
}

fn plain<M: Method + 'static>(stem: &'static str, make: impl Fn() -> M + 'static) -> Entry {
    Entry { stem, knob: None, make: Box::new(move |_| Box::new(make())) }
}

fn turned<M: Method + 'static>(
    stem: &'static str,
    knob: Knob,
    usual: f64,
    make: impl Fn(f64) -> M + 'static,
) -> Entry {
    let knob = Knob { usual: Some(usual), ..knob };
    Entry { stem, knob: Some(knob), make: Box::new(move |value| Box::new(make(value.unwrap_or(usual)))) }
}

fn read(stem: &'static str, title: &'static str, table: Table, reading: Reading) -> Entry {
    let make = move |count: Option<f64>| -> Box<dyn Method> {
        let texels = count.map(|count| count as usize);
        Box::new(bouthors::method((stem, texels), title, table, reading))
    };
    Entry { stem, knob: Some(texels()), make: Box::new(make) }
}

fn bouthors(stem: &'static str, title: &'static str, table: Table, emission: Emission) -> Entry {
    read(stem, title, table, Reading::Corrected(emission))
}

fn shaded(stem: &'static str, title: &'static str, with_halo: bool) -> Entry {
    let make = move |count: Option<f64>| -> Box<dyn Method> {
        Box::new(fitted::method((stem, count.map(|count| count as usize)), title, with_halo))
    };
    Entry { stem, knob: Some(texels()), make: Box::new(make) }
}

fn knob(counts: &'static str, range: Range, values: &'static [f64]) -> Knob {
    Knob { counts, range, values, usual: None }
}

const TEXELS: Range = stratiform_tables::sampled::TEXELS;

fn texels() -> Knob {
    knob("texels", TEXELS, &[64.0, 128.0, 256.0, 512.0, 1024.0])
}

fn photons() -> Knob {
    knob("photons", Range::closed(2.0, 1e12), &[1e2, 1e3, 1e4])
}

fn entries() -> Vec<Entry> {
    let octave_knob = knob("octaves", Range::closed(1.0, 32.0), &[1.0, 2.0, 3.0, 4.0, 8.0, 16.0]);
    let streams = knob("streams per hemisphere", Range::closed(2.0, 128.0), &[2.0, 4.0, 8.0, 16.0, 32.0]);
    let orders = knob("orders", Range::closed(1.0, 60.0), &[1.0, 2.0, 5.0, 10.0, 20.0, 60.0]);
    let mut entries = vec![
        Entry {
            stem: "single-mie",
            knob: Some(texels()),
            make: Box::new(|count| match count {
                None => Box::new(single_scattering::mie()),
                Some(count) => Box::new(single_scattering::mie_texels(count as usize)),
            }),
        },
        plain("single-hg", single_scattering::hg),
        plain("single-hg-draine", single_scattering::hg_draine),
        plain("harris-lastra", multiple_forward::published),
        plain("multiple-forward", multiple_forward::of_cloud),
        turned("octaves", octave_knob, 8.0, |count| octaves::method(count as u32)),
        plain("beer-powder", beer_powder::method),
        plain("two-stream", || two_stream::method(Closure::Quadrature)),
        plain("delta-eddington", || two_stream::method(Closure::DeltaEddington)),
        plain("diffusion", || two_stream::method(Closure::Diffusion)),
        plain("asymptotic", asymptotic::method),
        read("bouthors-printed", "Bouthors 2006 as printed", Table::Published, Reading::Printed),
        bouthors(
            "bouthors-published",
            "Bouthors 2006, published table",
            Table::Published,
            Emission::Lambertian,
        ),
        bouthors(
            "bouthors-corrected",
            "Bouthors 2006, corrected and refitted",
            Table::Refitted,
            Emission::Lambertian,
        ),
        bouthors(
            "bouthors-corrected-isotropic",
            "The same, I3+ isotropic",
            Table::Refitted,
            Emission::Isotropic,
        ),
        bouthors(
            "bouthors-corrected-escape",
            "The same, I3+ by the escape function",
            Table::Refitted,
            Emission::Escape,
        ),
        read("bouthors-corrected-halo", "The same, with the halo", Table::Refitted, Reading::WithHalo),
        read(
            "bouthors-family",
            "Bouthors 2006, corrected, for every droplet size",
            Table::Family,
            Reading::NearestShapes,
        ),
        shaded("fitted", "Fitted radiance", false),
        shaded("fitted-halo", "Fitted radiance, with the halo", true),
        turned("orders", orders, 2.0, |count| successive::method(count as u32)),
        turned("solver", streams, 16.0, |count| solver::method(count as usize)),
    ];
    for geometry in [Geometry::Plain, Geometry::HalfSpace] {
        for medium in [Medium::Full, Medium::Modified] {
            let make = move |photons| monte_carlo::method(geometry, medium, photons);
            entries.push(turned(monte_carlo::stem(geometry, medium), photons(), 1e4, make));
        }
    }
    entries
}

/// Every method once, with its usual knob.
pub fn all() -> Vec<Box<dyn Method>> {
    entries().iter().map(|entry| (entry.make)(None)).collect()
}

/// The method of this name, with or without a knob.
///
/// # Errors
/// [`MethodError::Unknown`], with the names there are; [`MethodError::Knob`] or [`MethodError::Domain`] for what stands after the colon.
pub fn by_name(name: &str) -> Made {
    let (stem, text) = name.split_once(':').map_or((name, None), |(stem, text)| (stem, Some(text)));
    let entries = entries();
    let Some(entry) = entries.iter().find(|entry| entry.stem == stem) else {
        let known: Vec<&str> = entries.iter().map(|entry| entry.stem).collect();
        return Err(MethodError::Unknown { name: name.to_owned(), known: known.join(", ") });
    };
    let Some(text) = text else { return Ok((entry.make)(None)) };
    let refused = |reason: String| MethodError::Knob { name: name.to_owned(), reason };
    let knob = entry.knob.as_ref().ok_or_else(|| refused(format!("{stem} takes no number")))?;
    let value: f64 = text.parse().map_err(|_| refused(format!("`{text}` is no number")))?;
    knob.range.check(&format!("{stem}: {}", knob.counts), value)?;
    if value.fract() != 0.0 {
        return Err(refused(format!("{} are a whole number", knob.counts)));
    }
    Ok((entry.make)(Some(value)))
}

/// The knob of the method with this stem.
pub fn knobs(stem: &str) -> Option<Knob> {
    entries().into_iter().find(|entry| entry.stem == stem)?.knob
}
