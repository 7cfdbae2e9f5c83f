// Answers a questionnaire as two participants would, with the keyboard alone, and checks that `chereme evaluate ratings` reads the CSV.
// usage: node questionnaire.mjs page.html key.csv chereme [folder for pictures]
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync, mkdtempSync, mkdirSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { openViewer, withBrowser } from './browser.mjs';

const [html, key, chereme, pictures] = process.argv.slice(2);
if (!chereme) {
  console.error('usage: node questionnaire.mjs page.html key.csv chereme [folder for pictures]');
  process.exit(2);
}
const folder = mkdtempSync(path.join(tmpdir(), 'chereme-questionnaire-'));
if (pictures) mkdirSync(pictures, { recursive: true });
// An opaque name's right answer.
const cells = (line) => [...line.matchAll(/(?:^|,)(?:"((?:[^"]|"")*)"|([^,"]*))/g)].map(([, quoted, plain]) => quoted ?? plain);
const rows = readFileSync(key, 'utf8').trim().split('\n').map(cells);
const at = (name) => rows[0].indexOf(name);
const right = Object.fromEntries(rows.slice(1).map((row) => [row[at('stimulus')], row[at('correct')]]));
const fail = (what) => { throw new Error(what); };

async function participant(context, number, level) {
  const { page, faults } = await openViewer(context, html, '');
  const shot = (name) => pictures && number === 0 && page.screenshot({ path: path.join(pictures, `${name}.png`), fullPage: true });
  await page.click('#fr');
  await shot('sheet');
  // Without answers nothing begins.
  await page.press('#sheet button', 'Enter');
  if (!await page.isVisible('#message') || !await page.isVisible('#sheet')) fail('an empty sheet was taken');
  await page.fill('#sheet input[type=number]', String(30 + number));
  for (const [name, value] of [['gender', 'unstated'], ['hearing', 'born-deaf'], ['level', level]]) {
    const radio = page.locator(`input[name=${name}][value=${value}]`);
    await radio.focus();
    await page.keyboard.press('Space');
  }
  await page.press('#sheet button', 'Enter');
  const tasks = await page.evaluate('window.chereme.tasks');
  const seen = await page.evaluate(() => JSON.parse(document.getElementById('chereme-data').textContent).tasks.map((t) => t.stimulus));
  for (let i = 0; i < tasks; i++) {
    await page.waitForFunction((n) => document.getElementById('progress').value === n, i);
    await page.waitForSelector('#task:not([hidden])');
    if (i === 0) {
      await page.press('#play', 'Enter');
      await page.press('#questions button', 'Enter');
      if (!await page.isVisible('#message')) fail('a question was passed over');
    }
    if (i < 3) {
      await page.evaluate('window.chereme.seek(window.chereme.duration() * 0.45)');
      await shot(`task-${i + 1}`);
    }
    const correct = right[seen[i]];
    if (correct) {
      const answer = page.locator(`input[name=answer][value="${correct}"]`);
      await answer.focus();
      await page.keyboard.press('Space');
    }
    await page.locator(`input[name=realism][value="${1 + (i + number) % 5}"]`).focus();
    await page.keyboard.press('Space');
    if (i === 1) { // the other language keeps what was answered
      await page.click('#en');
      await shot('task-en');
      if (!await page.isChecked(`input[name=realism][value="${1 + (i + number) % 5}"]`)) fail('the answer was lost with the language');
    }
    await page.press('#questions button', 'Enter');
  }
  await page.waitForSelector('#end:not([hidden])');
  await shot('end');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#download')]);
  const file = path.join(folder, `${number}.csv`);
  await download.saveAs(file);
  if (readFileSync(file, 'utf8') !== await page.evaluate('window.chereme.csv()')) fail('the file is not what the page says');
  if (faults.length) fail(faults.join('\n'));
  await page.close();
  return tasks;
}

await withBrowser(async (context) => {
  const tasks = await participant(context, 0, 'native');
  await participant(context, 1, 'beginner');
  const run = (...more) => execFileSync(chereme, ['evaluate', 'ratings', folder, '--key', key, ...more], { encoding: 'utf8' });
  const all = run(), good = run('--level', 'good+');
  if (!all.startsWith('2 participants;')) fail(`two people answered, but: ${all}`);
  if (!good.startsWith('1 participant (1 left out by level);')) fail(`one of them is a beginner, but: ${good}`);
  if (/recognised/.test(all) && /[01]\/[0-9]+ = (?!100\.0)/.test(all)) fail(`all answers were right, but: ${all}`);
  if (pictures) writeFileSync(path.join(pictures, 'ratings.txt'), all);
  console.log(`${html}: ${tasks} stimuli answered twice, read by evaluate ratings`);
}, { viewport: { width: 1200, height: 860 } });
