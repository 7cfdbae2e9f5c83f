// A motion at equal steps of time, a row a page: from the front, with one row from the side where asked.
// usage: node strip.mjs PAGE.html... -o SHEET.png [--cells N] [--from S] [--to S] [--camera front|whole|side|right-hand|right-palm|left-hand]...
import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { parseArgs } from 'node:util';
import { withBrowser } from './browser.mjs';
import { openStudio, pageData } from './studio.mjs';

const USAGE = 'usage: node strip.mjs PAGE.html... -o SHEET.png [--cells N] [--from S] [--to S] [--camera NAME]...';
const CAMERAS = {
  front: { position: [0, 1.33, 1.9], target: [0, 1.295, 0], fov: 30 },
  side: { position: [-1.75, 1.36, 0.85], target: [0, 1.29, 0.14], fov: 30 },
  whole: { position: [0, 1.0, 3.4], target: [0, 0.92, 0], fov: 36 },
};

let parsed;
try {
  parsed = parseArgs({
    allowPositionals: true,
    options: {
      out: { type: 'string', short: 'o' }, cells: { type: 'string', default: '8' }, from: { type: 'string' },
      to: { type: 'string' }, camera: { type: 'string', multiple: true, default: ['front'] },
    },
  });
  if (!parsed.values.out || parsed.positionals.length === 0) throw new Error('a page and -o are needed');
} catch (error) {
  console.error(`${error.message}\n${USAGE}`);
  process.exit(2);
}
const { values: options, positionals: files } = parsed;
const count = Math.max(1, Number(options.cells)), motions = files.map(pageData);

/** The cells of a motion, row by row, each camera a row. */
function cellsOf(data) {
  const from = Number(options.from ?? 0), to = Number(options.to ?? data.duration);
  return options.camera.flatMap((camera) => Array.from({ length: count }, (_, i) => {
    const t = count === 1 ? from : from + ((to - from) * i) / (count - 1);
    return { t, camera: CAMERAS[camera] || camera, label: i ? t.toFixed(2) : `${data.title} ${t.toFixed(2)}`, strong: i === 0 };
  }));
}

await withBrowser(async (context) => {
  const studio = await openStudio(context, files[0]);
  await studio.open({ columns: count, rows: motions.length * options.camera.length, width: 196, height: 235, strip: 20 });
  let at = 0;
  for (const data of motions) await studio.shoot(data, cellsOf(data).map((cell) => ({ ...cell, at: at++ })));
  mkdirSync(path.dirname(options.out), { recursive: true });
  writeFileSync(options.out, await studio.picture());
  for (const fault of studio.faults) console.error(fault);
  if (studio.faults.length) process.exitCode = 1;
  console.log(`${options.out}: ${at} cells`);
}, { viewport: { width: 320, height: 240 } });
