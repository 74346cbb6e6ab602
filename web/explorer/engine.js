// The engine: WebAssembly, rows of doubles in and out. The numbers are those of `mdr solve --f64`.

const KINDS = [
  'start',
  'touch',
  'jump-in',
  'jump',
  'detached',
  'complete',
  'end-of-profile',
  'undecided',
  'not-admissible',
  'way-point',
  'end',
  'pinned',
  'depinned',
];
const UNDECIDED = -2;
/** No answer, as the instance is gone. */
const LOST = -5;
const FAILED = 'The engine failed there and was made anew; the last contact that it could show is open again.';
let wasm;
/** The instance that takes over: a call that throws has ended the one it was made of. */
let spare;
let compiled;
/** The scene and the table that are open. */
let opened = null;
/** How many instances have failed. */
let failures = 0;

/** The engine comes with the page, gzipped, in base64: a page opened from a file can fetch nothing. */
async function load() {
  const bytes = Uint8Array.from(atob(window.MDR_ENGINE), (c) => c.charCodeAt(0));
  const plain = new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip')));
  compiled = await WebAssembly.compile(await plain.arrayBuffer());
  wasm = (await WebAssembly.instantiate(compiled, {})).exports;
  prepare();
}
/** Makes the spare instance; one that is missed is used as soon as it is there. */
async function prepare() {
  const { exports } = await WebAssembly.instantiate(compiled, {});
  if (wasm) spare = exports;
  else takeOver(exports);
}
function takeOver(exports) {
  wasm = exports;
  spare = null;
  prepare();
  engine.restKnown = null;
  openAgain();
  request();
}
/** Opens what was open, once: what fails now is given up. */
function openAgain() {
  const last = opened;
  opened = null;
  if (last) engine.open(...last);
}
/** What an exported function returns; `missing` where it throws. */
function call(name, missing, ...numbers) {
  if (!wasm) return missing;
  try {
    return wasm[name](...numbers);
  } catch (error) {
    console.warn(`The engine failed in ${name}(${numbers.join(', ')}): ${error.message}`);
    failures += 1;
    wasm = null;
    // A contact that fails as soon as it is opened is not opened again.
    if (name === 'contact') opened = null;
    if (spare) takeOver(spare);
    else request();
    return missing;
  }
}

/** Rows of the answer to a question; null where there is none. */
function rows(width, name, ...numbers) {
  const count = call(name, LOST, ...numbers);
  return count < 0 ? null : read(count, width);
}
function read(count, width) {
  const all = new Float64Array(wasm.memory.buffer, wasm.out(), count * width);
  return Array.from({ length: count }, (_, i) => all.slice(i * width, (i + 1) * width));
}
/** The words of the last failure. */
function words() {
  if (!wasm) return FAILED;
  return new TextDecoder().decode(new Uint8Array(wasm.memory.buffer, wasm.message(), wasm.message_length()));
}

/** The spacing of radii on the axis that is shown. */
const spacing = () => (P.axis === 'log' ? 0 : 2);

const engine = {
  /** Opens a contact from the text of a scene and of the table that it names; its folds, or { failure, message }. */
  open(scene, table = '') {
    const [head, tail] = [scene, table].map((text) => new TextEncoder().encode(text));
    const at = call('input', LOST, head.length + tail.length);
    if (!(at > 0)) return { failure: LOST, message: at === 0 ? words() : FAILED };
    const room = new Uint8Array(wasm.memory.buffer, at, head.length + tail.length);
    room.set(head);
    room.set(tail, head.length);
    this.restKnown = null;
    const before = opened;
    const count = call('contact', LOST, head.length);
    if (count === LOST) {
      // The contact that was open before is open again.
      opened = before;
      if (wasm) openAgain();
      return { failure: LOST, message: FAILED };
    }
    if (count < 0) return { failure: count, message: words() };
    opened = [scene, table];
    return { folds: read(count, 4) };
  },
  kappa: (n) => call('kappa', NaN, n),
  outer: () => call('outer_radius', NaN),
  curve: (low, high, count, power = 2) => rows(6, 'curve', low, high, count, power) || [],
  /** With two works of adhesion, the same of an edge that advances; the curve is that of one that recedes. */
  advancing: (low, high, count, power = 2) => (twoWorks() && rows(6, 'advancing_curve', low, high, count, power)) || [],
  advancingAt: (value) => (twoWorks() && rows(4, 'advancing_equilibria', value)) || [],
  /** d and F of an edge that is pinned at a radius. */
  pinned: (value, a) => (rows(2, 'pinned', a, value) || [[NaN, NaN]])[0],
  balance: (value, low, high, count) => rows(4, 'balance', value, low, high, count, spacing()) || [],
  /** The same at equal ratios of the radius. */
  around: (value, low, high, count) => rows(4, 'balance', value, low, high, count, 0) || [],
  at: (value, a) => (rows(4, 'balance', value, a, a, 1, 1) || [])[0],
  /** The last answer is kept: a frame asks several times. */
  equilibria(value) {
    if (this.restKnown === value) return this.rest;
    const found = rows(4, 'equilibria', value);
    this.rest = found || [];
    this.restKnown = found ? value : null;
    return this.rest;
  },
  advance: (a, from, to) => rows(10, 'advance', a, from, to),
  surface: (a, d, high, count) => rows(3, 'surface', a, d, high, count) || [],
  verify: (a) => (rows(3, 'verify', a) || [])[0],
};
