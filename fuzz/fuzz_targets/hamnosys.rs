//! HamNoSys strings, as characters or names: any text is read; what is read is printed, as HamNoSys and as SiGML, and read
//! again as the same.
#![no_main]

use chereme::diagnostics::Source;
use chereme::diagnostics::render::render;
use chereme::notation::hamnosys::parse;
use chereme::notation::hamnosys::print::{Form, print};
use chereme::notation::sigml::{self, Kind};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let source = Source::new("fuzz.hns", String::from_utf8_lossy(bytes));
    let (sign, told) = parse::sign(&source.text);
    for told in told.iter().take(20) {
        render(told, &source, false);
    }
    let Some(sign) = sign else { return };
    if let Ok(printed) = print(&sign, Form::Names) {
        let (again, told) = parse::sign(&printed);
        assert_eq!(again.as_ref(), Some(&sign), "{printed}\n{told:?}");
    }
    // What the symbols leave open, gestural SiGML says; so the text is compared, once it is said.
    if let Ok(text) = sigml::write(&[sign], Kind::Gestural) {
        let (signs, told) = sigml::read(&Source::new("again.sigml", text.as_str()));
        assert_eq!(sigml::write(&signs, Kind::Gestural).unwrap(), text, "{told:?}");
    }
});
