// Force over depth with the path so far and the energy lost; or the folding curve, the held quantity over the contact radius.

/** The curve that has been pinned: points [d, F, a] with the value that was controlled. */
let pinned = [];
function pin() {
  const whole = equilibriumCurve.map((r) => [r[3], r[4], r[0]]);
  pinned = pinned.length ? [] : whole.map((q) => [q, controlled(q[0], q[1])]);
  set($('pin'), { 'aria-pressed': pinned.length > 0 });
  request();
}
const folding = () => P.graph === 'fold';
/** A point [d, F, a] in the plane that is shown. */
const inPlane = (q) => (folding() ? [q[2], controlled(q[0], q[1])] : q);

function drawForce(rest, state) {
  const p = force;
  const xs = folding() ? radiusTicks(p) : ticks(p.now[0], p.now[1], p.w < 420 ? 4 : 6, 'd');
  const ys = ticks(p.now[2], p.now[3], 5, folding() ? heldKind() : 'F');
  const [xName, yName] = folding()
    ? [`${radiusName()} a${xs.unit || ' / R₀'}`, controlWords()[2]]
    : [`depth d${xs.unit || ' / Δl₀'}`, onWave() ? 'mean pressure F' : 'force F'];
  p.axes(xs, ys, xName, yName + ys.unit);
  drawBranches();
  set(p.trail, {
    d: trail
      .filter((s) => !s.jump)
      .map((s) => p.path(s.points.map(inPlane)))
      .join(''),
  });
  const leaps = trail.filter((s) => s.jump);
  drawAreas(folding() ? [] : leaps.filter((s) => s.area));
  drawLeaps(leaps);
  drawHeld();
  p.pool('rest', 'circle', p.marks, rest, (node, [a, d, F, sign]) => {
    const [x, y] = inPlane([d, F, a]);
    set(node, { class: sign > 0 ? 'm-stable' : 'm-unstable', cx: p.x(x), cy: p.y(y), r: sign > 0 ? 5 : 4.4 });
  });
  const [x, y] = present(state);
  set(p.ring, Number.isFinite(x + y) ? { cx: p.x(x), cy: p.y(y), r: 9, opacity: 1 } : { opacity: 0 });
  nameEdges(rest);
  const several = jumps ? [`lost in ${jumps} jump${jumps > 1 ? 's' : ''}: ${show(lostTotal, 'E', 4)}`] : [];
  const byEdge = receded !== 0 ? [`${several.length ? '' : 'lost '}by the edge: ${show(receded, 'E', 4)}`] : [];
  $('lost').textContent = unbounded ? 'lost: without bound' : [...several, ...byEdge].join(', ');
}
/** With two works of adhesion, which curve is that of which edge. */
function nameEdges(rest) {
  const p = force;
  const names = [p.tRecedes, p.tAdvances];
  if (!twoWorks()) return names.forEach((node) => set(node, { opacity: 0 }));
  const pixel = (q) => {
    const [x, y] = inPlane(q);
    return [p.x(x), p.y(y)];
  };
  const pixels = (rows) => rows.map((r) => pixel([r[3], r[4], r[0]]));
  const both = [equilibriumCurve, advancingCurve];
  const stable = both.map((rows) => pixels(rows.filter((r) => r[5])));
  const [l, t, r, b] = p.box;
  const [x, y] = pixel([value, value, value]);
  const share = (low, high) => [0, 1, 2, 3, 4, 5, 6, 7, 8].map((i) => low + ((high - low) * i) / 8);
  const held = !folding() && P.control === 'd' ? share(t, b).map((v) => [x, v]) : share(l, r).map((u) => [u, y]);
  const curves = [...both.map((rows) => pixels(rows.filter((row) => !row[5]))), held];
  const dots = rest.map(([a, d, F]) => pixel([d, F, a]));
  const taken = [];
  names.forEach((node, i) => {
    // On a small picture there is room for the work alone.
    const small = p.w < 420;
    node.textContent = (small ? ['w₂', 'w₁'] : ['recedes, w₂', 'advances, w₁'])[i];
    taken.push(beside(p, node, small ? 22 : 92, stable[i], [...stable, ...curves], dots, taken));
  });
  return undefined;
}
/** Where the state is in the plane; NaN where it is not in it. */
function present(state) {
  const nowhere = [NaN, 0];
  if (folding()) return state.kind === 1 ? [state.a, value] : nowhere;
  if (anim) return [state.dot, state.F];
  if (S.kind === 0) return P.control === 'F' ? nowhere : [value, 0];
  return state.away || S.kind === 2 ? nowhere : [state.d, state.F];
}
/** The curve of equilibria, stable and unstable, when it or the window has changed. */
function drawBranches() {
  const p = force;
  const key = [version, p.w, p.h, ...p.now, P.graph, P.axis, P.ghost, pinned.length].join();
  if (key === p.branchesKey) return;
  p.branchesKey = key;
  const parts = [[], []];
  const point = (r) => inPlane([r[3], r[4], r[0]]);
  equilibriumCurve.forEach((row, i) => {
    const before = equilibriumCurve[i - 1];
    const part = parts[row[5]];
    if (!before || before[5] !== row[5]) part.push([NaN, NaN], ...(before ? [point(before)] : []));
    part.push(point(row));
  });
  // Without adhesion the contact ends where g = d, and its springs bear what those of the edge would have been pulled by.
  const bare = ([a, g, pulled, , F]) => [g, F + stiffness(a) * pulled, a];
  set(p.ghost, { d: P.ghost === 'on' ? p.path(equilibriumCurve.map((row) => inPlane(bare(row)))) : '' });
  set(p.pinned, { d: p.path(pinned.map(([q, held]) => (folding() ? [q[2], held] : q))) });
  const advancing = [[], []];
  advancingCurve.forEach((row, i) => {
    if (!i || advancingCurve[i - 1][5] !== row[5]) advancing[row[5]].push([NaN, NaN]);
    advancing[row[5]].push(point(row));
  });
  set(p.advancing, { d: p.path(advancing[1]) });
  set(p.advancingUnstable, { d: p.path(advancing[0]) });
  set(p.stable, { d: p.path(parts[1]) });
  set(p.unstable, { d: p.path(parts[0]) });
}
/** The energy lost in each jump: tinted, hatched by its direction, and its amount where there is room. */
function drawAreas(areas) {
  const p = force;
  const twice = areas.flatMap((s) => [
    [s, false],
    [s, true],
  ]);
  p.pool('area', 'path', p.areas, twice, (node, [s, hatched]) => {
    const fill = `url(#hatch-${s.kind === 'jump-in' ? 'in' : 'out'})`;
    set(node, hatched ? { class: '', fill } : { class: 'lost', 'data-mark': 'lost', 'data-lost': s.lost });
    set(node, { d: p.path(s.area) + 'Z' });
  });
  p.pool('amount', 'text', p.labels, areas, (node, s) => {
    const middle = middleOf(s.area.map(([x, y]) => [p.x(x), p.y(y)]));
    set(node, { class: 't-ink halo-loss', x: middle ? middle[0] : 0, y: middle ? middle[1] + 4 : 0, 'text-anchor': 'middle' });
    node.textContent = middle ? show(s.lost, 'E', 3) : '';
  });
}
/** The centre of a polygon in pixels; null where a number has no room in it. */
function middleOf(polygon) {
  let [area, cx, cy] = [0, 0, 0];
  polygon.forEach(([x, y], i) => {
    const [u, v] = polygon[(i + 1) % polygon.length];
    const cross = x * v - u * y;
    area += cross / 2;
    cx += ((x + u) * cross) / 6;
    cy += ((y + v) * cross) / 6;
  });
  const extent = (j) => Math.max(...polygon.map((q) => q[j])) - Math.min(...polygon.map((q) => q[j]));
  return Math.abs(area) > 2600 && extent(0) > 52 && extent(1) > 22 ? [cx / area, cy / area] : null;
}
/** An arrow for each jump; where it has no end, to the border. */
function drawLeaps(leaps) {
  const p = force;
  const begun = leaps.filter(({ points: [from] }) => !Number.isNaN(inPlane(from)[0] + inPlane(from)[1]));
  const arrows = begun.map(({ points: [from, to] }) => {
    const [x0, y0] = inPlane(from);
    // Into complete contact: under a dead load at its force, else to ever larger tension.
    const [x1, y1] = to ? inPlane(to) : folding() || P.control === 'F' ? [1e9, y0] : [x0, -1e9];
    return [p.x(x0), p.y(y0), Number.isFinite(x1) ? p.x(x1) : p.box[0] - 30, p.y(folding() ? y0 : y1)];
  });
  p.pool('leap', 'path', p.leaps, arrows, (node, [x0, y0, x1, y1]) =>
    set(node, { class: 'leap', d: `M${x0} ${y0}L${x1} ${y1}` }),
  );
  p.pool('head', 'path', p.leaps, arrows, (node, [x0, y0, x1, y1]) => {
    const length = Math.hypot(x1 - x0, y1 - y0);
    if (length < 12) return set(node, { d: '' });
    const [u, v] = [(x1 - x0) / length, (y1 - y0) / length];
    const corner = (side) => `${x1 - 10 * u - 5 * side * v} ${y1 - 10 * v + 5 * side * u}`;
    return set(node, { class: 'leap-head', d: `M${x1} ${y1}L${corner(1)}L${corner(-1)}Z` });
  });
}
/** The controlled quantity: a vertical line, a horizontal one, or the line F = k(D − d) of the machine. */
function drawHeld() {
  const p = force;
  const [l, t, right, b] = p.box;
  const [x0, x1, y0, y1] = p.now;
  let d = `M${l} ${p.y(value)}H${right}`;
  if (!folding() && P.control === 'd') d = `M${p.x(value)} ${t}V${b}`;
  if (!folding() && P.control === 'D') {
    // Between the borders that it crosses: at the left and the right, or where it is steep at the bottom and the top.
    const steep = P.k * (x1 - x0) > y1 - y0;
    const ends = steep ? [y0, y1].map((y) => [value - y / P.k, y]) : [x0, x1].map((x) => [x, P.k * (value - x)]);
    d = p.path(ends);
  }
  set(p.load, { d });
  set(p.hit, { d });
}
