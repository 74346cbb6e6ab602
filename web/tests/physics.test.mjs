// What the contact does on the page, against closed forms and against the program.
import test, { after, before } from 'node:test';
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { change, close, data, launch, move, open, preset, sweep } from './browser.mjs';

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

test('JKR: pulled off at the fold, jumps in at d = 0, and the loop is the sum of both losses', async () => {
  const page = await open(browser);
  await sweep(page, -0.6);
  let d = await data(page);
  assert.deepEqual([d.state, d.jumps], ['detached', '1']);
  close(+d.lost, 0.25 ** (4 / 3) / 5, 1e-12); // (2/5)πa²w
  await sweep(page, 0.2);
  d = await data(page);
  assert.deepEqual([d.state, d.jumps], ['contact', '2']);
  close(+d.lost, 0.25 ** (4 / 3) / 5 + 0.3, 1e-12);
  const areas = await page.$$eval(
    '#force [data-mark="lost"]',
    (all) => all.filter((e) => e.getAttribute('display') !== 'none').length,
  );
  assert.equal(areas, 2);
  await page.close();
});

test('dead load: −(3/2)πwR, and the loss is unbounded', async () => {
  const page = await open(browser);
  await preset(page, 'Dead load');
  await sweep(page, -0.749);
  assert.equal((await data(page)).state, 'contact');
  await sweep(page, -0.751);
  const d = await data(page);
  assert.deepEqual([d.state, d.unbounded], ['detached', 'true']);
  await page.close();
});

test('the exponent through one half: stable, neutral, unstable; a nudge decides', async () => {
  const page = await open(browser);
  await preset(page, 'Through n = ½');
  for (const [n, stable, words] of [
    [0.8, 1, 'pull-off'],
    [0.5, 0, 'no length'],
    [0.3, 0, 'complete contact'],
  ]) {
    await change(page, { n });
    const d = await data(page);
    close(+d.a, 1, 1e-3);
    assert.ok((await page.textContent('#o-n')).includes(words));
    const marks = await page.$$eval(
      '#balance [data-mark="stable"]',
      (all) => all.filter((e) => e.getAttribute('display') !== 'none').length,
    );
    assert.equal(marks, stable, `n = ${n}`);
    assert.equal(d.degenerate, String(n === 0.5));
  }
  assert.match(await page.textContent('#story'), /Poised/);
  await move(page, 0.05);
  assert.equal((await data(page)).state, 'complete');
  await page.close();
});

test('on another medium the regimes meet at another exponent', async () => {
  const page = await open(browser);
  await preset(page, 'Graded half-space'); // k = ½: they meet at n = ¼
  for (const [n, words] of [
    [0.3, 'pull-off'],
    [0.25, 'no length'],
    [0.2, 'complete contact'],
  ]) {
    await change(page, { n });
    assert.ok((await page.textContent('#o-n')).includes(words), `n = ${n}`);
  }
  await change(page, { grade: -0.5 });
  assert.equal(await page.textContent('#o-grade'), '−0.500');
  await change(page, { medium: 'springs', n: 0.1 });
  assert.ok((await page.textContent('#o-n')).includes('pull-off'));
  await page.close();
});

test('a sharp tip is pressed into complete contact at d_c', async () => {
  const page = await open(browser);
  await preset(page, 'Sharp tip');
  await sweep(page, 0.249);
  assert.equal((await data(page)).state, 'contact');
  await sweep(page, 0.251);
  assert.equal((await data(page)).state, 'complete');
  await page.close();
});

test('machine: three folds, two loops; one fold when it is very soft or very stiff', async () => {
  const page = await open(browser);
  await preset(page, 'Three folds');
  assert.equal((await data(page)).folds, '3');
  const range = await page.evaluate(() => explorer.state().range);
  await sweep(page, range[1], 60);
  await sweep(page, range[0], 60);
  const d = await data(page);
  assert.deepEqual([d.jumps, d.state], ['4', 'detached']);
  for (const k of [0.03, 100]) {
    await change(page, { k });
    assert.equal((await data(page)).folds, '1', `k = ${k}`);
  }
  await page.close();
});

test('waves: figure 4 of the paper', async () => {
  const page = await open(browser);
  await preset(page, 'Figure 4: wavy sphere');
  await sweep(page, -0.3, 30);
  let d = await data(page);
  assert.deepEqual([d.jumps, d.state], ['1', 'contact']);
  await sweep(page, -0.4, 30);
  d = await data(page);
  assert.deepEqual([d.jumps, d.state], ['2', 'detached']);
  await page.close();
});

test('two routes agree wherever the contact is', async () => {
  const page = await open(browser);
  for (const name of ['JKR sphere', 'Cone', 'Sharp tip', 'Figure 4: wavy sphere', 'True sphere', 'Your own tip']) {
    await preset(page, name);
    const { check } = await data(page);
    assert.ok(check !== '' && +check < 1e-12, `${name}: ${check}`);
  }
  await page.close();
});

test('a path in one stride is the path in small steps', async () => {
  const page = await open(browser);
  for (const name of ['JKR sphere', 'Figure 4: wavy sphere', 'Short waves', 'Three folds', 'Your own tip']) {
    const ends = [];
    for (const steps of [1, 40]) {
      await preset(page, name);
      const [low, high] = await page.evaluate(() => explorer.state().range);
      for (const to of [low, high, 0]) await sweep(page, to, steps);
      ends.push(await data(page));
    }
    const [one, many] = ends;
    assert.equal(one.jumps, many.jumps, name);
    close(+one.lost, +many.lost, 1e-9, name);
    close(+one.a, +many.a, 1e-9, name);
  }
  await page.close();
});

/** Contacts and ways: chosen by hand where something is special, and at random. */
const SPECIAL = [
  ['JKR sphere', {}, [-0.6, 0.2]],
  ['JKR sphere', { unit: 'gel' }, [-0.6, 0.31]],
  ['Cone', { control: 'F' }, [0.5]],
  ['Through n = ½', { n: 0.6 }, [0.1]],
  ['Sharp tip', {}, [-0.1, 0.15]],
  ['Sharp tip', {}, [0.3]], // complete contact
  ['Dead load', { unit: 'paper' }, [0.9, -0.2]],
  ['Three folds', {}, [0.3, -0.02, 0.2]],
  ['Figure 4: wavy sphere', { unit: 'paper' }, [-0.32, 0.1]],
  ['Short waves', {}, [-0.3, 0.2]],
  ['AFM cantilever', {}, [-2, 0.3]],
  ['True sphere', {}, [0.8]],
  ['Your own tip', { unit: 'afm' }, [0.5, 0.05]],
  ['Your own tip', { unit: 'afm' }, [-9, 9, 0.19]], // all the way out and back
  ['Two works of adhesion', {}, [0.3, -9, 0.2]],
  ['Two works of adhesion', { control: 'F', unit: 'gel' }, [0.4, 0.1, 0.3, -9]],
  ['Two works of adhesion', { control: 'D', k: 0.3, unit: 'afm' }, [-9, 9, -9]],
  ['Two works of adhesion', { w1: 0, shape: 'wavy' }, [0.2, -0.1, 0.1, -9]],
  ['Two works of adhesion', { w1: 0.5, medium: 'graded', grade: 0.3 }, [0.4, -9]],
  ['Graded half-space', { unit: 'gel' }, [-9, 0.3]],
  ['Graded half-space', { grade: -0.4, control: 'F', unit: 'afm' }, [-9, 9]],
  ['Graded half-space', { medium: 'springs', control: 'D', unit: 'paper' }, [-9, 9]],
  ['Johnson’s wave', {}, [0.2, -9, 9]],
  ['Johnson’s wave', { control: 'D', unit: 'gel' }, [-9, 0.2]],
  ['Johnson’s wave', { control: 'd', alpha: 0.2, unit: 'afm' }, [-9, 0.4]],
];
function sixty() {
  let seed = 35;
  const random = () => (seed = (seed * 1103515245 + 12345) % 2147483648) / 2147483648;
  const pick = (all) => all[Math.floor(random() * all.length)];
  const names = ['JKR sphere', 'Sharp tip', 'Figure 4: wavy sphere', 'Short waves', 'True sphere', 'Cone', 'Your own tip'];
  const drawn = () => {
    const parameters = { control: pick(['d', 'F', 'D']), unit: pick(['none', 'afm', 'gel', 'paper']), k: 0.1 * 100 ** random() };
    Object.assign(parameters, { rho: 0.5 * 4 ** random(), R: 1.1 + random(), A: 0.1 * random(), L: 0.4 + random() });
    const name = pick(names);
    if (!['Figure 4: wavy sphere', 'Short waves', 'True sphere', 'Your own tip'].includes(name))
      parameters.n = pick([0.3, 0.7, 1, 1.5, 2, 3, 0.2 + 2 * random()]);
    if (parameters.n && random() < 0.5)
      Object.assign(parameters, { medium: pick(['graded', 'springs']), grade: 1.4 * random() - 0.5 });
    if (random() < 0.25) parameters.w1 = 0.1 + 0.8 * random();
    return [name, parameters, Array.from({ length: 1 + Math.floor(4 * random()) }, random), 'shares'];
  };
  // Some are poised, or have nowhere to go: sixty are left.
  return [...SPECIAL, ...Array.from({ length: 80 - SPECIAL.length }, drawn)];
}

/** The answer of the program to the scene that the page hands out. */
function solve({ scene, table }, ...flags) {
  const folder = mkdtempSync(join(tmpdir(), 'scene-'));
  try {
    writeFileSync(join(folder, 'scene.toml'), scene);
    if (table) writeFileSync(join(folder, 'profile.csv'), table);
    const text = execFileSync(process.env.MDR, ['solve', join(folder, 'scene.toml'), '--format', 'json', ...flags], {
      encoding: 'utf8',
      stdio: ['ignore', 'pipe', 'pipe'],
    });
    return JSON.parse(text);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

test('sixty states and sixty paths are those of mdr solve --f64', async () => {
  const page = await open(browser);
  let worst = 0;
  const ends = {};
  for (const [name, parameters, points, shares] of sixty()) {
    await preset(page, name);
    if (Object.keys(parameters).length) await change(page, parameters);
    const [low, high] = await page.evaluate(() => explorer.state().range);
    for (const to of points) await sweep(page, shares ? low + to * (high - low) : to, 5);
    const d = await data(page);
    const what = `${name} ${JSON.stringify(parameters)} ${points}`;
    const [files, { radius, height, force }, { rest, way, S, P }] = await page.evaluate(() => [
      explorer.files(),
      explorer.units(),
      explorer.state(),
    ]);
    const size = Math.max(1e-3, ...rest.map((e) => Math.abs(e[1])));
    const same = (x, y, part, least = 1e-3) => {
      const error = Math.abs(x - y) / Math.max(Math.abs(y), least);
      worst = Math.max(worst, error);
      assert.ok(error < 1e-11, `${what}, ${part}: ${x} is not ${y}`);
    };
    const answer = solve(files, '--f64');
    assert.equal(+d.folds, answer.folds.length, `${what}, folds`);
    // Every equilibrium at the value, and whether it is stable; of two works of adhesion those of the edge that recedes.
    const states = answer.equilibria[0].equilibria.filter((e) => P.w1 === 1 || e.edge === 'receding').filter((e) => P.medium !== 'wave' || e.contact_radius < radius * (1 - 1e-9));
    assert.equal(rest.length, states.length, `${what}: equilibria at ${d.value}`);
    rest.forEach(([a, depth, F, sign], i) => {
      same(a, states[i].contact_radius / radius, `a of state ${i}`);
      same(depth, states[i].indentation / height, `d of state ${i}`, size);
      same(F, states[i].force / force, `F of state ${i}`, size);
      assert.equal(sign > 0, states[i].stable, `${what}: stability of state ${i}`);
    });
    if (way.points.length < 2) continue;
    const happened = answer.path.filter((e) => ['jump', 'jump-in', 'detached', 'complete-contact'].includes(e.event));
    assert.equal(+d.jumps, happened.length, `${what}, jumps`);
    const end = answer.path.at(-1);
    const told = { 'complete-contact': 'complete', end: '' }[end.event] ?? end.event;
    ends[end.event] = (ends[end.event] || 0) + 1;
    assert.equal(d.state === 'complete' ? 'complete' : d.ended, told, `${what}, end`);
    if (d.state === 'complete') continue;
    same(S.kind === 1 ? S.a : 0, (end.contact_radius ?? 0) / radius, 'a at the end of the path');
    const lost = happened.reduce((sum, e) => sum + (e.dissipated ?? Infinity), 0);
    const byEdge = answer.path.reduce((sum, e) => sum + (e.hysteresis ?? 0), 0);
    same(+d.receded, byEdge / (force * height), 'energy lost by the edge that recedes');
    if (d.unbounded === 'false') same(+d.lost, lost / (force * height), 'energy lost');
  }
  const paths = Object.values(ends).reduce((sum, count) => sum + count, 0);
  assert.ok(paths >= 60, `${paths} paths`);
  console.log(`# ${paths} paths, the worst relative difference ${worst.toExponential(1)}; ends ${JSON.stringify(ends)}`);
  await page.close();
});

test('a wrong number on the page would be found', async () => {
  const page = await open(browser);
  const files = await page.evaluate(() => explorer.files());
  const right = solve(files, '--f64').equilibria[0].equilibria[0].contact_radius;
  const wrong = solve({ ...files, scene: files.scene.replace('radius = 1', 'radius = 1.000001') }, '--f64').equilibria[0]
    .equilibria[0].contact_radius;
  assert.ok(Math.abs(wrong / right - 1) > 1e-8);
  await page.close();
});

test('the scene file has certified digits as well', async () => {
  const page = await open(browser);
  const files = await page.evaluate(() => explorer.files());
  const answer = solve({ ...files, scene: files.scene.replace('arithmetic = "f64"', 'digits = 25') });
  assert.equal(answer.arithmetic, 'certified');
  close(+(await data(page)).a, +answer.equilibria[0].equilibria[0].contact_radius, 1e-14);
  await page.close();
});
