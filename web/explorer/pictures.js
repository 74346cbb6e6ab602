// What is drawn in a frame, the balance at the edge of the contact, and the energy.

let balance, energy, body, force;
let equilibriumCurve = []; // rows of a, g, Δl, d, F, stable
let advancingCurve = []; // the same of an edge that advances, with two works of adhesion
let version = 0; // counts the changes of this curve

/** Makes the pictures: layers from the back to the front, those over the clipped ones last. */
function pictures() {
  const edge = [
    ['grow', 'path', 'grow'],
    ['shrink', 'path', 'shrink'],
    ['g0', 'path', 'ela0'],
    ['drop', 'path', 'drop'],
    ['adh1', 'path', 'adh adh1'],
    ['adh', 'path', 'adh'],
    ['ela', 'path', 'ela'],
    ['hit', 'path', 'hit'],
  ];
  const edgeTop = [
    ['marks', 'g', ''],
    ['ring', 'circle', 'm-now'],
    ['tAdh', 'text', 'name t-adh halo'],
    ['tAdh1', 'text', 'name t-adh halo'],
    ['tEla', 'text', 'name t-ela halo'],
    ['arrows', 'g', ''],
    ['bar', 'path', 'probe-bar'],
    ['handle', 'path', 'probe'],
    ['inset', 'g', 'inset'],
  ];
  balance = new RadiusPlot('balance', [26, 14, 42, 44], [...edge, ...edgeTop.map((layer) => [...layer, true])]);
  energy = new RadiusPlot(
    'energy',
    [6, 14, 8, 44],
    [
      ['sea', 'path', 'sea'],
      ['line', 'path', 'energy'],
      ['ball', 'circle', 'ball'],
    ],
  );
  const solids = [
    ['half', 'path', 'f-half'],
    ['solid', 'path', 'f-body'],
    ['level', 'path', 'level'],
    ['springs', 'path', 'spring'],
    ['edge', 'path', 'spring edge'],
    ['gauge', 'path', 'gauge'],
    ['touching', 'path', 'touching'],
    ['width', 'path', 'probe-bar'],
  ];
  body = new Plot('body', [4, 4, 4, 4], [...solids, ['name', 'text', 'math t-ink halo', true]]);
  const plane = [
    ['ghost', 'path', 'ghost'],
    ['pinned', 'path', 'pinned'],
    ['areas', 'g', ''],
    ['advancing', 'path', 'stable advancing'],
    ['advancingUnstable', 'path', 'unstable advancing'],
    ['stable', 'path', 'stable'],
    ['unstable', 'path', 'unstable'],
    ['trail', 'path', 'trail'],
    ['leaps', 'g', ''],
    ['load', 'path', 'load'],
    ['hit', 'path', 'hit'],
  ];
  const planeTop = [
    ['marks', 'g', ''],
    ['ring', 'circle', 'm-now'],
    ['labels', 'g', ''],
    ['tRecedes', 'text', 'name t-ink halo'],
    ['tAdvances', 'text', 'name t-adh halo'],
  ];
  force = new RadiusPlot('force', [26, 14, 40, 48], [...plane, ...planeTop.map((layer) => [...layer, true])]);
  force.plain = () => P.graph === 'force';
  const defs = force.svg.querySelector('defs');
  for (const [id, angle] of [
    ['hatch-in', 45],
    ['hatch-out', -45],
  ]) {
    const pattern = make(
      'pattern',
      { id, width: 7, height: 7, patternUnits: 'userSpaceOnUse', patternTransform: `rotate(${angle})` },
      defs,
    );
    make('path', { class: 'hatch', d: 'M0 0V7' }, pattern);
  }
  set(balance.handle, {
    role: 'slider',
    tabindex: 0,
    'aria-label': 'Contact radius: move the edge by hand, Enter lets go',
    'data-part': 'probe',
  });
}

/** The state that is shown: the edge held by hand, or between two states while the contact jumps. `away`: not at rest. */
function shown() {
  if (probe) return { kind: 1, a: probe, d: (engine.at(value, probe) || [0, 0, 0, value])[3], F: NaN, away: true };
  if (!anim) return S;
  const t = Math.min(1, (performance.now() - anim.start) / anim.time);
  if (t === 1) {
    finish();
    return S;
  }
  const { from, to } = anim;
  const mix = (x, y) => x + (y - x) * t * t * (3 - 2 * t);
  const a = Math.max(1e-4, mix(from.a || 0, [0, to.a, 2.2 * reach][to.kind]));
  const d = (engine.at(value, a) || [])[3];
  const arrives = to.kind === 1;
  const F = arrives || P.control !== 'F' ? mix(from.F || 0, arrives ? to.F : 0) : value;
  const dot = mix(from.d, arrives ? to.d : P.control === 'F' ? from.d : value); // its depth in the plane of force and depth
  return { kind: 1, a, d: Number.isFinite(d) ? d : value, F, away: true, dot };
}

/** One frame; true while something still moves. */
function draw() {
  const state = shown();
  const low = P.axis === 'log' ? reach / DECADES : reach * 1e-6;
  const samples = P.shape === 'table' ? 0.6 * detail : detail; // a table takes longer than a formula
  if (redraw.curve) {
    equilibriumCurve = engine.curve(low, reach, 300 * samples, spacing());
    advancingCurve = engine.advancing(low, reach, 300 * samples, spacing());
    version += 1;
    aim();
    redraw.curve = false;
  }
  const gliding = [balance, body, force].map((p) => p.glide());
  const sides = engine.balance(value, low, balance.now[1], (balance.w < 500 ? 160 : 240) * samples);
  const rest = [...engine.equilibria(value), ...engine.advancingAt(value).map((e) => [...e, true])];
  gliding.push(drawEnergy(sides, rest, state));
  drawBalance(sides, rest, state);
  drawForce(rest, state);
  if (P.view === 'springs') drawSprings(state);
  else drawBody(state);
  return gliding.some(Boolean) || Boolean(anim);
}

// ---------------------------------------------------------------- windows
/** Where each picture looks: at the states that the control can reach. */
function aim() {
  const high = 1.1 * Math.max(...(equilibriumCurve.length ? equilibriumCurve.map((r) => r[2]) : [Math.sqrt(reach)]));
  balance.aim([0, reach, -0.26 * high, high]);
  const seen = equilibriumCurve.filter((r) => {
    const v = controlled(r[3], r[4]);
    return v >= range[0] - 1e-9 && v <= range[1] + 1e-9;
  });
  force.aim(P.graph === 'fold' ? [0, reach, ...range] : forceWindow(seen));
  body.aim(bodyWindow(seen.filter((r) => r[5]).map((r) => r[3])));
}
function forceWindow(seen) {
  const column = (i, least) => {
    const all = [...seen.map((r) => r[i]), 0, least];
    const [low, high] = [Math.min(...all), Math.max(...all)];
    return [low - 0.09 * (high - low), high + 0.09 * (high - low)];
  };
  const depths = P.control === 'd' ? range : column(3, P.control === 'F' ? 0 : range[0]);
  const firm = [...seen.filter((r) => r[5]).map((r) => r[4]), ...folds.filter((f) => f.a < reach).map((f) => f.F), 0];
  const [least, most] = [Math.min(...firm), Math.max(...firm)];
  const size = most - least || 1;
  // Unstable branches may run away: the window is that of the stable ones and of the folds, with some room.
  let [low, high] = column(4, P.control === 'F' ? range[0] : 0);
  low = Math.max(low, least - 0.6 * size);
  high = Math.min(high, most + 0.35 * size);
  if (P.control !== 'F') {
    const tension = -Math.min(...seen.map((r) => r[4]), 0);
    high = Math.min(high, Math.max(1.6 * tension, 0.1 * high, 0.02)); // adhesion is tensile: compression is of less interest
  }
  return [...depths, low, high];
}
function bodyWindow(depths) {
  const sharp = folds.length && folds[0].max ? 5 * folds[0].a : Infinity;
  const side = Math.min(reach, Math.max(sharp, 0.02), reach > 3 ? reach : 2.2);
  const unit = Math.sqrt(Math.min(side, 4));
  const deepest = Math.max(0, ...depths);
  // Drawn back as far as it goes, the tip of the body is in the picture.
  const highest = -Math.min(0, P.control === 'F' ? 0 : range[0], ...depths);
  if (P.view === 'scale') return scaledWindow(side);
  return [-side, side, -Math.max(0.62 * unit, 1.1 * deepest + 0.32 * unit), Math.max(0.66 * unit, highest + 0.4 * unit)];
}

// ---------------------------------------------------------------- the balance
const edgeHeight = (a, advancing) => balance.y(elongation(a) * (advancing ? ofAdvancing() : 1)); // of Δl(a)
const radiusName = () => (onWave() ? 'half-width' : 'contact radius');

/** Rows of a, g − d, Δl, d: the curves, the folds and equilibria on them, the state, and names. */
function drawBalance(sides, rest, state) {
  const p = balance;
  const xs = radiusTicks(p);
  const ys = ticks(p.now[2], p.now[3], p.h < 330 ? 4 : 6, 'd');
  p.axes(xs, ys, `${radiusName()} a${xs.unit || (P.unit === 'none' ? ' / R₀' : '')}`, `length${ys.unit || ' / Δl₀'}`);
  const adhesion = sides.map((r) => [r[0], r[2]]);
  const elasticity = sides.map((r) => [r[0], r[1]]);
  const undeformed = P.control === 'd' ? sides.map((r) => [r[0], r[1] + r[3]]) : []; // g, that is d = 0
  set(p.adh, { d: p.path(adhesion) });
  set(p.ela, { d: p.path(elasticity) });
  set(p.hit, { d: p.path(elasticity) });
  set(p.g0, { d: p.path(undeformed) });
  const ofGrowth = twoWorks() ? sides.map((r) => [r[0], r[2] * ofAdvancing()]) : adhesion;
  set(p.adh1, { d: twoWorks() ? p.path(ofGrowth) : '' });
  const between = (holds, pick) => p.path([...holds, ...sides.map((r, i) => [r[0], pick(r[1], holds[i][1])]).reverse()]) + 'Z';
  set(p.grow, { d: between(ofGrowth, Math.min) });
  set(p.shrink, { d: between(adhesion, Math.max) });
  drawArrows();
  const visible = folds.filter((f) => p.shareX(f.a) <= 1);
  drawMarks(visible, rest);
  const here = drawEdge(state);
  drawInset(state, visible);
  const pixels = (points) => points.map(([x, y]) => [p.x(x), p.y(y)]);
  const thin = (points) => pixels(points.filter((_, i) => i % 5 === 0));
  const curves = [thin(adhesion), thin(elasticity), thin(undeformed), ...(twoWorks() ? [thin(ofGrowth)] : [])];
  const marked = [...rest.map((e) => [e[0], e[4]]), ...visible.map((f) => [f.a, f.advancing])];
  const dots = [here, ...marked.map(([a, advancing]) => [p.x(a), edgeHeight(a, advancing)])];
  p.tEla.textContent = P.control === 'd' ? 'g(a) − d' : 'g(a) − d(a)';
  p.tAdh.textContent = twoWorks() ? 'Δl₂(a)' : 'Δl(a)';
  p.tAdh1.textContent = 'Δl₁(a)';
  const taken = beside(p, p.tEla, P.control === 'd' ? 66 : 84, curves[1], curves, dots, []);
  const second = beside(p, p.tAdh, twoWorks() ? 52 : 44, curves[0], curves, dots, [taken]);
  if (twoWorks()) beside(p, p.tAdh1, 52, curves[3], curves, dots, [taken, second]);
  else set(p.tAdh1, { opacity: 0 });
}
/** Which way the edge would move, along the axis (1.8), (1.9). */
function drawArrows() {
  const p = balance;
  const [l, , right, b] = p.box;
  const count = Math.max(6, Math.round((right - l) / 46));
  const places = Array.from({ length: count }, (_, i) => l + ((i + 0.5) * (right - l)) / count);
  p.pool('arrow', 'path', p.arrows, places, (node, px) => {
    const here = S.kind === 2 ? null : engine.at(value, p.radius(px));
    if (!here) return set(node, { d: '' });
    const gap = twoWorks() ? -excess(here[1], here[2]) : here[2] - here[1];
    if (gap === 0) return set(node, { d: '' });
    const size = Math.min(1, Math.abs(gap) / (0.12 * here[2]) + 0.25);
    const w = 9 * size * Math.sign(gap);
    const d = `M${px - w} ${b - 13}L${px + w} ${b - 8}L${px - w} ${b - 3}Z`;
    return set(node, { class: gap > 0 ? 'v-grow' : 'v-shrink', d, opacity: size.toFixed(2) });
  });
}
function drawMarks(visible, rest) {
  const p = balance;
  p.pool('fold', 'path', p.marks, visible, (node, f) => {
    const d = `M${p.x(f.a)} ${edgeHeight(f.a, f.advancing) - 6}l5 6l-5 6l-5 -6Z`;
    set(node, { class: 'm-fold', d, 'data-mark': 'fold', 'data-a': f.a });
  });
  p.pool('rest', 'circle', p.marks, rest, (node, [a, , , sign, advancing]) => {
    const mark = sign > 0 ? 'stable' : 'unstable';
    set(node, { class: `m-${mark}`, cx: p.x(a), cy: edgeHeight(a, advancing), r: sign > 0 ? 6 : 5.2, 'data-mark': mark, 'data-a': a });
  });
  const named = visible.length <= 4 ? visible : [];
  p.pool('foldName', 'text', p.marks, named, (node, f, i) => {
    // Above the curve: to the left where it rises, to the right where it falls.
    const falls = elongation(1.01 * f.a) < elongation(f.a);
    const [x, anchor] = falls ? [p.x(f.a) + 8, 'start'] : [p.x(f.a) - 8, 'end'];
    set(node, { class: 'math t-ink halo', x, y: edgeHeight(f.a, f.advancing) - 10, 'text-anchor': anchor });
    node.textContent = named.length > 1 ? 'P' + '₁₂₃₄'[i] : 'P';
  });
}
/** The present state, its radius on the axis, and the handle to move it; where it is, in pixels. */
function drawEdge(state) {
  const p = balance;
  const b = p.box[3];
  const here = state.kind === 1 && state.a > 0;
  const x = p.x(here ? state.a : 0);
  const y = here ? p.y((engine.at(value, state.a) || [0, 0])[1]) : p.y(0);
  set(p.ring, { cx: x, cy: y, r: 10, opacity: here ? 1 : 0 });
  set(p.drop, { d: here ? `M${x} ${y}V${b}` : '' });
  set(p.bar, { d: here && state.away ? `M${x} ${y}V${edgeHeight(state.a)}` : '' });
  set(p.handle, {
    d: S.kind === 1 && !anim ? `M${x - 11} ${b + 19}L${x} ${b + 3}L${x + 11} ${b + 19}Z` : '',
    'aria-valuenow': here ? state.a.toFixed(4) : 0,
    'aria-valuemin': 0,
    'aria-valuemax': reach.toFixed(3),
    'aria-valuetext': `${len(here ? state.a : 0)}`,
  });
  const covered = (tick) => here && S.kind === 1 && Math.abs(tick.getAttribute('x') - x) < 20; // by the handle
  (p.pools.tx || []).forEach((tick) => set(tick, { opacity: covered(tick) ? 0 : 1 }));
  return [x, y];
}

/** The least magnification that an inset is worth. */
const MAGNIFIED = 4;
/** Where both curves run along each other: what g − d exceeds Δl by, magnified, around the state or the nearest fold. */
function drawInset(state, visible) {
  const p = balance;
  const focus = state.kind === 1 && state.a > 0 ? state.a : visible.length ? visible[0].a : 0;
  const shown = focus > 0 && focus < reach && p.w > 420 && !twoWorks(); // beyond the picture there is nothing to magnify
  const [l, t, right, b] = p.box;
  const [width, height] = [0.34 * (right - l), 0.2 * (b - t)];
  const [x0, middle] = [l + 12, t + 12 + height / 2];
  const near = shown ? engine.around(value, focus / 3, Math.min(3 * focus, reach), 60) : [];
  // Scaled to the smaller half of the differences; the others leave the frame.
  const differences = near.map((r) => Math.abs(r[1] - r[2])).sort((u, v) => u - v);
  const size = 1.4 * differences[differences.length >> 1];
  const magnified = ((height / 2 - 4) / size) * p.perY();
  if (!(magnified >= MAGNIFIED && magnified < 1e9)) return set(p.inset, { display: 'none' });
  const [low, high] = [near[0][0], near[near.length - 1][0]];
  const x = (a) => x0 + (width * Math.log(a / low)) / Math.log(high / low);
  const y = (r) => middle - ((r[1] - r[2]) / size) * (height / 2 - 4);
  const framed = (r) => r && Math.abs(r[1] - r[2]) <= size;
  const curve = near
    .map((r, i) => (framed(r) ? `${framed(near[i - 1]) ? 'L' : 'M'}${x(r[0]).toFixed(1)} ${y(r).toFixed(1)}` : ''))
    .join('');
  const marked = visible.filter((f) => f.a > low && f.a < high).map((f) => `M${x(f.a)} ${middle - 4}l4 4l-4 4l-4 -4Z`);
  const here = state.kind === 1 ? engine.at(value, focus) : null;
  const parts = [
    ['panel-fill', `M${x0} ${middle - height / 2}h${width}v${height}h${-width}Z`],
    ['adh', `M${x0} ${middle}h${width}`],
    ['ela', curve],
    ['m-fold', marked.join('')],
    ['m-now', here ? `M${x(focus) - 6} ${y(here)}a6 6 0 1 0 12 0a6 6 0 1 0 -12 0` : ''],
  ];
  set(p.inset, { display: 'inline' });
  p.pool('inset', 'path', p.inset, parts, (node, [style, d]) => set(node, { class: style, d }));
  p.pool('insetName', 'text', p.inset, [magnified], (node) => {
    set(node, { x: x0 + 6, y: middle + height / 2 + 15 });
    node.textContent = `g − d − Δl, × ${(+magnified.toPrecision(1)).toLocaleString('en')}`;
  });
  return p.inset;
}

// ---------------------------------------------------------------- the energy
/** Π(a) at the held value up to a constant, from ∂Π/∂a = ½S'[(g − d)² − Δl²] by trapezoids: rows of a, Π. */
function landscape(sides, origin) {
  const slope = (r) => weight(r[0]) * drive(r[1], r[2]);
  const step = (i) => ((slope(sides[i]) + slope(sides[i - 1])) / 2) * (sides[i][0] - sides[i - 1][0]);
  // From a radius that matters: under force and machine control the slope is infinite at a = 0, and a sum from there would
  // drown in rounding.
  const start =
    P.control === 'd'
      ? 0
      : Math.max(
          0,
          sides.findIndex((r) => r[0] >= origin),
        );
  const heights = sides.map((r) => [r[0], 0]);
  for (let i = start + 1; i < sides.length; i++) heights[i][1] = heights[i - 1][1] + step(i);
  for (let i = start; i > 0; i--) heights[i - 1][1] = heights[i][1] - step(i);
  return heights;
}
/** The height of a polyline at x. */
function heightAt(line, x) {
  const i = line.findIndex((q) => q[0] >= x);
  if (i <= 0) return line.length ? line[i < 0 ? line.length - 1 : 0][1] : 0;
  const [[x0, y0], [x1, y1]] = [line[i - 1], line[i]];
  return y0 + ((y1 - y0) * (x - x0)) / (x1 - x0);
}
function drawEnergy(sides, rest, state) {
  const p = energy;
  const still = [...rest.map((e) => e[0]), ...folds.map((f) => f.a)].filter((a) => a < reach);
  const middle = still.length ? Math.max(...still) : 0.5 * reach;
  const line = landscape(sides, middle);
  const at = (a) => heightAt(line, a);
  const seen = [0, ...[0.25, 0.5, 0.75, 1].map((t) => at(t * middle)), ...still.map(at)];
  const [low, high] = [Math.min(...seen), Math.max(...seen)];
  const size = Math.max(high - low, 0.02 * Math.sqrt(reach));
  p.aim([0, balance.now[1], low - 0.4 * size, high + 0.8 * size]);
  p.now[1] = p.goal[1]; // the axis of the picture above
  const moving = p.glide();
  const drawn = p.path(line);
  set(p.line, { d: drawn });
  set(p.sea, { d: drawn && `${drawn}L${p.box[2]} ${p.box[3]}L${p.box[0]} ${p.box[3]}Z` });
  const here = state.kind === 1 && state.a > 0 && state.a < p.now[1];
  set(p.ball, { cx: p.x(here ? state.a : 0), cy: p.y(here ? at(state.a) : 0) - 7, r: 7, opacity: here ? 1 : 0 });
  return moving;
}

/** A window in which a length is as long in height as in width, the surface below its middle. */
function scaledWindow(side) {
  const { radius, height } = system();
  const [l, t, r, b] = body.box;
  const high = ((2 * side * (b - t)) / (r - l)) * (radius / height);
  return [-side, side, -0.42 * high, 0.58 * high];
}
