// A picture of the whole viewer page. usage: node page.mjs viewer.html out.png ["t=0.8&view=front"] [width height] [light|dark]
import { openViewer, withBrowser } from './browser.mjs';

const [html, out, hash = 't=0.8', width = '1280', height = '860', colorScheme = 'light'] = process.argv.slice(2);
if (!out) {
  console.error('usage: node page.mjs viewer.html out.png ["t=0.8&view=front"] [width height] [light|dark]');
  process.exit(2);
}
await withBrowser(async (context) => {
  const { page, faults } = await openViewer(context, html, `play=0&${hash}`);
  await page.waitForTimeout(700);
  await page.screenshot({ path: out });
  for (const fault of faults) console.error(fault);
  process.exitCode = faults.length ? 1 : 0;
}, { viewport: { width: +width, height: +height }, colorScheme });
