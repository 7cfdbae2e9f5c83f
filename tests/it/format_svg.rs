//! Figures as SVG: well formed whatever the labels say, small however long the recording, the same as the golden one.

use crate::strategies::profile;
use chereme::format::profile_plot::{Layout, Motion, against, figure};
use chereme::format::svg::{Base, Column, Figure, Line, Mark, Panel, Row, write};
use chereme::motion::curve::{Curve, Measure, Phase, Profile, Reference};
use chereme::motion::difference::Tolerance;
use chereme::time::Seconds;
use proptest::prelude::*;
use std::path::Path;

/// Each polyline's points, all within the sheet.
fn lines(svg: &str) -> Vec<Vec<(f64, f64)>> {
    let document = roxmltree::Document::parse(svg).unwrap_or_else(|e| panic!("{e}\n{svg}"));
    let root = document.root_element();
    let side = |name| root.attribute(name).unwrap().parse::<f64>().unwrap();
    let (width, height) = (side("width"), side("height"));
    let point = |text: &str| {
        let (x, y) = text.split_once(',').unwrap();
        let (x, y) = (x.parse::<f64>().unwrap(), y.parse::<f64>().unwrap());
        assert!((0.0..=width).contains(&x) && (0.0..=height).contains(&y), "({x}, {y}) outside {width}×{height}");
        (x, y)
    };
    let drawn = document.descendants().filter(|n| n.has_tag_name("polyline"));
    drawn.map(|n| n.attribute("points").unwrap().split_whitespace().map(point).collect()).collect()
}

fn motion(name: &str, profile: Profile) -> Motion {
    let marks = vec![Mark { name: "A".into(), time: Seconds(0.1) }];
    Motion { name: name.into(), profile, marks }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn any_profile_is_a_well_formed_figure(a in profile(), b in profile(), title in any::<String>()) {
        let motions = [motion(&title, a), motion("b", b)];
        let curves: usize = motions.iter().map(|m| m.profile.curves().len()).sum();
        for layout in [Layout::Overlaid, Layout::Columns] {
            prop_assert_eq!(lines(&write(&figure(&title, &motions, layout))).len(), curves);
        }
        lines(&write(&against(&title, &motions[0], &motions[0], |_| Tolerance::OfRange(0.01))));
    }

    #[test]
    fn any_numbers_stay_on_the_sheet(values in prop::collection::vec((any::<f64>(), any::<f64>()), 0..20), size in any::<f64>()) {
        let row = |base| Row { title: "x".into(), base, panels: vec![Panel { lines: vec![Line { key: 9, points: values.clone() }] }] };
        let rows = vec![row(Base::Data), row(Base::Zero), row(Base::Tolerance(size))];
        let figure = Figure { keys: vec!["k".into(); 10], columns: vec![Column::default()], rows, ..Figure::default() };
        lines(&write(&figure));
    }
}

#[test]
fn an_empty_figure_is_a_figure() {
    assert!(lines(&write(&Figure::default())).is_empty());
}

#[test]
fn phases_of_one_motion_are_not_shown_as_those_of_another() {
    let profile = |end| {
        let phase = Phase { name: "stroke".into(), start: Seconds(0.0), end: Seconds(end) };
        Profile::new(vec![Seconds(0.0), Seconds(1.0)], vec![]).unwrap().with_phases(vec![phase])
    };
    let phases = |ends: [f64; 2], layout| {
        let motions = ends.map(|end| motion("a", profile(end)));
        figure("", &motions, layout).columns.iter().map(|c| c.phases.len()).sum::<usize>()
    };
    assert_eq!(phases([0.5, 0.51], Layout::Overlaid), 1);
    assert_eq!(phases([0.5, 0.8], Layout::Overlaid), 0);
    assert_eq!(phases([0.5, 0.8], Layout::Columns), 2);
}

#[test]
fn an_hour_is_a_small_file_and_keeps_its_peak() {
    let mut points: Vec<(f64, f64)> =
        (0..216_000).map(|i| (f64::from(i) / 60.0, (f64::from(i) / 500.0).sin())).collect();
    points[100_001].1 = 9.0;
    let row = Row { title: "x".into(), base: Base::Data, panels: vec![Panel { lines: vec![Line { key: 0, points }] }] };
    let svg = write(&Figure { columns: vec![Column::default()], rows: vec![row], ..Figure::default() });
    assert!(svg.len() < 100_000, "{} bytes", svg.len());
    let drawn = &lines(&svg)[0];
    let top = drawn.iter().map(|p| p.1).fold(f64::INFINITY, f64::min);
    let next = drawn.iter().map(|p| p.1).filter(|y| *y > top + 1.0).fold(f64::INFINITY, f64::min);
    assert!(next - top > 50.0, "the peak stands out: {top} and {next}");
}

#[test]
fn a_small_figure_is_as_it_was() {
    let curve = |measure, values: [f64; 5]| Curve {
        point: "Right<Hand>".into(),
        reference: Reference::Floor,
        measure,
        values: values.to_vec(),
    };
    let curves =
        vec![curve(Measure::Height, [1.0, 1.02, 1.1, 1.18, 1.2]), curve(Measure::Speed, [0.0, 0.4, 0.8, 0.4, 0.0])];
    let times = (0..5).map(|i| Seconds(f64::from(i) / 10.0)).collect();
    let phase = |name: &str, start, end| Phase { name: name.into(), start: Seconds(start), end: Seconds(end) };
    let phases = vec![phase("preparation", 0.0, 0.2), phase("stroke", 0.2, 0.4)];
    let profile = Profile::new(times, curves).unwrap().with_phases(phases);
    let svg = write(&figure("BOL & co", &[motion("BOL", profile)], Layout::Overlaid));
    let golden = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/suite/format/profile.svg");
    if std::env::var_os("UPDATE").is_some() {
        std::fs::create_dir_all(golden.parent().unwrap()).unwrap();
        std::fs::write(&golden, &svg).unwrap();
    }
    assert_eq!(std::fs::read_to_string(&golden).unwrap_or_default(), svg);
}
