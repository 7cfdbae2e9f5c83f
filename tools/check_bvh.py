"""Opens BVH and GLB files in Blender and measures every joint of every frame against a table of positions; by hand, not in CI.

    python3.11 -m venv venv && venv/bin/pip install bpy
    cargo run --example joint_positions -- lexicon/lsf/bol.sign out/bol
    venv/bin/python tools/check_bvh.py out/bol.bvh out/bol.csv [more pairs]
    venv/bin/python tools/check_bvh.py out/bol.glb out/bol.csv     (chereme render lexicon/lsf/bol.sign -o out/bol.glb)

The table has frame,joint,x,y,z in metres, Y up; X_end is the end of joint X, Blender's bone tail. Blender turns the file
(x, y, z) to (x, -z, y). Fails above 1 mm, and where a wrist or an index tip was not compared.
"""

import csv
import sys

import bpy

LIMIT_MM = 1.0
NEEDED = {"RightHand", "LeftHand", "RightHandIndex3_end", "LeftHandIndex3_end"}


def opened(path):
    """The rig of a file, and the number of its first frame."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    if path.endswith(".glb"):
        # Blender turns seconds into frames at the scene's rate when it imports.
        bpy.context.scene.render.fps = 60
        bpy.ops.import_scene.gltf(filepath=path)
        return next(o for o in bpy.data.objects if o.type == "ARMATURE"), 0
    bpy.ops.import_anim.bvh(filepath=path, axis_forward="-Z", axis_up="Y", global_scale=0.01, update_scene_fps=True)
    return bpy.context.object, 1


def measure(bvh, table):
    rig, first = opened(bvh)
    scene = bpy.context.scene
    frames = {}
    with open(table, newline="") as file:
        for row in csv.DictReader(file):
            place = (float(row["x"]), -float(row["z"]), float(row["y"]))
            frames.setdefault(int(row["frame"]), {})[row["joint"]] = place
    compared, seen = 0, set()
    worst = needed = (0.0, "", 0)
    for frame, joints in sorted(frames.items()):
        scene.frame_set(frame + first)
        for joint, place in joints.items():
            bone = rig.pose.bones.get(joint.removesuffix("_end"))
            if bone is None:
                continue  # the forearm's twist joints are not written
            if first == 0 and joint.endswith("_end"):
                continue  # glTF has no bone ends; Blender makes them up
            at = rig.matrix_world @ (bone.tail if joint.endswith("_end") else bone.head)
            mm = sum((a - b) ** 2 for a, b in zip(at, place)) ** 0.5 * 1000
            compared += 1
            seen.add(joint)
            worst = max(worst, (mm, joint, frame))
            if joint in NEEDED:
                needed = max(needed, (mm, joint, frame))
    wanted = NEEDED if first else {joint for joint in NEEDED if not joint.endswith("_end")}
    if not wanted <= seen:
        sys.exit(f"{bvh}: {', '.join(sorted(wanted - seen))} cannot be compared")
    last = round(rig.animation_data.action.frame_range[1]) + 1 - first
    if last != len(frames):
        sys.exit(f"{bvh}: {last} frames, {len(frames)} in {table}")
    fps = scene.render.fps / scene.render.fps_base
    forearm, hand = rig.data.bones["RightForeArm"], rig.data.bones["RightHand"]
    gap = (forearm.tail_local - hand.head_local).length * 1000
    ends = f"forearm ends {gap:.3f} mm from the wrist; " if first else ""
    print(f"{bvh}: {len(frames)} frames at {fps:.6f}, {len(rig.data.bones)} bones, {compared} places; {ends}wrists and index tips within {needed[0]:.4f} mm ({needed[1]}, frame {needed[2]}), "
          f"all within {worst[0]:.4f} mm ({worst[1]}, frame {worst[2]})")
    return worst[0] <= LIMIT_MM


if __name__ == "__main__":
    files = sys.argv[1:]
    if not files or len(files) % 2:
        sys.exit(__doc__)
    results = [measure(*pair) for pair in zip(files[::2], files[1::2])]
    sys.exit(0 if all(results) else f"more than {LIMIT_MM} mm away")
