// Units, and the contact as a scene file: what the engine opens, and what a reader takes away, are the same text.

// Lengths of the contact in R₀, where Δl(R₀) = Δl₀, and E* = 1, w = 1/2π, so that Δl(a) = √a.
const WORK = 1 / (2 * Math.PI);
const UNITS = {
  // label, radius R of the sphere in m, E* in Pa, w in J/m²
  none: ['reduced'],
  afm: ['AFM tip, R = 20 nm', 20e-9, 1e9, 0.05],
  gel: ['gel, R = 1 cm', 0.01, 1e6, 0.05],
  paper: ['figure 4, R = 1 m', 1, 1e5, 10],
  own: ['of your own'],
};

/** The units that are shown: of a radius, a height, E*, w, and a force, which on a wave is one per area. */
function system(name = P.unit) {
  const whole = (units) => ({ ...units, force: onWave() ? (units.modulus * units.height) / units.radius : units.modulus * units.radius * units.height });
  if (name === 'none') return whole({ radius: 1, height: 1, modulus: 1, work: WORK });
  const [, R, modulus, work] = name === 'own' ? ['', P.uR, P.uE, P.uw] : UNITS[name];
  const radius = Math.cbrt((2 * Math.PI * R * R * work) / modulus); // R₀²/R = Δl₀ = √(2πR₀w/E*)
  return whole({ radius, height: Math.sqrt((2 * Math.PI * radius * work) / modulus), modulus, work });
}
/** The factor and the unit of a quantity: a radius a, a height d, a force F, an energy E, a stiffness k. */
function scale(what) {
  if (P.unit === 'none') return [1, ''];
  const { radius, height, force } = system();
  const [F, E, k] = onWave() ? ['Pa', 'J/m²', 'Pa/m'] : ['N', 'J', 'N/m'];
  return { a: [radius, 'm'], d: [height, 'm'], F: [force, F], E: [force * height, E], k: [force / height, k] }[what];
}

const PREFIX = { '-18': 'a', '-15': 'f', '-12': 'p', '-9': 'n', '-6': 'µ', '-3': 'm', 0: '', 3: 'k', 6: 'M', 9: 'G' };
const thousands = (y) => (y === 0 ? 0 : Math.max(-18, Math.min(9, 3 * Math.floor(Math.log10(Math.abs(y)) / 3 + 1e-9))));
const minus = (text) => text.replace('-', '−');
/** A number in words of the units that are shown. */
function show(x, what, digits = 3) {
  const [factor, unit] = scale(what);
  if (Number.isNaN(x)) return '—';
  if (!Number.isFinite(x)) return x > 0 ? '∞' : '−∞';
  if (!unit && what === 'E' && x > 1e-12 && x < 5e-5)
    return minus(x.toExponential(1).replace(/e(.*)/, (_, e) => ' · 10' + [...e].map((c) => '⁰¹²³⁴⁵⁶⁷⁸⁹'[c] || '⁻').join('')));
  if (!unit) return minus(Math.abs(x) < 5e-5 ? '0' : x.toFixed(Math.abs(x) < 0.1 ? digits + 1 : digits));
  const y = x * factor;
  if (y === 0) return `0 ${unit}`;
  const e = thousands(y);
  return minus(`${(y / 10 ** e).toPrecision(digits)} ${PREFIX[e]}${unit}`);
}
const len = (a) => show(a, 'a');

// ---------------------------------------------------------------- the profile
let kappaKnown = [NaN, NaN];
function kappa(n) {
  if (kappaKnown[0] !== n) kappaKnown = [n, engine.kappa(n)];
  return kappaKnown[1];
}
/** [profile] in some units; ρ is g(R₀)/Δl₀. */
function profileLines({ radius, height }) {
  if (onWave()) return ['kind = "wave"', `amplitude = ${amplitude() * height}`];
  switch (P.shape) {
    case 'power':
      if (P.n === 2) return ['kind = "paraboloid"', `radius = ${(radius * radius) / (P.rho * height)}`];
      return ['kind = "power"', `n = ${P.n}`, `c = ${((P.rho / kappa(P.n)) * height) / radius ** P.n}`];
    case 'sphere': // with the curvature of the paraboloid at its tip: heights have a unit of their own, hence an ellipsoid
      return ['kind = "ellipsoid"', `lateral = ${P.R * radius}`, `height = ${P.rho * P.R * P.R * height}`];
    case 'wavy':
      return [
        'kind = "wavy-paraboloid"',
        `radius = ${(radius * radius) / (P.rho * height)}`,
        `amplitude = ${P.A * height}`,
        `wavelength = ${P.L * radius}`,
      ];
    default:
      return ['kind = "table"', 'file = "profile.csv"', ...(P.smooth ? [`smooth = ${P.smooth * radius}`] : [])];
  }
}
const CONTROL_KINDS = { d: 'indentation', F: 'force', D: 'machine' };
/** A scene without outputs: the contact and its control. */
function sceneHead(units) {
  const medium = mediumLines(units);
  const { work } = units;
  const lines = [
    '[material]',
    ...(['graded', 'springs'].includes(P.medium) ? [] : [`e_star = ${units.modulus}`]),
    `work_of_adhesion = ${twoWorks() ? `{ advancing = ${work * P.w1}, receding = ${work} }` : work}`,
    '',
    ...(medium.length ? ['[medium]', ...medium, ''] : []),
    '[profile]',
    ...profileLines(units),
    '',
  ];
  lines.push('[control]', `kind = "${CONTROL_KINDS[P.control]}"`);
  if (P.control === 'D') lines.push(`stiffness = ${(P.k * units.force) / units.height}`);
  return lines;
}
/** The contact in the units of the engine. */
const sceneForEngine = () => [...sceneHead(system('none')), '[output]', 'want = ["folds"]', 'arithmetic = "f64"'].join('\n');
/** What is controlled, in some units. */
const inUnits = (v, { height, force }) => v * (P.control === 'F' ? force : height);
/** The contact and its way so far, in the units that are shown, as `mdr solve` reads it. */
function sceneFile() {
  const units = system();
  const lines = sceneHead(units);
  const walked = !S.poised && way.points.length > 1;
  if (walked) {
    const start = way.start.kind === 1 ? way.start.a * units.radius : '"detached"';
    lines.push(`path = [${way.points.map((v) => inUnits(v, units)).join(', ')}]`, `start = ${start}`);
  }
  lines.push('', '[output]', `want = ["folds", "equilibria"${walked ? ', "path"' : ''}]`, 'arithmetic = "f64"');
  lines.push(`equilibria.at = [${inUnits(value, units)}]`);
  return lines.join('\n').replace(/e\+/g, 'e') + '\n';
}

// ---------------------------------------------------------------- tables
const LENGTHS = { m: 1, mm: 1e-3, um: 1e-6, µm: 1e-6, μm: 1e-6, nm: 1e-9, pm: 1e-12 };
/** The unit of a cell in a row of headings or units, "nm", "r (nm)", "height/nm"; null where it names none. */
function unitOf(cell) {
  if (cell in LENGTHS) return LENGTHS[cell];
  const [, unit] = cell.match(/[([/]\s*([^)\]]+?)\s*[)\]]?$/) || [];
  if (!unit) return null;
  if (unit in LENGTHS) return LENGTHS[unit];
  throw new Error(`“${unit}” is no unit of length: write m, mm, µm, nm or pm`);
}
/** The factors of a row of headings or of units; `second`: after a row of headings, it has to be one of units. */
function unitsOf(cells, second) {
  const units = cells.slice(0, 2).map(unitOf);
  if (units.length === 2 && units.every(Boolean)) return units;
  const odd = cells.find((cell, i) => !units[i]);
  if (second || units.some(Boolean)) throw new Error(`“${odd}” is no unit of length: write m, mm, µm, nm or pm`);
  return null;
}
/** The rows of a CSV, and whether a row of units makes them metres. The engine judges whether they are a profile. */
function readTable(text) {
  const points = [];
  let units = null;
  let headed = false;
  for (const line of text.split(/\r?\n/)) {
    if (!line.trim() || line.trim().startsWith('#')) continue;
    const cells = line
      .split(/[,;\t]|\s+(?=[^\s([])/)
      .map((cell) => cell.trim())
      .filter(Boolean);
    const numbers = cells.slice(0, 2).map(Number);
    if (numbers.length === 2 && numbers.every(Number.isFinite)) points.push(numbers);
    else if (points.length || units) throw new Error(`“${line.trim()}” is no row of two numbers, radius and height`);
    else {
      units = unitsOf(cells, headed);
      headed = true;
    }
  }
  if (points.length < 4) throw new Error(`a profile needs at least four rows of radius and height, got ${points.length}`);
  return { points: units ? points.map(([r, f]) => [r * units[0], f * units[1]]) : points, metric: Boolean(units) };
}
/** A table as r,f;r,f;… as it is, or with six digits for the address. */
const packTable = (points, digits = 17) => points.map((row) => row.map((x) => +x.toPrecision(digits)).join(',')).join(';');
const unpackTable = (text) =>
  text
    .split(';')
    .map((row) => row.split(',').map(Number))
    .filter((row) => row.length === 2 && row.every(Number.isFinite));
/** The table as a file, in some units. */
const tableFile = ({ radius, height }) =>
  'r,f\n' +
  unpackTable(P.table)
    .map(([r, f]) => `${+(r * radius).toPrecision(15)},${+(f * height).toPrecision(15)}\n`)
    .join('')
    .replace(/e\+/g, 'e');
/** A tip on a shoulder: f = 0.3 r² + 0.3 (1 − exp(−(r/0.4)⁴)) comes off in two jumps. */
const EXAMPLE_TABLE = packTable(
  Array.from({ length: 33 }, (_, i) => i / 11).map((r) => [r, 0.3 * r * r - 0.3 * Math.expm1(-((r / 0.4) ** 4))]),
  6,
);
