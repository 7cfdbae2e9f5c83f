// Headless Chromium with WebGL in software (about 3 frames a second), its own profile, and no network.
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const FLAGS = ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
  '--ignore-gpu-blocklist', '--disable-background-networking', '--disable-component-update', '--disable-sync',
  '--no-first-run', '--disable-quic'];

/** Starts the browser, hands its context to `work`, and tidies up whatever happens. */
export async function withBrowser(work, options = {}) {
  const profile = mkdtempSync(path.join(tmpdir(), 'chereme-shots-'));
  const context = await chromium.launchPersistentContext(profile, {
    executablePath: process.env.CHROMIUM || '/usr/bin/chromium', headless: true, args: [...FLAGS, ...(options.flags || [])],
    viewport: options.viewport || { width: 1280, height: 860 }, colorScheme: options.colorScheme || 'light',
  });
  try {
    return await work(context);
  } finally {
    await context.close();
    rmSync(profile, { recursive: true, force: true });
  }
}

/**
 * Opens a viewer page from disk and waits for its first picture. Returns the page and the list of
 * faults, which goes on growing: console errors and warnings, page errors, requests to a network.
 */
export async function openViewer(context, file, hash = 'play=0') {
  const page = await context.newPage(), faults = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) faults.push(`console ${message.type()}: ${message.text()}`);
  });
  page.on('pageerror', (error) => faults.push(`page error: ${error.message}`));
  page.on('request', (request) => {
    if (!/^(file|blob|data):/.test(request.url())) faults.push(`network request: ${request.url()}`);
  });
  page.on('requestfailed', (request) => faults.push(`failed request: ${request.url().slice(0, 120)}`));
  await page.goto(`${pathToFileURL(path.resolve(file))}#${hash}`);
  await page.waitForFunction('window.DONE', null, { timeout: 120000 });
  const error = await page.evaluate('window.chereme.error');
  if (error) throw new Error(`${file}: ${error}`);
  return { page, faults };
}
