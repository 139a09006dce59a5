//! Cost of a frame against resolution and against radiosity passes.

use crate::chart::{
    Axis, Figure, LegendEntry, Line, Marker, Panel, Point, Row, Scale, Series, Style, palette,
};
use stratiform_artifact::RenderCostRow;

const STYLES: [(&str, Line, Marker); 6] = [
    (palette::BLUE, Line::Solid, Marker::Circle),
    (palette::ORANGE, Line::Dashed, Marker::Triangle),
    (palette::GREEN, Line::DashDot, Marker::Diamond),
    (palette::VERMILION, Line::Dotted, Marker::Square),
    (palette::PURPLE, Line::Solid, Marker::Cross),
    (palette::GREY, Line::Dashed, Marker::Ring),
];

/// A whole frame.
#[derive(Clone, Debug, PartialEq)]
struct Frame {
    pixels: f64,
    model: String,
    passes: Option<u64>,
    side: u64,
    ms: f64,
}

/// A figure for each scene and device.
pub fn figures(rows: &[RenderCostRow]) -> Vec<Figure> {
    distinct(rows.iter().map(|row| (row.scene.as_str(), row.adapter.as_str())))
        .into_iter()
        .enumerate()
        .map(|(i, (scene, adapter))| {
            let of = |row: &&RenderCostRow| row.scene == scene && row.adapter == adapter;
            figure(i, (scene, adapter), &frames(rows.iter().filter(of)))
        })
        .collect()
}

fn distinct<T: PartialEq>(all: impl Iterator<Item = T>) -> Vec<T> {
    let mut seen = Vec::new();
    all.for_each(|one| {
        if !seen.contains(&one) {
            seen.push(one);
        }
    });
    seen
}

/// Sums of the passes of each frame, in the order of the file.
fn frames<'a>(rows: impl Iterator<Item = &'a RenderCostRow>) -> Vec<Frame> {
    let mut frames: Vec<Frame> = Vec::new();
    for row in rows {
        let (pixels, passes, side) =
            ((row.width * row.height) as f64, row.radiosity_passes, row.radiosity_side);
        let same =
            |f: &&mut Frame| (f.pixels, &f.model, f.passes, f.side) == (pixels, &row.model, passes, side);
        match frames.iter_mut().find(same) {
            Some(frame) => frame.ms += row.ms,
            None => frames.push(Frame { pixels, model: row.model.clone(), passes, side, ms: row.ms }),
        }
    }
    frames
}

fn figure(number: usize, (scene, adapter): (&str, &str), frames: &[Frame]) -> Figure {
    let label =
        |passes: Option<u64>| passes.map_or("as many passes as needed".to_owned(), |n| format!("{n} passes"));
    let by_passes = distinct(frames.iter().map(|frame| (frame.model.clone(), frame.passes)));
    let series =
        by_passes.iter().zip(STYLES.iter().cycle()).map(|((model, passes), (colour, line, marker))| {
            let of = frames.iter().filter(|frame| frame.model == *model && frame.passes == *passes);
            let points = of.map(|frame| Point::new(frame.pixels, frame.ms)).collect();
            Series { style: Style::line(colour, *line).with_marker(*marker), points }
        });
    let resolution: Vec<Series> = series.collect();
    let legend = by_passes.iter().zip(&resolution);
    let legend =
        legend.map(|((model, passes), s)| LegendEntry::new(format!("{model}, {}", label(*passes)), s.style));
    let (passes, further) = against_passes(frames);
    let all = || frames.iter().map(|frame| frame.ms);
    Figure {
        name: if number == 0 { "render-costs".to_owned() } else { format!("render-costs-{}", number + 1) },
        title: format!("Cost of a frame: {scene} on {}", adapter.split(" (").next().unwrap_or(adapter)),
        caption: "Sum of all passes by the device's clock, against pixels and against radiosity passes at the largest picture.".to_owned(),
        legend: legend.chain(further).collect(),
        rows: vec![Row {
            height: 300.0,
            panels: vec![
                Panel {
                    title: "Resolution".to_owned(),
                    x: Axis::new("pixels", Scale::logarithmic(frames.iter().map(|frame| frame.pixels))),
                    y: Axis::new("time of a frame (ms)", Scale::logarithmic(all())),
                    series: resolution,
                    marks: Vec::new(),
                },
                passes,
            ],
        }],
    }
}

/// Time against passes at the largest picture, a line for each model, and their legend.
fn against_passes(frames: &[Frame]) -> (Panel, Vec<LegendEntry>) {
    let most = frames.iter().map(|frame| frame.pixels).fold(0.0, f64::max);
    let largest: Vec<_> = frames.iter().filter(|frame| frame.pixels == most).collect();
    let models = distinct(largest.iter().map(|frame| frame.model.as_str()));
    let styles = [(palette::BLACK, Marker::Circle), (palette::GREY, Marker::Square)];
    let series: Vec<Series> = models
        .iter()
        .zip(styles.iter().cycle())
        .map(|(model, (colour, marker))| {
            let of = largest.iter().filter(|frame| frame.model == *model);
            let mut points: Vec<Point> =
                of.filter_map(|frame| Some(Point::new(frame.passes? as f64, frame.ms))).collect();
            points.sort_by(|a, b| a.x.total_cmp(&b.x));
            Series { style: Style::line(colour, Line::Solid).with_marker(*marker), points }
        })
        .collect();
    let legend = models.iter().zip(&series);
    let legend =
        legend.map(|(model, s)| LegendEntry::new(format!("{model} against passes"), s.style)).collect();
    let points = || series.iter().flat_map(|s| &s.points);
    let highest = points().map(|point| point.y).fold(0.0, f64::max);
    let panel = Panel {
        title: "Radiosity passes".to_owned(),
        x: Axis::new("passes", Scale::linear(points().map(|point| point.x))),
        y: Axis::new("time of a frame (ms)", Scale::from_zero(1.1 * highest)),
        series,
        marks: Vec::new(),
    };
    (panel, legend)
}
