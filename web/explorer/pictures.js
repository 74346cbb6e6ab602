// The pictures: the balance at the edge, the energy, the body or its springs, force over depth. They draw and ask nothing of the reader.

const NS = 'http://www.w3.org/2000/svg';
const make = (tag, attributes, parent) => {
  const node = document.createElementNS(NS, tag);
  for (const key in attributes) node.setAttribute(key, attributes[key]);
  if (parent) parent.appendChild(node);
  return node;
};
const set = (node, attributes) => {
  // touches the document only where something changes
  const had = node.had || (node.had = {});
  for (const key in attributes) if (had[key] !== attributes[key]) node.setAttribute(key, (had[key] = attributes[key]));
  return node;
};
const $ = (id) => document.getElementById(id);

/** One picture: pixels, a world window that glides to where it should be, layers made once. */
class Plot {
  constructor(id, margin, layers) {
    this.svg = $(id);
    this.margin = margin;
    this.now = null;
    this.goal = null;
    this.pools = {};
    this.frame = make('g', {}, this.svg);
    const clip = make('clipPath', { id: `${id}-clip` }, make('defs', {}, this.svg));
    this.clip = make('rect', {}, clip);
    this.inside = make('g', { 'clip-path': `url(#${id}-clip)` }, this.svg);
    this.over = make('g', {}, this.svg);
    for (const [name, tag, cls, top] of layers) this[name] = make(tag, { class: cls }, top ? this.over : this.inside);
    new ResizeObserver(() => {
      this.resize();
      redraw.curve = true;
      request();
    }).observe(this.svg);
    this.resize();
  }
  resize() {
    const { width, height } = this.svg.getBoundingClientRect();
    this.w = width;
    this.h = height;
    this.svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
    const [t, r, b, l] = this.margin;
    this.box = [l, t, width - r, height - b];
    set(this.clip, { x: l, y: t, width: Math.max(1, width - l - r), height: Math.max(1, height - t - b) });
  }
  aim(goal) {
    this.goal = goal;
    if (!this.now || reduced.matches) this.now = [...goal];
  }
  glide() {
    // towards the goal; true while on the way
    let moving = false;
    this.goal.forEach((g, i) => {
      const gap = g - this.now[i],
        size = Math.abs(this.goal[i | 1] - this.goal[i & ~1]) || 1;
      if (Math.abs(gap) < 1e-3 * size) this.now[i] = g;
      else {
        this.now[i] += 0.28 * gap;
        moving = true;
      }
    });
    return moving;
  }
  shareX(v) {
    const [lo, hi] = this.now;
    return (v - lo) / (hi - lo);
  }
  x(v) {
    return this.box[0] + Math.max(-9, Math.min(10, this.shareX(v))) * (this.box[2] - this.box[0]);
  }
  y(v) {
    const s = (v - this.now[2]) / (this.now[3] - this.now[2]);
    return this.box[3] - Math.max(-9, Math.min(10, s)) * (this.box[3] - this.box[1]);
  }
  perY() {
    return (this.now[3] - this.now[2]) / (this.box[3] - this.box[1]);
  }
  path(points) {
    let s = '',
      pen = 'M';
    for (const [px, py] of points) {
      if (Number.isNaN(px + py)) {
        pen = 'M';
        continue;
      }
      s += pen + this.x(px).toFixed(1) + ' ' + this.y(py).toFixed(1);
      pen = 'L';
    }
    return s;
  }
  pool(name, tag, parent, count, draw) {
    const nodes = (this.pools[name] = this.pools[name] || []);
    while (nodes.length < count) nodes.push(make(tag, {}, parent));
    nodes.forEach((node, i) => {
      set(node, { display: i < count ? 'inline' : 'none' });
      if (i < count) draw(node, i);
    });
  }
  axes(xs, ys, xName, yName) {
    // light grid, numbers outside, names at the ends
    const [l, t, r, b] = this.box,
      key = [this.w, this.h, ...this.now, P.axis, P.unit, xName, yName, xs.length].join();
    if (key === this.axesKey) return;
    this.axesKey = key;
    this.pool('gx', 'path', this.frame, xs.length, (n, i) => set(n, { class: 'grid', d: `M${this.x(xs[i][0])} ${t}V${b}` }));
    this.pool('gy', 'path', this.frame, ys.length, (n, i) =>
      set(n, { class: ys[i][0] === 0 ? 'zero' : 'grid', d: `M${l} ${this.y(ys[i][0])}H${r}` }),
    );
    this.pool('tx', 'text', this.frame, xs.length, (n, i) => {
      set(n, { x: this.x(xs[i][0]), y: b + 17, 'text-anchor': 'middle' });
      n.textContent = xs[i][1];
    });
    this.pool('ty', 'text', this.frame, ys.length, (n, i) => {
      set(n, { x: l - 8, y: this.y(ys[i][0]) + 4, 'text-anchor': 'end' });
      n.textContent = ys[i][1];
    });
    this.pool('names', 'text', this.frame, 2, (n, i) => {
      set(
        n,
        i
          ? { class: 'math', x: l - 8, y: t - 8, 'text-anchor': 'start' }
          : { class: 'math', x: r, y: b + 34, 'text-anchor': 'end' },
      );
      n.textContent = i ? yName : xName;
    });
  }
}
/** The axis of radii: linear, square root or logarithmic. */
class RadiusPlot extends Plot {
  shareX(a) {
    if (this.plain && this.plain()) return super.shareX(a);
    const hi = this.now[1];
    return P.axis === 'lin'
      ? a / hi
      : P.axis === 'sqrt'
        ? Math.sqrt(Math.max(a, 0) / hi)
        : 1 + Math.log(Math.max(a, 1e-12) / hi) / Math.log(3000);
  }
  radius(px) {
    const hi = this.now[1],
      s = (px - this.box[0]) / (this.box[2] - this.box[0]);
    return Math.max(
      1e-6,
      Math.min(hi, P.axis === 'lin' ? s * hi : P.axis === 'sqrt' ? Math.max(0, s) ** 2 * hi : hi * 3000 ** (s - 1)),
    );
  }
}
function ticks(lo, hi, count, kind) {
  // round numbers with their labels, in the units that are shown
  const [factor] = scale(kind),
    span = (hi - lo) * factor,
    raw = span / count,
    mag = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].find((s) => s * mag >= raw * 0.99) * mag,
    out = [];
  for (let t = Math.ceil((lo * factor) / step - 1e-9); t * step <= hi * factor * (1 + 1e-9); t++)
    out.push([(t * step) / factor, t * step]);
  const biggest = Math.max(...out.map((o) => Math.abs(o[1]))),
    e = factor === 1 ? 0 : Math.max(-18, Math.min(9, 3 * Math.floor(Math.log10(biggest) / 3 + 1e-9)));
  const digits = Math.max(0, -Math.floor(Math.log10(step / 10 ** e) + 1e-9));
  const marks = out.map(([v, shown]) => [
    v,
    (Math.abs(shown) < step / 1e3 ? 0 : shown / 10 ** e).toFixed(digits).replace('-', '−'),
  ]);
  marks.unit = scale(kind)[1] ? ` (${PREFIX[e]}${scale(kind)[1]})` : '';
  return marks;
}
function radiusTicks(plot) {
  if (P.axis !== 'log') return ticks(0, plot.now[1], plot.w < 420 ? 4 : 6, 'a');
  const out = [];
  for (let e = -6; e <= 1; e++)
    if (10 ** e <= plot.now[1] * 1.001 && 10 ** e >= plot.now[1] / 3000)
      out.push([
        10 ** e,
        show(10 ** e, 'a', 2)
          .replace(/\.?0+$/, '')
          .replace(/\.?0+ /, ' '),
      ]);
  out.unit = '';
  return out;
}

let balance, energy, body, force;
let equilibriumCurve = [],
  version = 0;
function pictures() {
  balance = new RadiusPlot(
    'balance',
    [26, 14, 42, 44],
    [
      ['grow', 'path', 'grow'],
      ['shrink', 'path', 'shrink'],
      ['g0', 'path', 'ela0'],
      ['drop', 'path', 'drop'],
      ['adh', 'path', 'adh'],
      ['ela', 'path', 'ela'],
      ['hit', 'path', 'hit'],
      ['marks', 'g', '', 1],
      ['ring', 'circle', 'm-now', 1],
      ['tAdh', 'text', 'name t-adh halo', 1],
      ['tEla', 'text', 'name t-ela halo', 1],
      ['arrows', 'g', '', 1],
      ['bar', 'path', 'probe-bar', 1],
      ['handle', 'path', 'probe', 1],
      ['tip', 'text', 'halo', 1],
    ],
  );
  energy = new RadiusPlot(
    'energy',
    [6, 14, 8, 44],
    [
      ['sea', 'path', 'sea'],
      ['line', 'path', 'energy'],
      ['ball', 'circle', 'ball'],
      ['tip', 'text', 'halo', 1],
    ],
  );
  body = new Plot(
    'body',
    [4, 4, 4, 4],
    [
      ['half', 'path', 'f-half'],
      ['solid', 'path', 'f-body'],
      ['level', 'path', 'level'],
      ['springs', 'path', 'spring'],
      ['edge', 'path', 'spring edge'],
      ['gauge', 'path', 'gauge'],
      ['touching', 'path', 'touching'],
      ['width', 'path', 'probe-bar'],
      ['name', 'text', 'math t-ink halo', 1],
      ['tip', 'text', 'halo', 1],
    ],
  );
  force = new RadiusPlot(
    'force',
    [26, 14, 40, 48],
    [
      ['areas', 'g', ''],
      ['stable', 'path', 'stable'],
      ['unstable', 'path', 'unstable'],
      ['trail', 'path', 'trail'],
      ['leaps', 'g', ''],
      ['load', 'path', 'load'],
      ['hit', 'path', 'hit'],
      ['marks', 'g', '', 1],
      ['ring', 'circle', 'm-now', 1],
      ['labels', 'g', '', 1],
      ['tip', 'text', 'halo', 1],
    ],
  );
  force.plain = () => P.graph === 'force';
  for (const [id, angle] of [
    ['hatch-in', 45],
    ['hatch-out', -45],
  ])
    make(
      'path',
      { class: 'hatch', d: 'M0 0V7' },
      make(
        'pattern',
        { id, width: 7, height: 7, patternUnits: 'userSpaceOnUse', patternTransform: `rotate(${angle})` },
        force.svg.querySelector('defs'),
      ),
    );
  set(balance.handle, {
    role: 'slider',
    tabindex: 0,
    'aria-label': 'Contact radius: move the edge by hand, Enter lets go',
    'data-part': 'probe',
  });
}

/** The state that is shown: moving between two while the contact jumps. */
function shown() {
  if (probe) return { kind: 1, a: probe, d: (engine.at(value, probe) || [0, 0, 0, value])[3], F: NaN, away: true };
  if (!anim) return S;
  const t = Math.min(1, (performance.now() - anim.start) / anim.time),
    s = t * t * (3 - 2 * t),
    { from, to } = anim;
  if (t === 1) {
    finish();
    return S;
  }
  const a1 = to.kind === 0 ? 0 : to.kind === 2 ? 2.2 * reach : to.a,
    a = Math.max(1e-4, (from.a || 0) + (a1 - (from.a || 0)) * s),
    held = engine.at(value, a);
  const d = held && Number.isFinite(held[3]) ? held[3] : value;
  return {
    kind: 1,
    a,
    d,
    F: to.kind === 1 || P.control !== 'F' ? (from.F || 0) + ((to.kind === 1 ? to.F : 0) - (from.F || 0)) * s : value,
    away: true,
    dot: from.d + ((to.kind === 1 ? to.d : P.control === 'F' ? from.d : value) - from.d) * s,
  };
}

function draw() {
  const state = shown(),
    samples = (balance.w < 500 ? 160 : 240) * detail,
    low = P.axis === 'log' ? reach / 3000 : reach * 1e-6;
  if (redraw.curve) {
    equilibriumCurve = engine.curve(low, reach, 300 * detail, spacing());
    version += 1;
    const high = Math.sqrt(reach) * 1.1;
    balance.aim([0, reach, -0.26 * high, high]);
    const seen = equilibriumCurve.filter((r) => {
      const v = controlled(r[3], r[4]);
      return v >= range[0] - 1e-9 && v <= range[1] + 1e-9;
    });
    const firm = seen
        .filter((r) => r[5])
        .map((r) => r[4])
        .concat(
          folds.map((f) => f.F).filter((F, i) => folds[i].a < reach),
          0,
        ),
      firmSize = Math.max(...firm) - Math.min(...firm) || 1;
    const box = (i, least) => {
      const all = seen.map((r) => r[i]).concat(0, least),
        lo = Math.min(...all),
        hi = Math.max(...all),
        pad = 0.09 * (hi - lo);
      return [lo - pad, hi + pad];
    };
    const ds = P.control === 'd' ? range : box(3, P.control === 'F' ? 0 : range[0]),
      tension = Math.min(...seen.map((r) => r[4]), 0);
    const fs = box(4, P.control === 'F' ? range[0] : 0).map((F, i) =>
      i ? Math.min(F, Math.max(...firm) + 0.35 * firmSize) : Math.max(F, Math.min(...firm) - 0.6 * firmSize),
    );
    force.aim(
      P.graph === 'fold'
        ? [0, reach, ...range]
        : [...ds, fs[0], P.control === 'F' ? fs[1] : Math.min(fs[1], Math.max(1.6 * -tension, 0.1 * fs[1], 0.02))],
    );
    const sharp = folds.length && folds[0].max ? 5 * folds[0].a : Infinity,
      side = Math.min(reach, Math.max(sharp, 0.02), reach > 3 ? reach : 2.2),
      unit = Math.sqrt(Math.min(side, 4));
    const depths = seen
        .filter((r) => r[5])
        .map((r) => r[3])
        .concat(0),
      deep = Math.max(...depths),
      high2 = -Math.min(...depths);
    body.aim([-side, side, -Math.max(0.62 * unit, 1.1 * deep + 0.32 * unit), Math.max(0.66 * unit, high2 + 0.4 * unit)]);
    redraw.curve = false;
  }
  let moving = [balance, body, force].map((p) => p.glide()).some(Boolean) || Boolean(anim);
  const rowsNow = engine.balance(value, low, balance.now[1], samples),
    rest = engine.equilibria(value);
  moving = drawEnergy(rowsNow, rest, state) || moving;
  drawBalance(rowsNow, rest, state);
  drawForce(rest, state);
  (P.view === 'springs' ? drawSprings : drawBody)(state);
  return moving;
}

function drawBalance(r, rest, state) {
  const p = balance,
    [l, t, right, b] = p.box,
    both = (top, bottom) => p.path([...top, ...bottom.reverse()]) + 'Z';
  const adh = r.map((q) => [q[0], q[2]]),
    ela = r.map((q) => [q[0], q[1]]);
  const xs = radiusTicks(p),
    ys = ticks(p.now[2], p.now[3], p.h < 330 ? 4 : 6, 'd');
  p.axes(xs, ys, `contact radius a${xs.unit || (P.unit === 'none' ? ' / R₀' : '')}`, `length${ys.unit || ' / Δl₀'}`);
  set(p.adh, { d: p.path(adh) });
  set(p.ela, { d: p.path(ela) });
  set(p.hit, { d: p.path(ela) });
  set(p.g0, { d: P.control === 'd' ? p.path(r.map((q) => [q[0], q[1] + q[3]])) : '' });
  set(p.grow, {
    d: both(
      adh,
      r.map((q) => [q[0], Math.min(q[1], q[2])]),
    ),
  });
  set(p.shrink, {
    d: both(
      r.map((q) => [q[0], Math.max(q[1], q[2])]),
      [...adh],
    ),
  });
  // Which way the edge moves, along the axis (1.8), (1.9).
  const count = Math.max(6, Math.round((right - l) / 46));
  p.pool('arrow', 'path', p.arrows, count, (node, i) => {
    const px = l + ((i + 0.5) * (right - l)) / count,
      a = p.radius(px),
      here = engine.at(value, a);
    if (!here || S.kind === 2) return set(node, { d: '' });
    const gap = here[2] - here[1],
      s = Math.sign(gap) * Math.min(1, Math.abs(gap) / (0.12 * here[2]) + 0.25),
      w = 9 * s;
    set(node, {
      class: gap > 0 ? 'v-grow' : 'v-shrink',
      d: `M${px - w} ${b - 13}L${px + w} ${b - 8}L${px - w} ${b - 3}Z`,
      opacity: Math.abs(s).toFixed(2),
    });
  });
  const visible = folds.filter((f) => p.shareX(f.a) <= 1);
  p.pool('fold', 'path', p.marks, visible.length, (n, i) => {
    const f = visible[i],
      x = p.x(f.a),
      y = p.y(Math.sqrt(f.a));
    set(n, { class: 'm-fold', d: `M${x} ${y - 6}l5 6l-5 6l-5 -6Z`, 'data-mark': 'fold', 'data-a': f.a });
  });
  p.pool('rest', 'circle', p.marks, rest.length, (n, i) => {
    const [a, , , s] = rest[i];
    set(n, {
      class: s > 0 ? 'm-stable' : 'm-unstable',
      cx: p.x(a),
      cy: p.y(Math.sqrt(a)),
      r: s > 0 ? 6 : 5.2,
      'data-mark': s > 0 ? 'stable' : 'unstable',
      'data-a': a,
    });
  });
  const here = state.kind === 1 && state.a > 0,
    x = p.x(here ? state.a : 0),
    y = here ? p.y((engine.at(value, state.a) || [0, 0])[1]) : p.y(0);
  set(p.ring, { cx: x, cy: y, r: 10, opacity: here ? 1 : 0 });
  set(p.drop, { d: here ? `M${x} ${y}V${b}` : '' });
  set(p.bar, { d: here && state.away ? `M${x} ${y}V${p.y(Math.sqrt(state.a))}` : '' });
  set(p.handle, {
    d: S.kind === 1 && !anim ? `M${x - 11} ${b + 19}L${x} ${b + 3}L${x + 11} ${b + 19}Z` : '',
    'aria-valuenow': here ? state.a.toFixed(4) : 0,
    'aria-valuemin': 0,
    'aria-valuemax': reach.toFixed(3),
    'aria-valuetext': `${len(here ? state.a : 0)}`,
  });
  (p.pools.tx || []).forEach((n) => set(n, { opacity: here && S.kind === 1 && Math.abs(n.getAttribute('x') - x) < 20 ? 0 : 1 })); // not under the handle
  const named = visible.length <= 4 ? visible : [];
  p.pool('foldName', 'text', p.marks, named.length, (n, i) => {
    set(n, { class: 'math t-ink halo', x: p.x(named[i].a) - 8, y: p.y(Math.sqrt(named[i].a)) - 10, 'text-anchor': 'end' });
    n.textContent = named.length > 1 ? 'P' + '₁₂₃₄'[i] : 'P';
  });
  const thin = (points) => points.filter((_, i) => i % 5 === 0).map(([u, v]) => [p.x(u), p.y(v)]),
    curves = [thin(adh), thin(ela)],
    dots = [
      [x, y],
      ...rest.map((e) => [p.x(e[0]), p.y(Math.sqrt(e[0]))]),
      ...visible.map((f) => [p.x(f.a), p.y(Math.sqrt(f.a))]),
    ];
  if (P.control === 'd') curves.push(thin(r.map((q) => [q[0], q[1] + q[3]])));
  p.tEla.textContent = P.control === 'd' ? 'g(a) − d' : 'g(a) − d(a)';
  p.tAdh.textContent = 'Δl(a)';
  const used = beside(p, p.tEla, P.control === 'd' ? 66 : 84, curves[1], curves, dots, null);
  beside(p, p.tAdh, 44, curves[0], curves, dots, used);
}
/** A name beside its own curve, where the most room is; it stays where it is as long as that is nearly as good. */
function beside(p, node, width, own, curves, dots, taken) {
  const [l, t, r, b] = p.box;
  let best = null,
    kept = null;
  for (let f = 0.18; f < 0.99; f += 0.08)
    for (const [dx, dy] of [
      [0, -17],
      [0, 21],
      [width / 2 + 12, 0],
      [-width / 2 - 12, 0],
    ]) {
      const spot = own.reduce(
        (m, q) => (Math.abs(q[0] - l - f * (r - l)) < Math.abs(m[0] - l - f * (r - l)) ? q : m),
        own[0] || [0, 0],
      );
      if (spot[1] < t + 4 || spot[1] > b - 30) continue;
      const cx = Math.min(r - width / 2 - 2, Math.max(l + width / 2 + 4, spot[0] + dx)),
        cy = spot[1] + dy;
      if (cy < t + 12 || cy > b - 32) continue;
      const gap = ([u, v]) => Math.hypot(Math.max(0, Math.abs(u - cx) - width / 2), Math.max(0, Math.abs(v - cy) - 10));
      let score = 24;
      for (const curve of curves) for (const q of curve) score = Math.min(score, gap(q) * (curve === own ? 3 : 1));
      for (const q of dots) score = Math.min(score, gap(q) - 4);
      if (taken && Math.abs(taken[0] - cx) < (width + taken[2]) / 2 + 4 && Math.abs(taken[1] - cy) < 21) continue;
      score += 6 * f;
      const key = `${f.toFixed(2)} ${dx} ${dy}`,
        here = { key, cx, cy, score };
      if (key === node.kept) kept = here;
      if (!best || score > best.score) best = here;
    }
  const spot = kept && kept.score > 0.7 * best.score ? kept : best;
  set(node, spot ? { x: spot.cx, y: spot.cy + 5, 'text-anchor': 'middle', opacity: 1 } : { opacity: 0 });
  node.kept = spot && spot.key;
  return spot && [spot.cx, spot.cy, width];
}

function drawEnergy(r, rest, state) {
  const p = energy,
    slope = (q) => q[1] * q[1] - q[2] * q[2]; // ∂Π/∂a = E*[(g − d)² − Δl²] at the held value
  const still = [...rest.map((e) => e[0]), ...folds.map((f) => f.a)].filter((a) => a < reach),
    middle = still.length ? Math.max(...still) : 0.5 * reach;
  const start =
      P.control === 'd'
        ? 0
        : Math.max(
            0,
            r.findIndex((q) => q[0] >= middle),
          ),
    U = r.map((q) => [q[0], 0]);
  for (let i = start + 1; i < r.length; i++)
    U[i][1] = U[i - 1][1] + ((slope(r[i]) + slope(r[i - 1])) / 2) * (r[i][0] - r[i - 1][0]);
  for (let i = start - 1; i >= 0; i--) U[i][1] = U[i + 1][1] - ((slope(r[i]) + slope(r[i + 1])) / 2) * (r[i + 1][0] - r[i][0]);
  const at = (a) => {
    const i = U.findIndex((u) => u[0] >= a);
    if (i < 0) return U.length ? U[U.length - 1][1] : 0;
    if (i === 0) return U[0][1];
    const [u, w] = [U[i - 1], U[i]];
    return u[1] + ((w[1] - u[1]) * (a - u[0])) / (w[0] - u[0]);
  };
  const spread = [0.25, 0.5, 0.75].map((t) => at(t * middle)).concat(still.map(at), at(middle)),
    lo = Math.min(0, ...spread),
    hi = Math.max(0, ...spread),
    size = Math.max(hi - lo, 0.02 * Math.sqrt(reach));
  p.aim([0, balance.now[1], lo - 0.4 * size, hi + 0.8 * size]);
  p.now[1] = p.goal[1];
  const moving = p.glide(),
    line = U;
  set(p.line, { d: p.path(line) });
  set(p.sea, { d: p.path(line) + `L${p.box[2]} ${p.box[3]}L${p.box[0]} ${p.box[3]}Z` });
  const here = state.kind === 1 && state.a > 0 && state.a < p.now[1];
  set(p.ball, { cx: p.x(here ? state.a : 0), cy: p.y(here ? at(state.a) : 0) - 7, r: 7, opacity: here ? 1 : 0 });
  return moving;
}

/** Force over depth; or the folding curve, the held quantity over the contact radius. */
function drawForce(rest, state) {
  const p = force,
    [l, t, right, b] = p.box,
    fold = P.graph === 'fold',
    at = fold ? ([d, F, a]) => [a, controlled(d, F)] : (q) => q;
  const xs = fold ? radiusTicks(p) : ticks(p.now[0], p.now[1], p.w < 420 ? 4 : 6, 'd'),
    ys = ticks(p.now[2], p.now[3], 5, fold ? heldKind() : 'F');
  p.axes(
    xs,
    ys,
    fold ? `contact radius a${xs.unit || ' / R₀'}` : `depth d${xs.unit || ' / Δl₀'}`,
    (fold ? CONTROLS[P.control][2] : 'force F') + ys.unit,
  );
  const still = [version, p.w, p.h, ...p.now, P.graph, P.axis].join();
  if (still !== p.still) {
    p.still = still;
    const parts = { stable: [], unstable: [] };
    equilibriumCurve.forEach((q, i) => {
      const prev = equilibriumCurve[i - 1],
        key = q[5] ? 'stable' : 'unstable',
        point = (c) => at([c[3], c[4], c[0]]);
      if (!prev || prev[5] !== q[5]) parts[key].push([NaN, NaN], ...(prev ? [point(prev)] : []));
      parts[key].push(point(q));
    });
    set(p.stable, { d: p.path(parts.stable) });
    set(p.unstable, { d: p.path(parts.unstable) });
  }
  set(p.trail, {
    d: trail
      .filter((s) => !s.jump)
      .map((s) => p.path(s.points.map(at)))
      .join(''),
  });
  const leaps = trail.filter((s) => s.jump),
    areas = fold ? [] : leaps.filter((s) => s.area);
  p.pool('area', 'path', p.areas, areas.length * 2, (n, i) => {
    const s = areas[i >> 1];
    set(
      n,
      i % 2
        ? { class: '', fill: `url(#hatch-${s.kind === 'jump-in' ? 'in' : 'out'})` }
        : { class: 'lost', 'data-mark': 'lost', 'data-lost': s.lost },
    );
    set(n, { d: p.path(s.area) + 'Z' });
  });
  p.pool('amount', 'text', p.labels, areas.length, (n, i) => {
    // what was lost, where there is room for it
    const q = areas[i].area.map(([x, y]) => [p.x(x), p.y(y)]),
      lo = (j) => Math.min(...q.map((c) => c[j])),
      hi = (j) => Math.max(...q.map((c) => c[j]));
    let A = 0,
      cx = 0,
      cy = 0;
    q.forEach(([x, y], j) => {
      const [u, v] = q[(j + 1) % q.length],
        k = x * v - u * y;
      A += k / 2;
      cx += ((x + u) * k) / 6;
      cy += ((y + v) * k) / 6;
    });
    const room = Math.abs(A) > 2600 && hi(0) - lo(0) > 52 && hi(1) - lo(1) > 22;
    set(n, { class: 't-ink halo-loss', x: room ? cx / A : 0, y: room ? cy / A + 4 : 0, 'text-anchor': 'middle' });
    n.textContent = room ? show(areas[i].lost, 'E', 3) : '';
  });
  const ends = (s) => {
    const [x0, y0] = at(s.points[0]),
      end = s.points[1],
      [x1, y1] = end ? at(end) : fold ? [1e9, y0] : [x0, -1e9];
    return [p.x(x0), p.y(y0), Number.isFinite(x1) ? p.x(x1) : l - 30, p.y(fold ? y0 : y1)];
  };
  p.pool('leap', 'path', p.leaps, leaps.length, (n, i) => {
    const [x0, y0, x1, y1] = ends(leaps[i]);
    set(n, { class: 'leap', d: `M${x0} ${y0}L${x1} ${y1}` });
  });
  p.pool('head', 'path', p.leaps, leaps.length, (n, i) => {
    const [x0, y0, x1, y1] = ends(leaps[i]),
      L = Math.hypot(x1 - x0, y1 - y0);
    if (L < 12) return set(n, { d: '' });
    const ux = (x1 - x0) / L,
      uy = (y1 - y0) / L;
    set(n, {
      class: 'leap-head',
      d: `M${x1} ${y1}L${x1 - 10 * ux - 5 * uy} ${y1 - 10 * uy + 5 * ux}L${x1 - 10 * ux + 5 * uy} ${y1 - 10 * uy - 5 * ux}Z`,
    });
  });
  // What is held: a vertical line, a horizontal one, or the line F = k(D − d) of the machine.
  const far = 60,
    [x0, x1, y0, y1] = p.now,
    line = fold
      ? [
          [0, value],
          [x1, value],
        ]
      : P.control === 'd'
        ? [
            [value, y0 - 1],
            [value, y1 + 1],
          ]
        : P.control === 'F'
          ? [
              [x0, value],
              [x1, value],
            ]
          : [
              [value - far, P.k * far],
              [value + far, -P.k * far],
            ];
  const px = fold
      ? [
          [l, p.y(value)],
          [right, p.y(value)],
        ]
      : line.map(([x, y]) => [l + ((x - x0) / (x1 - x0)) * (right - l), b - ((y - y0) / (y1 - y0)) * (b - t)]),
    dLoad = `M${px[0]}L${px[1]}`;
  set(p.load, { d: dLoad });
  set(p.hit, { d: dLoad });
  p.pool('rest', 'circle', p.marks, rest.length, (n, i) => {
    const [a, d, F, s] = rest[i],
      [x, y] = at([d, F, a]);
    set(n, { class: s > 0 ? 'm-stable' : 'm-unstable', cx: p.x(x), cy: p.y(y), r: s > 0 ? 5 : 4.4 });
  });
  const now = fold
    ? state.kind === 1
      ? [state.a, value]
      : [NaN, 0]
    : anim
      ? [state.dot, state.F]
      : S.kind === 0
        ? [P.control === 'F' ? NaN : value, 0]
        : state.away || S.kind === 2
          ? [NaN, 0]
          : [state.d, state.F];
  set(p.ring, Number.isFinite(now[0] + now[1]) ? { cx: p.x(now[0]), cy: p.y(now[1]), r: 9, opacity: 1 } : { opacity: 0 });
  $('lost').textContent = unbounded
    ? 'lost: without bound'
    : jumps
      ? `lost in ${jumps} jump${jumps > 1 ? 's' : ''}: ${show(lostTotal, 'E', 4)}`
      : '';
}

/** The profile at depth d over the deformed half-space, as it is (heights stretched). */
function drawBody(state) {
  const p = body,
    side = p.now[1],
    a = state.kind === 2 ? side * 1.1 : state.kind === 1 ? state.a : 0;
  const high = Math.min(1.06 * side, engine.outer() * 0.9999);
  const d = Number.isFinite(state.d) ? state.d : -0.5 * p.now[3],
    drop = state.kind === 0 ? Math.min(d, 0) : d;
  const r = engine.surface(state.kind === 0 ? 0 : Math.max(a, 1e-6), d, high, 130 * detail);
  const free = (q) => (state.kind === 0 ? 0 : q[1] - d - q[2]);
  const mirror = (f) => [...r.map((q) => [-q[0], f(q)]).reverse(), ...r.map((q) => [q[0], f(q)])];
  const solid = mirror((q) => q[1] - drop),
    half = [...(high < side ? [[-1.1 * side, 0]] : []), ...mirror(free), ...(high < side ? [[1.1 * side, 0]] : [])];
  set(p.solid, { d: p.path(solid) + `V-40H${p.x(-high)}Z` });
  set(p.half, { d: p.path(half) + `V${p.h + 40}H${p.x(-1.06 * side)}Z` });
  set(p.touching, { d: a > 0 && state.kind ? p.path(mirror((q) => q[1] - drop).filter(([x]) => Math.abs(x) <= a)) : '' });
  set(p.level, { d: `M${p.box[0]} ${p.y(0)}H${p.box[2]}` });
  const x0 = p.x(-Math.min(a, side)),
    x1 = p.x(Math.min(a, side)),
    y = p.h - 16,
    wide = state.kind === 1 && x1 - x0 > 8;
  set(p.width, { d: wide ? `M${x0} ${y - 5}v10M${x0} ${y}H${x1}M${x1} ${y - 5}v10` : '' });
  set(p.name, {
    x: wide && x1 - x0 < 44 ? x1 + 8 : wide ? (x0 + x1) / 2 : p.w / 2,
    y: wide && x1 - x0 < 44 ? y + 5 : wide ? y - 9 : p.h - 12,
    'text-anchor': wide && x1 - x0 < 44 ? 'start' : 'middle',
  });
  p.name.textContent = state.kind === 0 ? 'apart' : state.kind === 2 ? 'in contact everywhere' : '2a';
  ['springs', 'edge', 'gauge'].forEach((k) => set(p[k], { d: '' }));
}
/** The same as the method sees it: the transformed profile g on springs of equal stiffness, none of them coupled. */
function drawSprings(state) {
  const p = body,
    side = p.now[1],
    a = state.kind === 2 ? side * 1.02 : state.kind === 1 ? state.a : 0,
    d = Number.isFinite(state.d) ? state.d : -0.5 * p.now[3],
    drop = state.kind === 0 ? Math.min(d, 0) : d;
  const r = engine.curve(side * 1e-5, Math.min(side, engine.outer() * 0.9999), 110).map((q) => [q[0], q[1]]),
    g = (x) => {
      const i = r.findIndex((q) => q[0] >= x);
      return i < 0 ? 0 : r[i][1];
    };
  const solid = [...r.map((q) => [-q[0], q[1] - drop]).reverse(), ...r.map((q) => [q[0], q[1] - drop])];
  set(p.solid, { d: p.path(solid) + 'V-40H' + p.x(-r[r.length - 1][0]) + 'Z' });
  const base = p.h - 26,
    spring = (x, top) => {
      let s = `M${x} ${base}`;
      for (let i = 1; i <= 9; i++) s += `L${x + (i % 2 ? 3 : -3) * (i < 9 ? 1 : 0)} ${base + ((top - base) * i) / 9}`;
      return s;
    };
  let all = '',
    count = Math.round(p.w / 17);
  for (let i = 0; i < count; i++) {
    const x = ((i + 0.5) / count) * 2 * side - side;
    if (Math.abs(Math.abs(x) - a) < (0.45 * 2 * side) / count && state.kind) continue;
    all += spring(p.x(x), p.y(Math.abs(x) < a ? g(Math.abs(x)) - drop : 0));
  }
  set(p.springs, { d: all });
  set(p.half, { d: `M0 ${base}H${p.w}V${p.h}H0Z` });
  set(p.level, { d: `M${p.box[0]} ${p.y(0)}H${p.box[2]}` });
  const on = state.kind === 1 && a < side,
    edgeTop = on ? p.y(g(a) - drop) : 0;
  set(p.edge, { d: on ? spring(p.x(a), edgeTop) + spring(p.x(-a), edgeTop) : '' });
  set(p.gauge, { d: on ? `M${p.x(a) + 9} ${p.y(0)}V${p.y(Math.sqrt(a))}M${p.x(-a) - 9} ${p.y(0)}V${p.y(Math.sqrt(a))}` : '' });
  set(p.touching, { d: a > 0 && state.kind ? p.path(solid.filter(([x]) => Math.abs(x) <= a)) : '' });
  set(p.width, { d: '' });
  set(p.name, {
    x: on ? Math.min(p.x(a) + 16, p.w - 46) : p.w / 2,
    y: on ? (p.y(0) + p.y(Math.sqrt(a))) / 2 + 5 : p.h - 8,
    'text-anchor': on ? 'start' : 'middle',
  });
  p.name.textContent = on ? 'Δl' : state.kind === 2 ? 'in contact everywhere' : 'apart';
}
