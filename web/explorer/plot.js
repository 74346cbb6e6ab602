// One picture: axes, paths, marks, and a window of the world that glides to where it should be.

const NS = 'http://www.w3.org/2000/svg';
const $ = (id) => document.getElementById(id);
function make(tag, attributes, parent) {
  const node = document.createElementNS(NS, tag);
  for (const key in attributes) node.setAttribute(key, attributes[key]);
  if (parent) parent.appendChild(node);
  return node;
}
/** Sets attributes; touches the document only where something changes. */
function set(node, attributes) {
  const had = node.had || (node.had = {});
  for (const key in attributes) if (had[key] !== attributes[key]) node.setAttribute(key, (had[key] = attributes[key]));
  return node;
}
/** In a lecture, letters, lines and marks of the pictures are larger: so many pixels of the screen are one of theirs. A phone
 *  has no room for that. */
const magnification = () => (document.body.dataset.mode === 'lecture' && innerWidth > 760 && innerHeight > 480 ? 1.4 : 1);
/** The logarithmic axis of radii shows so many times the smallest one. */
const DECADES = 3000;

/** A share of the window, at most nine windows away from it; so far, too, where there is no number. */
const onSheet = (share) => (Number.isNaN(share) ? -9 : within(share, [-9, 10]));

/** Pixels, the window (`now`, on the way to `goal`: left, right, bottom, top), and layers that are made once. */
class Plot {
  constructor(id, margin, layers) {
    Object.assign(this, { svg: $(id), margin, now: null, goal: null, pools: {} });
    this.frame = make('g', {}, this.svg);
    const clip = make('clipPath', { id: `${id}-clip` }, make('defs', {}, this.svg));
    this.clip = make('rect', {}, clip);
    const inside = make('g', { 'clip-path': `url(#${id}-clip)` }, this.svg);
    const over = make('g', {}, this.svg);
    for (const [name, tag, style, onTop] of layers) this[name] = make(tag, { class: style }, onTop ? over : inside);
    new ResizeObserver(() => {
      this.resize();
      redraw.curve = true;
      request();
    }).observe(this.svg);
    this.resize();
  }
  resize() {
    const box = this.svg.getBoundingClientRect();
    const [width, height] = [box.width, box.height].map((side) => side / magnification());
    const [t, r, b, l] = this.margin;
    Object.assign(this, { w: width, h: height, box: [l, t, width - r, height - b] });
    this.svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
    set(this.clip, { x: l, y: t, width: Math.max(1, width - l - r), height: Math.max(1, height - t - b) });
  }
  aim(goal) {
    // A window without numbers is none: the last one stays.
    if (!goal.every(Number.isFinite)) goal = this.goal || [0, 1, 0, 1];
    this.goal = goal;
    if (!this.now || reduced.matches) this.now = [...goal];
  }
  /** A step towards the goal; true while on the way. */
  glide() {
    let moving = false;
    this.goal.forEach((goal, i) => {
      const size = Math.abs(this.goal[i | 1] - this.goal[i & ~1]) || 1;
      const gap = goal - this.now[i];
      const near = Math.abs(gap) < 1e-3 * size;
      this.now[i] = near ? goal : this.now[i] + 0.28 * gap;
      moving = moving || !near;
    });
    return moving;
  }
  shareX(v) {
    return (v - this.now[0]) / (this.now[1] - this.now[0]);
  }
  shareY(v) {
    return (v - this.now[2]) / (this.now[3] - this.now[2]);
  }
  x(v) {
    return this.box[0] + onSheet(this.shareX(v)) * (this.box[2] - this.box[0]);
  }
  y(v) {
    return this.box[3] - onSheet(this.shareY(v)) * (this.box[3] - this.box[1]);
  }
  /** The world's height of a pixel. */
  perY() {
    return (this.now[3] - this.now[2]) / (this.box[3] - this.box[1]);
  }
  /** A polyline through points; NaN lifts the pen. */
  path(points) {
    let text = '';
    let pen = 'M';
    for (const [x, y] of points) {
      const known = !Number.isNaN(x + y);
      if (known) text += pen + this.x(x).toFixed(1) + ' ' + this.y(y).toFixed(1);
      pen = known ? 'L' : 'M';
    }
    return text;
  }
  /** As many nodes of a kind as there are things; spare ones are hidden. */
  pool(name, tag, parent, things, draw) {
    const nodes = (this.pools[name] = this.pools[name] || []);
    while (nodes.length < things.length) nodes.push(make(tag, {}, parent));
    nodes.forEach((node, i) => {
      set(node, { display: i < things.length ? 'inline' : 'none' });
      if (i < things.length) draw(node, things[i], i);
    });
  }
  /** A light grid, numbers outside of it, names at the ends. */
  axes(xs, ys, xName, yName) {
    const key = [this.w, this.h, ...this.now, P.axis, P.unit, xName, yName, xs.length].join();
    if (key === this.axesKey) return;
    this.axesKey = key;
    const [l, t, r, b] = this.box;
    const label = (place) => (node, tick) => {
      set(node, place(tick[0]));
      node.textContent = tick[1];
    };
    this.pool('gx', 'path', this.frame, xs, (n, [x]) => set(n, { class: 'grid', d: `M${this.x(x)} ${t}V${b}` }));
    this.pool('gy', 'path', this.frame, ys, (n, [y]) =>
      set(n, { class: y === 0 ? 'zero' : 'grid', d: `M${l} ${this.y(y)}H${r}` }),
    );
    this.pool(
      'tx',
      'text',
      this.frame,
      xs,
      label((x) => ({ x: this.x(x), y: b + 17, 'text-anchor': 'middle' })),
    );
    this.pool(
      'ty',
      'text',
      this.frame,
      ys,
      label((y) => ({ x: l - 8, y: this.y(y) + 4, 'text-anchor': 'end' })),
    );
    const names = [
      [{ x: r, y: b + 34, 'text-anchor': 'end' }, xName],
      [{ x: l - 8, y: t - 8, 'text-anchor': 'start' }, yName],
    ];
    this.pool('names', 'text', this.frame, names, (n, [place, name]) => {
      set(n, { class: 'math', ...place });
      n.textContent = name;
    });
  }
}
/** The axis of radii: linear, square root or logarithmic. */
class RadiusPlot extends Plot {
  shareX(a) {
    if (this.plain && this.plain()) return super.shareX(a);
    const share = a / this.now[1];
    if (P.axis === 'lin') return share;
    return P.axis === 'sqrt' ? Math.sqrt(Math.max(share, 0)) : 1 + Math.log(Math.max(share, 1e-12)) / Math.log(DECADES);
  }
  /** The radius at a pixel. */
  radius(px) {
    const share = (px - this.box[0]) / (this.box[2] - this.box[0]);
    const high = this.now[1];
    const a = { lin: share * high, sqrt: Math.max(0, share) ** 2 * high, log: high * DECADES ** (share - 1) }[P.axis];
    return within(a, [1e-6, high]);
  }
}

/** Round numbers with their labels, in the units that are shown. */
function ticks(low, high, count, kind) {
  const [factor, unit] = scale(kind);
  const raw = ((high - low) * factor) / count;
  const magnitude = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].find((s) => s * magnitude >= raw * 0.99) * magnitude;
  const shown = [];
  for (let i = Math.ceil((low * factor) / step - 1e-9); i * step <= high * factor * (1 + 1e-9); i++) shown.push(i * step);
  const e = unit ? thousands(Math.max(...shown.map(Math.abs))) : 0;
  const digits = Math.max(0, -Math.floor(Math.log10(step / 10 ** e) + 1e-9));
  const marks = shown.map((x) => [x / factor, minus((Math.abs(x) < step / 1e3 ? 0 : x / 10 ** e).toFixed(digits))]);
  marks.unit = unit ? ` (${PREFIX[e]}${unit})` : '';
  return marks;
}
function radiusTicks(plot) {
  const high = plot.now[1];
  if (P.axis !== 'log') return ticks(0, high, plot.w < 420 ? 4 : 6, 'a');
  const powers = [-6, -5, -4, -3, -2, -1, 0, 1].map((e) => 10 ** e).filter((a) => a <= high * 1.001 && a >= high / DECADES);
  const label = (a) => show(a, 'a', 2).replace(/\.?0+( |$)/, '$1');
  const marks = powers.map((a) => [a, label(a)]);
  marks.unit = '';
  return marks;
}

/** Where a name may stand: beside its own curve, at eleven places on four sides. */
function places(p, width, own) {
  const [l, t, r, b] = p.box;
  const found = [];
  for (let share = 0.18; share < 0.99; share += 0.08) {
    const off = (q) => Math.abs(q[0] - l - share * (r - l));
    const spot = own.reduce((best, q) => (off(q) < off(best) ? q : best), own[0] || [0, 0]);
    if (spot[1] < t + 4 || spot[1] > b - 30) continue;
    for (const [dx, dy] of [
      [0, -17],
      [0, 21],
      [width / 2 + 12, 0],
      [-width / 2 - 12, 0],
    ]) {
      const cx = within(spot[0] + dx, [l + width / 2 + 4, r - width / 2 - 2]);
      const cy = spot[1] + dy;
      if (cy >= t + 12 && cy <= b - 32) found.push({ key: `${share.toFixed(2)} ${dx} ${dy}`, cx, cy, share });
    }
  }
  return found;
}
/** A name beside its own curve, where the most room is and none of the names that are `taken`; it stays where it is as long as that is nearly as good. */
function beside(p, node, width, own, curves, dots, taken) {
  let best = null;
  let kept = null;
  for (const here of places(p, width, own)) {
    const { cx, cy } = here;
    const covers = (other) => other && Math.abs(other[0] - cx) < (width + other[2]) / 2 + 4 && Math.abs(other[1] - cy) < 21;
    if (taken.some(covers)) continue;
    const gap = ([u, v]) => Math.hypot(Math.max(0, Math.abs(u - cx) - width / 2), Math.max(0, Math.abs(v - cy) - 10));
    let room = 24;
    for (const curve of curves) for (const q of curve) room = Math.min(room, gap(q) * (curve === own ? 3 : 1));
    for (const q of dots) room = Math.min(room, gap(q) - 4);
    here.score = room + 6 * here.share;
    if (here.key === node.kept) kept = here;
    if (!best || here.score > best.score) best = here;
  }
  const spot = kept && kept.score > 0.7 * best.score ? kept : best;
  node.kept = spot && spot.key;
  set(node, spot ? { x: spot.cx, y: spot.cy + 5, 'text-anchor': 'middle', opacity: 1 } : { opacity: 0 });
  return spot && [spot.cx, spot.cy, width];
}
