// A profile of one's own, drawn or pasted; and the pictures to take away.

/** So many rows are opened at once; longer tables are weighed first, away from the page. */
const FEW_ROWS = 40;
const [FEW_FOLDS, MANY_FOLDS] = [8, 40];
/** The time of a move, and of the weighing of a table, in ms. */
const BUDGET = 50;
const WAIT = 4000;
/** In a worker: opens a scene with its table; the number of folds, and the time of a move. It shares nothing with the page. */
function weighing() {
  onmessage = async ({ data: { module, scenes, table } }) => {
    const { exports: e } = await WebAssembly.instantiate(module, {});
    for (const [smooth, scene, values] of scenes) {
      const [head, tail] = [scene, table].map((text) => new TextEncoder().encode(text));
      const at = e.input(head.length + tail.length);
      const room = new Uint8Array(e.memory.buffer, at, head.length + tail.length);
      room.set(head);
      room.set(tail, head.length);
      const folds = e.contact(head.length);
      // The first moves are those of code that has not been compiled yet.
      let time = 0;
      for (let i = 0; i < 3 && folds >= 0; i++) {
        const start = performance.now();
        e.advance(-1, ...values);
        time = performance.now() - start;
      }
      postMessage({ smooth, folds, time });
    }
    postMessage(null);
  };
}
/** The folds of a table and the time of a move; if they are many, a length that leaves few. `folds` and `time` are infinite where
 * they take longer than the page waits. */
function weigh(table) {
  const before = { ...P };
  Object.assign(P, { shape: 'table', medium: 'half', table, smooth: 0 });
  const rows = unpackTable(table);
  const wide = Math.max(...rows.map(([r]) => r));
  const lengths = [0, wide / 40, wide / 20, wide / 10, wide / 5];
  const high = Math.max(...rows.map(([, f]) => f), Math.sqrt(wide));
  const scenes = lengths.map((smooth) => {
    P.smooth = smooth;
    return [smooth, sceneForEngine(), [-high, high]];
  });
  const file = tableFile(system('none'));
  P = before;
  return new Promise((done) => {
    const worker = new Worker(URL.createObjectURL(new Blob([`(${weighing})()`], { type: 'text/javascript' })));
    const found = { folds: Infinity, time: Infinity, smooth: wide / 20 };
    let timer = 0;
    const end = () => {
      clearTimeout(timer);
      worker.terminate();
      done(found);
    };
    timer = setTimeout(end, WAIT);
    worker.onerror = end;
    worker.onmessage = ({ data }) => {
      if (!data) return end();
      if (!data.smooth) Object.assign(found, { folds: Math.max(0, data.folds), time: data.time });
      else found.smooth = data.smooth;
      // A few folds are those of the profile; a table that is refused is told so by the page.
      if (!data.smooth) return data.folds <= FEW_FOLDS || (data.folds <= MANY_FOLDS && data.time <= BUDGET) ? end() : undefined;
      return data.folds >= 0 && data.folds <= FEW_FOLDS ? end() : undefined;
    };
    worker.postMessage({ module: compiled, scenes, table: file });
  });
}

const pad = {
  /** The profile that is open, and its text where that is not being typed. */
  show() {
    const units = system();
    const points = unpackTable(P.table);
    if (document.activeElement !== $('table-text')) $('table-text').value = tableFile(units);
    const [width, height] = [300, 150];
    this.right = this.dragging ? this.right : Math.max(...points.map(([r]) => r));
    this.top = this.dragging ? this.top : 1.15 * Math.max(...points.map(([, f]) => f));
    const line = points.map(
      ([r, f]) => `${((r / this.right) * width).toFixed(1)} ${(height - 8 - (f / this.top) * (height - 16)).toFixed(1)}`,
    );
    set($('pad').querySelector('path'), { d: `M${line.join('L')}` });
  },
  /** The row next to the pointer takes its height; between two events, all that were passed. */
  draw(e) {
    const box = $('pad').getBoundingClientRect();
    const r = within(((e.clientX - box.left) / box.width) * this.right, [0, this.right]);
    const f = ((box.bottom - e.clientY) / box.height) * 150;
    const to = [r, Math.max(0, ((f - 8) / 134) * this.top)];
    const from = this.last || to;
    this.last = to;
    const [low, high] = [Math.min(from[0], r), Math.max(from[0], r)];
    const step = this.right / (this.points.length - 1) / 2;
    this.points.forEach((point, i) => {
      if (i === 0 || point[0] < low - step || point[0] > high + step) return;
      const t = high > low ? within((point[0] - from[0]) / (to[0] - from[0]), [0, 1]) : 1;
      point[1] = from[1] + t * (to[1] - from[1]);
    });
    change({ table: packTable(this.points, 6) });
  },
  begin() {
    this.dragging = true;
    this.last = null;
    const known = unpackTable(P.table);
    const at = (r) => {
      const i = Math.max(
        1,
        known.findIndex((row) => row[0] >= r),
      );
      const [[r0, f0], [r1, f1]] = [known[i - 1], known[i]];
      return r <= known[0][0] ? known[0][1] : f0 + ((f1 - f0) * (r - r0)) / (r1 - r0);
    };
    this.points = Array.from({ length: 33 }, (_, i) => (i / 32) * this.right).map((r) => [r, r ? at(r) : 0]);
  },
  paste(text) {
    let table;
    try {
      table = readTable(text);
    } catch (error) {
      return this.refuse(error.message);
    }
    turnPage();
    // A table in metres needs units to be shown in, and so small radii are metres without saying so.
    const widest = Math.max(...table.points.map(([r]) => r));
    if (P.unit === 'none' && (table.metric || widest < 1e-3)) {
      remember('units');
      Object.assign(P, { unit: 'own', uR: 2 * widest, uE: widest < 1e-6 ? 1e9 : P.uE });
      sync();
    }
    const { radius, height } = system();
    const points = table.points.map(([r, f]) => [r / radius, f / height]);
    const use = (smooth) => {
      change({ shape: 'table', table: packTable(points), smooth });
      return this.refuse(trouble);
    };
    if (points.length <= FEW_ROWS) return use(0);
    return weigh(packTable(points)).then((found) => this.offer(found, use));
  },
  /** Takes a table that is quick to follow; for another one, offers its rows smoothed. */
  offer({ folds, time, smooth }, use) {
    if (folds <= FEW_FOLDS || (folds <= MANY_FOLDS && time <= BUDGET)) return use(0);
    const long = Number.isFinite(time) ? `a move takes about ${time.toFixed(0)} ms` : 'a move takes seconds';
    const many = Number.isFinite(folds) ? `${folds} folds, and ${long}` : `its folds are not found within ${WAIT / 1000} s`;
    this.refuse('');
    const note = $('table-note');
    note.textContent = `These rows make ${many}: noise of a measurement does that. `;
    const button = (text, length) => {
      const node = document.createElement('button');
      Object.assign(node, { type: 'button', textContent: text, onclick: () => (note.replaceChildren(), use(length)) });
      note.append(node, ' ');
    };
    if (smooth) button(`Smooth over ${show(smooth, 'a')}`, smooth);
    if (Number.isFinite(time)) button('Use as it is', 0);
    return undefined;
  },
  refuse(words) {
    $('table-note').textContent = words ? `Refused: ${words}` : '';
  },
};

// ---------------------------------------------------------------- to take away
function download(name, type, text) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
const escaped = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;');
/** The contact and its control, as a line below the pictures. */
function parametersInWords() {
  const keys = Object.keys(SLIDERS).filter((key) => SLIDERS[key][6]() && (key !== 'w1' || twoWorks()));
  const shown = keys.map((key) => `${SLIDERS[key][1]} = ${SHOWN_AS[key] ? show(P[key], SHOWN_AS[key]) : +P[key].toPrecision(5)}`);
  const kind = onWave() ? 'wave' : { power: 'power law', sphere: 'sphere', wavy: 'wavy sphere', table: 'table' }[P.shape];
  const medium = onWave() ? [] : [mediumInWords()].filter(Boolean);
  const units = P.unit === 'none' ? 'reduced units, E* = 1, w = 1/2π' : `E* = ${system().modulus} Pa, w = ${system().work} J/m²`;
  return [kind, ...medium, ...shown, `${controlWords()[2]} = ${show(value, heldKind())}`, units].join(', ');
}
/** Pictures as one SVG with the colours that are shown; all four in two columns. */
function picture(parts = PARTS) {
  const style = getComputedStyle(document.documentElement);
  const colours = ['bg', 'panel', 'ink', 'muted', 'line', 'grid', 'adh', 'ela', 'loss', 'body', 'body-edge', 'half', 'half-edge'];
  const variables = colours.map((name) => `--${name}:${style.getPropertyValue('--' + name).trim()}`).join(';');
  const rules = [...$('figures').sheet.cssRules].map((rule) => rule.cssText);
  const shapes = parts.map((id) => $(id)).map((svg) => [svg, svg.getBoundingClientRect()]);
  const column = ([one, two]) => Math.max(...[one, two].map((shape) => (shape ? shape[1].width : 0)));
  const [left, right] = [column(shapes), column(shapes.slice(2))];
  const heights = [0, 1, 2, 3].map((i) => (shapes[i] ? shapes[i][1].height : -16));
  const at = [
    [0, 0],
    [0, heights[0] + 16],
    [left + 16, 0],
    [left + 16, heights[2] + 16],
  ];
  const size = [left + (right && right + 16), Math.max(heights[0] + heights[1], heights[2] + heights[3]) + 16];
  const drawn = shapes.map(([svg, box], i) => {
    const copy = svg.cloneNode(true);
    for (const name of ['role', 'aria-labelledby', 'id']) copy.removeAttribute(name);
    copy.querySelectorAll('.hit, .probe, [display="none"]').forEach((node) => node.remove());
    Object.entries({ x: at[i][0], y: at[i][1], width: box.width, height: box.height }).forEach(([k, v]) =>
      copy.setAttribute(k, v),
    );
    return new XMLSerializer().serializeToString(copy).replaceAll('xmlns="http://www.w3.org/2000/svg" ', '');
  });
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="-16 -16 ${size[0] + 32} ${size[1] + 52}" width="${size[0] + 32}" height="${size[1] + 52}">
<title>An adhesive contact: ${$('value-label').textContent} ${$('value-out').textContent}</title><desc>${escaped(`${$('story').textContent} ${parametersInWords()}`)}</desc>
<metadata>${escaped(JSON.stringify({ address: address(), scene: sceneFile(), ...(P.shape === 'table' ? { table: tableFile(system()) } : {}) }))}</metadata>
<style>svg{${variables}} ${rules.join(' ').replaceAll('<', '&lt;')}</style>
<rect x="-16" y="-16" width="100%" height="100%" style="fill:var(--panel)"/>
${drawn.join('\n')}
<text x="0" y="${size[1] + 22}">${escaped(parametersInWords())}</text>
</svg>
`;
}
