// Contact sheets of a lexicon: every sign of a folder at the start, amid and at the end of its stroke, and from the side.
// usage: node lexicon.mjs lexicon/lsf -o out/lsf [--alphabet] [--only NAME,...] [--binary PATH]
// The folder (or single files) may hold .sign files, which the program renders first, or viewer pages.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { withBrowser } from './browser.mjs';
import { openStudio, pageData } from './studio.mjs';

const USAGE = 'usage: node lexicon.mjs FOLDER|FILE... -o OUT [--alphabet] [--only NAME,...] [--binary PATH]';
const SIGNS_A_SHEET = 12, LETTERS_A_SHEET = 30;

// From the head to the hips, with room for raised hands and for elbows.
const FRONT = { position: [0, 1.33, 1.9], target: [0, 1.295, 0], fov: 30 };
// From the signer's right and a little in front, so that depth shows and the near arm hides little.
const SIDE = { position: [-1.75, 1.36, 0.85], target: [0, 1.29, 0.14], fov: 30 };
// Both hands of a two-handed letter.
const HANDS = { position: [0, 1.26, 1.0], target: [0, 1.22, 0.2], fov: 32 };

function readArguments() {
  try {
    const { values, positionals } = parseArgs({
      allowPositionals: true,
      options: {
        out: { type: 'string', short: 'o' }, alphabet: { type: 'boolean' }, only: { type: 'string' },
        binary: { type: 'string' },
      },
    });
    if (!values.out || positionals.length === 0) throw new Error('a folder and -o are needed');
    return { ...values, inputs: positionals };
  } catch (error) {
    console.error(`${error.message}\n${USAGE}`);
    process.exit(2);
  }
}

/** The release program, of this repository unless `--binary` names another. */
function program(given) {
  const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
  const binary = given || path.join(process.env.CARGO_TARGET_DIR || path.join(root, 'target'), 'release/chereme');
  if (!existsSync(binary)) {
    console.error(`there is no ${binary}: cargo build --release first`);
    process.exit(2);
  }
  return binary;
}

/** Files of the wanted kinds among files and folders, in order; `alphabet.sign` in alphabet mode only. */
function gather(inputs, alphabet) {
  const found = inputs.flatMap((input) => (statSync(input).isDirectory()
    ? readdirSync(input).map((name) => path.join(input, name))
      .filter((file) => /\.html$/.test(file) || (/\.sign$/.test(file) && (path.basename(file) === 'alphabet.sign') === Boolean(alphabet)))
    : [input]));
  return found.sort((a, b) => a.localeCompare(b, 'en'));
}

/** Viewer pages of the inputs: `.sign` files are rendered into the temporary folder, one page a sign. */
function pages(files, folder, binary) {
  return files.flatMap((file) => {
    if (file.endsWith('.html')) return [file];
    const out = path.join(folder, path.basename(file, '.sign'));
    mkdirSync(out, { recursive: true });
    try {
      execFileSync(program(binary), ['render', file, '-o', `${out}/`], { stdio: ['ignore', 'ignore', 'inherit'] });
    } catch {
      console.error(`${file}: not rendered (see above)`);
      process.exitCode = 1;
    }
    return readdirSync(out).filter((name) => name.endsWith('.html')).map((name) => path.join(out, name));
  });
}

/** The stroke and the hold of a sign, of the right hand or else the left: { start, end, hold }, seconds. */
function phases(data) {
  for (const name of ['RH Phase', 'LH Phase']) {
    const values = data.tiers.find((tier) => tier.name === name)?.values || [];
    const stroke = values.filter((value) => value.label === 'stroke'), hold = values.filter((value) => value.label === 'hold');
    const all = [...stroke, ...hold];
    if (all.length === 0) continue;
    const start = Math.min(...all.map((value) => value.start));
    const end = stroke.length ? Math.max(...stroke.map((value) => value.end)) : start;
    return { start, end, hold: hold.length ? (hold.at(-1).start + hold.at(-1).end) / 2 : end };
  }
  return { start: 0, end: data.duration, hold: data.duration / 2 };
}

/** The four cells of a sign: start, between, end from the front, the end from the side; of a still one the hand close by. */
function cellsOfSign(data) {
  const cell = (t, camera, label, strong = false) => ({ t, camera, label, strong });
  const { start, end, hold } = phases(data);
  if (end - start < 0.06) {
    return [
      cell(hold, FRONT, `${data.title}  held`, true), cell(hold, SIDE, 'side'),
      cell(hold, 'right-hand', 'right hand'), cell(hold, 'right-palm', 'its palm'),
    ];
  }
  return [
    cell(start, FRONT, `${data.title}  ${start.toFixed(2)}`, true), cell([start, end], FRONT, 'between'),
    cell(end, FRONT, `end ${end.toFixed(2)}`), cell(end, SIDE, 'end, side'),
  ];
}

/** The one cell of a letter: the right hand seen by the addressee, or both where the left one acts too. */
function cellsOfLetter(data) {
  const { start, end, hold } = phases(data);
  const acts = (name) => data.tiers.some((tier) => tier.name === name && tier.values.length > 0);
  const moves = end - start >= 0.06;
  return [{ t: moves ? start : hold, camera: acts('LH Configuration') ? HANDS : 'right-hand', label: `${data.title}${moves ? ', moves' : ''}`, strong: true }];
}

const options = readArguments();
const temporary = mkdtempSync(path.join(tmpdir(), 'chereme-lexicon-'));
try {
  const wanted = options.only?.split(',').map((name) => name.toLowerCase());
  const files = pages(gather(options.inputs, options.alphabet), temporary, options.binary);
  const signs = files.map(pageData).filter((data) => !wanted || wanted.includes(data.title.toLowerCase()));
  if (signs.length === 0) throw new Error('no signs to show');
  await makeSheets(signs, files[0]);
} finally {
  rmSync(temporary, { recursive: true, force: true });
}

/** Draws the sheets; the viewer in `page` is the studio. */
async function makeSheets(signs, page) {
  const cellsOf = options.alphabet ? cellsOfLetter : cellsOfSign, perSheet = options.alphabet ? LETTERS_A_SHEET : SIGNS_A_SHEET;
  const columns = options.alphabet ? 6 : 8, width = options.alphabet ? 230 : 196, height = options.alphabet ? 230 : 235;
  mkdirSync(options.out, { recursive: true });
  const started = performance.now();
  let count = 0;
  await withBrowser(async (context) => {
    const studio = await openStudio(context, page);
    for (let from = 0; from < signs.length; from += perSheet) {
      const some = signs.slice(from, from + perSheet), cells = some.map(cellsOf);
      const rows = Math.ceil(cells.flat().length / columns);
      await studio.open({ columns: Math.min(columns, cells.flat().length), rows, width, height, strip: 20 });
      let at = 0;
      for (const [i, data] of some.entries()) {
        const placed = cells[i].map((cell) => ({ ...cell, at: at++ }));
        await studio.shoot(data, placed);
        count += placed.length;
      }
      const name = path.join(options.out, `${options.alphabet ? 'alphabet' : 'signs'}-${1 + from / perSheet}.png`);
      writeFileSync(name, await studio.picture());
      console.log(`${name}: ${some.map((data) => data.title).join(' ')}`);
    }
    for (const fault of studio.faults) console.error(fault);
    if (studio.faults.length) process.exitCode = 1;
  }, { viewport: { width: 320, height: 240 } });
  console.log(`${count} cells, ${((performance.now() - started) / 1000 / count).toFixed(2)} s each`);
}
