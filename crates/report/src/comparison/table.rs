//! The tables of a comparison.

use maud::{Markup, html};
use stratiform_artifact::{AblationRow, ComparisonRow};

/// Rows of luminance; those of the channels stay in the file.
pub fn errors(rows: &[ComparisonRow]) -> Markup {
    let percent = |share: f64| format!("{:.2}", 100.0 * share);
    let relative = |value: f64, row: &ComparisonRow| {
        if row.mean_truth > 0.0 { percent(value / row.mean_truth) } else { "–".to_owned() }
    };
    html! {
        div class="wide" { table {
            caption { "Luminance; shares in %. Of the channels: " code { "comparison.csv" } "." }
            thead { tr {
                th class="words" { "part" } th { "model" } th { "mean truth" } th { "mean picture" } th { "bias" } th { "its error" }
                th { "median" } th { "of noise" } th { "95 %" } th { "rms less noise" } th { "of whole" } th { "> 3 σ" } th { "FLIP" }
            } }
            tbody { @for row in rows.iter().filter(|row| row.band == "luminance") { tr {
                td class="words" { (row.contribution) } td { (row.model) }
                td { (format!("{:.5}", row.mean_truth)) } td { (format!("{:.5}", row.mean_picture)) }
                td { (relative(row.bias, row)) } td { (relative(row.bias_error, row)) }
                td { (percent(row.median)) } td { (percent(row.noise_median)) } td { (percent(row.p95)) }
                td { (relative(row.excess_rms, row)) } td { (percent(row.share)) } td { (percent(row.beyond_3_sigma)) }
                td { @if let Some(flip) = row.flip { (format!("{flip:.4}")) } }
            } } }
        } }
        p {
            "Of whole: the part's rms error over the mean of the whole truth, so that parts can be compared. > 3 σ: pixels off by more \
             than three standard errors; noise alone puts 0.27 % there. A part that few paths carry has errors that its standard error \
             does not know."
        }
    }
}

/// Every change, in the order of the file.
pub fn ablation(rows: &[AblationRow]) -> Markup {
    let percent = |share: f64| format!("{:.2}", 100.0 * share).replace('-', "−");
    let time = |ms: Option<f64>| ms.map_or("–".to_owned(), |ms| format!("{ms:.3}").replace('-', "−"));
    html! {
        div class="wide" { table {
            caption { "Errors of luminance in % of the truth's mean, noise taken off; times of the device's clock." }
            thead { tr {
                th { "scene" } th class="words" { "change" } th { "error" } th { "noise" } th { "rise" } th { "difference" } th { "FLIP" } th { "ms" }
                th { "ms saved" }
            } }
            tbody { @for row in rows { tr {
                td { (row.scene) } td class="words" { (row.change) } td { (percent(row.error)) } td { (percent(row.noise)) } td { (percent(row.rise)) }
                td { (percent(row.difference)) } td { (format!("{:.4}", row.flip)) } td { (time(row.ms)) } td { (time(row.ms_saved)) }
            } } }
        } }
        p {
            "Rise: the error less that of the unchanged picture, below 0 where the change helps. Difference: from the unchanged picture; \
             several changes together raise the error by no more than the sum of theirs. Noise: that of the truth; errors far below it are not known."
        }
    }
}
