// Joins the parts: reads the data in the page, draws when something changed, offers window.chereme.
import { OrbitControls } from './OrbitControls.js';
import { loadAvatar } from './avatar.js';
import { cameraOf, eyePoint, fit, HAND_SIDES, resolve, VIEWS } from './cameras.js';
import { addressOptions, connect, show } from './controls.js';
import { Player } from './player.js';
import { hasWebGL, Stage } from './stage.js';
import { wristSpeeds } from './speed.js';
import { Timeline } from './timeline.js';

const by = (id) => document.getElementById(id);

function bytesOf(base64) {
  return Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)).buffer;
}

function showFacts(data) {
  document.title = data.title ? `${data.title} – sign viewer` : 'Sign viewer';
  by('title').textContent = data.language ? `${data.title} (${data.language})` : data.title;
  for (const [label, text] of data.facts || []) {
    const term = document.createElement('dt'), value = document.createElement('dd');
    term.textContent = label;
    value.textContent = text;
    by('fact-list').append(term, value);
  }
  by('facts').open = by('main-view').clientWidth > 480;
}

export async function start() {
  const data = JSON.parse(by('chereme-data').textContent);
  showFacts(data);
  if (!hasWebGL()) {
    throw new Error('This browser offers no WebGL 2, which the avatar needs. Another browser, or turning on hardware acceleration, should help.');
  }
  const avatar = await loadAvatar(bytesOf(data.glb));
  const duration = data.duration || avatar.duration, fps = data.fps || 60;
  const stage = new Stage(by('gl'), avatar);
  const player = new Player(duration, fps);
  const state = { view: 'front', handSide: 'front', mirror: false, dirty: true };
  const named = (data.still && data.still.cameras) || {};
  const touch = () => { state.dirty = true; };
  const timeline = new Timeline({
    tiers: data.tiers || [], duration, speeds: wristSpeeds(avatar, duration, fps),
    seek: (t) => actions.seek(t), select: (value) => actions.select(value),
  });

  const aspect = () => by('main-view').clientWidth / Math.max(by('main-view').clientHeight, 1);
  const camera = cameraOf(avatar, 'front', aspect());
  const orbit = new OrbitControls(camera, by('main-view'));
  Object.assign(orbit, { minDistance: 0.25, maxDistance: 6, zoomSpeed: 0.7 });
  orbit.addEventListener('change', touch);
  let eyes = null; // where the eyes were at the last frame, while the view is the signer's own

  const actions = {
    seek(t) { player.seek(t); touch(); },
    step(frames) { player.step(frames); touch(); },
    toggle() { player.toggle(); touch(); },
    select(value) { timeline.selected = player.selection = value; touch(); },
    setSpeed(speed) { player.speed = Math.min(Math.max(speed, 0.1), 2); touch(); },
    changeSpeed(by) { actions.setSpeed(Math.round((player.speed + by) * 20) / 20); },
    setLoop(on = !player.looping) { player.looping = on; touch(); },
    setMirror(on = !state.mirror) { state.mirror = on; touch(); },
    nextHandSide() { state.handSide = HAND_SIDES[(HAND_SIDES.indexOf(state.handSide) + 1) % HAND_SIDES.length]; touch(); },
    zoom(factor) { timeline.zoom(factor); },
    help() { by('help').showModal(); },
    setView(name) {
      if (!VIEWS[name]) throw new Error(`no view is called "${name}"; there are ${Object.keys(VIEWS).join(', ')}`);
      const view = fit(resolve(avatar, VIEWS[name]), aspect());
      camera.fov = view.fov;
      camera.near = view.near || 0.02;
      camera.position.fromArray(view.position);
      orbit.target.fromArray(view.target);
      orbit.update();
      eyes = VIEWS[name].eyes ? eyePoint(avatar) : null;
      state.view = name;
      touch();
    },
  };

  /** The frames of the page in pixels from the canvas's lower left corner; a mirror exchanges the sides. */
  const boxes = () => {
    const home = by('stage').getBoundingClientRect();
    return ['main-view', 'face-view', 'right-view', 'left-view'].map((id) => {
      const frame = by(id).getBoundingClientRect();
      const x = state.mirror ? home.right - frame.right : frame.left - home.left;
      return { x, y: home.bottom - frame.bottom, width: Math.max(frame.width, 1), height: Math.max(frame.height, 1) };
    });
  };

  const draw = () => {
    state.dirty = false;
    avatar.pose(player.time);
    if (eyes) { // the signer's own view goes with the head
      const moved = eyePoint(avatar).sub(eyes);
      eyes.add(moved);
      camera.position.add(moved);
      orbit.target.add(moved);
    }
    camera.lookAt(orbit.target);
    const side = state.handSide === 'front' ? 'hand' : state.handSide;
    const cameras = [camera, ...['face', `right-${side}`, `left-${side}`].map((name) => cameraOf(avatar, name, 1, named))];
    const places = boxes();
    by('gl').style.transform = state.mirror ? 'scaleX(-1)' : '';
    stage.draw(by('stage').clientWidth, by('stage').clientHeight, cameras.map((one, i) => [one, places[i]]));
    timeline.move(player.time);
    show(player, state);
  };

  connect(actions);
  new ResizeObserver(touch).observe(by('stage'));
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => { timeline.readColours(); stage.paintBackdrop(); touch(); });

  const options = addressOptions();
  actions.setView(VIEWS[options.view] ? options.view : 'front');
  if (options.t) actions.seek(+options.t || 0);
  if (options.speed) actions.setSpeed(+options.speed || 1);
  if (HAND_SIDES.includes(options.hands)) state.handSide = options.hands;
  state.mirror = options.mirror === '1';
  player.playing = options.play ? options.play === '1' : !matchMedia('(prefers-reduced-motion: reduce)').matches;

  window.chereme = {
    duration, fps, speeds: timeline.speeds, tiers: timeline.tiers, player,
    seek(t) { player.playing = false; player.seek(t); draw(); },
    setView(name) { actions.setView(name); draw(); },
    /** Where every joint is at a time: { name: [x, y, z] } in metres, as three.js poses the avatar. */
    places(t) {
      avatar.pose(t);
      const of = ({ matrixWorld: { elements } }) => [12, 13, 14].map((i) => elements[i]);
      return Object.fromEntries(Object.entries(avatar.bones).map(([name, bone]) => [name, of(bone)]));
    },
    /** A picture of the pose of now as a PNG data URL; `spec` is a camera's name or {position, target, fov}. */
    renderTo(width, height, spec) {
      avatar.pose(player.time);
      const picture = stage.picture(width, height, cameraOf(avatar, spec, width / height, named));
      touch();
      return picture;
    },
  };

  draw();
  window.DONE = 1;
  let last = performance.now();
  const loop = (now) => {
    requestAnimationFrame(loop);
    if (player.playing) {
      player.advance(Math.min((now - last) / 1000, 0.5)); // a page that slept does not jump
      touch();
    }
    last = now;
    if (state.dirty) draw();
  };
  requestAnimationFrame(loop);
}
