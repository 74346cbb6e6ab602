// The contact: the body on the half-space, or the springs of the method.

/** Radius, depth, and how far the body has come down, of a state that may be apart or in contact everywhere. */
function placed(state, everywhere) {
  const a = [0, state.a, everywhere][state.kind];
  const d = Number.isFinite(state.d) ? state.d : -0.3 * body.now[3];
  return { a, d, drop: state.kind === 0 ? Math.min(d, 0) : d };
}
const mirrored = (points) => [...points.map(([r, z]) => [-r, z]).reverse(), ...points];
const name = (text, x, y, anchor) => {
  set(body.name, { x, y, 'text-anchor': anchor });
  body.name.textContent = text;
};

/** The profile at depth d over the deformed half-space, as it is, with heights stretched. */
function drawBody(state) {
  const p = body;
  const side = p.now[1];
  const { a, d, drop } = placed(state, 1.1 * side);
  const high = Math.min(1.06 * side, engine.outer() * 0.9999);
  const rows = engine.surface(state.kind === 0 ? 0 : Math.max(a, 1e-6), d, high, 160 * detail);
  const solid = mirrored(rows.map(([r, f]) => [r, f - drop]));
  const free = mirrored(rows.map(([r, f, gap]) => [r, state.kind === 0 ? 0 : f - d - gap]));
  const half = high < side ? [[-1.1 * side, 0], ...free, [1.1 * side, 0]] : free;
  set(p.solid, { d: rows.length ? `${p.path(solid)}V-40H${p.x(-high)}Z` : '' });
  set(p.half, { d: rows.length ? `${p.path(half)}V${p.h + 40}H${p.x(-1.06 * side)}Z` : '' });
  set(p.touching, { d: a > 0 ? p.path(solid.filter(([x]) => Math.abs(x) <= a)) : '' });
  set(p.level, { d: `M${p.box[0]} ${p.y(0)}H${p.box[2]}` });
  for (const layer of [p.springs, p.edge, p.gauge]) set(layer, { d: '' });
  drawWidth(state, Math.min(a, side));
}
/** The width of the contact, 2a, below it. */
function drawWidth(state, a) {
  const p = body;
  const [x0, x1, y] = [p.x(-a), p.x(a), p.h - 16];
  const wide = state.kind === 1 && x1 - x0 > 8;
  set(p.width, { d: wide ? `M${x0} ${y - 5}v10M${x0} ${y}H${x1}M${x1} ${y - 5}v10` : '' });
  if (!wide) return name(['apart', '2a', 'in contact everywhere'][state.kind], p.w / 2, p.h - 12, 'middle');
  return x1 - x0 < 44 ? name('2a', x1 + 8, y + 5, 'start') : name('2a', (x0 + x1) / 2, y - 9, 'middle');
}

/** The same as the method sees it: the transformed profile g on springs of equal stiffness, none of them coupled. */
function drawSprings(state) {
  const p = body;
  const side = p.now[1];
  const { a, drop } = placed(state, 1.02 * side);
  const profile = engine.curve(side * 1e-5, Math.min(side, engine.outer() * 0.9999), 110).map((r) => [r[0], r[1] - drop]);
  const solid = mirrored(profile);
  set(p.solid, { d: solid.length ? `${p.path(solid)}V-40H${p.x(solid[0][0])}Z` : '' });
  set(p.touching, { d: a > 0 ? p.path(solid.filter(([x]) => Math.abs(x) <= a)) : '' });
  const base = p.h - 26;
  const spring = (x, top) => {
    const turns = Array.from(
      { length: 9 },
      (_, i) => `L${x + (i === 8 ? 0 : i % 2 ? -3 : 3)} ${base + ((top - base) * (i + 1)) / 9}`,
    );
    return `M${x} ${base}${turns.join('')}`;
  };
  const count = Math.round(p.w / 17);
  const places = Array.from({ length: count }, (_, i) => ((i + 0.5) / count) * 2 * side - side);
  const free = places.filter((x) => !state.kind || Math.abs(Math.abs(x) - a) >= (0.9 * side) / count); // not at the edge
  const top = (x) => p.y(Math.abs(x) < a ? heightAt(profile, Math.abs(x)) : 0);
  set(p.springs, { d: free.map((x) => spring(p.x(x), top(x))).join('') });
  set(p.half, { d: `M0 ${base}H${p.w}V${p.h}H0Z` });
  set(p.level, { d: `M${p.box[0]} ${p.y(0)}H${p.box[2]}` });
  set(p.width, { d: '' });
  drawOuter(state.kind === 1 && a < side ? a : 0, spring, p.y(heightAt(profile, a)), state);
}
/** The outer springs, stretched by g − d, beside what they can bear, Δl. */
function drawOuter(a, spring, top, state) {
  const p = body;
  const [level, limit] = [p.y(0), p.y(elongation(a))];
  set(p.edge, { d: a ? spring(p.x(a), top) + spring(p.x(-a), top) : '' });
  set(p.gauge, { d: a ? `M${p.x(a) + 9} ${level}V${limit}M${p.x(-a) - 9} ${level}V${limit}` : '' });
  if (a) name('Δl', Math.min(p.x(a) + 16, p.w - 20), (level + limit) / 2 + 5, 'start');
  else name(state.kind === 2 ? 'in contact everywhere' : 'apart', p.w / 2, p.h - 8, 'middle');
}
