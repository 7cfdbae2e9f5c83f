//! New arrays for a file: key times and values, appended to the binary chunk in one buffer view.

use serde_json::{Value, json};
use std::collections::HashMap;

/// Collects arrays, and puts them into the file at the end.
pub(super) struct Samples {
    bin: Vec<u8>,
    /// Where the new bytes begin.
    start: usize,
    accessors: Vec<Value>,
    /// How many accessors and buffer views the file has already.
    accessors_before: usize,
    views_before: usize,
    /// Key times written already, by their bytes: most channels share theirs.
    times: HashMap<Vec<u8>, usize>,
    last_time: f32,
}

impl Samples {
    pub(super) fn new(json: &Value, bin: &[u8]) -> Samples {
        let count = |name: &str| json[name].as_array().map_or(0, Vec::len);
        // The buffer may be some bytes shorter than its chunk, which is padded.
        let used = json["buffers"][0]["byteLength"].as_u64().map_or(0, |n| n as usize).min(bin.len());
        let mut bin = bin[..used].to_vec();
        bin.resize(used.next_multiple_of(4), 0);
        Samples {
            start: bin.len(),
            bin,
            accessors: Vec::new(),
            accessors_before: count("accessors"),
            views_before: count("bufferViews"),
            times: HashMap::new(),
            last_time: 0.0,
        }
    }

    /// Begins an animation: none of its keys is written yet.
    pub(super) fn begin(&mut self) {
        self.last_time = 0.0;
    }

    /// The latest key time of the animation so far, seconds; 0 where there is none.
    pub(super) fn last_time(&self) -> f32 {
        self.last_time
    }

    /// Key times in seconds, ascending; returns the accessor's number, the same one for the same times.
    pub(super) fn times(&mut self, times: &[f32]) -> usize {
        self.last_time = times.last().copied().unwrap_or(0.0).max(self.last_time);
        let bytes: Vec<u8> = times.iter().flat_map(|t| t.to_le_bytes()).collect();
        if let Some(&known) = self.times.get(&bytes) {
            return known;
        }
        let index = self.push(times, "SCALAR");
        if let Some(accessor) = self.accessors.last_mut() {
            accessor["min"] = json!([times.first()]);
            accessor["max"] = json!([times.last()]);
        }
        self.times.insert(bytes, index);
        index
    }

    /// Values of the shape `SCALAR`, `VEC3` or `VEC4`; returns the accessor's number.
    pub(super) fn push(&mut self, values: &[f32], shape: &str) -> usize {
        let width = match shape {
            "VEC4" => 4,
            "VEC3" => 3,
            _ => 1,
        };
        self.accessors.push(json!({
            "bufferView": self.views_before,
            "byteOffset": self.bin.len() - self.start,
            "componentType": 5126,
            "count": values.len() / width,
            "type": shape,
        }));
        self.bin.extend(values.iter().flat_map(|v| v.to_le_bytes()));
        self.accessors_before + self.accessors.len() - 1
    }

    /// Adds the accessors and their buffer view to the JSON, and returns the whole binary chunk.
    pub(super) fn finish(self, json: &mut Value) -> Vec<u8> {
        let view = json!({ "buffer": 0, "byteOffset": self.start, "byteLength": self.bin.len() - self.start });
        append(&mut json["bufferViews"], vec![view]);
        append(&mut json["accessors"], self.accessors);
        // A file without numbers may list no buffer, or none that is one.
        if !json["buffers"][0].is_object() {
            json["buffers"] = json!([{}]);
        }
        json["buffers"][0]["byteLength"] = json!(self.bin.len());
        self.bin
    }
}

/// Appends to an array, which is made where there is none.
fn append(array: &mut Value, values: Vec<Value>) {
    match array.as_array_mut() {
        Some(array) => array.extend(values),
        None => *array = Value::Array(values),
    }
}
