//! Manifests of corpora: any text is read or refused; what is read is written and read again as the same.
#![no_main]

use chereme::corpus::manifest::read;
use chereme::diagnostics::Source;
use chereme::diagnostics::render::render;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let source = Source::new("corpus.yaml", String::from_utf8_lossy(bytes));
    match read(&source.text) {
        Ok(manifest) => {
            let text = manifest.to_yaml();
            let again = read(&text).unwrap_or_else(|told| panic!("{told:?}\n{text}"));
            assert_eq!(again, manifest, "{text}");
            assert_eq!(again.to_yaml(), text);
            for rule in &manifest.tiers {
                rule.fits("RH Gloss");
            }
        }
        Err(told) => {
            assert!(!told.is_empty());
            for told in told.iter().take(20) {
                render(told, &source, false);
            }
        }
    }
});
