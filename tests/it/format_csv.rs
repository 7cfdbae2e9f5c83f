//! Kinematic profiles as CSV: what is written is read back, and nothing that is read panics.

use crate::strategies::profile;
use chereme::format::csv::{read, write};
use proptest::prelude::*;

proptest! {
    #[test]
    fn what_is_written_is_read_back(profile in profile(), decimals in 0..12usize) {
        let text = write(&profile, decimals);
        let back = read(text.as_bytes()).unwrap_or_else(|e| panic!("{e}\n{text}"));
        prop_assert_eq!(write(&back, decimals), text);
        let half = 0.5 * 10f64.powi(-(decimals as i32)) + 1e-9;
        prop_assert_eq!(back.curves().len(), profile.curves().len());
        for (a, b) in back.curves().iter().zip(profile.curves()) {
            prop_assert_eq!(a.name(), b.name());
            prop_assert!(a.values.iter().zip(&b.values).all(|(v, w)| (v - w).abs() <= half));
        }
    }

    #[test]
    fn any_bytes_are_read_or_refused(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let _ = read(&bytes);
    }

    #[test]
    fn a_spoiled_table_is_read_or_refused(profile in profile(), at in any::<prop::sample::Index>(), byte in any::<u8>()) {
        let mut bytes = write(&profile, 3).into_bytes();
        let at = at.index(bytes.len());
        bytes[at] = byte;
        let _ = read(&bytes);
    }
}

#[test]
fn refusals_say_where_and_what_was_expected() {
    for (text, words) in [
        ("", "line 1: the file is empty"),
        ("time [s]\n", "line 2: there is no row"),
        ("t,RightHand floor speed [m/s]\n0,1\n", "line 1, column 1: the first column is `t`; expected `time [s]`"),
        ("time [s];RightHand floor speed [m/s]\n0;1\n", "line 1: the cells are not separated by commas"),
        ("time [s],speed\n0,1\n", "line 1, column 2: `speed` names no curve"),
        ("time [s],A floor sped [m/s]\n0,1\n", "line 1, column 2: there is no measure called `sped`"),
        ("time [s],A flor speed [m/s]\n0,1\n", "there are floor, body, wrist"),
        ("time [s],A floor speed [km/h]\n0,1\n", "line 1, column 2: speed is in m/s, not in `km/h`"),
        ("time [s],A floor x [m],A floor x [m]\n0,1,1\n", "line 1, column 3: A floor x is there twice"),
        ("time [s],A floor x [m]\n0,1\n0.1\n", "line 3: 1 cells instead of 2"),
        ("time [s],A floor x [m]\n0,1\n0.1,nan\n", "line 3, column 2: `nan` is no finite number"),
        ("time [s],A floor x [m]\n0,1\n0,1\n", "line 3, column 1: times increase"),
    ] {
        let error = read(text.as_bytes()).expect_err(text).to_string();
        assert!(error.contains(words), "{text:?}: {error}");
    }
    assert!(read(b"time [s],A floor x [m]\n0,\xff\n").unwrap_err().to_string().contains("not UTF-8"));
    let wide = vec![b','; 3000];
    assert!(read(&wide).unwrap_err().to_string().contains("columns"));
}

#[test]
fn a_spreadsheets_file_is_read() {
    let text = "\u{feff}time [s],\"A floor x [m]\",phase\r\n0, 1 ,stroke\r\n0.5,1e-1,\r\n";
    let profile = read(text.as_bytes()).unwrap();
    assert_eq!(profile.curves()[0].values, [1.0, 0.1]);
    let phase = &profile.phases()[0];
    assert_eq!((phase.name.as_str(), phase.start.0, phase.end.0), ("stroke", 0.0, 0.5));
}
