// Opens viewer pages from disk, plays, uses every control, and fails on whatever a person would find in the
// console, on any network request, and on empty curves or tiers. usage: node console.mjs page.html...
import { openViewer, withBrowser } from './browser.mjs';

/** Uses the page as a person would; throws where something does not answer. */
async function tryControls(page, check) {
  const time = () => page.evaluate('chereme.player.time');
  await page.click('#play');
  await page.waitForTimeout(1000);
  check(await page.evaluate('chereme.player.playing') && (await time()) > 0, 'playing does not move the time');
  await page.click('#play');
  await page.click('#to-start');
  check((await time()) === 0, 'the start button does not go to 0');
  await page.click('#forward');
  check(await page.evaluate('chereme.player.frame') === 1, 'one frame forward is not frame 1');
  await page.click('#back');
  for (const view of ['signer', 'right', 'left', 'top', 'front']) await page.click(`#view-${view}`);
  for (const id of ['hands', 'hands', 'hands', 'mirror', 'mirror', 'loop', 'loop']) await page.click(`#${id}`);
  await page.click('#help-button');
  check(await page.isVisible('#help'), 'the help does not open');
  await page.keyboard.press('Escape');
  await page.locator('#main-view').focus();
  for (const key of ['Space', 'Space', 'Home', '.', ',', 'ArrowRight', 'ArrowLeft', 'End', '1', '2', '3', '4', '5', '1', 'h', 'm', 'm', 'l', 'l', '[', ']', '+', '-']) {
    await page.keyboard.press(key);
  }
  check(await page.evaluate('Math.abs(chereme.player.time - chereme.duration) < 0.1'), 'End does not go to the end');
  await page.keyboard.press('Home');
  const box = await page.locator('#tiers').boundingBox();
  await page.mouse.click(box.x + box.width * 0.6, box.y + 12);
  const area = await page.locator('#curves').boundingBox();
  await page.mouse.move(area.x + area.width * 0.4, area.y + 50);
  await page.mouse.down();
  await page.mouse.move(area.x + area.width * 0.7, area.y + 50, { steps: 3 });
  await page.mouse.up();
  check((await time()) > 0, 'dragging on the timeline does not scrub');
  const view = await page.locator('#main-view').boundingBox();
  await page.mouse.move(view.x + view.width / 2, view.y + view.height / 2);
  await page.mouse.down();
  await page.mouse.move(view.x + view.width / 2 + 60, view.y + view.height / 2, { steps: 3 });
  await page.mouse.up();
  await page.mouse.wheel(0, 100);
  await page.setViewportSize({ width: 420, height: 800 });
  await page.waitForTimeout(600);
}

let failed = process.argv.length < 3;
if (failed) console.error('usage: node console.mjs page.html...');
await withBrowser(async (context) => {
  for (const html of process.argv.slice(2)) {
    const { page, faults } = await openViewer(context, html);
    const check = (good, fault) => { if (!good) faults.push(fault); };
    const facts = await page.evaluate(() => ({
      top: window.chereme.speeds.top, curves: Math.min(window.chereme.speeds.right.length, window.chereme.speeds.left.length),
      tiers: window.chereme.tiers.length, values: window.chereme.tiers.reduce((sum, tier) => sum + tier.values.length, 0),
    }));
    check(facts.curves > 1 && facts.top > 0, 'the wrist speeds are empty');
    check(facts.values > 0, 'the tiers are empty');
    await tryControls(page, check);
    console.log(`${html}: ${facts.tiers} tiers, ${facts.values} values, ${facts.curves} speeds up to ${facts.top.toFixed(2)} m/s, ${faults.length} faults`);
    for (const fault of faults) console.error(`  ${fault}`);
    failed ||= faults.length > 0;
    await page.close();
  }
});
process.exit(failed ? 1 : 0);
