//! The library of the halo: light that met forward events only, around the sun behind a layer.

use crate::language::{Glue, Library};
use crate::phase_library::versine;
use crate::radiance_test::Twin;
use crate::shader::{cases, medium_line};
use crate::table_access::Table;
use crate::text::{banner, fill, literal};
use crate::{CodegenError, HaloTable, Inputs};

/// μ_l, μ_v, Θ in degrees and τ of the embedded self-test.
const TESTED: [[f64; 4]; 5] = [
    [0.8, 0.8, 0.2, 0.5],
    [0.8, 0.79, 2.0, 2.0],
    [0.5, 0.52, 4.0, 6.0],
    [0.9, 0.95, 7.0, 1.0],
    [1.0, 1.0, 1.0, 40.0],
];

/// The library, which stands below `needs`.
pub(crate) fn library<'a>(
    inputs: &Inputs,
    halo: &HaloTable,
    needs: Vec<&'a Library<'a>>,
) -> Result<Library<'a>, CodegenError> {
    let (columns, rows) = (halo.angles, halo.values.len() / halo.angles);
    let mut places = vec![
        ("FORWARD", literal(inputs.parameters.medium.forward_fraction)),
        ("COLUMNS", columns.to_string()),
        ("ROWS", rows.to_string()),
        ("ACROSS", literal((columns - 1) as f64 * 0.5_f64.sqrt() / halo.reach)),
        ("ALONG", literal((rows - 1) as f64 / halo.longest)),
    ];
    places.extend(self_test(inputs)?);
    let table = Table {
        prefix: "stratiform_halo",
        owner: "StratiformHalo halo = {phase, buffer}; halo.stratiform_halo(mu_l, mu_v, v, tau).",
        content: "Shape of the halo, row by row of the optical path",
        texture: format!("Its channel r holds `values` of halo.json, {rows} rows."),
        binding: 1,
        columns,
        values: halo.values.iter().map(|value| literal(*value)).collect(),
    };
    Ok(Library {
        head: head(inputs, halo),
        name: "stratiform_halo",
        code: fill(include_str!("wgsl/halo.wgsl"), &places),
        owner: Some("StratiformHalo"),
        glue: Some(Glue {
            function: "stratiform_halo_texel",
            text: Box::new(move |target| table.access(target)),
        }),
        needs,
    })
}

fn self_test(inputs: &Inputs) -> Result<[(&'static str, String); 3], CodegenError> {
    let twin = Twin::new(inputs)?;
    let vector =
        |[mu_l, mu_v, theta_deg, tau]: &[f64; 4]| twin.vector([*mu_l, *mu_v, versine(*theta_deg), *tau], 0);
    let vectors = TESTED.iter().map(vector).collect::<Result<Vec<_>, _>>()?;
    let sight = vectors.iter().map(|s| {
        let numbers = [s.mu_l, s.mu_v, s.v, s.tau].map(literal);
        format!("StratiformSight({})", numbers.join(", "))
    });
    Ok([
        ("COUNT", vectors.len().to_string()),
        ("SIGHTS", cases(&sight.collect::<Vec<_>>())),
        ("EXPECTED", cases(&vectors.iter().map(|vector| literal(vector.halo)).collect::<Vec<_>>())),
    ])
}

fn head(inputs: &Inputs, halo: &HaloTable) -> String {
    let reach_deg = (2.0 * libm::asin(halo.reach)).to_degrees();
    let (columns, rows) = (halo.angles, halo.values.len() / halo.angles);
    banner(inputs, "Halo around the sun behind a stratiform layer: light that met forward events only.")
        + "//\n\
           // Use        @USE@.\n\
           // Check      stratiform_halo_self_test() returns the number of wrong values: 0 if the table is in place.\n"
        + &format!(
            "// Table      {columns} columns of sin(Theta / 2) up to Theta = {reach_deg:.1} deg, {rows} rows of the optical path up to {}:\n",
            halo.longest
        )
        + "//            the shape of light that met two or more forward events (Goudsmit & Saunderson 1940). One event comes\n\
           //            from P itself, which ends at theta_f. C and Rust carry the table; halo.json has it.\n\
           // Unit       reflectance factor, to be added to stratiform_radiance_bottom or stratiform_shade_bottom.\n\
           // Error      of the table, by what each inner value differs from the mean of its neighbours, a quarter of it:\n"
        + &curvature(halo)
        + &medium_line(inputs)
}

/// Interpolation error, as a quarter of the error at a value that is left out; relative to the row's peak.
fn curvature(halo: &HaloTable) -> String {
    let columns = halo.angles;
    let rows: Vec<_> = halo.values.chunks(columns).collect();
    let off = |value: f64, a: f64, b: f64, peak: f64| 0.25 * (value - 0.5 * (a + b)).abs() / peak;
    let across = rows.iter().flat_map(|row| row.windows(3).map(|w| off(w[1], w[0], w[2], row[0])));
    let along =
        rows.windows(3).flat_map(|w| (0..columns).map(move |i| off(w[1][i], w[0][i], w[2][i], w[1][0])));
    let worst = |errors: &mut dyn Iterator<Item = f64>| errors.fold(0.0, f64::max);
    let (across, along) = (worst(&mut { across }), worst(&mut { along }));
    format!(
        "//            {across:.1e} of the row's peak at most between columns, {along:.1e} between rows.\n"
    )
}
