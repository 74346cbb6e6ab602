// The controls: buttons, sliders, numbers that are typed, and the lecture.

/** A row of buttons of which one is chosen, with the keys of a radio group. */
function segment(id, options, get, pick) {
  const root = $(id);
  const steps = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 };
  options.forEach(([key, label], i) => {
    const button = document.createElement('button');
    Object.assign(button, { type: 'button', textContent: label });
    set(button, { role: 'radio', 'data-key': key });
    button.onclick = () => {
      pick(key);
      sync();
    };
    button.onkeydown = (e) => {
      if (!steps[e.key]) return;
      e.preventDefault();
      const next = root.children[(i + steps[e.key] + options.length) % options.length];
      next.focus();
      next.click();
    };
    root.appendChild(button);
  });
  root.sync = () => {
    for (const button of root.children) {
      const on = button.dataset.key === get();
      set(button, { 'aria-checked': on, tabindex: on ? 0 : -1 });
    }
  };
}
const toSlider = (s, x) => (s[4] ? Math.log(x / s[2]) / Math.log(s[3] / s[2]) : (x - s[2]) / (s[3] - s[2]));
const fromSlider = (s, t) => (s[4] ? s[2] * (s[3] / s[2]) ** t : s[2] + t * (s[3] - s[2]));
function tickMark(s, [at, text]) {
  const end = text.length > 4 && [0, 1].includes(toSlider(s, at));
  const shift = end ? `;transform:translateX(${at === s[2] ? '-11px' : 'calc(11px - 100%)'})` : '';
  return `<span style="left:${100 * toSlider(s, at)}%${shift}">${text}</span>`;
}
function sliders() {
  for (const [key, s] of Object.entries(SLIDERS)) {
    const row = document.createElement('div');
    row.className = 'slider';
    row.id = `row-${key}`;
    row.innerHTML = `<label for="s-${key}"><span><i>${s[1]}</i> ${s[0]}</span><output for="s-${key}" id="o-${key}"></output></label>
      <input type="range" id="s-${key}" min="0" max="1" step="0.002"><div class="ticks" aria-hidden="true">${s[5].map((tick) => tickMark(s, tick)).join('')}</div>`;
    $('sliders').appendChild(row);
    // Marks hold a pointer that comes near, and keys where they would pass one; they hold none of both for good.
    let keyed = false;
    $(`s-${key}`).onpointerdown = () => (keyed = false);
    $(`s-${key}`).onkeydown = () => (keyed = true);
    $(`s-${key}`).oninput = (e) => {
      const [now, before] = [+e.target.value, toSlider(s, P[key])];
      const held = (at) => (keyed ? (at - before) * (at - now) < -1e-9 : Math.abs(at - now) < 0.006);
      const mark = s[5].find(([at]) => held(toSlider(s, at)));
      change({ [key]: mark ? mark[0] : fromSlider(s, now) });
    };
  }
}
/** Where the regimes meet, on the slider of the exponent. */
function trackOfExponent() {
  const half = 100 * within(toSlider(SLIDERS.n, Math.max(meeting(), 1e-3)), [-0.1, 1]);
  const [soft, firm] = ['--ela) 60%', '--adh) 55%'].map((colour) => `color-mix(in srgb, var(${colour}, var(--panel))`);
  $('s-n').style.setProperty(
    '--track',
    `linear-gradient(90deg, ${soft} calc(${half}% - 2px), var(--ink) 0 calc(${half}% + 2px), ${firm} 0)`,
  );
}
/** The controls show the parameters. */
function sync() {
  for (const [key, s] of Object.entries(SLIDERS)) {
    $(`row-${key}`).style.display = s[6]() ? '' : 'none';
    $(`s-${key}`).value = toSlider(s, P[key]);
    const plain = key === 'n' && P.n === 0.5 ? '½' : minus(P[key].toFixed(P[key] < 10 ? 3 : 1));
    const text = SHOWN_AS[key] && P.unit !== 'none' ? show(P[key], SHOWN_AS[key]) : plain;
    const over = P.n - meeting();
    const regime = Math.abs(over) < 1e-12 ? ' · no length' : over > 0 ? ' · pull-off' : ' · complete contact';
    $(`o-${key}`).textContent = text + (key === 'n' ? regime : '');
    set($(`s-${key}`), { 'aria-valuetext': $(`o-${key}`).textContent });
  }
  trackOfExponent();
  ['control', 'shape', 'medium', 'view', 'graph'].forEach((id) => $(id).sync());
  set($('ghost'), { 'aria-pressed': P.ghost === 'on' });
  $('axis').value = P.axis;
  $('unit').value = P.unit;
  $('own-units').hidden = P.unit !== 'own';
  for (const key in OWN) if (document.activeElement !== $(key)) $(key).value = P[key];
  $('table-editor').hidden = P.shape !== 'table' || onWave();
  if (P.shape === 'table') pad.show();
  $('value-label').textContent = controlWords()[1];
  $('shape').parentElement.hidden = onWave();
  redraw.curve = true;
  request();
}
/** Shows a graph from its own range, without gliding. */
function turn(graph) {
  P.graph = graph;
  force.now = null;
}

/** A number with or without its unit, and what is wrong with it, in words. */
function readQuantity(key, text) {
  const [symbol, unit, units] = OWN_UNITS[key];
  const [, number, given] = text.trim().match(/^([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*)$/) || [];
  const example = `${symbol} is a number in ${unit}, or one with a unit: ${Object.keys(units).join(', ')}`;
  if (!number) return [NaN, `“${text.trim()}” is no number. ${example}.`];
  const power = given ? units[given.replace(/\s*\/\s*/, '/')] : 0;
  if (power === undefined) return [NaN, `“${given}” is no unit of ${symbol}. ${example}.`];
  const [low, high] = OWN[key];
  const x = power < 0 ? number / 10 ** -power : number * 10 ** power;
  return [x, x >= low && x <= high ? '' : `${symbol} is between ${low} and ${high} ${unit} here, got ${x}.`];
}

/** Three pictures and one slider, larger, for a room; and back. */
function lecture(on = document.body.dataset.mode !== 'lecture') {
  if (on) document.body.dataset.mode = 'lecture';
  else delete document.body.dataset.mode;
  set($('lecture'), { 'aria-pressed': on });
  for (const plot of [balance, energy, body, force]) plot.resize();
  redraw.curve = true;
  saveSoon();
  request();
}
