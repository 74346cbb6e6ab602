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
];
const UNDECIDED = -2;
let wasm;

/** The engine comes with the page, gzipped, in base64: a page opened from a file can fetch nothing. */
async function load() {
  const bytes = Uint8Array.from(atob(window.MDR_ENGINE), (c) => c.charCodeAt(0));
  const plain = new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip')));
  wasm = (await WebAssembly.instantiate(await plain.arrayBuffer(), {})).instance.exports;
}

/** Rows of the last answer; null where there is none. */
function rows(count, width) {
  if (count < 0) return null;
  const all = new Float64Array(wasm.memory.buffer, wasm.out(), count * width);
  return Array.from({ length: count }, (_, i) => all.slice(i * width, (i + 1) * width));
}

/** The spacing of radii on the axis that is shown. */
const spacing = () => (P.axis === 'log' ? 0 : 2);

const engine = {
  /** Opens a contact from the text of a scene and of the table that it names; its folds, or { failure, message }. */
  open(scene, table = '') {
    const [head, tail] = [scene, table].map((text) => new TextEncoder().encode(text));
    const at = wasm.input(head.length + tail.length);
    const room = new Uint8Array(wasm.memory.buffer, at, head.length + tail.length);
    room.set(head);
    room.set(tail, head.length);
    const count = wasm.contact(head.length);
    this.restKnown = null;
    if (count >= 0) return { folds: rows(count, 4) };
    const words = new Uint8Array(wasm.memory.buffer, wasm.message(), wasm.message_length());
    return { failure: count, message: new TextDecoder().decode(words) };
  },
  kappa: (n) => wasm.kappa(n),
  outer: () => wasm.outer_radius(),
  curve: (low, high, count, power = 2) => rows(wasm.curve(low, high, count, power), 6) || [],
  balance: (value, low, high, count) => rows(wasm.balance(value, low, high, count, spacing()), 4) || [],
  /** The same at equal ratios of the radius. */
  around: (value, low, high, count) => rows(wasm.balance(value, low, high, count, 0), 4) || [],
  at: (value, a) => (rows(wasm.balance(value, a, a, 1, 1), 4) || [])[0],
  /** The last answer is kept: a frame asks several times. */
  equilibria(value) {
    if (this.restKnown !== value) this.rest = rows(wasm.equilibria(value), 4) || [];
    this.restKnown = value;
    return this.rest;
  },
  advance: (a, from, to) => rows(wasm.advance(a, from, to), 9),
  surface: (a, d, high, count) => rows(wasm.surface(a, d, high, count), 3) || [],
  verify: (a) => (rows(wasm.verify(a), 3) || [])[0],
};
