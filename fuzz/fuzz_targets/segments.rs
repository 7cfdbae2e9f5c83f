//! Tables of segments: any bytes are read or refused; what is read is written and read again as the same.
#![no_main]

use chereme::diagnostics::render::render;
use chereme::format::segments::{read, write};
use chereme::format::text::source_of_bytes;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| match read(bytes) {
    Ok(reading) => {
        let table = write(&reading.recordings);
        let again = read(table.as_bytes()).unwrap_or_else(|told| panic!("{told:?}\n{table}"));
        assert_eq!(again.recordings, reading.recordings, "{table}");
    }
    Err(told) => {
        let source = source_of_bytes("fuzz.tsv", bytes);
        for told in told.iter().take(20) {
            render(told, &source, false);
        }
    }
});
