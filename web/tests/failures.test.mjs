// The page goes on whatever happens: near n = ½, where radii leave every range, and when the engine fails.
import test, { after, before } from 'node:test';
import assert from 'node:assert/strict';
import { change, close, data, launch, move, open, preset } from './browser.mjs';

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

/** In the page: what is drawn has numbers, none of them far beyond every screen. */
function lookAround() {
  const drawn = new Set(['d', 'x', 'y', 'cx', 'cy', 'x1', 'x2', 'y1', 'y2', 'r', 'points']);
  for (const node of document.querySelectorAll('main svg *'))
    for (const { name, value } of node.attributes)
      if (drawn.has(name) && /NaN|Infinity|undefined|\d{6,}(?!\d*\.)|\de\+/.test(value.replace(/\.\d+/g, '.')))
        return `${node.closest('svg').id} ${node.getAttribute('class')} ${name}="${value.slice(0, 80)}"`;
  return '';
}

test('through n = ½, ρ = 2, n = 0.514, press and pull', async () => {
  const page = await open(browser, '', { reducedMotion: 'no-preference' });
  await preset(page, 'Through n = ½');
  await change(page, { rho: 2 });
  await change(page, { n: 0.514 });
  await page.click('#play');
  await page.waitForTimeout(4000);
  const d = await data(page);
  assert.deepEqual([page.problems, d.failures], [[], '0']);
  await preset(page, 'JKR sphere');
  close(+(await data(page)).force, -0.4387769220263308, 1e-9);
  await page.close();
});

test('slightly above n = ½ every combination is pressed, pulled and drawn', async () => {
  const page = await open(browser, '', { reducedMotion: 'no-preference' });
  await page.evaluate(`window.lookAround = ${lookAround}`);
  const bad = await page.evaluate(async () => {
    const bad = [];
    for (const control of ['d', 'F', 'D'])
      for (const n of [0.5001, 0.501, 0.505, 0.51, 0.514, 0.52, 0.53, 0.54, 0.55, 0.499])
        for (const rho of [0.4, 1, 1.4, 2, 4]) {
          explorer.change({ shape: 'power', control, n, rho, graph: n > 0.52 ? 'fold' : 'force' });
          const { range } = explorer.state();
          for (const share of [1, 0.4, 0, 0.7]) {
            explorer.move(range[0] + share * (range[1] - range[0]));
            await new Promise(requestAnimationFrame);
            await new Promise(requestAnimationFrame);
            const found = lookAround();
            if (found) bad.push([control, n, rho, share, found]);
          }
        }
    return bad;
  });
  assert.deepEqual(bad.slice(0, 5), [], `${bad.length} of 600`);
  assert.deepEqual([page.problems, (await data(page)).failures], [[], '0']);
  await page.close();
});

/** The exports of every instance are wrapped: `window.fails` names the calls that end theirs. */
function breakable() {
  window.fails = {};
  const make = WebAssembly.instantiate;
  WebAssembly.instantiate = async (...parts) => {
    const { exports } = await make(...parts);
    let dead = false;
    const wrapped = { memory: exports.memory };
    for (const [name, call] of Object.entries(exports))
      if (typeof call === 'function')
        wrapped[name] = (...numbers) => {
          dead ||= window.fails[name] > 0 && window.fails[name]-- > 0;
          if (dead) throw new WebAssembly.RuntimeError('unreachable');
          return call(...numbers);
        };
    return { exports: wrapped };
  };
}

for (const name of ['balance', 'surface', 'equilibria', 'advance', 'curve', 'outer_radius', 'contact', 'verify', 'kappa', 'input'])
  test(`an engine that fails in ${name} is made anew, and the page says so`, async () => {
    const page = await open(browser, '#v=0', { script: breakable });
    const before = await data(page);
    await page.evaluate((name) => (window.fails[name] = 1), name);
    // What calls each of them: another contact, and a path with an event.
    await change(page, { n: 1.5 });
    await data(page);
    await move(page, -0.6);
    await page.waitForTimeout(400);
    const d = await data(page);
    assert.equal(d.failures, '1', name);
    assert.ok(['contact', 'detached'].includes(d.state));
    // A path, a state, and a contact of another kind are what they are without a failure.
    await preset(page, 'JKR sphere');
    const again = await data(page);
    close(+again.force, -0.4387769220263308, 1e-9, name);
    await move(page, -0.6);
    assert.equal((await data(page)).state, 'detached');
    assert.equal(before.failures, '0');
    assert.deepEqual(page.problems, []);
    await page.close();
  });

test('the last good contact is open after a failure, with words', async () => {
  const page = await open(browser, '#v=0.2&n=1.5&control=F', { script: breakable });
  const before = await data(page);
  await page.evaluate(() => (window.fails.balance = 1));
  await move(page, 0.1);
  await page.waitForTimeout(300);
  const d = await data(page);
  assert.match(await page.textContent('#story'), /engine failed.*made anew/);
  assert.deepEqual([d.value, d.a, d.force, d.failures], [before.value, before.a, before.force, '1']);
  await page.focus('#value');
  await page.keyboard.press('ArrowRight');
  assert.ok(+(await data(page)).value > +before.value);
  assert.doesNotMatch(await page.textContent('#story'), /engine failed/);
  await page.close();
});

test('an engine that fails for ever is not asked for ever', async () => {
  const page = await open(browser, '#v=0.2', { script: breakable });
  await page.evaluate(() => (window.fails.balance = 1e9));
  await move(page, 0.1);
  await page.waitForTimeout(1500);
  assert.match(await page.textContent('#story'), /reload/);
  const count = await page.evaluate(() => 1e9 - window.fails.balance);
  await page.waitForTimeout(500);
  assert.equal(await page.evaluate(() => 1e9 - window.fails.balance), count);
  assert.ok(count < 20, `${count} failures`);
  await page.close();
});
