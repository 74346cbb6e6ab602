// The page on screens: small, large, dark, in a lecture, in a frame, and taken away as SVG.
import test, { after, before } from 'node:test';
import assert from 'node:assert/strict';
import { axe, change, close, data, launch, move, open, preset } from './browser.mjs';

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

test('the body is in the picture when it has come off, and true to scale where units give one', async () => {
  const page = await open(browser);
  const tip = () =>
    page.evaluate(() => {
      const solid = document.querySelector('#body .f-body').getBBox();
      return [solid.y + solid.height, document.querySelector('#body').clientHeight];
    });
  for (const name of ['JKR sphere', 'Dead load', 'AFM cantilever', 'Figure 4: wavy sphere', 'Your own tip', 'Cone']) {
    await preset(page, name);
    await page.evaluate(() => explorer.move(explorer.state().range[0]));
    assert.equal((await data(page)).state, 'detached', name);
    const [y, height] = await tip();
    assert.ok(y > 8 && y < height, `${name}: the tip is at ${y} of ${height}`);
  }
  await page.click('[data-key="scale"]');
  await data(page);
  assert.match(await page.textContent('#story'), /choose units/);
  await preset(page, 'AFM cantilever');
  await page.click('[data-key="scale"]');
  await data(page);
  // A tip of 20 nm: over a width of 2x its height is x²/2R.
  const [bow, x] = await page.evaluate(() => {
    const path = document.querySelector('#body .f-body').getAttribute('d').match(/^M[^VZ]*/)[0];
    const points = path.slice(1).split('L').map((p) => p.split(' ').map(Number));
    const low = points.reduce((a, b) => (b[1] > a[1] ? b : a));
    return [low[1] - points[0][1], low[0] - points[0][0]];
  });
  const perPixel = (2 * 2.2 * 5.0107e-9) / (await page.evaluate(() => document.querySelector('#body').clientWidth - 8));
  close(bow * perPixel, (x * perPixel) ** 2 / 2 / 20e-9, 0.05);
  await page.close();
});

test('a lecture, a laptop and a phone on its side need no scrolling, and the slider is as high as a thumb', async () => {
  for (const [width, height, hash, seen, hidden] of [
    [1280, 720, '#lecture&v=0.25', ['balance', 'body', 'force', 'value'], ['s-n', 'energy']],
    [1366, 768, '', ['balance', 'energy', 'body', 'force', 'value', 's-n'], []],
    [844, 390, '', ['balance', 'value'], ['energy']],
    [844, 390, '#task=1', ['balance', 'guess', 'task-play', 'value'], ['energy']],
    [844, 390, '#lecture', ['balance', 'force', 'value', 'lecture'], ['body']],
    [390, 844, '#lecture', ['balance', 'body', 'force', 'value', 'lecture'], ['energy']],
  ]) {
    const page = await open(browser, hash, { viewport: { width, height } });
    const what = `${width} × ${height}`;
    const [w, h] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.scrollHeight]);
    assert.ok(w <= width && h <= height, `${w} × ${h} in ${what}`);
    for (const id of seen) {
      const box = await page.locator(`#${id}`).boundingBox();
      assert.ok(box.y >= 0 && box.y + box.height <= height + 1 && box.height > 20, `${what}: ${id} at ${JSON.stringify(box)}`);
      assert.ok(box.x >= 0 && box.x + box.width <= width + 1, `${what}: ${id} at ${JSON.stringify(box)}`);
    }
    for (const id of hidden) assert.ok(await page.isHidden(`#${id}`), `${what}: ${id}`);
    const slider = await page.locator('#value').boundingBox();
    if (width !== 1366) assert.ok(slider.height >= 44, `${what}: ${slider.height}`);
    assert.deepEqual(page.problems, []);
    await page.close();
  }
});

test('what the page says is whole in a lecture and on a phone on its side', async () => {
  for (const [width, height, mode] of [
    [1280, 720, 'lecture&'],
    [844, 390, ''],
  ])
    for (const hash of ['n=0.3&axis=sqrt&v=0', 'w1=0.25&v=0.1&a=0.85', 'n=0.3&v=0.1&a=all']) {
      const page = await open(browser, `#${mode}${hash}`, { viewport: { width, height } });
      const story = await page.$eval('#story', (e) => [e.scrollWidth - e.clientWidth, e.scrollHeight - e.clientHeight, e.textContent]);
      assert.ok(story[0] <= 0 && story[1] <= 1, `${width}: ${story}`);
      await page.close();
    }
});

test('lecture: by key and address, letters 1.4 times, dragging goes as far as the pointer', async () => {
  const page = await open(browser, '#v=0.25', { viewport: { width: 1280, height: 720 } });
  const letters = () => page.$eval('#balance text', (e) => e.getBoundingClientRect().height);
  const before = await letters();
  await page.keyboard.press('l');
  await data(page);
  close((await letters()) / before, 1.4, 0.05);
  await page.waitForFunction(() => location.hash.includes('lecture'));
  // Where the orange curve is at a share of the width of the picture, on the screen.
  const curve = (share) =>
    page.evaluate((share) => {
      const hit = document.querySelector('#balance .hit');
      const box = document.querySelector('#balance').getBoundingClientRect();
      let [low, high] = [0, hit.getTotalLength()];
      for (let i = 0; i < 40; i++) {
        const at = hit.getPointAtLength((low + high) / 2).matrixTransform(hit.getScreenCTM());
        if (at.x < box.left + share * box.width) low = (low + high) / 2;
        else high = (low + high) / 2;
      }
      const at = hit.getPointAtLength(low).matrixTransform(hit.getScreenCTM());
      return [at.x, at.y];
    }, share);
  const [x, y] = await curve(0.4);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x, y - 24, { steps: 4 });
  await page.mouse.up();
  await data(page);
  close((await curve(0.4))[1], y - 24, 0.01);
  await page.keyboard.press('L');
  await page.waitForFunction(() => !location.hash.includes('lecture'));
  await page.close();
});

test('reduced motion: a jump is over at once, and nothing glides', async () => {
  for (const [reducedMotion, moving] of [
    ['reduce', false],
    ['no-preference', true],
  ]) {
    const page = await open(browser, '', { reducedMotion });
    const radii = await page.evaluate(async () => {
      explorer.move(-0.6);
      const seen = [];
      for (let i = 0; i < 8; i++) {
        await new Promise(requestAnimationFrame);
        seen.push(document.querySelector('#energy .ball').getAttribute('opacity'));
      }
      return seen;
    });
    assert.equal(radii.slice(1).includes('1'), moving, reducedMotion);
    await page.close();
  }
});

test('no overflow from 360 to 1600 pixels, light and dark', async () => {
  for (const width of [360, 390, 600, 768, 1024, 1280, 1600])
    for (const colorScheme of ['light', 'dark']) {
      const page = await open(browser, '#shape=table&v=0.2&control=D&unit=own', {
        viewport: { width, height: 900 },
        colorScheme,
      });
      const over = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      assert.ok(over <= 0, `${width} ${colorScheme}: ${over} px too wide`);
      const cut = await page.$$eval('.panel', (all) =>
        all.filter((e) => e.scrollWidth > e.clientWidth + 1).map((e) => e.className),
      );
      assert.deepEqual(cut, [], `${width} ${colorScheme}`);
      await page.close();
    }
});

test('axe finds nothing, light and dark', async () => {
  for (const colorScheme of ['light', 'dark'])
    for (const hash of ['', '#shape=table&v=0.2&control=D&unit=own']) {
      const page = await open(browser, hash, { colorScheme });
      await page.click('summary');
      await page.evaluate(axe);
      const { violations } = await page.evaluate(() => globalThis.axe.run(document));
      assert.deepEqual(
        violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.target.join(' ')).slice(0, 3)}`),
        [],
      );
      await page.close();
    }
});

test('the picture to take away is an SVG on its own, in the colours that are shown', async () => {
  for (const colorScheme of ['light', 'dark']) {
    const page = await open(browser, '', { colorScheme });
    await move(page, -0.6);
    const svg = await page.evaluate(() => explorer.picture());
    const told = await page.evaluate((text) => {
      const document_ = new DOMParser().parseFromString(text, 'image/svg+xml');
      return {
        errors: document_.querySelectorAll('parsererror').length,
        panels: document_.querySelectorAll('svg > svg').length,
        scene: JSON.parse(document_.querySelector('metadata').textContent).scene,
        paths: document_.querySelectorAll('path').length,
      };
    }, svg);
    assert.deepEqual([told.errors, told.panels], [0, 4]);
    assert.ok(told.paths > 30);
    assert.match(svg, colorScheme === 'dark' ? /--panel:#1a1e23/ : /--panel:#ffffff|--panel:#fff/);
    assert.match(svg, /power law, n = 2, ρ = 1, depth d = −0\.6/);
    assert.match(told.scene, /^path = \[0\.25, -0\.6\]$/m);
    assert.ok(!/https?:(?!\/\/www\.w3\.org)/.test(svg));
    const [download] = await Promise.all([page.waitForEvent('download'), page.click('#save-svg')]);
    assert.equal(download.suggestedFilename(), 'contact.svg');
    await page.close();
  }
});

test('SI units say the same: the pull-off force of an AFM tip is −(3/2)πwR', async () => {
  const page = await open(browser);
  await preset(page, 'Dead load');
  await change(page, { unit: 'afm' });
  await page.evaluate(() => explorer.move(-0.75 + 1e-9));
  await data(page);
  // w = 0.05 J/m², R = 20 nm
  assert.match(await page.textContent('#readout'), /−4\.71 nN/);
  await page.close();
});

test('one picture and its control fit into a frame of another page', async () => {
  for (const [width, height, only, other] of [
    [360, 420, 'balance', 'force'],
    [900, 420, 'balance', 'body'],
    [360, 420, 'body', 'force'],
    [700, 420, 'force', 'balance'],
  ]) {
    const page = await open(browser, `#only=${only}`, { viewport: { width, height } });
    await move(page, -0.6);
    assert.equal((await data(page)).state, 'detached');
    const [w, h] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.scrollHeight]);
    assert.ok(w <= width && h <= height, `${w} × ${h} in ${width} × ${height}`);
    assert.ok((await page.isHidden(`#${other}`)) && (await page.isVisible(`#${only}`)));
    assert.ok((await page.evaluate(() => location.hash)).includes(`only=${only}`));
    assert.deepEqual(page.problems, []);
    await page.close();
  }
});
