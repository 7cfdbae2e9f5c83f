//! Positions of markers: any bytes are read or refused; every position that is read is finite.
#![no_main]

use chereme::diagnostics::render::render;
use chereme::format::markers::read;
use chereme::format::text::source_of_bytes;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| match read(bytes) {
    Ok(reading) => {
        let markers = reading.markers;
        assert!(markers.frames().all(|frame| frame.len() == markers.names().len()));
        assert!(markers.frames().flatten().flatten().all(|place| place.is_finite()));
    }
    Err(told) => {
        let source = source_of_bytes("fuzz.tsv", bytes);
        for told in told.iter().take(20) {
            render(told, &source, false);
        }
    }
});
