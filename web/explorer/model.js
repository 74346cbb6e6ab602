// The model: the state of the contact, and what it does when something moves.

let P = { ...DEFAULTS };
let value = 0;
let folds = [];
let range = [-1, 1];
let reach = 2;
let degenerate = false;
let S = { kind: 1, a: 1, d: 0, F: 0 }; // kind: 0 apart, 1 in contact, 2 in contact everywhere; poised: on an unstable equilibrium
let trail = []; // {points: [d, F, a], jump, area, lost, kind}
let lostTotal = 0;
let jumps = 0;
let unbounded = false;
let receded = 0; // what an edge that recedes has lost besides, with two works of adhesion
let way = { start: S, points: [0] }; // from where, and the values at which the control turned round
let leg = { from: S, at: 0, before: [[], 0, 0, false, 0] }; // from the last of them, and trail, loss and jumps before it
let ended = ''; // how the way came to an end, if it did
let anim = null;
let probe = null; // the radius at which the edge is held by hand
let playing = 0;
let spent = 0; // time of the moves since the last frame, ms
let note = '';
let trouble = '';
const redraw = { curve: true };
const reduced = matchMedia('(prefers-reduced-motion: reduce)');
const controlled = (d, F) => (P.control === 'd' ? d : P.control === 'F' ? F : d + F / P.k);
const heldKind = () => (P.control === 'F' ? 'F' : 'd');
const within = (x, [lo, hi]) => Math.min(hi, Math.max(lo, x));

/** What was drawn last without a failure of the engine, and how many failures that is after. */
let good = null;
let mended = 0;
let attempts = 0;
function keepGood() {
  good = { P: { ...P }, value, S, origin };
  attempts = 0;
}
/** After a failure of the engine: what could be shown last, at rest, or the first preset. False where that has failed as well. */
function fallBack() {
  mended = failures;
  attempts += 1;
  stop();
  finish();
  probe = null;
  if (attempts > 3) {
    $('story').textContent = 'The engine fails again and again: reload the page.';
    return false;
  }
  if (good) {
    P = { ...good.P };
    ({ value, S, origin } = good);
  }
  if (!good || !rebuild()) preset(0);
  good = null; // one that fails once more is not tried again
  clearTrail();
  note = FAILED;
  sync();
  return true;
}

/** The contact from scratch: its folds, the range of the control, how far to look. False where the profile is refused. */
function rebuild() {
  const table = P.shape === 'table' ? tableFile(system('none')) : '';
  let found = engine.open(sceneForEngine(), table);
  degenerate = found.failure === UNDECIDED;
  if (degenerate) {
    // n = 1/2 at a threshold: step off it by a hair
    const kept = P.rho;
    P.rho *= 1 + 1e-7;
    found = engine.open(sceneForEngine(), table);
    P.rho = kept;
  }
  trouble = found.failure ? found.message.replace(/^.*profile\.csv: |^profile\.file: /, '') : '';
  if (found.failure) return false;
  const cap = P.shape === 'wavy' ? WAVES_SHOWN : FOLDS_SHOWN;
  folds = found.folds.map(([a, d, F, kind]) => ({ a, d, F, max: kind % 2 === 1, advancing: kind > 1, v: controlled(d, F) }));
  const seen = folds.filter((f) => f.a < cap);
  const values = seen.map((f) => f.v);
  // Springs that do not act on each other hold to d = −Δl, however small the contact.
  if (P.medium === 'springs' && P.control !== 'F') values.push(-1);
  const size = Math.max(...values.map(Math.abs), P.shape === 'wavy' ? 0.4 : 0.25);
  range = [Math.min(0, ...values) * 1.3 - 0.3 * size, Math.max(0, ...values) * 1.25 + 1.1 * size];
  const edge = engine.outer() * (1 - 1e-7);
  const largest =
    engine
      .equilibria(range[1])
      .filter((e) => e[3] > 0)
      .map((e) => e[0])
      .pop() || 0;
  reach = Math.min(Math.max(1.25, 1.2 * Math.min(largest, 5), ...seen.map((f) => Math.min(1.3 * f.a, 6))), edge);
  redraw.curve = true;
  return true;
}

// ---------------------------------------------------------------- states
const contactState = ([a, d, F]) => ({ kind: 1, a, d, F });
const away = () => ({ kind: 0, a: 0, d: P.control === 'F' ? NaN : value, F: 0 });
const complete = (d = NaN, F = NaN) => ({ kind: 2, a: Infinity, d, F });
/** A state as the engine returns it: a = 0 apart, NaN in contact everywhere. */
const told = (a, d, F) => ({ kind: Number.isNaN(a) ? 2 : a > 0 ? 1 : 0, a: Number.isNaN(a) ? Infinity : a, d, F });
const restingStates = () => engine.equilibria(value).filter((e) => e[3] > 0);
const advancingStates = () => engine.advancingAt(value).filter((e) => e[3] > 0);
const forceAt = (a) => (engine.curve(a, a, 1)[0] || [])[4];

/** Where the contact is when it has been let alone at a value. */
function settle(how, near = 1) {
  const stable = restingStates();
  const now = how === 'nearest' && engine.at(value, near);
  if (now && twoWorks()) return relaxed(near, now);
  if (now && Math.abs(now[1] - now[2]) < 1e-6 * now[2]) {
    // at rest; unstable unless it is one of those
    const firm = stable.find((e) => Math.abs(e[0] / near - 1) < 1e-4);
    return firm ? contactState(firm) : { kind: 1, a: near, d: now[3], F: forceAt(near), poised: true };
  }
  if (now) return relaxed(near, now); // where the direction of change leads, not the nearest
  const pick = how === 'smallest' ? (twoWorks() ? advancingStates() : stable)[0] : how === 'detached' ? null : stable[stable.length - 1];
  return pick ? contactState(pick) : away();
}
/** Let go at radius a, where the balance is a row of a, g − d, Δl, d: (1.8), (1.9), or pinned between two works of adhesion. */
function relaxed(a, [, y, most]) {
  const over = twoWorks() ? excess(y, most) : y - most;
  if (twoWorks() && over === 0) {
    const [d, F] = engine.pinned(value, a);
    return { kind: 1, a, d, F };
  }
  const rest = twoWorks() && over < 0 ? advancingStates() : restingStates();
  const next =
    rest.find((e) => Math.abs(e[0] / a - 1) < 1e-6) || (over > 0 ? rest.filter((e) => e[0] < a).pop() : rest.find((e) => e[0] > a));
  if (next) return contactState(next);
  return over > 0 ? away() : complete();
}
function clearTrail() {
  way = { start: S, points: [value] };
  ended = '';
  begin([], 0, 0, false, 0);
}
/** A leg of the way begins at the state and the value that there are: what came before it is kept as it is. */
function begin(...before) {
  leg = { from: S, at: value, before };
  [trail, lostTotal, jumps, unbounded, receded] = before;
}
/** The curve of equilibria between two radii, as points [d, F, a]. Those of a leg are asked for again and again. */
function along(from, to) {
  const key = `${from} ${to}`;
  if (along.contact !== opened) along.known = new Map();
  along.contact = opened;
  if (!along.known.has(key)) {
    if (along.known.size > 200) along.known.clear();
    along.known.set(key, between(from, to));
  }
  return along.known.get(key);
}
function between(from, to) {
  const count = Math.round(
    within((120 * Math.abs(Math.sqrt(to) - Math.sqrt(from))) / Math.sqrt(reach), [2, P.shape === 'table' ? 40 : 90]),
  );
  const curve = twoWorks() && to > from ? engine.advancing : engine.curve;
  const points = curve(Math.max(Math.min(from, to), 1e-9), Math.max(from, to), count).map((r) => [r[3], r[4], r[0]]);
  return from < to ? points : points.reverse();
}
/** From one state of contact to another: along a line where the edge is pinned, else along the curve of equilibria. */
function onTheWay(from, to) {
  const pinned = twoWorks() && Math.abs(from.a - to.a) <= 1e-9 * to.a;
  return pinned ? [from, to].map(({ a, d, F }) => [d, F, a]) : along(from.a, to.a);
}
const smooth = (points) => trail.push({ points });

// ---------------------------------------------------------------- moves
/** Moves the control to `to`; its time counts with that of the next frame. */
function move(to) {
  const start = performance.now();
  moveTo(to);
  spent += performance.now() - start;
}
/** Follows the leg from where the control turned round to `to`, as `mdr solve` follows the way: the library finds every event and
 * every state. */
function moveTo(to) {
  to = within(to, range);
  finish();
  probe = null;
  if (S.kind === 2 || to === value) {
    value = to;
    return request();
  }
  if (S.poised) return nudge(to);
  const points = way.points;
  const last = points[points.length - 1];
  const forward = points.length > 1 && Math.sign(to - value) === Math.sign(last - leg.at);
  if (ended && forward) return request();
  if (!forward) turnRound();
  const events = engine.advance(leg.from.kind === 1 ? leg.from.a : -1, leg.at, to);
  if (!events) return restart(to);
  if (forward) points[points.length - 1] = to;
  else points.push(to);
  const known = forward ? jumps : leg.before[2];
  const [at, arrived, jumpedFrom] = follow(events, to, known);
  value = arrived;
  if (jumpedFrom && !reduced.matches) anim = { from: { ...jumpedFrom }, to: at, start: performance.now(), time: 420 };
  S = at.kind === 0 ? away() : at;
  return request();
}
/** The control turns round: a new leg. A way that came to an end turns just before it. */
function turnRound() {
  if (ended) {
    value -= Math.sign(way.points[way.points.length - 1] - leg.at) * 1e-9 * (range[1] - range[0]);
    way.points[way.points.length - 1] = value;
    if (S.kind === 0) S = away();
    ended = '';
  }
  begin([...trail], lostTotal, jumps, unbounded, receded);
}
/** Where the library has no way from here: at rest at `to`, with its words. */
function restart(to) {
  const why = words();
  value = to;
  S = settle('nearest', S.a || 1e-3);
  clearTrail();
  note = `No way leads there from this state: ${why}.`;
  request();
}
/** The events of a leg: the last state, the value it is reached at, and the state that the last new jump left; `known` jumps
 * have been told. */
function follow(events, to, known) {
  [, lostTotal, jumps, unbounded, receded] = leg.before;
  trail = [...leg.before[0]];
  let at = { ...leg.from };
  let from = leg.at;
  let jumpedFrom = null;
  for (const [number, v, a, d, F, a1, d1, F1, lost, byEdge] of events) {
    const kind = KINDS[number];
    const before = told(a, d, F);
    const after = told(a1, d1, F1);
    if (kind === 'touch') after.kind = 1; // at a point, a = 0
    receded += byEdge;
    if (at.kind === 1 && before.kind === 1) smooth(onTheWay(at, before));
    else if (at.kind === 0 && P.control !== 'F') smooth([from, v].map((x) => [Math.min(x, 0), 0, 0]));
    if (['jump', 'jump-in', 'detached', 'complete'].includes(kind)) {
      const words = leap(kind, v, before, after, lost);
      if (jumps > known) [note, jumpedFrom] = [words, before];
    }
    at = after.kind === 2 ? complete(before.d, before.F) : after;
    from = v;
    if (ENDS[kind]) {
      note = ENDS[kind];
      ended = kind;
      return [at, v, jumpedFrom];
    }
  }
  return [at, to, jumpedFrom];
}
const ENDS = {
  'end-of-profile': 'The edge of the contact has come to the end of the profile: what is beyond is not known.',
  undecided: 'Beyond this value no state was found.',
  'not-admissible': 'Outside of the contact the surfaces touch on a ring. The theory of one simple contact ends here.',
};
/** From an unstable equilibrium, the smallest change decides. */
function nudge(to) {
  const from = S;
  value = to;
  const here = engine.at(to, S.a);
  S = here ? relaxed(from.a, here) : away();
  if (!reduced.matches) anim = { from, to: S, start: performance.now(), time: 700 };
  clearTrail();
  request();
}
/** Records a jump and the area that it loses in the plane of force and depth; what happened, in words. */
function leap(kind, v, before, after, lost) {
  const [from, to] = [kind === 'jump-in' ? 0 : before.a, after.kind === 1 ? after.a : 0];
  const start = kind === 'jump-in' ? [0, 0, 0] : [before.d, before.F, before.a];
  const end = after.kind === 1 ? [after.d, after.F, after.a] : P.control === 'F' ? [-Infinity, v, 0] : [v, 0, 0];
  const bounded = after.kind === 1 || (Number.isFinite(lost) && after.kind !== 2 && P.control !== 'F');
  const area = bounded && before.a + to > 0 ? [...along(from, to), ...(after.kind === 0 ? [[0, 0, 0]] : []), end] : null;
  trail.push({ jump: true, points: after.kind === 2 ? [start] : [start, end], area, lost, kind });
  jumps += 1;
  if (Number.isFinite(lost)) lostTotal += lost;
  else unbounded = true;
  return {
    jump: `The curves touched. The contact jumped from a = ${len(before.a)} to ${len(after.a)}.`,
    'jump-in': `They touched, and the contact jumped to a = ${len(to)}.`,
    detached:
      before.a > 0
        ? `The curves touched for the last time at a = ${len(before.a)}: the contact broke.`
        : 'The contact has shrunk to nothing.',
    complete: `At a = ${len(before.a)} the last equilibrium is gone: the surfaces come into complete contact. Here the theory ends.`,
  }[kind];
}
function finish() {
  anim = null;
}
/** The edge is let go. */
function release() {
  if (!probe) return;
  remember('edge');
  const here = engine.at(value, probe);
  const from = { kind: 1, a: probe, d: value, F: 0 };
  S = here ? relaxed(probe, here) : S;
  probe = null;
  clearTrail();
  if (!reduced.matches) anim = { from, to: S, start: performance.now(), time: 520 };
  request();
}

// ---------------------------------------------------------------- changes
/** New parameters, the control held: the contact goes where the direction of change takes it. What is refused is taken back. */
function change(parameters) {
  remember(Object.keys(parameters).join());
  const before = S;
  const kept = { ...P };
  stop();
  finish();
  probe = null;
  note = '';
  Object.assign(P, together(parameters));
  if (!rebuild()) {
    const words = trouble;
    P = kept;
    rebuild();
    trouble = words;
    sync();
    return request();
  }
  if (P.control !== kept.control)
    value = controlled(Number.isFinite(before.d) ? before.d : 0, Number.isFinite(before.F) ? before.F : 0);
  value = within(value, range);
  if (before.kind === 1) S = settle('nearest', Math.min(before.a, reach));
  else if (before.kind === 0) S = value >= 0 ? settle('largest') : away();
  else S = settle(value > 0 && P.n < meeting() ? 'smallest' : 'largest');
  clearTrail();
  if (P.shape === 'wavy' && P.A === highestWaves(P))
    note = `The waves are held at a height of ${show(P.A, 'd')}: higher ones of this length would make folds by the hundred.`;
  sync();
  request();
}
let origin = { value: 0, start: 'largest' };
function preset(index) {
  const [, { v, start = 'largest', ...parameters }, text] = PRESETS[index];
  if (good) remember(`preset ${index}`);
  stop();
  finish();
  probe = null;
  note = '';
  const kept = PRESETS.some(([, { unit }]) => unit === P.unit) ? {} : { unit: P.unit };
  const graph = P.graph;
  P = { ...DEFAULTS, ...kept, uR: P.uR, uE: P.uE, uw: P.uw, view: P.view, ghost: P.ghost, ...parameters };
  if (P.graph !== graph) turn(P.graph);
  if (!rebuild()) return request();
  value = v;
  S = settle(start);
  clearTrail();
  origin = { value, start };
  $('note').textContent = text;
  markPreset(index);
  sync();
  request();
}
const markPreset = (index = -1) => [...$('presets').querySelectorAll('[data-preset]')].forEach((b, i) => set(b, { 'aria-pressed': i === index }));
function startAgain() {
  remember('again');
  stop();
  finish();
  probe = null;
  note = '';
  value = within(origin.value, range);
  S = settle(origin.start);
  clearTrail();
  request();
}
