// Contact sheet: renders moments of viewer pages with named cameras and joins them, labelled, in one PNG.
// usage: node sheet.mjs plan.json      (the plan's form stands in README.md; its paths are relative to it)
import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { openViewer, withBrowser } from './browser.mjs';

const planFile = process.argv[2];
if (!planFile) {
  console.error('usage: node sheet.mjs plan.json');
  process.exit(2);
}
const plan = JSON.parse(readFileSync(planFile, 'utf8'));
const beside = (file) => path.resolve(path.dirname(planFile), file);
const [width, height] = plan.cell || [300, 360];

/** Runs in the page: joins the pictures row by row and writes the label under each. */
async function compose({ cells, columns, width, height }) {
  const strip = 20, rows = Math.ceil(cells.length / columns);
  const canvas = Object.assign(document.createElement('canvas'), { width: columns * width, height: rows * (height + strip) });
  const pen = canvas.getContext('2d');
  pen.fillStyle = '#14171d';
  pen.fillRect(0, 0, canvas.width, canvas.height);
  pen.font = '13px system-ui, "DejaVu Sans", sans-serif';
  pen.textBaseline = 'middle';
  for (const [i, cell] of cells.entries()) {
    const x = (i % columns) * width, y = Math.floor(i / columns) * (height + strip);
    const image = new Image();
    image.src = cell.picture;
    await image.decode();
    pen.drawImage(image, x, y, width - 2, height - 1);
    pen.fillStyle = '#e4e8f0';
    pen.fillText(cell.label, x + 5, y + height + strip / 2, width - 10);
  }
  return canvas.toDataURL('image/png');
}

const cells = plan.cells.map((cell) => ({ t: 0, camera: 'front', ...cell }));
const faults = [];
await withBrowser(async (context) => {
  for (const html of new Set(cells.map((cell) => cell.html))) {
    const viewer = await openViewer(context, beside(html));
    for (const cell of cells.filter((one) => one.html === html)) {
      cell.picture = await viewer.page.evaluate(({ t, camera, width, height }) => {
        window.chereme.seek(t);
        return window.chereme.renderTo(width, height, camera);
      }, { t: cell.t, camera: cell.camera, width, height });
      cell.label ??= `${path.basename(html, '.html')} ${cell.t.toFixed(2)} s ${typeof cell.camera === 'string' ? cell.camera : ''}`;
    }
    faults.push(...viewer.faults.map((fault) => `${html}: ${fault}`));
    await viewer.page.close();
  }
  const page = await context.newPage();
  const picture = await page.evaluate(compose, {
    cells: cells.map(({ picture, label }) => ({ picture, label })), columns: Math.min(plan.columns || 4, cells.length), width, height,
  });
  writeFileSync(beside(plan.out), Buffer.from(picture.split(',')[1], 'base64'));
});
console.log(`${beside(plan.out)}: ${cells.length} cells`);
for (const fault of faults) console.error(fault);
process.exit(faults.length ? 1 : 0);
