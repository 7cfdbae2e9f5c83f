//! The interpolation table of `cargo run --example interpolation` agrees with theory (facts/phonology.md §5).

#[path = "../../examples/interpolation/measure.rs"]
mod measure;

use measure::{EASINGS, measure};

#[test]
fn joints_turn_as_the_laws_say() {
    let rows = measure();
    assert_eq!(rows.len(), 2 * EASINGS.len());
    for row in &rows {
        let off = row.ratio / row.theory() - 1.0;
        assert!(off.abs() < 0.03, "{row:?}: {:.3} by theory", row.theory());
        assert!(row.peak > 0.2 && row.peak < 3.0, "{row:?}");
    }
    // The paper's order: the sharper the law, the faster the point at its fastest.
    for gesture in rows.chunks(EASINGS.len()) {
        let [slerp, cosine, sigmoid, jerk] = gesture else { panic!("four laws") };
        assert!(gesture.iter().all(|row| row.gesture == slerp.gesture));
        assert!([cosine, sigmoid, jerk].iter().all(|row| (0.3..0.7).contains(&row.at)), "{gesture:?}");
        assert!(slerp.peak < cosine.peak && cosine.peak < jerk.peak && jerk.peak < sigmoid.peak, "{gesture:?}");
    }
}
