#!/usr/bin/env python3
"""Pick the named places and the hand's contact points on the avatar's skin (grammar/landmarks.ron).

usage: pick_landmarks.py [--avatar assets/avatar.glb] [--skeleton assets/avatar.skeleton.json]
                         [--locations grammar/locations.ron] [--out grammar/landmarks.ron]

Needs numpy only; the same input gives the same bytes. Run it again whenever the avatar or the half-widths in
grammar/locations.ron change; nothing here is a coordinate typed in, every point follows from a rule.

How a point is found: a ray is cast at the mesh at rest (T-pose, palms down, Y up, facing +Z, the signer's left is +X, metres).
It rides on the joint with the greatest skin weight where the ray meets the mesh, except that places of the trunk never ride
on the arm, places on the midline never ride on one side, palm, back, edges and knuckles of the hand never ride on a finger,
and the wrist rides on the forearm. Its normal is the mean of the skin about it, so that it does not follow a crease. Only the
middle and the left are picked and written; the right is the left's mirror image (Left <-> Right, x <-> -x), which is exact
because the avatar is.

The order of the file: the mesh, the profile of the face, places of the body, points of the hand and arm, writing.
"""
import argparse
import json
import re
import struct

import numpy as np

X, Y, Z = np.eye(3)
FINGERS = ('index', 'middle', 'ring', 'pinky')


def unit(v):
    v = np.asarray(v, float)
    return v / np.linalg.norm(v)


# ---------------------------------------------------------------- the mesh

class Mesh:
    """Triangles of the avatar at rest, by material, with the joint weights of their corners."""

    def __init__(self, path):
        data = open(path, 'rb').read()
        size = struct.unpack('<I', data[12:16])[0]
        self.gltf, self.blob = json.loads(data[20:20 + size]), data[28 + size:]
        nodes = self.gltf['nodes']
        self.joints = [nodes[i]['name'] for i in self.gltf['skins'][0]['joints']]
        corners, weights, part, points, morphs = [], [], [], {}, {}
        for mesh in self.gltf['meshes']:
            for primitive in mesh['primitives']:
                name = self.gltf['materials'][primitive['material']]['name']
                attributes = primitive['attributes']
                p = self.accessor(attributes['POSITION']).astype(float)
                w = np.zeros((len(p), len(self.joints)))
                rows = np.arange(len(p))
                joint, weight = self.accessor(attributes['JOINTS_0']), self.accessor(attributes['WEIGHTS_0']) / 255
                for k in range(4):
                    np.add.at(w, (rows, joint[:, k].astype(int)), weight[:, k])
                t = self.accessor(primitive['indices']).reshape(-1, 3).astype(int)
                corners.append(p[t])
                weights.append(w[t])
                part += [name] * len(t)
                points[name] = p
                for target, label in zip(primitive.get('targets', []), mesh.get('extras', {}).get('targetNames', [])):
                    morphs[name, label] = self.accessor(target['POSITION'])
        self.corners, self.weights = np.concatenate(corners), np.concatenate(weights)
        self.part, self.points, self.morphs = np.array(part), points, morphs
        cross = np.cross(self.corners[:, 1] - self.corners[:, 0], self.corners[:, 2] - self.corners[:, 0])
        self.area = np.linalg.norm(cross, axis=1) / 2
        self.normals = cross / np.maximum(self.area * 2, 1e-15)[:, None]
        self.centres = self.corners.mean(1)
        self.owner = np.array(self.joints)[self.weights.mean(1).argmax(1)]

    def accessor(self, index):
        """A glTF accessor as an (n, components) array; sparse ones made dense."""
        a = self.gltf['accessors'][index]
        kinds = {5126: '<f4', 5121: 'u1', 5123: '<u2', 5125: '<u4'}
        width = {'SCALAR': 1, 'VEC2': 2, 'VEC3': 3, 'VEC4': 4, 'MAT4': 16}[a['type']]

        def read(view, offset, kind, count):
            v = self.gltf['bufferViews'][view]
            return np.frombuffer(self.blob, kinds[kind], count, v.get('byteOffset', 0) + offset)

        out = np.zeros(a['count'] * width, kinds[a['componentType']])
        if 'bufferView' in a:
            out = read(a['bufferView'], a.get('byteOffset', 0), a['componentType'], a['count'] * width)
        out = out.reshape(-1, width).copy()
        if 'sparse' in a:
            s = a['sparse']
            rows = read(s['indices']['bufferView'], s['indices'].get('byteOffset', 0), s['indices']['componentType'], s['count'])
            out[rows] = read(s['values']['bufferView'], s['values'].get('byteOffset', 0), a['componentType'],
                             s['count'] * width).reshape(-1, width)
        return out

    def those(self, *parts):
        return np.isin(self.part, parts)

    def ray(self, origin, direction, among, last=False):
        """The first (or last) triangle of `among` that a ray meets: (distance, triangle, barycentric), or None."""
        index = np.where(among)[0]
        a, b, c = self.corners[index].transpose(1, 0, 2)
        d = unit(direction)
        e1, e2 = b - a, c - a
        p = np.cross(d, e2)
        det = (e1 * p).sum(1)
        ok = np.abs(det) > 1e-14
        inv = 1 / np.where(ok, det, 1)
        s = origin - a
        u = (s * p).sum(1) * inv
        q = np.cross(s, e1)
        v = (q @ d) * inv
        t = (e2 * q).sum(1) * inv
        hit = np.where(ok & (u >= -1e-9) & (v >= -1e-9) & (u + v <= 1 + 1e-9) & (t > 1e-6))[0]
        if not len(hit):
            return None
        k = hit[t[hit].argmax() if last else t[hit].argmin()]
        return t[k], index[k], np.array([1 - u[k] - v[k], u[k], v[k]])

    def point(self, hit, radius, among, midline=False, ride=None):
        """A landmark of a ray's hit: position, joint and the mean outward normal of the skin within `radius` metres."""
        _, triangle, weight = hit
        position = weight @ self.corners[triangle]
        flat = self.normals[triangle]
        near = among & (np.linalg.norm(self.centres - position, axis=1) < radius) & (self.normals @ flat > 0.3)
        normal = unit((self.normals[near] * self.area[near, None]).sum(0) + flat * self.area[triangle])
        share = weight @ self.weights[triangle]
        for i, name in enumerate(self.joints):
            if midline and name.startswith(('Left', 'Right')) or ride and not name.startswith(ride):
                share[i] = 0
        if midline:
            position[0] = normal[0] = 0.0
        # an eyeball has no skin weight of the head, yet the place does not turn with the gaze
        joint = self.joints[share.argmax()] if share.any() else ride[0]
        return {'joint': joint, 'position': position, 'normal': unit(normal)}


# ---------------------------------------------------------------- places of the body

TRUNK = ('Hips', 'Spine', 'Neck', 'LeftShoulder', 'RightShoulder')


class Body:
    """Levels of the body read off the mesh and the skeleton, and the 22 places picked by them."""

    def __init__(self, mesh, skeleton, half_width):
        self.mesh = mesh
        self.pos = {name: np.array(joint['pos']) for name, joint in skeleton.items()}
        self.arm = np.linalg.norm(self.pos['LeftForeArm'] - self.pos['LeftArm']) \
            + np.linalg.norm(self.pos['LeftHand'] - self.pos['LeftForeArm'])
        self.half_width = half_width
        self.outer = mesh.those('face', 'hands', 'suit', 'hair', 'eyes')
        self.head = self.outer & np.isin(mesh.owner, ['Head', 'LeftEye', 'RightEye'])
        self.levels()

    def depth(self, y, x=1e-5):
        """How far forward the body's outer surface lies at a height, metres."""
        hit = self.mesh.ray(np.array([x, y, 1.0]), -Z, self.outer)
        return 1 - hit[0] if hit else -np.inf

    def levels(self):
        """Heights (and some depths) of the features of the profile, top down."""
        mesh, pos = self.mesh, self.pos
        top = mesh.corners[self.head][:, :, 1].max()
        y = np.arange(pos['Spine2'][1], top, 0.0005)
        z = np.array([self.depth(h) for h in y])
        between = lambda low, high: np.where((y > low) & (y < high))[0]
        highest = lambda low, high: y[between(low, high)[z[between(low, high)].argmax()]]
        deepest = lambda low, high: y[between(low, high)[z[between(low, high)].argmin()]]
        self.top = top
        self.nose = highest(pos['LeftEye'][1] - 0.06, pos['LeftEye'][1])
        # the lips: the skin that the open mouth takes along begins where they meet
        face, opened = mesh.points['face'], np.linalg.norm(mesh.morphs['face', 'mouth-open'], axis=1)
        lower_lip = face[(np.abs(face[:, 0]) < 0.004) & (opened > 0.5 * opened.max()) & (face[:, 2] > z[between(1.4, 1.6)].max() - 0.02)]
        mouth = lower_lip[:, 1].max()
        self.lips = deepest(mouth - 0.008, mouth + 0.004)
        self.base_of_nose = deepest(self.lips + 0.01, self.nose)
        self.neck_fold = y[[i for i in between(self.lips - 0.06, self.lips - 0.02) if z[i] < z[between(self.lips - 0.03, self.lips)].min() - 0.025][-1]]
        fold_under_lip = deepest(self.lips - 0.022, self.lips - 0.008)
        self.chin = (self.neck_fold + fold_under_lip) / 2
        self.notch = deepest(pos['LeftArm'][1], self.neck_fold)
        raised = np.linalg.norm(mesh.morphs['face', 'eyebrows-left-up'], axis=1)
        self.brows = (face[:, 1] * raised).sum() / raised.sum()
        hair = mesh.those('hair')
        self.hairline = min(h for h in np.arange(self.brows, top, 0.0005)
                            if hair[mesh.ray(np.array([1e-5, h, 1.0]), -Z, self.outer)[1]])
        self.eyes = pos['LeftEye'][1]
        head = mesh.corners[self.head & (mesh.centres[:, 1] > self.brows)]
        self.head_depth = (head[:, :, 2].min() + head[:, :, 2].max()) / 2
        # the trunk from the shoulder line to the hips, in the proportions of data/phonology/locations.tsv
        shoulder, hip = pos['LeftArm'][1], pos['LeftUpLeg'][1]
        down = lambda part: shoulder + (hip - shoulder) * part
        self.shoulders, self.chest, self.stomach, self.below = down(0.06), down(0.30), down(0.57), down(0.84)

    def cast(self, origin, direction, radius, among, x, ride):
        hit = self.mesh.ray(np.asarray(origin, float), direction, among)
        return hit and self.mesh.point(hit, radius, among, midline=x == 0, ride=ride)

    def triple(self, name, ray, wrap, radius, among, ride, past=0.12):
        """The place, `at` (half of the half-width to the left) and `beside` (1.5 of it); past the outline the ray comes from the side."""
        width = self.half_width[name] * self.arm
        out = {}
        for key, x in (('centre', 0.0), ('at', 0.5 * width), ('beside', 1.5 * width)):
            found = self.cast(*ray(x), radius, among, x, ride)
            # a ray that meets the body far behind the place has passed the outline too
            if found is None or x and np.linalg.norm(found['position'] - out['centre']['position'] - [x, 0, 0]) > past:
                found = self.cast(*wrap, radius, among, x, ride)
            assert found, f'{name} {key}: no skin there'
            out[key] = found
        return out

    def front(self, name, y, radius, among, ride, turn, axis=None, past=0.12):
        """A place touched from the front; `turn` degrees off the front is where `beside` lies when it passes the outline.

        Its normals are level, because a hand before the slanting skin of the upper chest is before it and not above it."""
        axis = np.array([0, y, self.head_depth if axis is None else axis])
        side = np.array([np.sin(np.radians(turn)), 0, np.cos(np.radians(turn))])
        found = self.triple(name, lambda x: ([x, y, 1.0], -Z), (axis + side, -side), radius, among, ride, past)
        for point in found.values():
            point['normal'] = unit(point['normal'] * [1, 0, 1])
        return found

    def places(self):
        mesh, pos, head, outer = self.mesh, self.pos, self.head, self.outer
        face = head & mesh.those('face', 'eyes', 'hair')
        out = {}
        side = unit([np.sin(np.radians(50)), np.cos(np.radians(50)), 0])
        crown = np.array([0, self.brows, self.head_depth])
        out['headtop'] = self.triple('headtop', lambda x: ([x, 3.0, self.head_depth], -Y), (crown + side, -side), 0.02, head, ('Head',))
        out['head'] = self.front('head', (self.top + self.neck_fold) / 2, 0.03, head, ('Head',), 80)
        out['forehead'] = self.front('forehead', (self.brows + self.hairline) / 2, 0.015, face, ('Head',), 60)
        out['eyebrows'] = self.front('eyebrows', self.brows, 0.008, face, ('Head',), 60)
        out['eyes'] = self.front('eyes', self.eyes, 0.008, face, ('Head',), 65)
        out['nose'] = self.front('nose', self.nose, 0.008, face, ('Head',), 60)
        tip, base = self.depth(self.nose), self.depth(self.base_of_nose)
        under = base + 0.6 * (tip - base)  # clear of the upper lip
        from_below = lambda x: ([x, self.base_of_nose - 0.01, under], Y)
        found = {'centre': self.cast(*from_below(0.0), 0.006, face, 0, ('Head',))}
        width = self.half_width['nostrils'] * self.arm
        for key, x in (('at', 0.5 * width), ('beside', 1.5 * width)):
            # beside the nostrils is the cheek, which is met from the front
            ray = from_below(x) if key == 'at' else ([x, self.base_of_nose, 1.0], -Z)
            found[key] = self.cast(*ray, 0.006, face, x, ('Head',)) or self.cast([x, self.base_of_nose, 1.0], -Z, 0.006, face, x, ('Head',))
        out['nostrils'] = found
        out['lips'] = self.front('lips', self.lips, 0.014, face, ('Head',), 60)
        for name, among in (('teeth', mesh.those('teeth')), ('tongue', mesh.those('tongue'))):
            corners = mesh.corners[among].reshape(-1, 3)
            front = corners[corners[:, 2] > corners[:, 2].max() - 0.004]
            y = self.lips if front[:, 1].min() < self.lips < front[:, 1].max() else front[:, 1].mean()
            if name == 'teeth':  # the upper row
                y = max(y, (self.lips + front[:, 1].max()) / 2)
            out[name] = self.front(name, y, 0.006, among, ('Head',), 60, axis=corners[:, 2].mean())
        out['chin'] = self.front('chin', self.chin, 0.01, face, ('Head',), 60, axis=0.6 * self.depth(self.chin), past=0.04)
        z = self.depth(self.neck_fold - 0.004) * 0.5 + self.depth(self.chin) * 0.5
        low = self.neck_fold - 0.012
        jaw = unit([0.6, -0.8, 0])  # beside it is the edge of the jaw, a little further back
        inside = np.array([0.01, self.chin + 0.012, z - 0.015])
        out['underchin'] = self.triple('underchin', lambda x: ([x, low, z], Y), (inside + jaw, -jaw), 0.012, face, ('Head',), past=0.01)
        neck = (self.neck_fold + self.notch) / 2
        out['neck'] = self.front('neck', neck, 0.015, outer, ('Neck', 'Head', 'Spine'), 60, axis=pos['Neck'][2])
        for name, y in (('shoulders', self.shoulders), ('chest', self.chest), ('stomach', self.stomach), ('belowstomach', self.below)):
            out[name] = self.front(name, y, 0.03, outer, TRUNK, 45, axis=pos['Spine1'][2])
        out.update(self.pairs(face))
        return out

    def pairs(self, face):
        """Places of which the body has two: the left one, and beside it."""
        mesh, pos = self.mesh, self.pos
        skin = face & mesh.those('face')
        corners = mesh.corners[skin].reshape(-1, 3)
        rim = corners[corners[:, 0] > corners[:, 0].max() - 0.012]
        rim = rim[np.abs(rim[:, 2] - np.median(rim[:, 2])) < 0.03]
        bottom, ear_z = rim[:, 1].min(), rim[:, 2].mean()
        ear_y = (bottom + rim[:, 1].max()) / 2
        lobe_z = rim[rim[:, 1] < bottom + 0.008][:, 2].mean()
        from_left = lambda y, z: ([1.0, y, z], -X)
        out = {}

        def pair(name, ray, beside, radius, among, ride):
            out[name] = {'at': self.cast(*ray, radius, among, 1, ride), 'beside': self.cast(*beside, radius, among, 1, ride)}
            assert out[name]['at'] and out[name]['beside'], name

        pair('ear', from_left(ear_y, ear_z), from_left(ear_y, ear_z), 0.02, skin, ('Head',))
        lobe = from_left(bottom + 0.005, lobe_z)
        pair('earlobe', lobe, lobe, 0.012, skin, ('Head',))
        # the cheek: below the outer corner of the eye, at the height of the nose's underside
        x, y = pos['LeftEye'][0] * 1.7, self.base_of_nose
        aim = unit([0.5, 0, 0.866])
        wide = x + 1.5 * self.half_width['cheek'] * self.arm
        on_front = self.cast([x, y, 1.0], -Z, 0.012, face, 1, ('Head',))['position']
        far = np.array([0, y, self.head_depth]) + np.array([0.9, 0, 0.436])
        pair('cheek', (on_front + aim, -aim), (far, -unit([0.9, 0, 0.436])), 0.012, face, ('Head',))
        # the top of the shoulder: amid the side of the neck and the joint
        neck_side = mesh.corners[self.outer & (mesh.owner == 'Neck')]
        level = (self.neck_fold + self.notch) / 2
        at_level = neck_side[np.abs(neck_side[:, :, 1].mean(1) - level) < 0.01]
        x = (at_level[:, :, 0].max() + pos['LeftArm'][0]) / 2
        down = lambda x: ([x, 3.0, pos['LeftArm'][2]], -Y)
        pair('shouldertop', down(x), down(x + 1.5 * self.half_width['shouldertop'] * self.arm), 0.02, self.outer, TRUNK)
        return out


# ---------------------------------------------------------------- points of the hand and arm

class Limb:
    """Contact points of the left hand and arm; each is met from inside outwards, so that no neighbour is in the way."""

    def __init__(self, mesh, skeleton):
        self.mesh = mesh
        self.pos = {name: np.array(joint['pos']) for name, joint in skeleton.items()}
        self.tail = {name: np.array(joint['tail']) for name, joint in skeleton.items()}
        left = mesh.centres[:, 0] > self.pos['LeftArm'][0] + 0.03
        # inside-out rays must meet the outermost layer: the suit over the arm, skin beyond its cuff
        self.skin = left & mesh.those('hands', 'suit')
        self.hand = left & mesh.those('hands')

    def exit(self, origin, direction, radius, last=False, among=None, ride=None):
        among = self.hand if among is None else among
        hit = self.mesh.ray(origin, direction, among, last=last)
        assert hit, f'no skin from {origin} along {direction}'
        found = self.mesh.point(hit, radius, among)
        return {**found, 'joint': ride} if ride else found

    def digit_frame(self, digit):
        """Joint positions from base to tip, and the dorsal, radial directions of the digit at rest."""
        name = f'LeftHand{digit.capitalize()}'
        joints = [self.pos[name + k] for k in '123'] + [self.tail[name + '3']]
        axis = unit(joints[3] - joints[2])
        if digit != 'thumb':
            dorsal, radial = Y, Z
        else:
            # across the nail the thumb is thinnest; the nail looks away from the palm
            centre = (joints[2] + joints[3]) / 2
            own = self.hand & (self.mesh.owner == name + '3')
            points = self.mesh.corners[own].reshape(-1, 3) - centre
            points -= np.outer(points @ axis, axis)
            values, vectors = np.linalg.eigh(points.T @ points)
            dorsal = vectors[:, 1]  # the least eigenvalue belongs to the axis, which was taken out
            dorsal = dorsal * np.sign(dorsal @ unit(Y + 0.5 * Z))
            radial = np.cross(dorsal, axis)
            radial = radial * np.sign(radial @ unit([-0.5, 0, 1]))
        dorsal = unit(dorsal - (dorsal @ axis) * axis)
        radial = unit(radial - (radial @ axis) * axis)
        radial = unit(radial - (radial @ dorsal) * dorsal)
        return joints, axis, dorsal, radial

    def digit(self, digit):
        joints, axis, dorsal, radial = self.digit_frame(digit)
        one, two, three, tip = joints
        along = lambda a, b, part: a + (b - a) * part
        out = {}
        # the axis of the last phalanx, centred in the skin, and where it leaves the fingertip
        middle = along(three, tip, 0.6)
        up, down = (self.exit(middle, d, 0.003)['position'] for d in (dorsal, -dorsal))
        end = self.exit((up + down) / 2, axis, 0.004)
        length = (end['position'] - three) @ axis

        def station(part):
            """A point inside the last phalanx, amid its dorsal and palmar skin."""
            inside = along(three, three + axis * length, part)
            walls = [self.exit(inside, d, 0.003)['position'] for d in (dorsal, -dorsal)]
            return sum(walls) / 2

        def flanks(name, origin, here, radius, slant=None, ride=None):
            """The point itself, met along `here`, and its four faces; with `slant` the sides are half-way to it."""
            out[name] = self.exit(origin, here, radius, ride=ride)
            faces = {'radial': radial, 'ulnar': -radial, 'dorsal': dorsal, 'palmar': -dorsal}
            for face, d in faces.items():
                if slant is not None and face in ('radial', 'ulnar'):
                    d = d + slant
                out[f'{face} {name}'] = self.exit(origin, unit(d), radius, ride=ride)

        near_end = station(0.86)
        flanks(f'{digit} tip', near_end, axis, 0.004)
        flanks(f'{digit} nail', station(0.68), dorsal, 0.004, slant=dorsal)
        flanks(f'{digit} pad', station(0.55), -dorsal, 0.004, slant=-dorsal)
        pip, mcp, side = (three, two, along(two, three, 0.5)) if digit == 'thumb' else (two, one, along(two, three, 0.5))
        flanks(f'{digit} midjoint', pip, dorsal, 0.004)
        # a knuckle is the head of the metacarpal: it stays with the hand when its finger bends
        flanks(f'{digit} base', mcp, dorsal, 0.006, slant=dorsal, ride='LeftHandThumb1' if digit == 'thumb' else 'LeftHand')
        flanks(f'{digit} side', side, -radial if digit == 'pinky' else radial, 0.004)
        return out

    def limb(self):
        pos, out = self.pos, {}
        wrist, elbow, shoulder = pos['LeftHand'], pos['LeftForeArm'], pos['LeftArm']
        knuckle = {f: pos[f'LeftHand{f.capitalize()}1'] for f in FINGERS}
        along = lambda a, b, part: a + (b - a) * part
        tilt = lambda a, b: unit(a + b)

        def part(name, origin, default, faces, radius, among=None, last=False, ride=None):
            get = lambda d: self.exit(d[0] if isinstance(d, tuple) else origin, unit(d[1] if isinstance(d, tuple) else d), radius, last, among, ride)
            out[name] = get(default)
            for face, d in faces.items():
                out[f'{face} {name}'] = get(d)

        # the hand: two thirds of the way from the wrist to the knuckles, between those of the middle and ring finger
        middle = along(wrist, (knuckle['middle'] + knuckle['ring']) / 2, 0.65)
        toward_index = along(wrist, knuckle['index'], 0.85)
        toward_pinky = along(wrist, knuckle['pinky'], 0.6)
        across = {'radial': (toward_index, -Y), 'ulnar': (toward_pinky, -Y), 'dorsal': (middle, Y), 'palmar': (middle, -Y)}
        # palm, back and edges stay with the hand when a finger bends at the knuckle beside them
        part('palm', middle, -Y, across, 0.008, ride='LeftHand')
        part('back', middle, Y, {**across, 'radial': (toward_index, Y), 'ulnar': (toward_pinky, Y)}, 0.008, ride='LeftHand')
        edge = knuckle['index']
        part('thumb-side', edge, Z, {'radial': Z, 'ulnar': Z, 'dorsal': tilt(Z, Y), 'palmar': tilt(Z, -Y)}, 0.006, ride='LeftHand')
        edge = along(wrist, knuckle['pinky'], 0.6)
        part('pinky-side', edge, -Z, {'radial': -Z, 'ulnar': -Z, 'dorsal': tilt(-Z, Y), 'palmar': tilt(-Z, -Y)}, 0.006, ride='LeftHand')
        # the ball of the thumb: amid its metacarpal, on the palm's side
        one, two = pos['LeftHandThumb1'], pos['LeftHandThumb2']
        out_of_palm = unit(-Y - ((-Y) @ unit(two - one)) * unit(two - one))
        ball = along(one, two, 0.5)
        part('thumb-ball', ball, out_of_palm, {'radial': tilt(out_of_palm, Z), 'ulnar': tilt(out_of_palm, -Z),
                                               'dorsal': -out_of_palm, 'palmar': out_of_palm}, 0.008)
        # the arm: faces turn by a quarter from the elbow (crook forward) to the wrist (palm down)
        def faces(turn):
            c, s = np.cos(turn), np.sin(turn)
            radial, dorsal = Y * c + Z * s, -Z * c + Y * s
            return {'radial': radial, 'ulnar': -radial, 'dorsal': dorsal, 'palmar': -dorsal}

        at_wrist, amid, at_elbow = faces(np.pi / 2), faces(np.pi / 4), faces(0.0)
        # the wrist turns with the forearm and does not bend with the hand
        part('wrist-back', wrist, at_wrist['dorsal'], at_wrist, 0.01, ride='LeftForeArmTwist2')
        part('wrist-pulse', wrist, at_wrist['palmar'], at_wrist, 0.01, ride='LeftForeArmTwist2')
        outer = dict(among=self.skin, last=True)
        part('lower-arm', along(elbow, wrist, 0.5), amid['dorsal'], amid, 0.02, **outer)
        part('elbow', elbow, at_elbow['dorsal'], at_elbow, 0.02, **outer)
        part('elbow-inside', elbow, at_elbow['palmar'], at_elbow, 0.02, **outer)
        part('upper-arm', along(shoulder, elbow, 0.5), at_elbow['radial'], at_elbow, 0.02, **outer)
        return out

    def points(self):
        out = {}
        for digit in ('thumb',) + FINGERS:
            out.update(self.digit(digit))
        out.update(self.limb())
        return out


# ---------------------------------------------------------------- writing

def ron(point, pos):
    numbers = lambda v: '(' + ', '.join(f'{x + 0.0:.5f}' for x in np.round(v, 5) + 0.0) + ')'
    offset = point['position'] - pos[point['joint']]
    return f'(joint: "{point["joint"]}", offset: {numbers(offset)}, normal: {numbers(point["normal"])})'


def write(path, places, points, pos):
    lines = ['// Landmarks on the avatar at rest. Written by tools/pick_landmarks.py; run it again rather than edit.',
             '// joint, offset from that joint (metres, rest axes: X left, Y up, Z out), outward normal of the skin.',
             '// Only the middle and the left: the right is their mirror image. "at" and "beside" are to the left of a place;',
             '// a paired place has no centre, its "at" is the left one.', '(', '    body: {']
    for name, place in places.items():
        fields = [f'{key}: ' + (f'Some({ron(place[key], pos)})' if key == 'centre' else ron(place[key], pos))
                  for key in ('centre', 'at', 'beside') if key in place]
        lines.append(f'        "{name}": (\n            ' + ',\n            '.join(fields) + ',\n        ),')
    lines += ['    },', '    hand: {']
    lines += [f'        "{name}": {ron(point, pos)},' for name, point in points.items()]
    lines += ['    },', ')']
    with open(path, 'w') as file:
        file.write('\n'.join(lines) + '\n')


def half_widths(path):
    """Place -> half-width in arm lengths, from the inventory's rows."""
    rows = re.findall(r'id:\s*"([^"]+)".*?half_width:\s*([0-9.]+)', open(path).read(), re.S)
    return {name: float(width) for name, width in rows}


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument('--avatar', default='assets/avatar.glb')
    options.add_argument('--skeleton', default='assets/avatar.skeleton.json')
    options.add_argument('--locations', default='grammar/locations.ron')
    options.add_argument('--out', default='grammar/landmarks.ron')
    chosen = options.parse_args()
    mesh, skeleton = Mesh(chosen.avatar), json.load(open(chosen.skeleton))
    body = Body(mesh, skeleton, half_widths(chosen.locations))
    places, points = body.places(), Limb(mesh, skeleton).points()
    write(chosen.out, places, points, body.pos)
    print(f'{chosen.out}: {len(places)} places of the body, {len(points)} points of the hand and arm')


if __name__ == '__main__':
    main()
