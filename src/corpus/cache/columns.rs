//! The frames of a clip as columns of `f32`: what never changes is kept once.
//!
//! A hand's take moves a third of the rig at most, so most columns are still. A frame is the root's position (three
//! columns), each joint's rotation (x, y, z, w), and each morph's weight.

use super::bytes::{Sink, Tap};
use crate::diagnostics::Error;
use crate::motion::clip::{Clip, Frame};
use crate::motion::pose::LocalPose;
use crate::motion::skeleton::Skeleton;
use crate::time::Fps;
use glam::{DQuat, DVec3};
use std::sync::Arc;

/// How far a rotation may be from a unit quaternion to be one that was rounded.
const ROUNDED: f64 = 1e-3;

/// The most frames of a clip that never moves: they take no bytes, so the file's size does not bound them.
const MOST_STILL: u32 = 100_000;

/// Where a clip's numbers are among the frames of a cache.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Columns {
    /// Frames; none where a recording failed.
    pub(super) frames: u32,
    /// All columns of the first frame.
    pub(super) still: Vec<f32>,
    /// The numbers of the columns that change, ascending.
    pub(super) moving: Vec<u32>,
}

/// A frame's numbers.
fn row(frame: &Frame) -> impl Iterator<Item = f32> {
    let root = frame.pose.root_model.to_array().map(|x| x as f32);
    let rotations = frame.pose.rotations.iter().flat_map(|q| q.to_array().map(|x| x as f32));
    root.into_iter().chain(rotations).chain(frame.weights.iter().copied())
}

impl Columns {
    /// The columns of a clip, and the bytes of those that change, frame by frame.
    pub(super) fn of(clip: &Clip) -> Result<(Columns, Vec<u8>), Error> {
        let frames = u32::try_from(clip.frames().len()).map_err(|_| Error::new("a recording has too many frames"))?;
        let still: Vec<f32> = row(&clip.frames()[0]).collect();
        let mut moves = vec![false; still.len()];
        for frame in clip.frames() {
            for ((moves, first), now) in moves.iter_mut().zip(&still).zip(row(frame)) {
                *moves |= first.to_bits() != now.to_bits();
            }
        }
        if frames > MOST_STILL && !moves.contains(&true) {
            return Err(Error::new(format!("a recording of {frames} frames that never moves is none")));
        }
        let moving: Vec<u32> = (0..).zip(&moves).filter(|(_, moves)| **moves).map(|(at, _)| at).collect();
        let mut bytes = Vec::with_capacity(clip.frames().len() * moving.len() * 4);
        for frame in clip.frames() {
            let changed = row(frame).zip(&moves).filter(|(_, moves)| **moves);
            changed.for_each(|(now, _)| bytes.extend(now.to_le_bytes()));
        }
        Ok((Columns { frames, still, moving }, bytes))
    }

    /// How many bytes the frames take.
    pub(super) fn bytes(&self) -> u64 {
        u64::from(self.frames) * self.moving.len() as u64 * 4
    }

    /// The clip again.
    pub(super) fn clip(
        &self,
        bytes: &[u8],
        rig: &Arc<Skeleton>,
        morphs: &Arc<Vec<String>>,
        fps: Fps,
    ) -> Result<Clip, Error> {
        // Recordings of bodies have no face: their clips have no morphs.
        let none = Arc::new(Vec::new());
        let morphs = if self.still.len() == 3 + 4 * rig.len() { &none } else { morphs };
        if self.frames == 0
            || self.still.len() != 3 + 4 * rig.len() + morphs.len()
            || bytes.len() as u64 != self.bytes()
        {
            return Err(Error::new("its frames do not fit the rig"));
        }
        let mut now = self.still.clone();
        let mut frames = Vec::with_capacity(self.frames as usize);
        for at in 0..self.frames as usize {
            let width = self.moving.len() * 4;
            let numbers = bytes[at * width..(at + 1) * width].chunks_exact(4);
            for (column, number) in self.moving.iter().zip(numbers) {
                now[*column as usize] = f32::from_le_bytes(number.try_into().unwrap_or_default());
            }
            frames.push(frame(&now, rig.len()).ok_or_else(|| Error::new(format!("its frame {at} is no pose")))?);
        }
        Clip::new(rig.clone(), fps, morphs.clone(), frames).ok_or_else(|| Error::new("it has no frames"))
    }

    pub(super) fn write(&self, sink: &mut Sink) {
        sink.u32(self.frames);
        sink.list(&self.still, |sink, x| sink.u32(x.to_bits()));
        sink.list(&self.moving, |sink, at| sink.u32(*at));
    }

    pub(super) fn read(tap: &mut Tap<'_>) -> Result<Columns, Error> {
        let frames = tap.u32()?;
        let still = tap.list(|tap| tap.u32().map(f32::from_bits))?;
        let moving = tap.list(Tap::u32)?;
        let fits = moving.last().is_none_or(|last| (*last as usize) < still.len());
        let still_for_ever = moving.is_empty() && frames > MOST_STILL;
        if (frames == 0) != still.is_empty() || still_for_ever || !fits || !moving.is_sorted_by(|a, b| a < b) {
            return Err(Error::new("its columns are out of order"));
        }
        Ok(Columns { frames, still, moving })
    }
}

/// A frame of numbers; `None` where they are not finite or a rotation is none.
fn frame(row: &[f32], joints: usize) -> Option<Frame> {
    if !row.iter().all(|x| x.is_finite()) {
        return None;
    }
    let (root, rest) = row.split_at(3);
    let (rotations, weights) = rest.split_at(4 * joints);
    let rotation = |q: &[f32]| {
        let q = DQuat::from_xyzw(q[0].into(), q[1].into(), q[2].into(), q[3].into());
        ((q.length() - 1.0).abs() < ROUNDED).then(|| q.normalize())
    };
    let rotations = rotations.chunks_exact(4).map(rotation).collect::<Option<_>>()?;
    let root_model = DVec3::new(root[0].into(), root[1].into(), root[2].into());
    Some(Frame { pose: LocalPose { root_model, rotations }, weights: weights.to_vec() })
}
