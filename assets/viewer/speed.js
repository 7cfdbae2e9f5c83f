// Kinematics read back from the animation: the speed of each wrist.
import { Vector3 } from 'three';

/** Samples at most this many moments, so that a whole song opens quickly. */
const MOST = 20000;

/**
 * Wrist speeds over the animation: { step, right, left, top } with `step` in seconds, speeds in m/s
 * (central differences), `top` the highest.
 */
export function wristSpeeds(avatar, duration, fps) {
  const count = Math.min(Math.max(Math.round(duration * fps) + 1, 2), MOST);
  const step = duration / (count - 1) || 1 / fps;
  const paths = { right: [], left: [] };
  for (let i = 0; i < count; i++) {
    avatar.pose(i * step);
    for (const [side, bone] of [['right', 'RightHand'], ['left', 'LeftHand']]) {
      paths[side].push(avatar.bones[bone] ? avatar.bones[bone].getWorldPosition(new Vector3()) : new Vector3());
    }
  }
  const speeds = (path) => path.map((_, i) => {
    const a = Math.max(i - 1, 0), b = Math.min(i + 1, path.length - 1);
    return path[b].distanceTo(path[a]) / ((b - a) * step);
  });
  const right = speeds(paths.right), left = speeds(paths.left);
  const top = [...right, ...left].reduce((most, value) => Math.max(most, value), 0);
  return { step, right, left, top };
}

/** A round distance between grid lines (1, 2 or 5 times a power of ten) giving about `wanted` of them. */
export function roundStep(range, wanted) {
  const rough = range / Math.max(wanted, 1), power = 10 ** Math.floor(Math.log10(rough || 1));
  return power * ([1, 2, 5].find((factor) => factor * power >= rough) || 10);
}
