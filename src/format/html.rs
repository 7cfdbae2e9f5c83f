//! The viewer page: one HTML file with the avatar, its motion, the tiers and the program that shows them.
//!
//! The page opens from disk, asks nothing of a network, and is written for linguists who want to look at a
//! sign from all sides, slowly, beside its tiers. Its parts stand in `assets/viewer/`; three.js is
//! embedded as published, with its licence.

use super::glb;
use crate::diagnostics::Error;
use crate::track::Track;
use base64::Engine;
use serde_json::json;

/// What a page shows besides the motion.
#[derive(Debug, Clone, Default)]
pub struct Page {
    /// The sign's or the song's name.
    pub title: String,
    /// The sign language, as its folder is named; may be empty.
    pub language: String,
    /// Label and text of each line of the small panel: meaning, source, status.
    pub facts: Vec<(String, String)>,
}

const TEMPLATE: &str = include_str!("../../assets/viewer/viewer.html");
const STYLE: &str = include_str!("../../assets/viewer/viewer.css");
const BOOT: &str = include_str!("../../assets/viewer/boot.js");
const LICENCE: &str = include_str!("../../assets/viewer/vendor/LICENSE-three-MIT.txt");

macro_rules! modules {
    ($($path:literal)*) => { [$(($path, include_str!(concat!("../../assets/viewer/", $path)))),*] };
}

/// Path below `assets/viewer/` and text of each module.
const MODULES: &[(&str, &str)] = &modules!(
    "vendor/three.core.min.js" "vendor/three.module.min.js" "vendor/BufferGeometryUtils.js"
    "vendor/SkeletonUtils.js" "vendor/GLTFLoader.js" "vendor/OrbitControls.js"
    "avatar.js" "cameras.js" "controls.js" "player.js" "speed.js" "stage.js" "timeline.js" "main.js"
);

/// The page of a track; `avatar` is the avatar's GLB file.
///
/// # Errors
/// Those of [`glb::write`]: an avatar that is no GLB file or does not fit the track.
pub fn write(avatar: &[u8], track: &Track, page: &Page) -> Result<String, Error> {
    let glb = glb::write(avatar, track)?;
    let tiers: Vec<_> = track
        .tiers
        .iter()
        .map(|tier| {
            let values: Vec<_> = tier
                .values()
                .iter()
                .map(|v| json!({ "start": v.start.0, "end": v.end.0, "label": v.label, "source": v.source }))
                .collect();
            json!({ "name": tier.name, "values": values })
        })
        .collect();
    let data = json!({
        "title": page.title,
        "language": page.language,
        "facts": page.facts,
        "fps": track.clip.fps().get(),
        "duration": track.clip.duration().0,
        "tiers": tiers,
        "still": null,
        "glb": base64::engine::general_purpose::STANDARD.encode(glb),
    });
    Ok(join(TEMPLATE, &[STYLE], &data.to_string(), &[]))
}

/// Puts a page together: its template, styles, data (a JSON text) and modules beside the viewer's own. The module
/// `main.js` begins; one of the page's own stands in place of the viewer's.
pub(super) fn join(template: &str, styles: &[&str], data: &str, own: &[(&str, &str)]) -> String {
    // A "<" can stand only inside a string of the JSON, where this is the same letter.
    let data = data.replace('<', "\\u003c");
    let mut modules = format!("<!--\nthree.js, embedded below:\n{}-->\n", LICENCE.replace("--", "- -"));
    let replaced = |path: &str| own.iter().any(|(name, _)| *name == path);
    for (path, text) in MODULES.iter().filter(|(path, _)| !replaced(path)).chain(own) {
        let name = path.rsplit('/').next().unwrap_or(path);
        modules += &format!("<script type=\"text/plain\" data-module=\"{name}\">\n{}</script>\n", script(text));
    }
    modules += &format!("<script>\n{}</script>", script(BOOT));
    let data = format!("<script type=\"application/json\" id=\"chereme-data\">{data}</script>");
    // The marks are replaced in one pass, so that a mark inside an inserted text stays as it is.
    let style = styles.concat();
    let mut page = String::with_capacity(template.len() + data.len() + modules.len() + style.len());
    let mut rest = template;
    let marks = [("/*chereme:style*/", &style), ("<!--chereme:data-->", &data), ("<!--chereme:modules-->", &modules)];
    for (mark, text) in marks {
        let (before, after) = rest.split_once(mark).unwrap_or((rest, ""));
        page += before;
        page += text;
        rest = after;
    }
    page + rest
}

/// Text of a program that may stand in a script element: nothing in it ends the element or opens a comment.
fn script(text: &str) -> String {
    text.replace("</script", "<\\/script").replace("<!--", "<\\!--")
}
