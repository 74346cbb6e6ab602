// The page: frames, and all together.

const PARTS = ['balance', 'energy', 'body', 'force'];

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
    'medium',
    [
      ['half', 'half-space'],
      ['graded', 'graded'],
      ['springs', 'springs'],
      ['wave', 'wave'],
    ],
    () => P.medium,
    (key) => {
      turnPage();
      change({ medium: key });
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
    ownAddress = location.hash;
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
      receded,
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
