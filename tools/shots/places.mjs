// Pictures of the landmarks: the avatar at rest with every landmark as a labelled dot with its normal.
// usage: node places.mjs OUT_DIR [page...]   (first: npm install, npm install --no-save three@0.185.1)
// It reads assets/avatar.glb and grammar/landmarks.ron; the pages are named below. In the pictures "<" is left at, "<<" left beside.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { withBrowser } from './browser.mjs';

const here = path.dirname(fileURLToPath(import.meta.url)), root = path.resolve(here, '../..');
const require = createRequire(import.meta.url);
const three = path.resolve(path.dirname(require.resolve('three')), '..');
const [out, ...wanted] = process.argv.slice(2);
if (!out) {
  console.error('usage: node places.mjs OUT_DIR [page...]');
  process.exit(2);
}
mkdirSync(out, { recursive: true });

/** Name, joint, offset, normal of every landmark of the table, read line by line as pick_landmarks.py writes them. */
function landmarks() {
  const text = readFileSync(path.join(root, 'grammar/landmarks.ron'), 'utf8');
  const point = /joint: "(\w+)", offset: \(([^)]*)\), normal: \(([^)]*)\)/;
  const found = [];
  let place = '';
  for (const line of text.split('\n')) {
    place = /^ {8}"([^"]+)": \($/.exec(line)?.[1] ?? place;
    const match = point.exec(line);
    if (!match) continue;
    const key = /^ *(centre|at|beside):/.exec(line)?.[1];
    const name = key ? place + { centre: '', at: '<', beside: '<<' }[key] : /"([^"]+)"/.exec(line)[1];
    found.push({ name, body: Boolean(key), joint: match[1], offset: match[2].split(',').map(Number), normal: match[3].split(',').map(Number) });
  }
  return found;
}

const H = [0.74, 1.31, 0.03];
const pages = {
  front: { eye: [0.05, 1.3, 3], target: [0.05, 1.27, 0], height: 0.85, show: 'body' },
  side: { eye: [3, 1.3, 0.01], target: [0, 1.27, 0.03], height: 0.85, show: 'body', hide: true },
  face: { eye: [0, 1.55, 2], target: [0, 1.555, 0], height: 0.27, show: 'body' },
  faceside: { eye: [2, 1.55, 0.6], target: [0, 1.555, 0.05], height: 0.27, show: 'body', hide: true },
  palm: { eye: [H[0], -2, H[2]], target: H, up: [0, 0, 1], height: 0.17, show: 'plain' },
  palmfaces: { eye: [H[0], -2, H[2]], target: H, up: [0, 0, 1], height: 0.17, show: 'faces' },
  back: { eye: [H[0], 4, H[2]], target: H, up: [0, 0, 1], height: 0.17, show: 'plain' },
  backfaces: { eye: [H[0], 4, H[2]], target: H, up: [0, 0, 1], height: 0.17, show: 'faces' },
  thumb: { eye: [H[0], H[1], 3], target: H, height: 0.17, show: 'plain' },
  thumbfaces: { eye: [H[0], H[1], 3], target: H, height: 0.17, show: 'faces' },
  pinky: { eye: [H[0], H[1], -3], target: H, height: 0.17, show: 'plain' },
  thumbclose: { eye: [0.75, 2.4, 1.6], target: [0.72, 1.29, 0.08], height: 0.1, show: 'thumb' },
  thumbpalm: { eye: [0.85, 0.2, 1.3], target: [0.72, 1.29, 0.08], height: 0.1, show: 'thumb' },
  tips: { eye: [3, 1.31, 0.03], target: [0.8, 1.3, 0.03], height: 0.14, show: 'tips' },
  arm: { eye: [0.45, 1.4, 3], target: [0.45, 1.33, 0], height: 0.36, show: 'arm' },
  armtop: { eye: [0.45, 4, 0.02], target: [0.45, 1.33, 0.02], up: [0, 0, -1], height: 0.36, show: 'arm' },
};

const mime = { '.html': 'text/html', '.js': 'text/javascript' };
const server = createServer((request, response) => {
  const url = decodeURIComponent(new URL(request.url, 'http://x').pathname);
  const file = url === '/' ? path.join(here, 'places.html') : url === '/avatar.glb' ? path.join(root, 'assets/avatar.glb')
    : url.startsWith('/three/') ? path.join(three, url.slice(7)) : null;
  try {
    const bytes = file && readFileSync(file);
    response.writeHead(bytes ? 200 : 404, { 'content-type': mime[path.extname(file || '')] || 'application/octet-stream' });
    response.end(bytes || '');
  } catch {
    response.writeHead(404).end();
  }
}).listen(0, '127.0.0.1');
await new Promise((done) => server.once('listening', done));

await withBrowser(async (context) => {
  const page = await context.newPage();
  page.on('console', (message) => console.error(message.text()));
  page.on('pageerror', (error) => console.error(error.message));
  await page.goto(`http://127.0.0.1:${server.address().port}/`);
  await page.waitForFunction('window.ready', null, { timeout: 120000 });
  for (const [name, view] of Object.entries(pages)) {
    if (wanted.length && !wanted.includes(name)) continue;
    const url = await page.evaluate(({ view, marks }) => window.shoot(view, marks), { view, marks: landmarks() });
    writeFileSync(path.join(out, `${name}.png`), Buffer.from(url.split(',')[1], 'base64'));
    console.log(path.join(out, `${name}.png`));
  }
}, { viewport: { width: 1300, height: 1300 } });
server.close();
