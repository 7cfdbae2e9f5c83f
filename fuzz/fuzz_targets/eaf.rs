//! EAF and its vocabularies: any bytes are read or refused; the tiers that are read are written and read again as the same.
#![no_main]

use chereme::diagnostics::render::render;
use chereme::format::eaf::{self, Document, ecv};
use chereme::format::text::source_of_bytes;
use chereme::tier::Tier;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let _ = ecv::read(bytes);
    match eaf::read_with(bytes, |_| ecv::read(bytes).ok().map(|(all, _)| all)) {
        Ok(reading) => {
            let tiers: Vec<Tier> = reading.eaf.tiers.iter().map(|tier| tier.tier.clone()).collect();
            let text = eaf::write(&tiers, &Document::default()).unwrap();
            let again = eaf::read(text.as_bytes()).unwrap_or_else(|told| panic!("{told:?}\n{text}"));
            assert_eq!(again.warnings, []);
            for (tier, again) in tiers.iter().zip(&again.eaf.tiers) {
                let labels = |tier: &Tier| tier.values().iter().map(|v| v.label.clone()).collect::<Vec<_>>();
                assert_eq!(labels(&again.tier), labels(tier), "{text}");
            }
        }
        Err(told) => {
            let source = source_of_bytes("fuzz.eaf", bytes);
            for told in told.iter().take(20) {
                render(told, &source, false);
            }
        }
    }
});
