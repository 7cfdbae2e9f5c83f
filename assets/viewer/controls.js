// Buttons, keys and the address's #options; everything a person does ends in one of the `actions`.
import { VIEWS } from './cameras.js';

const by = (id) => document.getElementById(id);

/** Keys, what they do in words, and the action. The help overlay lists this table. */
const KEYS = [
  [[' '], 'Space', 'play or pause', (a) => a.toggle()],
  [[',', 'ArrowLeft'], ', or ←', 'one frame back (Shift: ten)', (a, e) => a.step(e.shiftKey ? -10 : -1)],
  [['.', 'ArrowRight'], '. or →', 'one frame forward (Shift: ten)', (a, e) => a.step(e.shiftKey ? 10 : 1)],
  [['Home'], 'Home', 'to the start', (a) => a.seek(0)],
  [['End'], 'End', 'to the end', (a) => a.seek(Infinity)],
  [['1', '2', '3', '4', '5'], '1 – 5', 'front, signer’s own, right, left, top view', (a, e) => a.setView(Object.keys(VIEWS)[e.key - 1])],
  [['h'], 'H', 'hands from the front, their palm, their back', (a) => a.nextHandSide()],
  [['m'], 'M', 'mirror the picture', (a) => a.setMirror()],
  [['l'], 'L', 'loop the whole or the selected value', (a) => a.setLoop()],
  [['['], '[', 'slower', (a) => a.changeSpeed(-0.1)],
  [[']'], ']', 'faster', (a) => a.changeSpeed(0.1)],
  [['+', '='], '+', 'zoom the timeline in', (a) => a.zoom(0.7)],
  [['-'], '−', 'zoom the timeline out', (a) => a.zoom(1 / 0.7)],
  [['Escape'], 'Esc', 'select nothing', (a) => a.select(null)],
  [['?'], '?', 'this list', (a) => a.help()],
];

export function connect(actions) {
  for (const [, shown, words] of KEYS) {
    const row = by('key-list').insertRow(), key = document.createElement('kbd');
    key.textContent = shown;
    row.insertCell().append(key);
    row.insertCell().textContent = words;
  }
  Object.keys(VIEWS).forEach((name, i) => {
    const button = document.createElement('button');
    Object.assign(button, { id: `view-${name}`, textContent: name === 'signer' ? 'signer’s' : name, title: `View ${name} (${i + 1})` });
    button.onclick = () => actions.setView(name);
    by('views').append(button);
  });
  by('play').onclick = () => actions.toggle();
  by('to-start').onclick = () => actions.seek(0);
  by('back').onclick = () => actions.step(-1);
  by('forward').onclick = () => actions.step(1);
  by('speed').oninput = (event) => actions.setSpeed(+event.target.value);
  by('loop').onclick = () => actions.setLoop();
  by('hands').onclick = () => actions.nextHandSide();
  by('mirror').onclick = () => actions.setMirror();
  by('help-button').onclick = () => actions.help();
  addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || by('help').open) return;
    if (event.target.matches('input') && event.key.startsWith('Arrow')) return;
    if (event.target.matches('button, summary') && event.key === ' ') return; // a focused button keeps its own key
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const found = KEYS.find(([keys]) => keys.includes(key));
    if (!found) return;
    event.preventDefault();
    found[3](actions, event);
  });
}

/** Shows the state of player and views in the bar. */
export function show(player, state) {
  by('play').textContent = player.playing ? '⏸ Pause' : '▶ Play';
  by('speed').value = player.speed;
  by('speed-value').textContent = `${player.speed.toFixed(2)}×`;
  by('loop').setAttribute('aria-pressed', player.looping);
  by('loop').textContent = player.selection ? `Loop: ${player.selection.label.slice(0, 16)}` : 'Loop';
  by('mirror').setAttribute('aria-pressed', state.mirror);
  by('hands').textContent = `Hands: ${state.handSide}`;
  for (const name of Object.keys(VIEWS)) by(`view-${name}`).setAttribute('aria-pressed', name === state.view);
  by('view-label').textContent = (state.view === 'signer' ? 'signer’s own view' : state.view) + (state.mirror ? ', mirrored' : '');
  for (const side of ['right', 'left']) {
    document.querySelector(`#${side}-view i`).textContent = state.handSide === 'front' ? '' : `, ${state.handSide}`;
  }
  by('time-code').textContent = `${player.time.toFixed(3)} / ${player.duration.toFixed(3)} s · frame ${player.frame}/${player.lastFrame} · ${+player.fps.toFixed(3)} fps`;
}

/** The options behind # in the address: t, view, play, hands, mirror, speed. */
export function addressOptions() {
  return Object.fromEntries(new URLSearchParams(location.hash.slice(1)));
}
