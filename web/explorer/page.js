// The page: words, frames, and all together.

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
