//! Whether the parameters from solver and from photons agree.

use super::number;
use crate::input::Inputs;
use maud::{Markup, html};
use stratiform_artifact::{AgreementDocument, AgreementRow};

pub fn section(inputs: &Inputs) -> Markup {
    let fitted_to = if inputs.parameters.provenance.is_random() { "photons" } else { "solved fluxes" };
    let Some((verdict, rows)) = &inputs.agreement else {
        return html! { p { "The table is fitted to " (fitted_to) "; there is no second source to hold it against." } };
    };
    html! {
        p {
            "The table is fitted to " (fitted_to) ". The same objective fitted to the other source, with "
            (verdict.photons) " photons per incidence and medium, must give the same parameters within both errors. The \
             solver's errors are estimated and carried through the fit as a bound; those of the photons are standard errors."
        }
        (sentence(verdict))
        details { summary { "Every parameter from both sources (per unit of optical thickness)" } (table(rows)) }
    }
}

fn sentence(verdict: &AgreementDocument) -> Markup {
    let AgreementDocument { comparisons, differing, threshold, worst, false_alarm_rate, .. } = verdict;
    let largest = html! {
        " Largest |z|: " (worst.z.map_or("no error claimed".to_owned(), |z| number::fixed(z.abs(), 2))) " ("
        (worst.parameter) " at " (worst.theta_l_deg) "); threshold " (number::fixed(*threshold, 2))
        ", which agreeing sources exceed with probability " (number::small(*false_alarm_rate)) "."
    };
    html! {
        @if verdict.agrees() { p { "All " (comparisons) " parameters agree." (largest) } }
        @else {
            aside class="alarm" {
                p { strong { "Solver and photons disagree in " (differing) " of " (comparisons) " parameters." } (largest)
                    " One of them is wrong: do not use this table before the reason is known." }
            }
        }
    }
}

fn table(rows: &[AgreementRow]) -> Markup {
    html! {
        div class="wide" {
            table {
                thead {
                    tr { th { "θ" sub { "l" } " (°)" } th { "parameter" } th { "solver" } th { "photons" } th { "z" } th { "" } }
                }
                tbody {
                    @for row in rows {
                        tr {
                            th { (row.theta_l_deg) }
                            td { (row.parameter) }
                            td { (number::with_error(row.solved, row.solved_error)) }
                            td { (number::with_error(row.traced, row.traced_std_error)) }
                            td { (row.z.map_or("–".to_owned(), |z| number::fixed(z, 2))) }
                            td { @if row.differs { strong { "differs" } } }
                        }
                    }
                }
            }
        }
    }
}
