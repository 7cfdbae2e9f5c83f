// Reads BVH files with three.js's BVHLoader and measures every joint of every frame against a table of positions.
//
// node bvh.mjs bol.bvh bol.csv [more pairs]     (cargo run --example joint_positions makes a pair)
//
// The table has frame,joint,x,y,z in metres; X_end is the end of joint X. Fails above 1 mm, and where a wrist or an
// index tip was not compared. No browser: the loader and the mixer need none.
import { readFileSync } from 'node:fs';
import { AnimationMixer, LoopOnce, Vector3 } from 'three';
import { BVHLoader } from 'three/addons/loaders/BVHLoader.js';

const LIMIT_MM = 1, METRES_PER_UNIT = 0.01;
const NEEDED = ['RightHand', 'LeftHand', 'RightHandIndex3_end', 'LeftHandIndex3_end'];

/** Frames of `{ joint: [x, y, z] }`. */
function table(file) {
  const frames = [];
  for (const line of readFileSync(file, 'utf8').trim().split('\n').slice(1)) {
    const [frame, joint, ...xyz] = line.split(',');
    (frames[Number(frame)] ??= {})[joint] = xyz.map(Number);
  }
  return frames;
}

function measure(bvh, csv) {
  const { skeleton, clip } = new BVHLoader().parse(readFileSync(bvh, 'utf8'));
  const expected = table(csv), root = skeleton.bones[0], places = new Map();
  for (const bone of skeleton.bones) {
    if (bone.name === 'ENDSITE') places.set(`${bone.parent.name}_end`, bone);
    else places.set(bone.name, bone);
  }
  const missing = NEEDED.filter((joint) => !places.has(joint) || !expected[0]?.[joint]);
  if (missing.length) throw new Error(`${bvh}: ${missing.join(', ')} cannot be compared`);
  const mixer = new AnimationMixer(root), action = mixer.clipAction(clip);
  action.setLoop(LoopOnce);
  action.clampWhenFinished = true;
  action.play();
  const keys = clip.tracks[0].times, worst = { mm: 0 }, needed = { mm: 0 }, at = new Vector3();
  if (keys.length !== expected.length) throw new Error(`${bvh}: ${keys.length} frames, ${expected.length} in ${csv}`);
  let compared = 0;
  for (let frame = 0; frame < expected.length; frame++) {
    action.time = keys[frame];
    mixer.update(0);
    root.updateMatrixWorld(true);
    for (const [joint, xyz] of Object.entries(expected[frame])) {
      const bone = places.get(joint);
      if (!bone) continue; // the forearm's twist joints are not written
      const mm = at.setFromMatrixPosition(bone.matrixWorld).multiplyScalar(METRES_PER_UNIT).distanceTo(new Vector3(...xyz)) * 1000;
      compared++;
      if (!(mm <= worst.mm)) Object.assign(worst, { mm, joint, frame });
      if (NEEDED.includes(joint) && !(mm <= needed.mm)) Object.assign(needed, { mm, joint, frame });
    }
  }
  const say = ({ mm, joint, frame }) => `${mm.toFixed(4)} mm (${joint}, frame ${frame})`;
  console.log(`${bvh}: ${expected.length} frames, ${skeleton.bones.length} bones, ${compared} places; ` +
    `wrists and index tips within ${say(needed)}, all within ${say(worst)}`);
  return worst.mm <= LIMIT_MM;
}

const files = process.argv.slice(2);
if (!files.length || files.length % 2) {
  console.error('usage: node bvh.mjs file.bvh positions.csv [more pairs]');
  process.exit(2);
}
let good = true;
for (let i = 0; i < files.length; i += 2) good = measure(files[i], files[i + 1]) && good;
if (!good) console.error(`more than ${LIMIT_MM} mm away`);
process.exit(good ? 0 : 1);
