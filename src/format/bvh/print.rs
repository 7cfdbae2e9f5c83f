//! A BVH file's data as its text.

use super::data::{Bvh, Joint};
use super::decimal::push;
use crate::time::Seconds;
use glam::DVec3;

/// The text of a BVH file, in the data's own unit and order: six decimals, eight of the frame time, tabs for depth.
///
/// A leaf without an End Site gets one of no length, which many programs ask for.
///
/// ```
/// use chereme::format::bvh;
/// let text = "HIERARCHY\nROOT Hips {\n OFFSET 0 1e2 0\n CHANNELS 1 Yrotation\n}\nMOTION\nFrames: 1\nFrame Time: .02\n-1.5\n";
/// let printed = bvh::print(&bvh::read(text.as_bytes()).unwrap().bvh);
/// assert!(printed.contains("\tOFFSET 0 100 0\n") && printed.ends_with("Frame Time: 0.02000000\n-1.500000\n"));
/// ```
pub fn print(bvh: &Bvh) -> String {
    let mut out = Vec::new();
    out.extend_from_slice(b"HIERARCHY\n");
    let mut open: Vec<usize> = Vec::new();
    for (at, joint) in bvh.joints().iter().enumerate() {
        while open.last().copied() != joint.parent {
            open.pop();
            line(&mut out, open.len(), "}");
        }
        let leaf = bvh.joints().get(at + 1).is_none_or(|next| next.parent != Some(at));
        begin(&mut out, joint, open.len(), leaf);
        open.push(at);
    }
    while open.pop().is_some() {
        line(&mut out, open.len(), "}");
    }
    let rows = bvh.rows();
    line(&mut out, 0, &format!("MOTION\nFrames: {}\nFrame Time: {}", rows.len(), seconds(bvh.frame_time())));
    // Most numbers take less than this; it saves growing step by step.
    out.reserve(rows.len() * bvh.channel_count() * 11);
    for row in rows {
        for (i, value) in row.iter().enumerate() {
            if i > 0 {
                out.push(b' ');
            }
            push(&mut out, *value);
        }
        out.push(b'\n');
    }
    String::from_utf8(out).unwrap_or_default()
}

/// A joint's lines up to where its children begin.
fn begin(out: &mut Vec<u8>, joint: &Joint, depth: usize, leaf: bool) {
    let keyword = if joint.parent.is_none() { "ROOT" } else { "JOINT" };
    line(out, depth, &format!("{keyword} {}", joint.name));
    line(out, depth, "{");
    offset(out, depth + 1, joint.offset);
    let words: String = joint.channels.iter().map(|c| format!(" {}", c.word())).collect();
    line(out, depth + 1, &format!("CHANNELS {}{words}", joint.channels.len()));
    let none = [DVec3::ZERO];
    let sites = if leaf && joint.end_sites.is_empty() { &none[..] } else { &joint.end_sites[..] };
    for site in sites {
        line(out, depth + 1, "End Site");
        line(out, depth + 1, "{");
        offset(out, depth + 2, *site);
        line(out, depth + 1, "}");
    }
}

/// Deeper joints are not set in further, or a chain of many joints would be mostly tabs.
const MOST_TABS: usize = 64;

fn tabs(out: &mut Vec<u8>, depth: usize) {
    out.resize(out.len() + depth.min(MOST_TABS), b'\t');
}

fn line(out: &mut Vec<u8>, depth: usize, text: &str) {
    tabs(out, depth);
    out.extend_from_slice(text.as_bytes());
    out.push(b'\n');
}

fn offset(out: &mut Vec<u8>, depth: usize, value: DVec3) {
    tabs(out, depth);
    out.extend_from_slice(b"OFFSET");
    for number in value.to_array() {
        out.push(b' ');
        push(out, number);
    }
    out.push(b'\n');
}

/// Eight decimals, from which programs find the frame rate again; all digits where eight would lose it.
fn seconds(time: Seconds) -> String {
    let eight = format!("{:.8}", time.0);
    let near = eight.parse::<f64>().is_ok_and(|read| (read / time.0 - 1.0).abs() < 1e-5);
    if near { eight } else { format!("{}", time.0) }
}
