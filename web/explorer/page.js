// The page: words, controls, the pointer and the keys.

const PARTS = ['balance', 'energy', 'body', 'force'];

function tell() {
  const broken = degenerate
    ? 'At n = ½ and ρ at its threshold the two curves are one: at d = 0 every radius is an equilibrium (1.19). '
    : '';
  let [text, tone] = [note, jumps ? 'jump' : 'stable'];
  if (trouble) [text, tone] = [`This profile is refused: ${trouble}`, 'over'];
  else if (probe) [text, tone] = tellProbe();
  else if (!text) [text, tone] = tellState(tone);
  const story = $('story');
  if (story.textContent === broken + text) return;
  story.textContent = broken + text;
  story.dataset.tone = tone;
}
function tellProbe() {
  const here = engine.at(value, probe);
  const grows = here && here[2] > here[1];
  const words = grows
    ? 'Δl exceeds g − d: let go, and the contact grows (1.9).'
    : 'g − d exceeds Δl: let go, and it shrinks (1.8).';
  return [`You hold the edge at a = ${len(probe)}. ${words}`, grows ? 'stable' : 'over'];
}
function tellState(tone) {
  if (S.kind === 2)
    return [
      'Complete contact: the surfaces touch everywhere, and no pulling within this theory parts them. Start again.',
      'over',
    ];
  if (S.kind === 0) return ['The surfaces are apart.' + (value < 0 ? ' Press to bring them together.' : ''), 'over'];
  if (S.poised)
    return [
      'Poised on an unstable equilibrium. Drag the edge ▲ a little, or the depth: it shrinks to nothing, or spreads over the whole surface.',
      tone,
    ];
  // Without numbers: a screen reader reads it out whenever it changes.
  const stable = restingStates().length;
  return [
    stable > 1
      ? `Stable contact, one of ${stable} that are stable here: which one it is depends on the past.`
      : 'Stable contact.',
    tone,
  ];
}

function readout() {
  const known = S.kind !== 2;
  const table = [
    ['contact radius a', S.kind === 1 ? len(S.a) : known ? '0' : '∞'],
    ['depth d', known ? show(S.d, 'd') : '—'],
    ['force F', known ? show(S.F, 'F') : '—'],
    ...(folds.length === 1 && folds[0].F ? [['force over that at P', known ? minus((S.F / folds[0].F).toFixed(3)) : '—']] : []),
    ['energy lost', unbounded ? '∞' : show(lostTotal, 'E', 4)],
    ['folds', String(folds.length)],
  ];
  if (P.control === 'D') table.splice(2, 0, ['stiffness k', show(P.k, 'k')]);
  $('readout').innerHTML = table.map(([k, v]) => `<tr><th scope="row">${k}</th><td>${v}</td></tr>`).join('');
  const text = show(value, heldKind());
  $('value-out').textContent = text;
  const state = S.kind === 1 ? 'contact radius ' + len(S.a) : S.kind ? 'complete contact' : 'apart';
  set($('value'), { min: range[0], max: range[1], 'aria-valuetext': `${CONTROLS[P.control][1]} ${text}; ${state}` });
  $('value').value = value;
  checkSoon();
  Object.assign($('explorer').dataset, {
    control: P.control,
    shape: P.shape,
    value: String(value),
    state: ['detached', 'contact', 'complete'][S.kind],
    ended,
    a: String(S.a),
    d: String(S.d),
    force: String(S.F),
    lost: String(lostTotal),
    unbounded,
    jumps,
    folds: folds.length,
    degenerate,
    failures,
  });
  const scene = $('scene');
  if (scene.closest('details').open) scene.textContent = sceneFile();
}

let checking = 0;
/** The second route takes longer than a frame may: it is asked when the contact has come to rest. */
function checkSoon() {
  clearTimeout(checking);
  checking = setTimeout(check, 80);
}
function check() {
  const checked = S.kind === 1 && S.a > 1e-9 && S.a < 0.999 * engine.outer() ? engine.verify(S.a) : null;
  const differ = checked && (checked[2] < 1e-16 ? 'nothing' : checked[2].toExponential(0));
  $('check').textContent = checked ? `Checked live: g(a) by its closed form and by quadrature of (1.1) differ by ${differ}.` : '';
  $('explorer').dataset.check = checked ? checked[2] : '';
}

// ---------------------------------------------------------------- frames
let pending = false;
let frames = [];
let lastSlow = 0;
let slowInARow = 0;
/** Half the samples on a processor that needs more than 24 ms for a frame, three times in a row. */
let detail = 1;
function request() {
  if (pending || !wasm) return;
  pending = true;
  requestAnimationFrame(frame);
}
function frame(now) {
  pending = false;
  const start = performance.now();
  const before = spent;
  if (playing) play(now);
  spent = 0;
  if (!wasm) return; // a new instance of the engine asks for a frame
  if (failures > mended && !fallBack()) return;
  const moving = draw();
  if (failures > mended) return request();
  keepGood();
  if (start - lastSlow > 60 || (!moving && !playing)) {
    readout();
    tell();
    saveSoon();
    lastSlow = start;
  }
  const took = performance.now() - start + before;
  slowInARow = took > 24 ? slowInARow + 1 : 0;
  if (slowInARow === 3) detail = 0.5;
  frames.push(took);
  if (frames.length > 240) frames.shift();
  $('explorer').dataset.frameMs = Math.max(...frames.slice(-120)).toFixed(2);
  if (moving || playing) request();
}
/** A slow cycle, to and fro. */
function play(now) {
  if (playing === 1) return void (playing = now);
  const seconds = Math.min(40, now - playing) / 1000;
  playing = now;
  const to = value + (play.way * (range[1] - range[0]) * seconds) / 4.5;
  if (to < range[0]) play.way = 1;
  else if (to > range[1]) play.way = -1;
  if (anim) return;
  note = '';
  move(to);
  if (ended) play.way = -play.way;
  if (S.kind === 2) stop();
}
play.way = -1;
function stop() {
  playing = 0;
  $('play').textContent = '▶ Press and pull';
  set($('play'), { 'aria-pressed': 'false' });
}
let saving = 0;
let ownAddress = '';
let step = false; // whether the next address is a step of its own for the button Back of the browser
function saveSoon() {
  if (!saving) saving = setTimeout(save, 300);
}
/** What follows can be taken back by the button Back of the browser; a frame leaves that of its page alone. */
function turnPage() {
  if (!$('explorer').dataset.ready.startsWith('t') || document.body.dataset.only) return;
  clearTimeout(saving);
  save();
  step = true;
}
function save() {
  saving = 0;
  const hash = address();
  if (hash === location.hash) return;
  ownAddress = hash;
  try {
    history[step ? 'pushState' : 'replaceState'](null, '', hash);
    step = false;
  } catch {
    location.replace(hash);
  }
}

// ---------------------------------------------------------------- controls
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
  const half = 100 * toSlider(SLIDERS.n, 0.5);
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
    const plain = key === 'n' && P.n === 0.5 ? '½' : P[key].toFixed(P[key] < 10 ? 3 : 1);
    const text = SHOWN_AS[key] && P.unit !== 'none' ? show(P[key], SHOWN_AS[key]) : plain;
    const regime = P.n > 0.5 ? ' · pull-off' : P.n < 0.5 ? ' · complete contact' : ' · no length';
    $(`o-${key}`).textContent = text + (key === 'n' ? regime : '');
    set($(`s-${key}`), { 'aria-valuetext': $(`o-${key}`).textContent });
  }
  ['control', 'shape', 'view', 'graph'].forEach((id) => $(id).sync());
  set($('ghost'), { 'aria-pressed': P.ghost === 'on' });
  $('axis').value = P.axis;
  $('unit').value = P.unit;
  $('own-units').hidden = P.unit !== 'own';
  for (const key in OWN) if (document.activeElement !== $(key)) $(key).value = P[key];
  $('table-editor').hidden = P.shape !== 'table';
  if (P.shape === 'table') pad.show();
  $('value-label').textContent = CONTROLS[P.control][1];
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

// ---------------------------------------------------------------- by hand
function drag(node, begin, step, end) {
  node.addEventListener('pointerdown', (e) => {
    e.preventDefault();
    node.setPointerCapture(e.pointerId);
    stop();
    remember.what = '';
    note = '';
    const memory = begin(e);
    const go = (m) => {
      note = '';
      step(m, memory);
    };
    node.addEventListener('pointermove', go);
    const done = (m) => {
      node.removeEventListener('pointermove', go);
      node.removeEventListener('pointerup', done);
      node.removeEventListener('pointercancel', done);
      if (end) end(m, memory);
    };
    node.addEventListener('pointerup', done);
    node.addEventListener('pointercancel', done);
  });
}
function pointers() {
  const share = () => (range[1] - range[0]) / 260; // of the control for a pixel, where it is no length
  const pull = (to) => {
    remember('drag');
    move(to);
  };
  const vertical = (plot) => (e, m) => pull(m.value + (at(e).y - m.y) * (P.control === 'd' ? plot.perY() : share()));
  const at = (e) => ({ x: e.clientX / magnification(), y: e.clientY / magnification() });
  const grip = (e) => ({ ...at(e), value });
  drag(balance.hit, grip, vertical(balance));
  drag(body.solid, grip, vertical(body));
  drag(force.hit, grip, (e, m) => {
    const up = -(at(e).y - m.y) * force.perY();
    if (P.graph === 'fold') return pull(m.value + up);
    const across = ((at(e).x - m.x) * (force.now[1] - force.now[0])) / (force.box[2] - force.box[0]);
    pull(m.value + controlled(across, up));
  });
  const hold = (e) => {
    if (S.kind !== 1) return;
    probe = Math.min(reach, balance.radius((e.clientX - balance.svg.getBoundingClientRect().left) / magnification()));
    request();
  };
  drag(balance.handle, () => ({}), hold, release);
  balance.handle.onkeydown = (e) => {
    const step = { ArrowLeft: -1, ArrowRight: 1, ArrowDown: -1, ArrowUp: 1 }[e.key];
    if (step) stop();
    if (step && S.kind === 1) probe = within((probe || S.a) + step * reach * 0.02, [1e-5, reach]);
    else if (e.key === 'Enter' || e.key === ' ') release();
    else if (e.key === 'Escape') probe = null;
    else return;
    e.preventDefault();
    request();
  };
  balance.handle.onblur = release;
}

// ---------------------------------------------------------------- what the pages of the book keep
const keep = (name, what) => {
  try {
    localStorage.setItem(name, what);
  } catch {
    // no storage for this page
  }
};
const kept = (name) => {
  try {
    return localStorage.getItem(name);
  } catch {
    return null;
  }
};
/** The fonts of the book, where its pages have said that they lie beside this one: alone, the page asks nobody for anything. */
function bookFonts() {
  if (kept('mdr-fonts') !== new URL('.', location.href).href) return;
  for (const [family, file, style] of [
    ['Pagella', 'pagella-regular', {}],
    ['Pagella', 'pagella-italic', { style: 'italic' }],
    ['Pagella', 'pagella-bold', { weight: '700' }],
    ['Inter', 'inter-regular', {}],
    ['Inter', 'inter-semibold', { weight: '600' }],
  ]) {
    const face = new FontFace(family, `url(fonts/${file}.woff2)`, style);
    face.load().then(
      (loaded) => document.fonts.add(loaded),
      () => {},
    );
  }
}

// ---------------------------------------------------------------- all together
function page() {
  PRESETS.forEach(([name], i) => {
    const button = document.createElement('button');
    const open = () => {
      turnPage();
      closeTasks();
      preset(i);
    };
    Object.assign(button, { type: 'button', textContent: name, onclick: open });
    button.dataset.preset = i;
    $('presets').appendChild(button);
  });
  tasks();
  segment(
    'control',
    Object.entries(CONTROLS).map(([k, [t]]) => [k, t]),
    () => P.control,
    (key) => {
      turnPage();
      change({ control: key });
    },
  );
  const shapes = [
    ['power', 'power law'],
    ['sphere', 'sphere'],
    ['wavy', 'wavy'],
    ['table', 'drawn'],
  ];
  segment(
    'shape',
    shapes,
    () => P.shape,
    (key) => {
      turnPage();
      change({ shape: key, ...(key === 'power' ? {} : { rho: 1 }) });
    },
  );
  segment(
    'view',
    [
      ['body', 'stretched'],
      ['scale', '1 : 1'],
      ['springs', 'springs'],
    ],
    () => P.view,
    (key) => {
      const reduced = key === 'scale' && P.unit === 'none';
      note = reduced ? 'In reduced units heights and radii have no scale in common: choose units to see it true to scale.' : '';
      if (!reduced) P.view = key;
    },
  );
  segment(
    'graph',
    [
      ['force', 'F over d'],
      ['fold', 'folds over a'],
    ],
    () => P.graph,
    turn,
  );
  sliders();
  $('axis').onchange = (e) => {
    P.axis = e.target.value;
    sync();
  };
  $('unit').innerHTML = Object.entries(UNITS)
    .map(([k, [t]]) => `<option value="${k}">${t}</option>`)
    .join('');
  $('unit').onchange = (e) => {
    remember('unit');
    P.unit = e.target.value;
    if (P.unit === 'none' && P.view === 'scale') P.view = 'body';
    sync();
  };
  for (const key in OWN) {
    $(key).onchange = (e) => {
      const [x, words] = readQuantity(key, e.target.value);
      set(e.target, { 'aria-invalid': Boolean(words) });
      $('unit-note').textContent = words;
      if (!words) {
        remember(key);
        P[key] = x;
      }
      sync();
    };
  }
  $('value').oninput = (e) => {
    remember('value');
    stop();
    note = '';
    move(+e.target.value);
  };
  $('value').onkeydown = (e) => {
    // steps of 1 %, as step="any" gives none
    const step = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -10, PageUp: 10, Home: -1e6, End: 1e6 }[
      e.key
    ];
    if (!step) return;
    e.preventDefault();
    remember('value');
    stop();
    note = '';
    move(value + (step * (range[1] - range[0])) / (e.shiftKey ? 1000 : 100));
  };
  $('play').onclick = () => {
    if (playing) return stop();
    if (S.kind === 2) startAgain();
    remember('play');
    playing = 1;
    $('play').textContent = '❚❚ Pause';
    set($('play'), { 'aria-pressed': 'true' });
    request();
  };
  $('reset').onclick = startAgain;
  $('undo').onclick = undo;
  $('pin').onclick = pin;
  $('ghost').onclick = () => {
    P.ghost = P.ghost === 'on' ? 'off' : 'on';
    sync();
  };
  addEventListener('keydown', (e) => {
    const writes = /^(textarea|select)$/i.test(e.target.tagName) || e.target.inputMode === 'decimal';
    if (writes || e.key !== 'z' || !(e.ctrlKey || e.metaKey) || e.shiftKey) return;
    e.preventDefault();
    undo();
  });
  addEventListener('keydown', (e) => {
    const plain = !e.ctrlKey && !e.metaKey && !e.altKey && !/^(textarea|select)$/i.test(e.target.tagName);
    if (plain && e.target.inputMode !== 'decimal' && (e.key === 'l' || e.key === 'L')) lecture();
  });
  $('lecture').onclick = () => lecture();
  document.addEventListener('visibilitychange', () => document.hidden && stop());
  $('theme').onclick = () => {
    const root = document.documentElement;
    const dark = root.dataset.theme ? root.dataset.theme === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
    root.dataset.theme = dark ? 'light' : 'dark';
    keep('mdr-theme', root.dataset.theme);
  };
  pointers();
  drag(
    $('pad'),
    (e) => (pad.begin(), pad.draw(e)),
    (e) => pad.draw(e),
    () => {
      pad.dragging = false;
      pad.show();
    },
  );
  $('table-use').onclick = () => pad.paste($('table-text').value);
  $('save-svg').onclick = () => download('contact.svg', 'image/svg+xml', picture());
  $('scene').closest('details').ontoggle = request;
  $('copy-scene').onclick = () => navigator.clipboard?.writeText(sceneFile());
  $('save-scene').onclick = () => {
    download('scene.toml', 'text/plain', sceneFile());
    if (P.shape === 'table') download('profile.csv', 'text/csv', tableFile(system()));
  };
  addEventListener('hashchange', () => {
    if (location.hash === ownAddress) return;
    remember('address');
    ownAddress = location.hash;
    restore(location.hash);
  });
  bookFonts();
}

load()
  .then(() => {
    pictures();
    page();
    restore(location.hash);
    // For tests: what a reader can do, without a pointer.
    const state = () => ({
      P: { ...P },
      value,
      S: { ...S },
      folds,
      range,
      reach,
      lostTotal,
      jumps,
      unbounded,
      trouble,
      way,
      ended,
      rest: engine.equilibria(value),
      frames: [...frames],
    });
    const hold = (a) => {
      probe = a;
      request();
    };
    const files = () => ({ scene: sceneFile(), table: P.shape === 'table' ? tableFile(system()) : '' });
    window.explorer = {
      move,
      change,
      preset,
      probe: hold,
      release,
      undo,
      state,
      files,
      picture,
      paste: (text) => pad.paste(text),
      units: system,
    };
    Object.assign($('explorer').dataset, { ready: 'true', readyMs: performance.now().toFixed(0) });
  })
  .catch((error) => {
    $('note').textContent = `The engine did not start: ${error.message}`;
    $('explorer').dataset.ready = 'failed';
  });
