//! TextGrid: any bytes are read or refused; what was written once comes back as the same.
#![no_main]

use chereme::diagnostics::render::render;
use chereme::format::text::source_of_bytes;
use chereme::format::textgrid::{TextGrid, read, write};
use chereme::tier::Tier;
use libfuzzer_sys::fuzz_target;

fn tiers(grid: &TextGrid) -> Vec<Tier> {
    grid.tiers.iter().map(|tier| tier.tier.clone()).collect()
}

fuzz_target!(|bytes: &[u8]| match read(bytes) {
    Ok(reading) => {
        // Overlaps are cut by the first writing, so the second one is compared.
        let text = write(&tiers(&reading.grid), reading.grid.end);
        let once = read(text.as_bytes()).unwrap_or_else(|told| panic!("{told:?}\n{text}"));
        let text = write(&tiers(&once.grid), once.grid.end);
        let twice = read(text.as_bytes()).unwrap_or_else(|told| panic!("{told:?}\n{text}"));
        assert_eq!(tiers(&twice.grid), tiers(&once.grid), "{text}");
    }
    Err(told) => {
        let source = source_of_bytes("fuzz.TextGrid", bytes);
        for told in told.iter().take(20) {
            render(told, &source, false);
        }
    }
});
