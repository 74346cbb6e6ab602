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
const pages = ['index', 'ball', 'controlled', 'validity', 'theory', 'wavy', '1.15', 'half', 'profiles', 'source-CHANGELOG.md', 'values-landing', 'fit-hyper1', 'errata', 'figures', 'fit', 'notation', 'contents', 'bibliography'];

async function open(name, { alone, ...options } = {}) {
  const page = await browser.newPage({ viewport: { width: 1200, height: 900 }, ...options });
  Object.assign(page, { problems: [] });
  const without = { body: 'window.EXPLORER=false;', contentType: 'text/javascript' };
  if (alone) await page.route('**/explorer-here.js', (route) => route.fulfill(without));
  page.on('pageerror', (e) => page.problems.push(e.message));
  await page.goto(new URL(`${name}.html`, folder).href);
  return page;
}

test('axe finds nothing, light and dark', { skip }, async () => {
  // The explorer has a test of its own.
  const page = await open('index', { alone: true });
  // The theme changes colours alone.
  const themes = { light: { rules: { 'target-size': { enabled: true } } }, dark: { runOnly: ['color-contrast'] } };
  for (const name of pages) {
    await page.goto(new URL(`${name}.html`, folder).href);
    await page.evaluate(axe);
    for (const [colorScheme, rules] of Object.entries(themes)) {
      await page.emulateMedia({ colorScheme });
      const { violations } = await page.evaluate((rules) => globalThis.axe.run(document, rules), rules);
      assert.deepEqual(
        violations.map((v) => `${name}: ${colorScheme}: ${v.id}: ${v.nodes.map((n) => n.target.join(' ')).slice(0, 3)}`),
        [],
      );
    }
    await page.emulateMedia({ colorScheme: 'light' });
  }
  await page.close();
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

test('no letter of a formula is smaller than 9 pixels', { skip }, async () => {
  for (const name of ['1.15', '1.19', 'wavy', 'notation', 'theory', 'conformance', 'kappa-series', 'errata']) {
    const page = await open(name);
    const small = await page.$$eval('math :is(mi, mn, mo, mtext)', (all) =>
      all.filter((e) => e.textContent.trim() && parseFloat(getComputedStyle(e).fontSize) < 9).map((e) => e.closest('math').textContent),
    );
    assert.deepEqual(small.slice(0, 3), [], `${name}: ${small.length}`);
    await page.close();
  }
});

test('a value is whole: in groups, with twelve digits and the rest to unfold on a phone, and copied without gaps', { skip }, async () => {
  const id = 'critical/jkr-unit/indentation/force';
  for (const width of [1200, 390]) {
    const page = await browser.newPage({ viewport: { width, height: 844 } });
    await page.goto(new URL(`values-critical.html#${id}`, folder).href);
    const row = page.locator(`[id="${id}"]`);
    await page.waitForTimeout(200);
    // The deep link lands on its value.
    const box = await row.boundingBox();
    assert.ok(box.y >= 0 && box.y + box.height <= 844, `${width}: ${box.y}`);
    const shown = (await row.locator('.digits').innerText()).replace(/\s/g, '');
    if (width === 390) {
      assert.equal(shown, '−2.61799387799…');
      await row.getByRole('button', { name: 'All digits' }).click();
    }
    const digits = (await row.locator('.digits').innerText()).replace(/[\s…]/g, '');
    assert.match(digits, /^−2\.6179938779914943653855361/);
    assert.ok(digits.length > 45, digits);
    // Nothing is cut at an edge.
    const wider = (all) => all.filter((e) => e.scrollWidth > e.clientWidth + 1).length;
    const over = await page.$$eval('#values section.case > .table', wider);
    assert.equal(over, 0, `${width}`);
    const copied = await page.evaluate(async (id) => {
      const texts = [];
      Object.defineProperty(navigator, 'clipboard', { value: { writeText: async (text) => texts.push(text) } });
      const row = document.getElementById(id);
      for (const button of row.querySelectorAll('.copies button')) button.click();
      return texts;
    }, id);
    assert.equal(copied[0], digits.replace('−', '-'));
    assert.match(copied[1], /^-0x1\./);
    assert.ok(copied[2].includes(id) && /release \d/.test(copied[2]));
    await page.close();
  }
});

test('every certified value can be copied, on every page of them', { skip }, async () => {
  const page = await open('index');
  for (const name of readdirSync(folder).filter((name) => /^values-.*html$/.test(name))) {
    await page.goto(new URL(name, folder).href);
    const without = (all) => all.filter((row) => row.querySelector('.digits') && !row.querySelector('.copies')).map((row) => row.id);
    assert.deepEqual((await page.$$eval('tr[data-release]', without)).slice(0, 3), [], name);
  }
  assert.deepEqual(page.problems, []);
  await page.close();
});

test('the search finds the theory before data sets, shows where, and is walked by arrow keys', { skip }, async () => {
  const page = await open('ball');
  await page.focus('#search');
  await page.keyboard.type('JKR');
  await page.waitForSelector('#results a');
  const found = await page.$$eval('#results a', (all) => all.map((a) => a.getAttribute('href')));
  assert.ok(found.length > 3 && !/^(fit|values)-/.test(found[0]), found.join());
  const data = found.findIndex((u) => u.startsWith('fit-jkrtest'));
  const theory = found.findIndex((u) => !/^(fit|values|source)-/.test(u));
  assert.ok(data === -1 || theory < data, found.join());
  assert.match(await page.textContent('#results li:first-child'), /JKR/);
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowDown');
  assert.equal(await page.evaluate(() => document.activeElement.getAttribute('href')), found[1]);
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('ArrowUp');
  assert.equal(await page.evaluate(() => document.activeElement.id), 'search');
  assert.deepEqual(page.problems, []);
  await page.close();
});

test('a number of an equation has a card with the equation', { skip }, async () => {
  const page = await open('method');
  const link = page.locator('a.ref').first();
  await link.hover();
  await page.waitForSelector('#card:not([hidden]) math');
  await page.keyboard.press('Escape');
  assert.ok(await page.locator('#card').isHidden());
  await page.close();
});

test('panels of a picture stand below each other on a phone', { skip }, async () => {
  const page = await open('hysteresis', { alone: true, viewport: { width: 390, height: 844 } });
  const box = await page.locator('figure.plot img').boundingBox();
  assert.ok(box.width > 330 && box.height > 2 * box.width, JSON.stringify(box));
  await page.close();
});

test('figures move where the explorer is, and are pictures where it is not', { skip }, async () => {
  const here = existsSync(new URL('explorer.html', folder));
  const page = await open('two-curves');
  if (here) {
    const frame = page.frameLocator('figure.live iframe');
    await frame.locator('#explorer[data-ready="true"]').waitFor({ state: 'attached', timeout: 20000 });
    assert.match(await page.locator('figure.live figcaption a').getAttribute('href'), /^explorer\.html#v=-0\.3$/);
    assert.ok(await frame.locator('#balance').isVisible());
  }
  await page.close();
  const alone = await open('two-curves', { alone: true });
  assert.ok((await alone.$eval('figure.live img', (img) => img.decode().then(() => img.naturalWidth))) > 300);
  await alone.close();
});
