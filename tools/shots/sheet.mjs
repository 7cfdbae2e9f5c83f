// Contact sheet: draws moments of viewer pages with named cameras and joins them, labelled, in one PNG.
// usage: node sheet.mjs plan.json      (the plan's form stands in README.md; its paths are relative to it)
import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { withBrowser } from './browser.mjs';
import { openStudio, pageData } from './studio.mjs';

const planFile = process.argv[2];
if (!planFile) {
  console.error('usage: node sheet.mjs plan.json');
  process.exit(2);
}
const plan = JSON.parse(readFileSync(planFile, 'utf8'));
const beside = (file) => path.resolve(path.dirname(planFile), file);
const [width, height] = plan.cell || [300, 360];
const labelOf = ({ html, t, camera }) => `${path.basename(html, '.html')} ${t.toFixed(2)} s ${typeof camera === 'string' ? camera : ''}`;
const cells = plan.cells.map((cell, at) => {
  const whole = { t: 0, camera: 'front', ...cell, at };
  return { ...whole, label: whole.label ?? labelOf(whole) };
});
const columns = Math.min(plan.columns || 4, cells.length);

await withBrowser(async (context) => {
  const studio = await openStudio(context, beside(cells[0].html));
  await studio.open({ columns, rows: Math.ceil(cells.length / columns), width, height, strip: 20 });
  for (const html of new Set(cells.map((cell) => cell.html))) {
    await studio.shoot(pageData(beside(html)), cells.filter((cell) => cell.html === html));
  }
  writeFileSync(beside(plan.out), await studio.picture());
  for (const fault of studio.faults) console.error(fault);
  process.exitCode = studio.faults.length ? 1 : 0;
}, { viewport: { width: 320, height: 240 } });
console.log(`${beside(plan.out)}: ${cells.length} cells`);
