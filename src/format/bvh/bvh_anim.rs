//! To and from the crate `bvh_anim`'s data, for programs that use it (feature `bvh_anim`).
//!
//! `bvh_anim` has one root, at most one End Site a joint, `f32` numbers, and frame times in whole nanoseconds.

use super::data::{Axis, Bvh, Channel, Joint};
use crate::diagnostics::Error;
use crate::time::Seconds;
use ::bvh_anim::ChannelType;
use glam::DVec3;

impl TryFrom<&::bvh_anim::Bvh> for Bvh {
    type Error = Error;

    /// # Errors
    /// Data that breaks a promise of [`Bvh`], as `bvh_anim` reads it from some files: numbers that are not finite, a frame
    /// time of 0, channels of joints that it lost.
    fn try_from(other: &::bvh_anim::Bvh) -> Result<Bvh, Error> {
        let mut joints = Vec::new();
        for joint in other.joints() {
            let data = joint.data();
            let offset = data.offset();
            let site = data.end_site();
            joints.push(Joint {
                name: data.name().to_string(),
                parent: data.parent_index(),
                offset: DVec3::new(offset.x.into(), offset.y.into(), offset.z.into()),
                channels: data.channels().iter().map(|c| channel(c.channel_type())).collect(),
                end_sites: site.map(|v| DVec3::new(v.x.into(), v.y.into(), v.z.into())).into_iter().collect(),
            });
        }
        let channels: usize = joints.iter().map(|j| j.channels.len()).sum();
        let rows = other.frames().map(::bvh_anim::Frame::as_slice);
        let mut values = Vec::new();
        for row in rows {
            if row.len() != channels {
                let message = format!("a row has {} numbers, and the joints have {channels} channels", row.len());
                return Err(Error::new(message));
            }
            values.extend(row.iter().map(|v| f64::from(*v)));
        }
        Bvh::new(joints, Seconds(other.frame_time().as_secs_f64()), values)
    }
}

impl TryFrom<&Bvh> for ::bvh_anim::Bvh {
    type Error = Error;

    /// Goes through text, which is the crate's only way in: six decimals.
    ///
    /// # Errors
    /// What `bvh_anim` would read as something else: several roots, several End Sites on a joint, a name with
    /// spaces or a colon.
    fn try_from(bvh: &Bvh) -> Result<::bvh_anim::Bvh, Error> {
        for (at, joint) in bvh.joints().iter().enumerate() {
            let lost = match () {
                () if at > 0 && joint.parent.is_none() => "several roots",
                () if joint.end_sites.len() > 1 => "several End Sites on a joint",
                () => continue,
            };
            return Err(Error::new(format!("bvh_anim cannot hold {lost} ({})", joint.name)));
        }
        let refused = |e: &dyn std::fmt::Display| Error::new(format!("bvh_anim refuses the file: {e}"));
        let made = ::bvh_anim::from_str(&super::print(bvh)).map_err(|e| refused(&e))?;
        // It cuts names at colons and at some other characters, without a word.
        let names = made.joints().map(|joint| joint.data().name().to_string());
        match bvh.joints().iter().map(|joint| joint.name.clone()).eq(names) {
            true => Ok(made),
            false => Err(Error::new("bvh_anim cannot hold a joint's name (it cuts at colons and spaces)")),
        }
    }
}

fn channel(kind: ChannelType) -> Channel {
    match kind {
        ChannelType::PositionX => Channel::Position(Axis::X),
        ChannelType::PositionY => Channel::Position(Axis::Y),
        ChannelType::PositionZ => Channel::Position(Axis::Z),
        ChannelType::RotationX => Channel::Rotation(Axis::X),
        ChannelType::RotationY => Channel::Rotation(Axis::Y),
        ChannelType::RotationZ => Channel::Rotation(Axis::Z),
    }
}
