// The questionnaire: participant's sheet, one stimulus after the other, the answers as a file.
import { Answers } from './answers.js';
import { loadAvatar } from './avatar.js';
import { cameraOf } from './cameras.js';
import { hasWebGL, Stage } from './stage.js';
import { SCALE, SHEET, WORDS } from './words.js';

const by = (id) => document.getElementById(id);
const bytesOf = (base64) => Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)).buffer;

function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  Object.assign(made, attributes);
  made.append(...children);
  return made;
}

export async function start() {
  const data = JSON.parse(by('chereme-data').textContent);
  let language = navigator.language?.startsWith('fr') ? 'fr' : 'en';
  const say = (words) => words[language];
  if (!hasWebGL()) throw new Error(say(WORDS.noWebGL));
  const avatar = await loadAvatar(bytesOf(data.glb));
  const stage = new Stage(by('gl'), avatar);
  const answers = new Answers(data.id);
  let place = answers.state.sheet ? answers.state.rows.length : -1;
  const show = { time: 0, playing: false, dirty: true, views: 0, since: 0 };

  const draw = () => {
    show.dirty = false;
    const { clientWidth: width, clientHeight: height } = by('gl');
    if (!width || !height) return;
    avatar.pose(show.time);
    stage.draw(width, height, [[cameraOf(avatar, 'front', width / height), { x: 0, y: 0, width, height }]]);
  };

  const play = () => {
    Object.assign(show, { time: 0, playing: true, dirty: true, views: show.views + 1 });
    label();
  };
  const label = () => { by('play').textContent = say(show.playing ? WORDS.playing : show.views ? WORDS.again : WORDS.play); };

  /** A question with one radio button a choice; choices are [value, label]. */
  const radios = (name, legend, choices, className = 'choices') => {
    const list = element('div', { className });
    choices.forEach(([value, text, number]) => {
      const input = element('input', { type: 'radio', name, value });
      list.append(element('label', {}, input, ...(number ? [element('span', { className: 'number', textContent: number })] : []), element('span', { textContent: text })));
    });
    return element('fieldset', { id: `field-${name}` }, element('legend', { textContent: legend }), list);
  };

  /** The values of a form's questions, or null (and the gaps marked) where one is missing. */
  const values = (form, names) => {
    const chosen = {};
    let first = null;
    for (const name of names) {
      const field = form.querySelector(`#field-${name}`), number = field.querySelector('input[type=number]');
      const value = number ? (number.checkValidity() ? number.value : '') : field.querySelector('input:checked')?.value ?? '';
      field.classList.toggle('missing', !value);
      if (!value) first ??= field;
      chosen[name] = value;
    }
    by('message').hidden = !first;
    by('message').textContent = say(WORDS.missing);
    first?.querySelector('input').focus();
    return first ? null : chosen;
  };

  const showSheet = () => {
    const form = by('sheet');
    form.replaceChildren(element('p', { textContent: say(data.introduction) }));
    for (const { name, label: text, choices } of SHEET) {
      if (choices) form.append(radios(name, say(text), choices.map(([value, words]) => [value, say(words)])));
      else {
        const input = element('input', { type: 'number', min: 1, max: 120, required: true, inputMode: 'numeric' });
        input.setAttribute('aria-label', say(text));
        form.append(element('fieldset', { id: `field-${name}` }, element('legend', { textContent: say(text) }), input));
      }
    }
    form.append(element('button', { className: 'main', textContent: say(WORDS.begin) }));
    form.noValidate = true;
  };

  const showTask = (fresh) => {
    const task = data.tasks[place], question = data.questions[task.question];
    if (fresh) {
      avatar.choose(task.stimulus);
      Object.assign(show, { time: 0, playing: false, dirty: true, views: 0, since: performance.now() });
    }
    by('progress').max = data.tasks.length;
    by('progress').value = place;
    by('progress-text').textContent = say(WORDS.progress)(place + 1, data.tasks.length);
    const form = by('questions');
    const kept = fresh ? {} : Object.fromEntries(new FormData(form));
    form.replaceChildren();
    if (question.choices.length) form.append(radios('answer', say(question.prompt), question.choices.map((c) => [c.value, say(c)])));
    form.append(radios('realism', say(WORDS.realism), SCALE.map((words, i) => [String(i + 1), say(words), String(i + 1)]), 'scale'));
    form.append(element('button', { className: 'main', textContent: say(WORDS.next) }));
    for (const input of form.querySelectorAll('input')) input.checked = kept[input.name] === input.value;
    label();
    if (fresh) {
      by('play').focus({ preventScroll: true });
      scrollTo(0, 0);
      if (!matchMedia('(prefers-reduced-motion: reduce)').matches) play();
    }
  };

  const showEnd = () => {
    for (const [id, words] of [['thanks', WORDS.thanks], ['explain', WORDS.explain], ['download', WORDS.download], ['copy-label', WORDS.copy]]) {
      by(id).textContent = say(words);
    }
    by('copy').value = answers.csv();
  };

  const render = (fresh = true) => {
    document.documentElement.lang = language;
    document.title = by('title').textContent = say(data.title);
    for (const name of ['fr', 'en']) by(name).setAttribute('aria-pressed', String(name === language));
    by('message').hidden = true;
    const ended = place >= data.tasks.length;
    by('sheet').hidden = place >= 0;
    by('task').hidden = place < 0 || ended;
    by('end').hidden = !ended;
    if (place < 0) showSheet();
    else if (ended) showEnd();
    else showTask(fresh);
  };

  by('sheet').addEventListener('submit', (event) => {
    event.preventDefault();
    const sheet = values(by('sheet'), SHEET.map((field) => field.name));
    if (!sheet) return;
    answers.setSheet(sheet);
    place = 0;
    render();
  });
  by('questions').addEventListener('submit', (event) => {
    event.preventDefault();
    const task = data.tasks[place], asked = data.questions[task.question].choices.length ? ['answer', 'realism'] : ['realism'];
    if (!show.views) {
      by('message').textContent = say(WORDS.unseen);
      by('message').hidden = false;
      return;
    }
    const given = values(by('questions'), asked);
    if (!given) return;
    answers.add({ ...given, language, stimulus: task.stimulus, views: show.views, seconds: Math.round((performance.now() - show.since) / 1000) });
    place += 1;
    render();
  });
  by('play').addEventListener('click', play);
  by('download').addEventListener('click', () => {
    const file = URL.createObjectURL(new Blob([answers.csv()], { type: 'text/csv' }));
    element('a', { href: file, download: `${data.id}-${answers.state.participant}.csv` }).click();
    setTimeout(() => URL.revokeObjectURL(file), 10000);
    answers.forget();
  });
  for (const name of ['fr', 'en']) by(name).addEventListener('click', () => { language = name; render(false); });
  new ResizeObserver(() => { show.dirty = true; }).observe(by('gl'));

  window.chereme = { tasks: data.tasks.length, csv: () => answers.csv(), seek(t) { Object.assign(show, { time: t, playing: false }); draw(); }, duration: () => avatar.duration };
  render();
  draw();
  window.DONE = 1;
  let last = performance.now();
  const loop = (now) => {
    requestAnimationFrame(loop);
    if (show.playing) {
      show.time += Math.min((now - last) / 1000, 0.5);
      show.dirty = true;
      if (show.time >= avatar.duration) {
        Object.assign(show, { time: avatar.duration, playing: false });
        label();
      }
    }
    last = now;
    if (show.dirty) draw();
  };
  requestAnimationFrame(loop);
}
