// A studio: one browser page in which the motions of many viewer pages are drawn, one after the other, on sheets.
// The viewer is loaded once and its avatar exchanged; every picture is drawn alone, straight onto the sheet, so a
// cell costs one drawing (loading a page for each sign, and letting the page draw its own views, costs ten times that).
import { readFileSync } from 'node:fs';
import { openViewer } from './browser.mjs';

/** The data of a viewer page: title, tiers, duration, glb (base64). */
export function pageData(file) {
  const text = readFileSync(file, 'utf8').split('id="chereme-data">')[1];
  if (!text) throw new Error(`${file} is not a viewer page`);
  return JSON.parse(text.slice(0, text.indexOf('</script>')));
}

/** Runs in the page: a stage of its own, and `studio.shoot`, which draws one motion's cells onto a sheet. */
async function furnish() {
  const { loadAvatar } = await import('avatar.js');
  const { cameraOf } = await import('cameras.js');
  const { Stage } = await import('stage.js');
  let stage = null, avatar = null, sheet = null, pen = null, size = null;
  const points = (t) => {
    avatar.pose(t);
    return ['RightHand', 'RightHandIndex3', 'LeftHand', 'LeftHandIndex3'].flatMap((name) => (
      avatar.bones[name] ? avatar.bones[name].matrixWorld.elements.slice(12, 15) : []));
  };
  const between = (a, b) => Math.hypot(...a.map((x, i) => x - b[i]));
  /** The moment at which the hands are farthest from where they start and end; half-way where they hardly move. */
  const amid = (from, to) => {
    const first = points(from), last = points(to);
    let best = (from + to) / 2;
    const far = (t) => Math.min(between(points(t), first), between(points(t), last));
    let most = far(best) + 0.01;
    for (let i = 1; i < 32; i++) {
      const t = from + (to - from) * i / 32, one = far(t);
      if (one > most) [best, most] = [t, one];
    }
    return best;
  };
  window.studio = {
    /** A new sheet of `rows` by `columns` cells with a line of text under each. */
    open({ columns, rows, width, height, strip }) {
      size = { columns, width, height, strip };
      sheet = Object.assign(document.createElement('canvas'), { width: columns * width, height: rows * (height + strip) });
      pen = sheet.getContext('2d');
      pen.fillStyle = '#14171d';
      pen.fillRect(0, 0, sheet.width, sheet.height);
      pen.font = `${Math.round(strip * 0.65)}px system-ui, "DejaVu Sans", sans-serif`;
      pen.textBaseline = 'middle';
    },
    /**
     * Draws cells [{ at, t, camera, label, strong }] of one page's data. `at` counts the sheet's cells row by row; `t` is in
     * seconds, or [from, to]: the moment between them at which the hands are farthest from both ends.
     */
    async shoot({ glb, still }, cells) {
      const before = avatar;
      avatar = await loadAvatar(Uint8Array.from(atob(glb), (letter) => letter.charCodeAt(0)).buffer);
      if (stage) {
        stage.scene.remove(before.root);
        stage.scene.add(avatar.root);
        stage.avatar = avatar;
      } else {
        stage = new Stage(document.createElement('canvas'), avatar);
        stage.renderer.setPixelRatio(1);
        stage.renderer.setSize(size.width, size.height, false);
        // Small cells do not show the fine shadows, which cost a quarter of the time.
        const fine = size.height > 300 ? 2048 : 1024;
        stage.scene.traverse((light) => { if (light.castShadow && light.shadow?.mapSize) light.shadow.mapSize.set(fine, fine); });
      }
      let posed = null;
      for (const cell of cells) {
        const t = Array.isArray(cell.t) ? amid(...cell.t) : cell.t;
        avatar.pose(t);
        stage.renderer.shadowMap.needsUpdate = posed !== t;
        posed = t;
        const x = (cell.at % size.columns) * size.width, y = Math.floor(cell.at / size.columns) * (size.height + size.strip);
        stage.drawView(cameraOf(avatar, cell.camera, size.width / size.height, still?.cameras), { x: 0, y: 0, width: size.width, height: size.height });
        pen.drawImage(stage.renderer.domElement, x, y, size.width - 2, size.height - 1);
        pen.fillStyle = cell.strong ? '#ffd479' : '#e4e8f0';
        pen.fillText(Array.isArray(cell.t) ? `${cell.label} ${t.toFixed(2)}` : cell.label, x + 5, y + size.height + size.strip / 2, size.width - 10);
      }
      // The old geometry goes; materials stay, or their shaders would be compiled again for each motion.
      before?.root.traverse((object) => object.geometry?.dispose());
    },
    picture: () => sheet.toDataURL('image/png'),
  };
}

/** Opens a studio beside a viewer page, whose program it uses. */
export async function openStudio(context, file) {
  const { page, faults } = await openViewer(context, file);
  await page.evaluate(furnish);
  return {
    faults,
    open: (sheet) => page.evaluate((sheet) => window.studio.open(sheet), sheet),
    shoot: ({ glb, still }, cells) => page.evaluate(([data, cells]) => window.studio.shoot(data, cells), [{ glb, still }, cells]),
    picture: async () => Buffer.from((await page.evaluate(() => window.studio.picture())).split(',')[1], 'base64'),
  };
}
