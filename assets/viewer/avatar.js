// The avatar: reads the GLB, poses it at any time, and dresses it so that hands can be read.
import {
  AnimationMixer, BackSide, BufferAttribute, BufferGeometry, Color, Float32BufferAttribute, MeshBasicMaterial,
} from 'three';
import { GLTFLoader } from './GLTFLoader.js';

/** Layers of the drawing; 0 is left to the lights. A close-up of one hand shows the forearm of its side only. */
export const LAYERS = { body: 1, right: 2, left: 3 };
/** Outlines of a forearm drawn alone; drawn beside the body, their open ends would show as rings at the elbows. */
export const LONE_OUTLINES = { right: 4, left: 5 };

const OUTLINED = ['face', 'hands', 'suit', ''];

/** In the T-pose, what is this far from the middle (metres) is forearm and hand. */
const FOREARM = 0.4;

/**
 * Loads the GLB and returns { root, bones, duration, pose(t), choose(name) }; `t` is in seconds. The first motion is posed
 * until another one is chosen by its name.
 */
export async function loadAvatar(bytes) {
  const gltf = await new GLTFLoader().parseAsync(bytes, '');
  const root = gltf.scene, bones = {}, meshes = [];
  root.traverse((object) => {
    if (object.isBone) bones[object.name] = object;
    if (object.isMesh) meshes.push(object);
  });
  const outline = outlineMaterial();
  for (const mesh of meshes) {
    for (const piece of split(mesh)) {
      dress(piece);
      const side = Object.keys(LONE_OUTLINES).find((name) => piece.layers.isEnabled(LAYERS[name]));
      if (side) addOutline(piece, outline, LONE_OUTLINES[side]);
    }
    if (OUTLINED.includes(mesh.material.name)) addOutline(mesh, outline, LAYERS.body);
  }
  const mixer = new AnimationMixer(root);
  let clip = gltf.animations[0];
  let action = clip ? mixer.clipAction(clip).play() : null;
  const pose = (t) => {
    if (action) {
      action.time = Math.min(Math.max(t, 0), clip.duration);
      mixer.update(0);
    }
    root.updateMatrixWorld(true);
  };
  const avatar = { root, bones, outline, duration: clip ? clip.duration : 0, pose };
  /** Poses another motion from now on; joints that it leaves alone go back to rest. */
  avatar.choose = (name) => {
    const chosen = gltf.animations.find((animation) => animation.name === name);
    if (!chosen) throw new Error(`the avatar has no motion "${name}"`);
    action?.stop();
    clip = chosen;
    action = mixer.clipAction(clip).play();
    avatar.duration = clip.duration;
    pose(0);
  };
  pose(0);
  return avatar;
}

/** Splits the parts that have forearms or hands into right, left and body, each on its layer. */
function split(mesh) {
  const whole = mesh.geometry, position = whole.getAttribute('position'), corners = { body: [], right: [], left: [] };
  if (!whole.index || !['hands', 'suit'].includes(mesh.material.name)) {
    mesh.layers.set(LAYERS.body);
    return [mesh];
  }
  if (mesh.material.name === 'hands') tintPalms(mesh);
  for (let i = 0; i < whole.index.count; i += 3) {
    const three = [0, 1, 2].map((k) => whole.index.getX(i + k)), x = position.getX(three[0]);
    corners[x < -FOREARM ? 'right' : x > FOREARM ? 'left' : 'body'].push(...three);
  }
  mesh.visible = false;
  return Object.keys(corners).filter((side) => corners[side].length).map((side) => {
    const geometry = new BufferGeometry(), piece = mesh.clone();
    for (const [name, attribute] of Object.entries(whole.attributes)) geometry.setAttribute(name, attribute);
    geometry.setIndex(new BufferAttribute(new Uint32Array(corners[side]), 1));
    Object.assign(geometry, { morphAttributes: whole.morphAttributes, morphTargetsRelative: whole.morphTargetsRelative });
    Object.assign(piece, { geometry, visible: true });
    piece.layers.set(LAYERS[side]);
    mesh.parent.add(piece);
    return piece;
  });
}

function dress(mesh) {
  mesh.frustumCulled = false; // the skin moves away from the box the mesh had at rest
  const kind = mesh.material.name;
  mesh.castShadow = ['face', 'hands', 'suit', 'hair', ''].includes(kind);
  mesh.receiveShadow = true;
  // Folds of so dark a cloth would not show. (The pieces share one material.)
  if (kind === 'suit') mesh.material.color.set(0x4d5872);
}

/** The outline is the same mesh inside out, grown by about one pixel. */
function addOutline(mesh, material, layer) {
  const line = mesh.clone();
  Object.assign(line, { material, visible: true, castShadow: false, receiveShadow: false, frustumCulled: false });
  line.layers.set(layer);
  // Clones copy the weights of the moment; the same array follows the animation.
  line.morphTargetInfluences = mesh.morphTargetInfluences;
  mesh.parent.add(line);
}

/** Palms are paler than backs of hands; at rest they look down, so the rest normal tells them apart. */
function tintPalms(mesh) {
  const normal = mesh.geometry.getAttribute('normal'), colours = [];
  const palm = new Color(1.16, 1.2, 1.24), back = new Color(1, 1, 1), mixed = new Color();
  for (let i = 0; i < normal.count; i++) {
    const down = Math.min(Math.max(-normal.getY(i) * 1.25 + 0.15, 0), 1);
    mixed.copy(back).lerp(palm, down * down * (3 - 2 * down));
    colours.push(mixed.r, mixed.g, mixed.b);
  }
  mesh.geometry.setAttribute('color', new Float32BufferAttribute(colours, 3));
  mesh.material.vertexColors = true;
}

/** Draws back faces only, pushed out along the normal by a constant width on the screen. */
function outlineMaterial() {
  const material = new MeshBasicMaterial({ color: 0x1b1512, side: BackSide, transparent: true, opacity: 0.72 });
  const width = { value: 0.001 };
  material.onBeforeCompile = (shader) => {
    shader.uniforms.outlineWidth = width;
    shader.vertexShader = 'uniform float outlineWidth;\n' + shader.vertexShader.replace(
      '#include <project_vertex>',
      `#include <project_vertex>
       mvPosition.xyz -= normalize(normalMatrix * objectNormal) * outlineWidth * mvPosition.z;
       gl_Position = projectionMatrix * mvPosition;`);
  };
  // `width` is the angle that one outline takes; the stage sets it for each view before drawing.
  material.userData.width = width;
  return material;
}
