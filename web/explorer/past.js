// Steps back: what was done last is taken back, with the way that led there.

const past = [];
/** Keeps the state before something is done; what goes on, such as a slider that is dragged, is one step back. */
function remember(what) {
  const now = performance.now();
  const goesOn = what === remember.what && now - remember.when < 900;
  Object.assign(remember, { what, when: now });
  if (goesOn) return;
  const story = { S, value, leg, trail, lostTotal, jumps, unbounded, receded, ended, origin, note };
  past.push({ ...story, P: { ...P }, way: { start: way.start, points: [...way.points] } });
  if (past.length > 100) past.shift();
}
/** One step back, with the way that led there. */
function undo() {
  const before = past.pop();
  stop();
  finish();
  probe = null;
  remember.what = '';
  if (!before) return;
  const { graph } = P;
  P = before.P;
  if (P.graph !== graph) turn(P.graph);
  rebuild();
  ({ S, value, leg, trail, lostTotal, jumps, unbounded, receded, ended, origin, note, way } = before);
  markPreset();
  sync();
}
