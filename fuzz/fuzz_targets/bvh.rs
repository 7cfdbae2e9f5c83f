//! BVH: any bytes are read or refused; what is read is printed and read again as the same.
#![no_main]

use chereme::diagnostics::render::render;
use chereme::format::bvh;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| match bvh::read(bytes) {
    Ok(reading) => {
        let text = bvh::print(&reading.bvh);
        let again = bvh::read(text.as_bytes()).unwrap_or_else(|told| panic!("{told:?}\n{text}"));
        assert_eq!(bvh::print(&again.bvh), text);
        assert_eq!(again.bvh.rows().len(), reading.bvh.rows().len());
        let _ = bvh::to_clip(&reading.bvh, &bvh::ClipOptions { roots: bvh::Roots::First, ..Default::default() });
    }
    Err(told) => {
        let source = bvh::source_of_bytes("fuzz.bvh", bytes);
        for told in told.iter().take(20) {
            render(told, &source, false);
        }
    }
});
