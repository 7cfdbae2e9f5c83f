#!/usr/bin/env python3
"""The avatar's skeleton with fingers of another length, to see what in a comparison is the hand's proportion.

usage: tools/short_fingers.py FACTOR [SKELETON] > OUT

Every finger is scaled by FACTOR from its first joint; palm, arm and body stay. SKELETON is assets/avatar.skeleton.json where it is
not said. The program holds the skeleton, so build it with the new one in another work tree (docs/reference.md, "Two bodies")."""
import json
import sys

DIGITS = [side + digit for side in ("LeftHand", "RightHand") for digit in ("Thumb", "Index", "Middle", "Ring", "Pinky")]


def main():
    if not 2 <= len(sys.argv) <= 3:
        sys.exit(__doc__)
    factor = float(sys.argv[1])
    with open(sys.argv[2] if len(sys.argv) == 3 else "assets/avatar.skeleton.json") as file:
        joints = json.load(file)
    for digit in DIGITS:
        root = list(joints[digit + "1"]["pos"])
        for number in "123":
            for key in ("pos", "tail"):
                at = joints[digit + number][key]
                joints[digit + number][key] = [r + (a - r) * factor for r, a in zip(root, at)]
    json.dump(joints, sys.stdout)


main()
