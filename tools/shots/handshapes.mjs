// Contact sheets of the handshapes on the avatar's right hand.
// usage: cargo run --release --example solve_handshapes -- --keep --dump rotations.json
//        node handshapes.mjs rotations.json OUT_DIR [views] [ids]
// Views, separated by commas: palm back thumb oblique front pinky (default palm,thumb); ids: all when left out.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { withBrowser } from './browser.mjs';

const here = path.dirname(fileURLToPath(import.meta.url)), assets = path.resolve(here, '../../assets');
const [rotations, out, views = 'palm,thumb', ids] = process.argv.slice(2);
if (!out) {
  console.error('usage: node handshapes.mjs rotations.json OUT_DIR [views] [ids]');
  process.exit(2);
}
const COLUMNS = 6, PER_SHEET = 30;
const wanted = ids?.split(','), names = views.split(',');
const shapes = JSON.parse(readFileSync(rotations, 'utf8')).filter((shape) => !wanted || wanted.includes(shape.id));
mkdirSync(out, { recursive: true });

/** The page, the avatar and three.js; the loader's own imports name folders that are flat here. */
function bytes(url) {
  if (url === '/') return ['text/html', readFileSync(path.join(here, 'handshapes.html'))];
  if (url === '/favicon.ico') return ['image/x-icon', ' '];
  if (url === '/avatar.glb') return ['model/gltf-binary', readFileSync(path.join(assets, 'avatar.glb'))];
  const name = /^\/(?:vendor|utils)\/([\w.]+\.js)$/.exec(url)?.[1];
  return name ? ['text/javascript', readFileSync(path.join(assets, 'viewer/vendor', name))] : null;
}
const server = createServer((request, response) => {
  try {
    const [type, body] = bytes(new URL(request.url, 'http://x').pathname) ?? [];
    response.writeHead(body ? 200 : 404, { 'content-type': type ?? 'text/plain' }).end(body ?? '');
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
  const step = Math.max(1, Math.floor(PER_SHEET / names.length));
  for (let i = 0; i < shapes.length; i += step) {
    const url = await page.evaluate(([part, views, columns]) => window.sheet(part, views, columns), [shapes.slice(i, i + step), names, COLUMNS]);
    const file = path.join(out, `handshapes-${String(i / step + 1).padStart(2, '0')}.png`);
    writeFileSync(file, Buffer.from(url.split(',')[1], 'base64'));
    console.log(file);
  }
});
server.close();
