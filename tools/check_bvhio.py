#!/usr/bin/env python3
"""Compare where joints are in BVH files: as chereme reads them, and as bvhio (PyPI) does.

usage: check_bvhio.py [--example target/debug/examples/bvh_positions] FILE.bvh...
  cargo build --example bvh_positions && python3 tools/check_bvhio.py ../shared/data/mocap/bvh_oddities/*.bvh

Prints for each file how many positions were compared and by how much they differ at most, in the file's unit and as a part
of the skeleton's size; fails beyond 1e-4 of it (bvhio calculates with 32 bits). A file that one of both refuses is told.
"""
import argparse
import csv
import io
import pathlib
import subprocess
import sys

import bvhio

TOLERANCE = 1e-4


def ours(example, path):
    """{(frame, joint): (x, y, z)} in the order of the file, or what is said of it."""
    run = subprocess.run([example, path], capture_output=True, text=True)
    if run.returncode != 0:
        return run.stderr.strip()
    rows = csv.DictReader(io.StringIO(run.stdout), quoting=csv.QUOTE_NONE)
    return {(int(r["frame"]), r["joint"]): tuple(float(r[axis]) for axis in "xyz") for r in rows}


def theirs(path, frames):
    """The same by bvhio, or what it says. Joints come in the order of the file."""
    try:
        root = bvhio.readAsHierarchy(str(path))
    except Exception as error:  # any of its own
        return f"{type(error).__name__}: {error}"
    joints = [joint for joint, _, _ in root.layout()]
    names = [joint.Name for joint in joints]
    places = {}
    for frame in range(frames):
        root.loadPose(frame)
        for number, joint in enumerate(joints):
            name = joint.Name if names.count(joint.Name) == 1 else f"{joint.Name}#{number}"
            places[frame, name] = tuple(joint.PositionWorld)
    return places


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("files", nargs="+", type=pathlib.Path)
    options.add_argument("--example", default="target/debug/examples/bvh_positions")
    given = options.parse_args()
    failed, compared = False, 0
    for path in given.files:
        mine = ours(given.example, path)
        frames = 0 if isinstance(mine, str) else max((frame for frame, _ in mine), default=-1) + 1
        other = theirs(path, frames)
        if isinstance(mine, str) or isinstance(other, str):
            said = [f"{who} refuses it ({says})" for who, says in [("chereme", mine), ("bvhio", other)] if isinstance(says, str)]
            print(f"{path.name}: " + "; ".join(said))
            continue
        same = mine.keys() == other.keys()
        both = [key for key in mine if key in other]
        apart = [max(abs(a - b) for a, b in zip(mine[key], other[key])) for key in both]
        size = max((max(map(abs, mine[key])) for key in both), default=0.0) or 1.0
        worst = max(apart, default=0.0)
        wrong = not same or worst > TOLERANCE * size
        failed |= wrong
        compared += 1
        print(f"{path.name}: {len(both)} positions of {frames} frames, at most {worst:.2e} apart ({worst / size:.1e} of the size)"
              + ("" if same else "; OTHER JOINTS OR FRAMES") + (" WRONG" if wrong else ""))
    print(f"{compared} of {len(given.files)} files compared")
    sys.exit(failed or compared == 0)


main()
