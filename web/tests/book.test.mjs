// The pages of the book in Chromium: whether all can read them, on any screen, and whether the picture of the first page moves.
import { after, before, test } from 'node:test';
import assert from 'node:assert/strict';
import { existsSync, readdirSync } from 'node:fs';
import { axe, launch } from './browser.mjs';

const folder = new URL('../../target/book/', import.meta.url);
const skip = !existsSync(new URL('index.html', folder)) && 'there is no target/book/index.html: make book';

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

/** One page of each kind: an equation, a chapter, a page of numbers, and what is a page of its own. */
const pages = ['index', '1.15', 'half', 'values-kappa', 'fit-hyper1', 'errata', 'figures', 'fit', 'notation', 'contents', 'bibliography'];

async function open(name, options) {
  const page = await browser.newPage({ viewport: { width: 1200, height: 900 }, ...options });
  Object.assign(page, { problems: [] });
  page.on('pageerror', (e) => page.problems.push(e.message));
  await page.goto(new URL(`${name}.html`, folder).href);
  return page;
}

test('axe finds nothing, light and dark', { skip }, async () => {
  for (const colorScheme of ['light', 'dark'])
    for (const name of pages) {
      const page = await open(name, { colorScheme });
      await page.evaluate(axe);
      const { violations } = await page.evaluate(() => globalThis.axe.run(document));
      assert.deepEqual(
        violations.map((v) => `${name}: ${v.id}: ${v.nodes.map((n) => n.target.join(' ')).slice(0, 3)}`),
        [],
      );
      await page.close();
    }
});

test('no page is wider than a screen of 360 pixels', { skip }, async () => {
  const page = await browser.newPage({ viewport: { width: 360, height: 740 } });
  for (const name of readdirSync(folder).filter((name) => name.endsWith('.html') && !/^(source-|explorer\.)/.test(name))) {
    await page.goto(new URL(name, folder).href);
    const wider = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(wider <= 0, `${name}: ${wider} pixels`);
  }
  await page.close();
});

test('the picture of the first page goes where it is moved, and plays', { skip }, async () => {
  const page = await open('index');
  const told = () => page.locator('figure.moving output').innerText();
  await page.locator('figure.moving input').fill('0');
  assert.match(await told(), /^d = −0\.70, apart$/);
  await page.locator('figure.moving input').fill('60');
  assert.match(await told(), /^d = 1\.20, a = 1\.\d\d$/);
  await page.getByRole('button', { name: 'Play' }).click();
  await page.waitForFunction(() => +document.querySelector('figure.moving input').value > 62);
  await page.getByRole('button', { name: 'Pause' }).click();
  assert.deepEqual(page.problems, []);
  await page.close();
});
