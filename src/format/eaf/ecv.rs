//! ELAN's external vocabularies (`.ecv`): lists of texts that many annotation files share.
//!
//! Source: the schemas EAFv2.8.xsd and EAFv3.0.xsd, element `CV_RESOURCE` (Max Planck Institute for Psycholinguistics).

use super::data::ControlledVocabulary;
use crate::diagnostics::Diagnostic;

/// Reads the vocabularies of an `.ecv` file, and what is odd about them; for [`read_with`](super::read_with).
///
/// # Errors
/// All faults with their places, as [`read`](super::read).
///
/// ```
/// use chereme::format::eaf::ecv;
/// let file = r#"<CV_RESOURCE><LANGUAGE LANG_ID="eng"/><CONTROLLED_VOCABULARY CV_ID="phases">
///   <CV_ENTRY_ML CVE_ID="p1"><CVE_VALUE LANG_REF="eng">stroke</CVE_VALUE></CV_ENTRY_ML></CONTROLLED_VOCABULARY></CV_RESOURCE>"#;
/// let (vocabularies, warnings) = ecv::read(file.as_bytes()).unwrap();
/// assert_eq!((vocabularies[0].entries[0].values[0].text.as_str(), warnings.len()), ("stroke", 0));
/// ```
pub fn read(bytes: &[u8]) -> Result<(Vec<ControlledVocabulary>, Vec<Diagnostic>), Vec<Diagnostic>> {
    super::read::external(bytes)
}
