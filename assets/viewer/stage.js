// The stage: light, backdrop, and drawing several views of the avatar on one canvas.
import {
  CanvasTexture, DirectionalLight, HemisphereLight, MathUtils, NeutralToneMapping, PCFShadowMap,
  Scene, SRGBColorSpace, Vector3, WebGLRenderer,
} from 'three';

/** True where WebGL 2 works here; asked first, because three.js writes to the console when it does not. */
export function hasWebGL() {
  try {
    const context = document.createElement('canvas').getContext('webgl2');
    if (!context) return false;
    context.getExtension('WEBGL_lose_context')?.loseContext();
    return true;
  } catch { return false; }
}

export class Stage {
  constructor(canvas, avatar) {
    this.avatar = avatar;
    this.renderer = new WebGLRenderer({ canvas, antialias: true });
    this.renderer.toneMapping = NeutralToneMapping;
    this.renderer.toneMappingExposure = 1.05;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.shadowMap.autoUpdate = false; // once a frame, not once a view
    this.scene = new Scene();
    this.scene.add(avatar.root);
    this.light();
    this.paintBackdrop();
  }

  /** One strong key light from the viewer's upper left with soft shadow, a weak sky, and a rim from behind. */
  light() {
    const key = new DirectionalLight(0xfff4e6, 2.3);
    key.position.set(-1.15, 2.75, 1.75);
    key.target.position.set(0, 1.15, 0.1);
    key.castShadow = true;
    Object.assign(key.shadow.camera, { left: -0.95, right: 0.95, top: 0.95, bottom: -0.95, near: 0.4, far: 4.5 });
    key.shadow.mapSize.set(2048, 2048);
    key.shadow.radius = 3;
    key.shadow.bias = -0.0006;
    key.shadow.normalBias = 0.004;
    const rim = this.rim = new DirectionalLight(0xcfe0ff, 1.3);
    rim.position.set(1.4, 1.9, -1.6);
    rim.target.position.set(0, 1.2, 0);
    this.head = new DirectionalLight(0xffffff, 1.0); // goes with the camera of each view
    this.scene.add(new HemisphereLight(0xe9f0ff, 0x54443c, 0.95), key, key.target, rim, rim.target, this.head, this.head.target);
  }

  /** A vertical gradient in the colours of the page; a mid tone, so that skin and dark cloth both stand out. */
  paintBackdrop() {
    const canvas = document.createElement('canvas');
    canvas.width = 4; canvas.height = 256;
    const pen = canvas.getContext('2d'), style = getComputedStyle(document.documentElement);
    const gradient = pen.createLinearGradient(0, 0, 0, 256);
    gradient.addColorStop(0, style.getPropertyValue('--backdrop-top').trim() || '#b5bdc9');
    gradient.addColorStop(1, style.getPropertyValue('--backdrop-bottom').trim() || '#7d8795');
    pen.fillStyle = gradient;
    pen.fillRect(0, 0, 4, 256);
    this.scene.background?.dispose();
    this.scene.background = new CanvasTexture(canvas);
    this.scene.background.colorSpace = SRGBColorSpace;
  }

  /** Draws one view; `box` is {x, y, width, height} in CSS pixels from the canvas's lower left corner. */
  drawView(camera, box) {
    camera.aspect = box.width / box.height;
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld(true);
    // From the upper left of the picture, so that fingers facing the camera keep a lit and a dark side.
    this.head.position.copy(camera.localToWorld(new Vector3(-0.9, 0.9, 0)));
    this.head.target.position.copy(camera.localToWorld(new Vector3(0, 0, -1)));
    this.head.target.updateMatrixWorld();
    // A hand alone is lit for its camera: turned to the chest, it would get flat light only.
    this.head.intensity = camera.userData.alone ? 2.4 : 0.9;
    this.rim.intensity = camera.userData.alone ? 0.15 : 1.3;
    const pixels = box.height * this.renderer.getPixelRatio();
    const lines = Math.max(1.1, pixels / 420); // wider in large pictures, never thinner than a pixel
    this.avatar.outline.userData.width.value = 2 * Math.tan(MathUtils.degToRad(camera.fov) / 2) / pixels * lines;
    this.renderer.setViewport(box.x, box.y, box.width, box.height);
    this.renderer.setScissor(box.x, box.y, box.width, box.height);
    this.renderer.render(this.scene, camera);
  }

  /** Draws all views: a list of [camera, box]. */
  draw(width, height, views) {
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.renderer.setSize(width, height, false);
    this.renderer.setScissorTest(true);
    this.renderer.shadowMap.needsUpdate = true;
    for (const [camera, box] of views) this.drawView(camera, box);
  }

  /** Draws one view alone, `width` by `height` pixels, and returns it as a PNG data URL. */
  picture(width, height, camera) {
    this.renderer.setPixelRatio(1);
    this.renderer.setSize(width, height, false);
    this.renderer.setScissorTest(false);
    this.renderer.shadowMap.needsUpdate = true;
    this.drawView(camera, { x: 0, y: 0, width, height });
    return this.renderer.domElement.toDataURL('image/png');
  }
}
