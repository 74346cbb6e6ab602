// How fast the page is, how large, and that nothing that is done to it ends it.
import test, { after, before } from 'node:test';
import assert from 'node:assert/strict';
import { gzipSync } from 'node:zlib';
import { readFileSync } from 'node:fs';
import { change, data, file, launch, move, open, preset } from './browser.mjs';

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

test('no move takes longer than 250 ms on a processor that is six times slower', async () => {
  const page = await open(browser, '', { reducedMotion: 'no-preference' });
  const client = await page.context().newCDPSession(page);
  await client.send('Emulation.setCPUThrottlingRate', { rate: 6 });
  for (const parameters of [
    {},
    { n: 0.514, rho: 2 },
    { shape: 'wavy', A: 0.2, L: 0.25, rho: 0.4, control: 'D' },
    { shape: 'wavy', A: 0.1, L: 0.3, w1: 0.3 },
    { shape: 'sphere', control: 'F' },
    { medium: 'graded', grade: -0.5, n: 1.3 },
    { medium: 'springs', w1: 0.5 },
    { medium: 'wave', w1: 0.4, control: 'F' },
  ]) {
    let best = Infinity;
    // A machine that is busy with other things may be slow once.
    for (let attempt = 0; attempt < 4 && best >= 250; attempt++) {
      const longest = await page.evaluate(async (parameters) => {
        explorer.preset(0);
        await new Promise((done) => setTimeout(done, 800));
        const timed = (what) => {
          const start = performance.now();
          what();
          return performance.now() - start;
        };
        const times = [timed(() => explorer.change(parameters))];
        await new Promise((done) => setTimeout(done, 800));
        const [low, high] = explorer.state().range;
        for (let i = 0; i < 24; i++) {
          explorer.move(low + (high - low) * (0.5 + 0.5 * Math.sin(i / 4)));
          await new Promise(requestAnimationFrame);
        }
        return Math.max(...times, ...explorer.state().frames.slice(-24));
      }, parameters);
      best = Math.min(best, longest);
    }
    console.log(`# ${JSON.stringify(parameters)}: ${best.toFixed(0)} ms`);
    assert.ok(best < 250, `${JSON.stringify(parameters)}: ${best} ms`);
  }
  await page.close();
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
      medium: () => pick(['half', 'half', 'graded', 'springs', 'wave']),
      grade: () => 1.4 * random() - 0.5,
      alpha: () => 0.1 + 1.1 * random(),
      w1: () => pick([1, 1, 0, random()]),
      axis: () => pick(['lin', 'sqrt', 'log']),
      view: () => pick(['body', 'scale', 'springs']),
      graph: () => pick(['force', 'fold']),
      unit: () => pick(['none', 'afm', 'gel', 'paper', 'own']),
    };
    for (let i = 0; i < actions; i++) {
      const op = random();
      const { range, reach } = explorer.state();
      let what = ['move', random() < 0.1 ? pick([...range, 0]) : range[0] + (range[1] - range[0]) * random()];
      if (op < 0.05) what = ['preset', Math.floor(random() * 14)];
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
