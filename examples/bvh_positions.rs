//! Where every joint of a BVH file is on every frame, from the file's own numbers: what other readers are compared with.
//!
//! `cargo run --example bvh_positions -- walk.bvh` prints `frame,joint,x,y,z` in the file's unit and axes; a name that is
//! used twice gets the joint's number. `tools/check_bvhio.py` takes it.

use chereme::format::bvh::{self, Bvh, Channel};
use glam::{DQuat, DVec3};
use std::error::Error;
use std::fmt::Write;

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).ok_or("give a .bvh file")?;
    let bytes = std::fs::read(&path)?;
    let reading = bvh::read(&bytes).map_err(|faults| format!("{path}: {}", faults[0].message))?;
    print!("{}", positions(&reading.bvh)?);
    Ok(())
}

/// A line a joint and frame. Position channels stand in place of the offset; rotations multiply in their order.
fn positions(bvh: &Bvh) -> Result<String, std::fmt::Error> {
    let mut csv = "frame,joint,x,y,z\n".to_owned();
    for (frame, row) in bvh.rows().enumerate() {
        let mut numbers = row.iter();
        let mut posed: Vec<(DVec3, DQuat)> = Vec::with_capacity(bvh.joints().len());
        for (number, joint) in bvh.joints().iter().enumerate() {
            let (mut place, mut turn) = (joint.offset, DQuat::IDENTITY);
            for (channel, value) in joint.channels.iter().zip(&mut numbers) {
                match channel {
                    Channel::Position(axis) => place[*axis as usize] = *value,
                    Channel::Rotation(axis) => turn *= DQuat::from_axis_angle(axis.vector(), value.to_radians()),
                }
            }
            let (origin, parent) = joint.parent.map_or((DVec3::ZERO, DQuat::IDENTITY), |parent| posed[parent]);
            posed.push((origin + parent * place, parent * turn));
            let place = posed[number].0;
            let twice = bvh.joints().iter().filter(|other| other.name == joint.name).count() > 1;
            let name = if twice { format!("{}#{number}", joint.name) } else { joint.name.clone() };
            writeln!(csv, "{frame},{name},{:.7},{:.7},{:.7}", place.x, place.y, place.z)?;
        }
    }
    Ok(csv)
}
