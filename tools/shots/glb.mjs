// Measures the avatar as three.js poses it from the GLB in a viewer page, joint by joint and frame by frame, against a table
// of positions.
//
// node glb.mjs bol.html bol.csv [more pairs]     (cargo run --example joint_positions makes the table)
//
// The table has frame,joint,x,y,z in metres. Fails above 1 mm, and where a wrist was not compared.
import { readFileSync } from 'node:fs';
import { openViewer, withBrowser } from './browser.mjs';

const LIMIT_MM = 1, NEEDED = ['RightHand', 'LeftHand'];

const files = process.argv.slice(2);
if (!files.length || files.length % 2) {
  console.error('usage: node glb.mjs page.html table.csv [more pairs]');
  process.exit(2);
}
let failed = false;
await withBrowser(async (context) => {
  for (let i = 0; i < files.length; i += 2) {
    const { page } = await openViewer(context, files[i]);
    const rows = readFileSync(files[i + 1], 'utf8').trim().split('\n').slice(1).map((line) => line.split(','));
    const frames = Number(rows.at(-1)[0]) + 1;
    const found = await page.evaluate((count) => {
      const { fps, places } = window.chereme;
      return Array.from({ length: count }, (_, frame) => places(frame / fps));
    }, frames);
    const worst = { mm: 0 }, compared = new Set();
    for (const [frame, joint, ...xyz] of rows) {
      const at = found[frame][joint];
      if (!at) continue; // the table has the ends of fingers too
      const mm = 1000 * Math.hypot(...at.map((value, axis) => value - xyz[axis]));
      compared.add(joint);
      if (!(mm <= worst.mm)) Object.assign(worst, { mm, joint, frame });
    }
    const missing = NEEDED.filter((joint) => !compared.has(joint));
    if (missing.length) throw new Error(`${files[i]}: ${missing.join(', ')} cannot be compared`);
    console.log(`${files[i]}: ${frames} frames, ${compared.size} joints, within ${worst.mm.toFixed(4)} mm (${worst.joint}, frame ${worst.frame})`);
    failed ||= !(worst.mm <= LIMIT_MM);
    await page.close();
  }
});
process.exit(failed ? 1 : 0);
