//! Tables of segments: what is written comes back, headings that people use, ELAN's exports, and what broken ones are told.

use crate::golden;
use crate::tiers::{apart, label, tier};
use chereme::diagnostics::Severity;
use chereme::diagnostics::render::render;
use chereme::format::segments::{Recording, read, write};
use chereme::format::text::source_of_bytes;
use chereme::tier::Tier;
use chereme::time::Seconds;
use proptest::collection::vec;
use proptest::prelude::*;

/// Recordings with other names each, tiers with other names each, none empty.
fn recordings() -> impl Strategy<Value = Vec<Recording>> {
    let tiers = vec(tier(apart()), 1..4).prop_map(|tiers| {
        let kept = |(at, tier): (usize, Tier)| {
            let mut numbered = Tier::new(format!("{}{at}", tier.name));
            tier.values().iter().for_each(|v| numbered.push(v.start, v.end, v.label.clone(), v.source.clone()));
            (!tier.values().is_empty()).then_some(numbered)
        };
        tiers.into_iter().enumerate().filter_map(kept).collect::<Vec<_>>()
    });
    vec((label(), tiers), 0..3).prop_map(|all| {
        let named = all.into_iter().enumerate();
        let named = named.map(|(at, (name, tiers))| Recording { name: format!("{name}{at}"), tiers });
        named.filter(|r| !r.tiers.is_empty()).collect()
    })
}

proptest! {
    #[test]
    fn what_is_written_comes_back(recordings in recordings()) {
        let table = write(&recordings);
        let reading = read(table.as_bytes()).unwrap_or_else(|told| panic!("{table}\n{told:?}"));
        prop_assert_eq!(&reading.recordings, &recordings);
        prop_assert_eq!(reading.warnings, []);
        prop_assert_eq!(write(&reading.recordings), table);
    }

    #[test]
    fn any_bytes_are_read_or_refused(
        bytes in prop_oneof![
            vec(any::<u8>(), 0..100),
            "(tier|start|end|label)(\t(start|end_ms|label|[a-z]{3})){0,5}\n([0-9.:\\-]{0,6}[\t\n\"]){0,20}".prop_map(String::into_bytes),
        ],
    ) {
        let source = source_of_bytes("a.tsv", &bytes);
        match read(&bytes) {
            Ok(reading) => {
                let table = write(&reading.recordings);
                let again = read(table.as_bytes()).unwrap();
                prop_assert_eq!(again.recordings, reading.recordings, "{}", table);
            }
            Err(told) => {
                prop_assert!(told.iter().any(|t| t.severity == Severity::Fault));
                prop_assert!(told.iter().all(|t| !render(t, &source, false).is_empty() && !t.label.is_empty()));
            }
        }
    }
}

/// Tier, start, end, label of all values of a table.
fn values(table: &str) -> Vec<(String, f64, f64, String)> {
    let reading = read(table.as_bytes()).unwrap_or_else(|told| panic!("{table}\n{told:?}"));
    let tiers = reading.recordings.into_iter().flat_map(|r| r.tiers);
    let of =
        |t: Tier| t.values().iter().map(|v| (t.name.clone(), v.start.0, v.end.0, v.label.clone())).collect::<Vec<_>>();
    tiers.flat_map(of).collect()
}

#[test]
fn headings_that_people_use_mean_the_same() {
    let expected = [("RH".to_owned(), 61.5, 62.25, "BOL".to_owned())];
    for table in [
        "tier\tstart\tend\tlabel\nRH\t61.5\t62.25\tBOL\n",
        "\u{feff}Tier Name\tOnset\tOffset\tValue\r\nRH\t61.5\t62.25\tBOL\r\n",
        "tier,start_ms,end_ms,label\nRH,61500,62250,BOL",
        "tier;start [ms];end (s);annotation\n\nRH;61500;62.25;\"BOL\"\n",
        "tier\tbegin time\tduration\ttext\nRH\t1:01.5\t0.75\tBOL\n",
        "label\tto\tfrom\ttier\tnotes\nBOL\t0:01:02.250\t0:01:01.500\tRH\tx\n",
        "tier\tBegin Time - hh:mm:ss.ms\tBegin Time - msec\tEnd Time - msec\tAnnotation\nRH\t00:01:01.500\t61500\t62250\tBOL\n",
        // ELAN, a column a tier, and the name of the file before the header.
        "#file:///a.eaf\nBegin Time - ss.msec\tEnd Time - ss.msec\tDuration - ss.msec\tRH\tLH\n61.5\t62.25\t0.75\tBOL\t\n",
        "Begin Time - PAL\tBegin Time - msec\tEnd Time - PAL\tEnd Time - msec\tRH\n0:01:01:12\t61500\t0:01:02:06\t62250\tBOL\n",
        // ELAN without a header, with a participant and without.
        "RH\tS1\t00:01:01.500\t61.5\t00:01:02.250\t62.25\t00:00:00.750\t0.75\tBOL\n",
        "RH\t\t61500\t62250\t750\tBOL\n",
        "RH\t00:01:01.500\t00:01:02.250\tBOL\n",
    ] {
        assert_eq!(values(table), expected, "{table}");
    }
    let alone = values("start\tend\tlabel\n0\t1\tA\n-0:01.5\t2\tB\n");
    assert_eq!(alone[0], ("label".into(), -1.5, 2.0, "B".into()));
}

#[test]
fn recordings_stay_apart() {
    let table =
        "file\ttier\tstart\tend\tlabel\tsource\nb.bvh\tRH\t1\t2\tX\ts\na.bvh\tRH\t0\t1\tY\t\nb.bvh\tRH\t0\t1\tZ\t\n";
    let recordings = read(table.as_bytes()).unwrap().recordings;
    let names: Vec<_> = recordings.iter().map(|r| r.name.as_str()).collect();
    assert_eq!(names, ["b.bvh", "a.bvh"]);
    let labels: Vec<_> = recordings[0].tiers[0].values().iter().map(|v| (v.start, v.label.as_str())).collect();
    assert_eq!(labels, [(Seconds(0.0), "Z"), (Seconds(1.0), "X")]);
    assert_eq!(recordings[0].tiers[0].values()[1].source, "s");
}

/// `UPDATE=1 cargo test` writes the expectations anew.
#[test]
fn each_mistake_has_its_message() {
    golden::beside("segments", "tsv", 9, |name, bytes| {
        let source = source_of_bytes(name, bytes);
        let told = read(bytes).unwrap_err();
        told.iter().map(|d| render(d, &source, false) + "\n\n").collect()
    });
}
