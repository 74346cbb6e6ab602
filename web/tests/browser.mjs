// A page of the explorer in Chromium, and what tests ask of it.
import { createRequire } from 'node:module';
import { readFileSync } from 'node:fs';
import assert from 'node:assert/strict';

const root = new URL('../../', import.meta.url);
const require = createRequire(new URL('target/browser/', root));
const { chromium } = require('playwright-core');
export const axe = readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');
export const file = new URL('target/book/explorer.html', root);
const executablePath = process.env.CHROMIUM || '/usr/bin/chromium';

export const launch = () => chromium.launch({ executablePath, args: ['--no-sandbox'] });

/** A new page; what it complains of and asks for is recorded. `script` runs before those of the page. */
export async function open(browser, hash = '', { script, ...options } = {}) {
  const page = await browser.newPage({ viewport: { width: 1400, height: 900 }, reducedMotion: 'reduce', ...options });
  Object.assign(page, { problems: [], requests: [] });
  page.on('console', (m) => m.type() === 'error' && page.problems.push(m.text()));
  page.on('pageerror', (e) => page.problems.push(e.message));
  page.on('request', (r) => page.requests.push(r.url()));
  if (script) await page.addInitScript(script);
  await page.goto(file.href + hash);
  await page.waitForSelector('#explorer[data-ready="true"]', { state: 'attached' });
  await page.waitForTimeout(150);
  return page;
}
/** The state, when it has been written. */
export async function data(page) {
  await page.waitForTimeout(200);
  return page.$eval('#explorer', (e) => ({ ...e.dataset }));
}
export const preset = (page, name) => page.getByRole('button', { name, exact: true }).click();
export const move = (page, to) => page.evaluate((to) => explorer.move(to), to);
export const change = (page, parameters) => page.evaluate((parameters) => explorer.change(parameters), parameters);
export const sweep = (page, to, steps = 12) =>
  page.evaluate(
    async ([to, steps]) => {
      const from = explorer.state().value;
      for (let i = 1; i <= steps; i++) {
        explorer.move(from + ((to - from) * i) / steps);
        await new Promise(requestAnimationFrame);
      }
    },
    [to, steps],
  );
export function close(x, y, tolerance = 1e-4, what = '') {
  assert.ok(Math.abs(x - y) <= tolerance * Math.max(1, Math.abs(y)), `${what} ${x} is not ${y}`);
}
