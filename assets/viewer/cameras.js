// Cameras: the fixed views, and the close-ups that follow the face and the hands.
// Model space: metres, Y up, the signer faces +Z, the signer's left is +X.
import { PerspectiveCamera, Quaternion, Vector3 } from 'three';
import { LAYERS, LONE_OUTLINES } from './avatar.js';

/** The views of the whole upper body, in the order of keys 1 to 5. */
export const VIEWS = {
  front: { position: [0, 1.33, 2.28], target: [0, 1.27, 0], fov: 29 },
  signer: { eyes: true, fov: 78 },
  right: { position: [-2.3, 1.33, 0.2], target: [0, 1.27, 0.12], fov: 29 },
  left: { position: [2.3, 1.33, 0.2], target: [0, 1.27, 0.12], fov: 29 },
  top: { position: [0, 3.05, 0.26], target: [0, 1.1, 0.2], fov: 30 },
};
export const HAND_SIDES = ['front', 'palm', 'back'];
const NAMES = ['right', 'left'];

/** World place of a joint, or null where the rig has none of that name. */
function place(avatar, name) {
  return avatar.bones[name] ? avatar.bones[name].getWorldPosition(new Vector3()) : null;
}

/** The point between the eyes, a little in front of the nose, so that the face is not in the picture. */
export function eyePoint(avatar) {
  const left = place(avatar, 'LeftEye'), right = place(avatar, 'RightEye');
  if (left && right) return left.add(right).multiplyScalar(0.5).add(new Vector3(0, 0.01, 0.05));
  return (place(avatar, 'Head') || new Vector3(0, 1.5, 0)).add(new Vector3(0, 0.08, 0.14));
}

/** Places a camera: {position, target, fov, up?, near?}; returns it. */
function aim(camera, spec) {
  camera.fov = spec.fov || 30;
  camera.near = spec.near || 0.02;
  camera.far = 30;
  camera.up.fromArray(spec.up || [0, 1, 0]);
  camera.position.fromArray(spec.position);
  camera.lookAt(new Vector3().fromArray(spec.target));
  camera.userData.alone = Boolean(spec.only);
  const layers = spec.only ? [LAYERS[spec.only], LONE_OUTLINES[spec.only]] : Object.values(LAYERS);
  for (const layer of layers) camera.layers.enable(layer);
  return camera;
}

function face(avatar) {
  const head = place(avatar, 'Head') || new Vector3(0, 1.5, 0);
  const target = head.add(new Vector3(0, 0.07, 0.03));
  return { position: [target.x, target.y + 0.01, target.z + 0.86], target: target.toArray(), fov: 23 };
}

/** Close-up of a hand, from the front of the signer or squarely onto its palm or back. */
function hand(avatar, name, side) {
  const prefix = name === 'left' ? 'Left' : 'Right';
  const wrist = place(avatar, `${prefix}Hand`);
  if (!wrist) return face(avatar);
  const knuckle = place(avatar, `${prefix}HandMiddle1`) || wrist;
  const tip = place(avatar, `${prefix}HandMiddle3`) || knuckle;
  const centre = wrist.multiplyScalar(0.25).addScaledVector(knuckle, 0.45).addScaledVector(tip, 0.3);
  const distance = 0.62;
  if (side === 'front') {
    const position = [centre.x + (name === 'left' ? 0.05 : -0.05), centre.y + 0.03, centre.z + distance];
    return { position, target: centre.toArray(), fov: 25 };
  }
  // At rest (T-pose) the palms look down and the fingers point away from the body.
  const turn = avatar.bones[`${prefix}Hand`].getWorldQuaternion(new Quaternion());
  const palm = new Vector3(0, -1, 0).applyQuaternion(turn);
  const fingers = new Vector3(name === 'left' ? 1 : -1, 0, 0).applyQuaternion(turn);
  const from = side === 'palm' ? palm : palm.negate();
  const position = centre.clone().addScaledVector(from, distance);
  // Chest and other hand often stand in between, so this hand is drawn alone.
  return { position: position.toArray(), target: centre.toArray(), fov: 25, up: fingers.toArray(), only: name };
}

/**
 * The camera of a name ('front', 'face', 'right-hand', 'left-palm', 'right-back', ...) or of a
 * description {position, target, fov}, for the pose the avatar has now.
 */
export function cameraOf(avatar, spec, aspect, extra = {}) {
  let described = spec;
  if (typeof spec === 'string') {
    const [name, side] = spec.split('-');
    if (extra[spec]) described = extra[spec];
    else if (VIEWS[spec]) described = fit(resolve(avatar, VIEWS[spec]), aspect);
    else if (spec === 'face') described = face(avatar);
    else if (NAMES.includes(name)) described = hand(avatar, name, side === 'hand' || !side ? 'front' : side);
    else throw new Error(`no camera is called "${spec}"`);
  }
  return aim(new PerspectiveCamera(30, aspect), described);
}

/** Gives the signer's own view its place, which depends on where the eyes are now. */
export function resolve(avatar, view) {
  if (!view.eyes) return view;
  const eyes = eyePoint(avatar);
  return { position: eyes.toArray(), target: [eyes.x, eyes.y - 0.44, eyes.z + 0.38], fov: view.fov, near: 0.09 };
}

/** Steps back where the picture is so narrow that the arms would leave it. */
export function fit(view, aspect) {
  const needed = 1;
  if (aspect >= needed || view.near) return view;
  const from = new Vector3().fromArray(view.position), to = new Vector3().fromArray(view.target);
  return { ...view, position: from.sub(to).multiplyScalar(needed / aspect).add(to).toArray() };
}
