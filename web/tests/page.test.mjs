// The page as a reader meets it: alone, by keys, by hand, small, dark, printed as SVG; and how fast it is.
import test, { after, before } from 'node:test';
import assert from 'node:assert/strict';
import { gzipSync } from 'node:zlib';
import { readFileSync } from 'node:fs';
import { axe, change, close, data, file, launch, move, open, preset } from './browser.mjs';

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

test('starts from a file, alone and without complaint, within a second', async () => {
  const times = [];
  for (let i = 0; i < 3; i++) {
    const page = await open(browser);
    assert.deepEqual(page.problems, []);
    assert.deepEqual(
      page.requests.filter((u) => !u.startsWith('data:') && u !== file.href),
      [],
    );
    const d = await data(page);
    assert.equal(d.state, 'contact');
    times.push(+d.readyMs);
    await page.close();
  }
  console.log(`# ready after ${times.join(', ')} ms`);
  assert.ok(Math.min(...times) < 1000);
});

test('is smaller than 500 kB, compressed', () => {
  const size = gzipSync(readFileSync(file), { level: 9 }).length;
  console.log(`# ${size} bytes compressed`);
  assert.ok(size < 500_000);
});

test('a frame takes less than 16 ms while dragging (95 of 100)', async () => {
  const page = await open(browser, '', { reducedMotion: 'no-preference' });
  for (const name of ['JKR sphere', 'Three folds', 'Short waves', 'Your own tip']) {
    let best = Infinity;
    // A machine that is busy with other things may be slow once.
    for (let attempt = 0; attempt < 8 && best >= 16; attempt++) {
      await preset(page, name);
      await page.waitForTimeout(600);
      const frames = await page.evaluate(async () => {
        const [lo, hi] = explorer.state().range;
        for (let i = 0; i < 120; i++) {
          explorer.move(lo + (hi - lo) * (0.5 + 0.45 * Math.sin(i / 8)));
          await new Promise(requestAnimationFrame);
        }
        return explorer
          .state()
          .frames.slice(-110)
          .sort((a, b) => a - b);
      });
      const [median, p95, largest] = [0.5, 0.95, 1].map(
        (q) => frames[Math.min(frames.length - 1, Math.floor(frames.length * q))],
      );
      console.log(`# ${name}: median ${median.toFixed(1)} ms, p95 ${p95.toFixed(1)} ms, largest ${largest.toFixed(1)} ms`);
      best = Math.min(best, p95);
    }
    assert.ok(best < 16, `${name}: ${best} ms`);
  }
  await page.close();
});

test('the address holds the state', async () => {
  const page = await open(browser, '#n=0.25&axis=sqrt&v=0.12&a=0.0016');
  const d = await data(page);
  assert.equal(d.state, 'contact');
  close(+d.value, 0.12);
  await move(page, 0.2);
  await page.waitForFunction(() => location.hash.includes('v=0.2'));
  const again = await open(browser, new URL(page.url()).hash);
  close(+(await data(again)).a, +(await data(page)).a, 1e-3);
  await again.close();
  await page.close();
  for (const bad of [
    '#v=NaN&n=-3&shape=cube&k=1e99',
    '#n=&v=',
    '#%%%',
    '#a=all&v=0.2',
    '#a=-1&v=1e9',
    '#v=0&shape=table&table=0,0;1,1',
    '#v=0&shape=table&table=0,0;1,1;0.5,2;3,x;4,4;5,5',
  ]) {
    const p = await open(browser, bad);
    assert.deepEqual(p.problems, [], bad);
    await p.close();
  }
});

test('a profile drawn or pasted is in the address, and a bad one is refused in words', async () => {
  const page = await open(browser);
  await preset(page, 'Your own tip');
  const box = await page.locator('#pad').boundingBox();
  const before = await page.evaluate(() => explorer.state().P.table);
  await page.mouse.move(box.x + 0.4 * box.width, box.y + 0.7 * box.height);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.7 * box.width, box.y + 0.3 * box.height, { steps: 8 });
  await page.mouse.up();
  assert.notEqual(await page.evaluate(() => explorer.state().P.table), before);
  assert.deepEqual(page.problems, []);

  const rows = Array.from({ length: 30 }, (_, i) => `${i * 2},${(i * 2) ** 2 / 40}`).join('\n');
  await page.fill('#table-text', `r,f\nnm,nm\n${rows}\n`);
  await page.click('#table-use');
  const d = await data(page);
  assert.equal(await page.textContent('#table-note'), '');
  assert.equal(d.shape, 'table');
  assert.equal(await page.inputValue('#unit'), 'own');
  await page.waitForFunction(() => location.hash.includes('unit=own') && location.hash.includes('table='));
  const again = await open(browser, new URL(page.url()).hash);
  assert.equal((await data(again)).folds, d.folds);
  await again.close();

  // The rows are kept as they are, not as the address rounds them; small radii are metres without a row of units.
  const fine = Array.from({ length: 200 }, (_, i) => `${i * 1.2345678e-10},${(i * 1.2345678e-10) ** 2 / 4e-8}`).join('\n');
  await page.evaluate(() => explorer.change({ unit: 'none' }));
  const took = await page.evaluate(async (text) => {
    const start = performance.now();
    await explorer.paste(text);
    return performance.now() - start;
  }, fine);
  console.log(`# a table of 200 rows is opened in ${took.toFixed(0)} ms`);
  assert.equal(await page.inputValue('#unit'), 'own');
  assert.match(await page.evaluate(() => explorer.files().table), /^1\.2345678e-10,/m);

  const kept = await page.evaluate(() => explorer.state().P.table);
  for (const [bad, words] of [
    ['1,2\n2,3', /at least four rows/],
    ['0,0\n1,1\n2,x\n3,3\n4,4', /no row of two numbers/],
    ['0,0\n1,-1\n2,-3\n3,-5', /fall outward/],
    ['r,f\nnm,furlong\n0,0\n1,1\n2,3\n3,5', /“furlong” is no unit of length/],
    ['r (inch),f (nm)\n0,0\n1,1\n2,3\n3,5', /“inch” is no unit of length/],
  ]) {
    await page.fill('#table-text', bad);
    await page.click('#table-use');
    assert.match(await page.textContent('#table-note'), words);
    assert.equal(await page.evaluate(() => explorer.state().P.table), kept);
  }
  await page.close();
});

test('a table with many folds is weighed away from the page, and offered smoothed', async () => {
  const page = await open(browser);
  await preset(page, 'Your own tip');
  let seed = 7;
  const noise = () => (seed = (seed * 1103515245 + 12345) % 2147483648) / 2147483648 - 0.5;
  const rows = Array.from({ length: 400 }, (_, i) => [i / 4, (i / 4) ** 2 / 80 + (i ? 0.4 * noise() : 0)]);
  const slept = await page.evaluate(async (text) => {
    let longest = 0;
    let last = performance.now();
    const beat = setInterval(() => {
      longest = Math.max(longest, performance.now() - last);
      last = performance.now();
    }, 10);
    await explorer.paste(text);
    clearInterval(beat);
    return longest;
  }, `r,f\nnm,nm\n${rows.map((row) => row.join()).join('\n')}\n`);
  console.log(`# the page stood still for ${slept.toFixed(0)} ms`);
  assert.match(await page.textContent('#table-note'), /folds/);
  await page.locator('#table-note button').first().click();
  const d = await data(page);
  assert.ok(d.shape === 'table' && +d.folds <= 8, `${d.folds} folds`);
  assert.match(await page.evaluate(() => explorer.files().scene), /^smooth = /m);
  assert.deepEqual(page.problems, []);
  await page.close();
});

test('no slider is a trap for keys: from every mark the arrows lead on', async () => {
  const page = await open(browser);
  for (const [key, at] of [
    ['n', 2],
    ['n', 0.5],
    ['rho', 1],
  ])
    for (const arrow of ['ArrowRight', 'ArrowLeft']) {
      await change(page, { [key]: at });
      await page.focus(`#s-${key}`);
      for (let i = 0; i < 6; i++) await page.keyboard.press(arrow);
      const now = await page.evaluate((key) => explorer.state().P[key], key);
      assert.ok(arrow === 'ArrowRight' ? now > at : now < at, `${key} = ${now} after ${arrow} from ${at}`);
      // And back: the mark is not passed by.
      const back = arrow === 'ArrowRight' ? 'ArrowLeft' : 'ArrowRight';
      const seen = new Set();
      for (let i = 0; i < 12; i++) {
        await page.keyboard.press(back);
        seen.add(await page.evaluate((key) => explorer.state().P[key], key));
      }
      assert.ok(seen.has(at), `${key}: ${at} among ${[...seen]}`);
    }
  await page.close();
});

test('undo takes back a move with its way, and Back a preset', async () => {
  const page = await open(browser, '#v=0.3');
  await page.focus('#value');
  await page.keyboard.press('Home');
  const there = await data(page);
  assert.equal(there.jumps, '1');
  await page.keyboard.press('Control+z');
  assert.deepEqual([(await data(page)).value, (await data(page)).jumps], ['0.3', '0']);
  await page.keyboard.press('Home');
  await page.waitForTimeout(1000);
  await change(page, { n: 1 });
  await page.click('#undo');
  const again = await data(page);
  assert.deepEqual([again.jumps, again.lost, again.state], [there.jumps, there.lost, there.state]);
  await preset(page, 'Cone');
  await page.waitForFunction(() => /n=1(&|$)/.test(location.hash));
  await page.goBack();
  await page.waitForFunction(() => explorer.state().P.n === 2);
  assert.equal((await data(page)).state, there.state);
  await page.close();
});

test('Play stops where something else is done, and a unit that is none is said in words', async () => {
  const page = await open(browser, '#v=0.3&unit=own', { reducedMotion: 'no-preference' });
  await page.click('#play');
  await page.evaluate(() => (location.hash = '#v=0.4&unit=own'));
  await page.waitForTimeout(400);
  assert.equal(await page.getAttribute('#play', 'aria-pressed'), 'false');
  for (const [field, text, words] of [
    ['uR', '5 furlong', /“furlong” is no unit of R.*µm/],
    ['uE', 'soft', /“soft” is no number/],
    ['uw', '1e9', /between/],
  ]) {
    await page.fill(`#${field}`, text);
    await page.keyboard.press('Enter');
    await page.locator(`#${field}`).blur();
    assert.match(await page.textContent('#unit-note'), words);
    assert.equal(await page.getAttribute(`#${field}`, 'aria-invalid'), 'true');
  }
  await page.fill('#uR', '5 um');
  await page.locator('#uR').blur();
  assert.equal(await page.textContent('#unit-note'), '');
  assert.equal(await page.evaluate(() => explorer.state().P.uR), 5e-6);
  await page.close();
});

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

test('compared with the contact of Hertz, and with a curve that was pinned', async () => {
  const page = await open(browser, '#v=0.25');
  assert.equal(await page.getAttribute('#force .ghost', 'd'), '');
  await page.click('#ghost');
  await page.click('#pin');
  await data(page);
  // In reduced units F = (4/3) d^(3/2).
  const points = await page.evaluate(() => {
    const ghost = document.querySelector('#force .ghost');
    const ticks = (axis) => [...document.querySelectorAll('#force text')].filter((e) => e.getAttribute('text-anchor') === axis && /^−?[\d.]+$/.test(e.textContent));
    const number = (e) => Number(e.textContent.replace('−', '-'));
    const scale = (all, key) => {
      const [one, two] = [all[0], all.at(-1)];
      const slope = (number(two) - number(one)) / (two.getAttribute(key) - one.getAttribute(key));
      return (pixel) => number(one) + slope * (pixel - one.getAttribute(key));
    };
    const xs = ticks('middle');
    const x = scale(xs, 'x');
    const y = scale(ticks('end').filter((e) => e.textContent), 'y');
    return [...ghost.getAttribute('d').matchAll(/([\d.-]+) ([\d.-]+)/g)].map(([, u, v]) => [x(+u), y(+v - -4)]).filter(([d, F]) => d > 0.1 && d < 0.5 && F < 0.5);
  });
  assert.ok(points.length > 3, `${points.length} points`);
  for (const [d, F] of points) close(F, (4 / 3) * d ** 1.5, 0.02);
  const kept = await page.getAttribute('#force .pinned', 'd');
  assert.ok(kept.length > 100);
  await change(page, { rho: 1.3 });
  assert.match(await page.textContent('#readout'), /force over that at P/);
  await page.click('#pin');
  await data(page);
  assert.equal(await page.getAttribute('#force .pinned', 'd'), '');
  assert.deepEqual(page.problems, []);
  await page.close();
});

test('six tasks: a guess, then what happens, and the progress in the address', async () => {
  const page = await open(browser);
  const found = [];
  await page.click('#tasks-open');
  for (let i = 0; i < 6; i++) {
    assert.match(await page.textContent('#task-text'), new RegExp(`^Task ${i + 1} of 6`));
    await page.locator('#guess').fill(String(await page.evaluate(() => explorer.state().range[0] * 0.5)));
    await page.click('#task-play');
    const text = await page.textContent('#task-answer');
    found.push(text.match(/= (−?[\d.]+)/)?.[1] ?? text);
    if (i < 5) await page.click('#task-next');
  }
  console.log(`# measured: ${found.join(', ')}`);
  assert.deepEqual(found.slice(0, 2), ['−0.472', '−0.750']);
  assert.ok(Number(found[3]) > 0.249 && Number(found[3]) < 0.251, found[3]);
  assert.ok(found.every((x) => /^−?\d/.test(x)), found.join());
  await page.waitForFunction(() => /task=6/.test(location.hash) && /done=1\.2\.3\.4\.5\.6/.test(location.hash));
  const again = await open(browser, new URL(page.url()).hash);
  assert.match(await again.textContent('#task-text'), /^Task 6 of 6/);
  await again.close();
  await preset(page, 'Cone');
  assert.ok(await page.isHidden('#tasks'));
  assert.deepEqual(page.problems, []);
  await page.close();
});

test('keyboard: the slider pulls it off, the edge can be held and let go', async () => {
  const page = await open(browser);
  await page.focus('#value');
  for (let i = 0; i < 9; i++) await page.keyboard.press('PageDown');
  assert.equal((await data(page)).state, 'detached');
  for (let i = 0; i < 8; i++) await page.keyboard.press('PageUp');
  assert.equal((await data(page)).state, 'contact');
  const rest = +(await data(page)).a;
  await page.focus('#balance .probe');
  for (let i = 0; i < 8; i++) await page.keyboard.press('ArrowLeft');
  await page.waitForTimeout(150);
  assert.match(await page.textContent('#story'), /You hold the edge/);
  await page.keyboard.press('Enter');
  close(+(await data(page)).a, rest);
  await page.focus('#value');
  await page.keyboard.press('Home');
  assert.equal((await data(page)).state, 'detached');
  await page.focus('#control [aria-checked="true"]');
  await page.keyboard.press('ArrowRight');
  assert.equal((await data(page)).control, 'F');
  await page.close();
});

test('every control is reached by Tab, and none holds the focus', async () => {
  const page = await open(browser);
  const seen = new Set();
  for (let i = 0; i < 60; i++) {
    await page.keyboard.press('Tab');
    seen.add(
      await page.evaluate(
        () =>
          document.activeElement.id ||
          document.activeElement.dataset.preset ||
          document.activeElement.dataset.key ||
          document.activeElement.dataset.part ||
          document.activeElement.tagName,
      ),
    );
  }
  for (const id of [
    'skip',
    'value',
    'play',
    'reset',
    's-n',
    's-rho',
    'axis',
    'unit',
    'probe',
    'save-svg',
    'theme',
    '0',
    'power',
    'd',
  ])
    assert.ok(seen.has(id), `${id} of ${[...seen]}`);
  await page.close();
});

test('pointer and finger: dragging the orange curve changes the depth', async () => {
  const middle = () => {
    const hit = document.querySelector('#balance .hit');
    const at = hit.getPointAtLength(hit.getTotalLength() * 0.5);
    const box = document.querySelector('#balance').getBoundingClientRect();
    return [box.left + at.x, box.top + at.y];
  };
  const page = await open(browser);
  const before = +(await data(page)).value;
  const [x, y] = await page.evaluate(middle);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x, y - 60, { steps: 6 });
  await page.mouse.up();
  assert.ok(+(await data(page)).value < before - 0.1);
  await page.close();

  const phone = await open(browser, '', { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true });
  const [u, v] = await phone.evaluate(middle);
  const client = await phone.context().newCDPSession(phone);
  const touch = (type, y) =>
    client.send('Input.dispatchTouchEvent', { type, touchPoints: type === 'touchEnd' ? [] : [{ x: u, y }] });
  await touch('touchStart', v);
  for (let i = 1; i <= 6; i++) await touch('touchMove', v - 10 * i);
  await touch('touchEnd');
  assert.ok(+(await data(phone)).value < before - 0.1);
  assert.deepEqual(phone.problems, []);
  await phone.close();
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

// FUZZ=2000 for more than the gate has time for.
const ACTIONS = Number(process.env.FUZZ) || 250;
for (const first of [12345, 35, 2026]) test(`${ACTIONS} random operations from ${first}: no complaint, no number that is none`, async () => {
  const page = await open(browser);
  const bad = await page.evaluate(async ([first, actions]) => {
    let seed = first;
    const random = () => (seed = (seed * 1103515245 + 12345) % 2147483648) / 2147483648;
    const pick = (all) => all[Math.floor(random() * all.length)];
    const bad = [];
    const parameters = {
      n: () => pick([0.1, 0.25, 0.5, 1, 2, 4, 0.1 * 40 ** random()]),
      rho: () => 0.4 * 10 ** random(),
      R: () => 1.05 + 5 * random(),
      A: () => 0.2 * random(),
      L: () => 0.25 + 1.75 * random(),
      k: () => 0.03 * 3333 ** random(),
      control: () => pick(['d', 'F', 'D']),
      shape: () => pick(['power', 'sphere', 'wavy', 'table']),
      axis: () => pick(['lin', 'sqrt', 'log']),
      view: () => pick(['body', 'scale', 'springs']),
      graph: () => pick(['force', 'fold']),
      unit: () => pick(['none', 'afm', 'gel', 'paper', 'own']),
    };
    for (let i = 0; i < actions; i++) {
      const op = random();
      const { range, reach } = explorer.state();
      let what = ['move', random() < 0.1 ? pick([...range, 0]) : range[0] + (range[1] - range[0]) * random()];
      if (op < 0.05) what = ['preset', Math.floor(random() * 11)];
      else if (op < 0.3) {
        const key = pick(Object.keys(parameters));
        what = ['change', { [key]: parameters[key]() }];
      } else if (op < 0.36) what = ['probe', random() * reach];
      else if (op < 0.4) what = ['undo'];
      try {
        explorer[what[0]](what[1]);
        if (what[0] === 'probe') explorer.release();
      } catch (error) {
        bad.push([what, error.stack.slice(0, 200)]);
      }
      if (i % 3 === 0) await new Promise(requestAnimationFrame);
      const { S, range: now, P } = explorer.state();
      const known = S.kind !== 1 || (S.a > 0 && Number.isFinite(S.d) && Number.isFinite(S.F));
      if (!known || !(now[0] < now[1])) bad.push([what, JSON.stringify(S), JSON.stringify(P)]);
    }
    return bad.slice(0, 5);
  }, [first, ACTIONS]);
  assert.deepEqual(bad, []);
  assert.deepEqual(page.problems, []);
  assert.equal((await data(page)).failures, '0');
  await page.close();
});
