// The avatar: reads the GLB, poses it at any time, and dresses it so that hands can be read.
import { AnimationMixer, BackSide, Color, MeshBasicMaterial, Float32BufferAttribute } from 'three';
import { GLTFLoader } from './GLTFLoader.js';

/** Loads the GLB and returns { root, bones, duration, pose(t) }; `t` is in seconds. */
export async function loadAvatar(bytes) {
  const gltf = await new GLTFLoader().parseAsync(bytes, '');
  const root = gltf.scene, bones = {}, meshes = [];
  root.traverse((object) => {
    if (object.isBone) bones[object.name] = object;
    if (object.isMesh) meshes.push(object);
  });
  const outline = outlineMaterial();
  for (const mesh of meshes) dress(mesh, outline);
  const clip = gltf.animations[0];
  const mixer = new AnimationMixer(root);
  const action = clip ? mixer.clipAction(clip).play() : null;
  const pose = (t) => {
    if (action) {
      action.time = Math.min(Math.max(t, 0), clip.duration);
      mixer.update(0);
    }
    root.updateMatrixWorld(true);
  };
  pose(0);
  return { root, bones, outline, duration: clip ? clip.duration : 0, pose };
}

function dress(mesh, outline) {
  mesh.frustumCulled = false; // the skin moves away from the box the mesh had at rest
  const kind = mesh.material.name;
  const solid = ['face', 'hands', 'suit', 'hair', ''].includes(kind);
  mesh.castShadow = solid;
  mesh.receiveShadow = true;
  if (kind === 'hands') tintPalms(mesh);
  if (kind === 'suit') mesh.material.color.multiplyScalar(1.7); // folds of so dark a cloth would not show
  if (!solid || kind === 'hair') return;
  // The outline is the same mesh inside out, grown by about one pixel.
  const line = mesh.clone();
  line.material = outline;
  line.castShadow = line.receiveShadow = false;
  mesh.parent.add(line);
}

/** Palms are paler than backs of hands; at rest they look down, so the rest normal tells them apart. */
function tintPalms(mesh) {
  const normal = mesh.geometry.getAttribute('normal'), colours = [];
  const palm = new Color(1.28, 1.3, 1.36), back = new Color(1, 1, 1), mixed = new Color();
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
