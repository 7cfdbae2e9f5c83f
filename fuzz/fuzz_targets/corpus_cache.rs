//! Caches and indices of corpora: any bytes are refused or are one, whose every recording is read, and which is written and
//! read again as the same. Bytes by chance never have the right hashes, so that the input is read a second time as its parts,
//! of which a file with right hashes is made: two lengths (`u16`), frames, index without checksum, table.
#![no_main]

use chereme::corpus::cache::{Cache, Frames, Head, Writer, hash};
use chereme::corpus::index::Index;
use chereme::corpus::label::Vocabulary;
use chereme::corpus::query::{Options, Query};
use chereme::motion::skeleton::{Joint, JointId, Skeleton};
use glam::DVec3;
use libfuzzer_sys::fuzz_target;
use std::sync::{Arc, LazyLock};

/// More frames than this cost time and show nothing new.
const MOST_FRAMES: usize = 10_000;

static VOCABULARY: LazyLock<Vocabulary> = LazyLock::new(|| {
    let rig = Skeleton::from_json(chereme::avatar::SKELETON).expect("it is ours");
    Vocabulary::builtin(&rig, None).expect("it is ours")
});

/// A rig of two joints and one morph.
static RIG: LazyLock<(Arc<Skeleton>, Arc<Vec<String>>)> = LazyLock::new(|| {
    let joint = |name: &str, parent| Joint { name: name.into(), parent, rest_model: DVec3::Y, tail_model: DVec3::Y };
    let rig = Skeleton::new(vec![joint("Hips", None), joint("Spine", Some(JointId(0)))]).expect("it is one");
    (Arc::new(rig), Arc::new(vec!["smile".to_owned()]))
});

fuzz_target!(|bytes: &[u8]| {
    cache(bytes.to_vec());
    index(bytes);
    let Some((lengths, rest)) = bytes.split_first_chunk::<4>() else { return };
    let length = |at: usize| usize::from(u16::from_le_bytes([lengths[at], lengths[at + 1]]));
    let (frames, rest) = rest.split_at(length(0).min(rest.len()));
    let (body, table) = rest.split_at(length(2).min(rest.len()));
    let index_bytes = [body, &checksum(body).to_le_bytes()].concat();
    index(&index_bytes);
    cache(whole(frames, &index_bytes, table));
});

/// A cache of its parts.
fn whole(frames: &[u8], index: &[u8], table: &[u8]) -> Vec<u8> {
    let mut all = [&b"CHERCRPS\x01\0\0\0\0\0\0\0"[..], frames, table, index].concat();
    let at = 16 + frames.len();
    let mut tail = Vec::new();
    for number in
        [at as u64, table.len() as u64, (at + table.len()) as u64, index.len() as u64, hash(table), hash(index)]
    {
        tail.extend(number.to_le_bytes());
    }
    tail.extend(hash(&tail).to_le_bytes());
    all.extend(tail);
    all.extend(b"SPRCREHC");
    all
}

/// The checksum of an index: FNV-1a over words of eight bytes, then the rest.
fn checksum(bytes: &[u8]) -> u64 {
    const PRIME: u64 = 0x0100_0000_01B3;
    let (words, rest) = bytes.as_chunks::<8>();
    let sum = words.iter().fold(0xCBF2_9CE4_8422_2325u64, |sum, word| {
        let sum = (sum ^ u64::from_le_bytes(*word)).wrapping_mul(PRIME);
        sum ^ (sum >> 32)
    });
    rest.iter().fold(sum, |sum, byte| (sum ^ u64::from(*byte)).wrapping_mul(PRIME))
}

fn index(bytes: &[u8]) {
    let Ok(index) = Index::from_bytes(bytes, &VOCABULARY) else { return };
    assert_eq!(Index::from_bytes(&index.to_bytes(), &VOCABULARY).as_ref(), Ok(&index));
    for number in 0..index.len() {
        assert!(index.segment(number).is_some());
    }
    assert_eq!(index.find(&Query::default(), &Options::default()).len(), index.len().min(100));
}

fn cache(bytes: Vec<u8>) {
    let Ok(cache) = Cache::from_bytes(bytes) else { return };
    let (rig, morphs) = &*RIG;
    let mut writer = Writer::new(Vec::new(), Head::clone(cache.head())).expect("memory takes everything");
    let mut sound = true;
    for entry in cache.entries() {
        assert_eq!(entry.failed(), entry.frame_count() == 0);
        assert!(entry.duration().0 >= 0.0);
        if entry.frame_count() <= MOST_FRAMES
            && let Ok(clip) = cache.clip(entry, rig, morphs)
        {
            assert_eq!(clip.frames().len(), entry.frame_count());
            let finite = |q: &glam::DQuat| q.is_finite() && q.is_normalized();
            for frame in clip.frames() {
                assert!(frame.pose.root_model.is_finite() && frame.pose.rotations.iter().all(finite));
            }
        }
        match Frames::kept(&cache, entry) {
            Ok(frames) => writer.add(entry.clone(), &frames).expect("memory takes everything"),
            Err(_) => sound = false,
        }
    }
    if sound {
        let again = Cache::from_bytes(writer.finish(cache.index()).expect("memory takes everything"));
        let again = again.unwrap_or_else(|told| panic!("{told}"));
        assert!(again.head() == cache.head() && again.index() == cache.index());
        // As text, in which a number that is none is like itself.
        assert_eq!(format!("{:?}", again.entries()), format!("{:?}", cache.entries()));
    }
}
