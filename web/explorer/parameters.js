// What can be chosen: the parameters of the page, the presets, and their limits.

const DEFAULTS = {
  shape: 'power',
  n: 2,
  rho: 1,
  R: 1.3,
  A: 0.06816,
  L: 1.16754,
  table: EXAMPLE_TABLE,
  smooth: 0, // the length over which a table is smoothed; 0: its rows as they are
  medium: 'half',
  grade: 0.5, // k of a half-space with E ∝ zᵏ
  alpha: 0.4, // Johnson's measure of the adhesion of waves
  w1: 1, // the work of adhesion of an edge that advances, in that of one that recedes
  control: 'd',
  k: 1,
  axis: 'lin',
  unit: 'none',
  uR: 1e-6,
  uE: 1e6,
  uw: 0.05,
  view: 'body',
  graph: 'force',
  ghost: 'off',
};
const PRESETS = [
  [
    'JKR sphere',
    { v: 0.25 },
    'A sphere, n = 2, held at a depth. Pull: at P the curves touch, and the contact breaks from a finite radius.',
  ],
  [
    'Through n = ½',
    { n: 0.8, axis: 'sqrt', v: 0 },
    'At zero depth the curves cross at R₀ for every n. Drag n down through ½: stable becomes unstable, and pull-off becomes complete contact.',
  ],
  [
    'Sharp tip',
    { n: 0.25, axis: 'sqrt', v: 0.12, start: 'smallest' },
    'n = ¼. Pulling never breaks it at a finite force, yet press it far enough and it turns tensile, and the surfaces come into contact everywhere.',
  ],
  [
    'Dead load',
    { control: 'F', v: 0.3 },
    'The sphere under a weight. It lets go earlier, at F = −¾ (that is −(3/2)πwR), and with a larger contact.',
  ],
  [
    'Three folds',
    { n: 0.65, rho: 1.82, control: 'D', k: 0.891, axis: 'sqrt', graph: 'fold', v: -0.02, start: 'detached' },
    'On a machine of finite stiffness, ½ < n < 0.768: two jumps in, two jumps out. Stiffen or soften the machine, and two of the folds meet and vanish.',
  ],
  [
    'Figure 4: wavy sphere',
    { shape: 'wavy', v: 0 },
    'Figure 4 of the paper: a slight waviness. Pulled off, the contact jumps from crest to crest before it breaks.',
  ],
  [
    'Short waves',
    { shape: 'wavy', A: 0.0273, L: 0.35, v: 0.2 },
    'Shorter waves: more jumps, and each costs energy. Guduru’s toughening. Watch the lost energy add up.',
  ],
  [
    'True sphere',
    { shape: 'sphere', R: 1.25, v: 0.3 },
    'No parabola: the contact can never pass the equator, and g grows without bound towards it.',
  ],
  [
    'Cone',
    { n: 1, v: 0.25 },
    'n = 1. The same story with another end: the force is never as strong as for the sphere, and it breaks at a smaller radius.',
  ],
  [
    'AFM cantilever',
    { control: 'D', k: 0.2, v: 0.5, unit: 'afm' },
    'A tip of 20 nm on a polymer, on a cantilever of 1 N/m: the base is moved, and the tip jumps in and off. Read the force in nN.',
  ],
  ['Your own tip', { shape: 'table', v: 0.3 }, 'A profile of your own: draw it, or paste a table of radius and height.'],
  [
    'Two works of adhesion',
    { w1: 0.25, v: 0.1, start: 'smallest' },
    'Surfaces that have touched hold four times as firmly as they attract. Drawn back, the edge stays where it is: pinned. Press further, and it takes more to part them.',
  ],
  [
    'Graded half-space',
    { medium: 'graded', grade: 0.5, v: 0.25 },
    'The modulus grows with the depth as E ∝ zᵏ. From k = 0, the half-space, towards 1, where the springs no longer act on each other.',
  ],
  [
    'Johnson’s wave',
    { medium: 'wave', control: 'F', alpha: 0.4, v: 0.05, start: 'smallest' },
    'A slightly wavy surface on another, one strip in contact in each period. Pressed on, it snaps into complete contact, and does not come off again.',
  ],
];
/** Which of them is the tip that is drawn. */
const OWN_TIP = PRESETS.findIndex(([name]) => name === 'Your own tip');
const SLIDERS = {
  // label, symbol, from, to, logarithmic, ticks, shown when
  n: [
    'exponent',
    'n',
    0.1,
    4,
    true,
    [
      [0.25, '¼'],
      [0.5, '½'],
      [1, 'cone 1'],
      [2, 'sphere 2'],
      [4, '4'],
    ],
    () => P.shape === 'power' && !onWave(),
  ],
  rho: [
    'steepness g(R₀)/Δl₀',
    'ρ',
    0.4,
    4,
    true,
    [
      [0.5, '½'],
      [1, '1'],
      [2, '2'],
      [3, '3'],
    ],
    () => (P.shape === 'power' || P.shape === 'wavy') && !onWave(),
  ],
  R: [
    'radius of the sphere',
    'R',
    1.05,
    6,
    true,
    [
      [1.05, '1.05'],
      [2, '2'],
      [4, '4'],
    ],
    () => P.shape === 'sphere' && !onWave(),
  ],
  A: [
    'amplitude of the waves',
    'A',
    0,
    0.2,
    false,
    [
      [0, 'none'],
      [0.1, '0.1'],
      [0.2, '0.2'],
    ],
    () => P.shape === 'wavy' && !onWave(),
  ],
  L: [
    'wavelength',
    'λ',
    0.25,
    2,
    true,
    [
      [0.25, '¼'],
      [0.5, '½'],
      [1, '1'],
      [2, '2'],
    ],
    () => P.shape === 'wavy' && !onWave(),
  ],
  k: [
    'stiffness of the machine',
    'k',
    0.03,
    100,
    true,
    [
      [0.03, 'dead load'],
      [1, '1'],
      [100, 'fixed grips'],
    ],
    () => P.control === 'D',
  ],
  grade: [
    'of the grading E ∝ zᵏ',
    'k',
    -0.5,
    0.9,
    false,
    [
      [-0.5, '−½'],
      [0, 'half-space 0'],
      [0.5, '½'],
      [0.9, '0.9'],
    ],
    () => P.medium === 'graded',
  ],
  alpha: [
    'adhesion of the waves',
    'α',
    0.1,
    1.2,
    false,
    [
      [0.1, '0.1'],
      [0.57, '0.57'],
      [1.065, '1.065'],
    ],
    onWave,
  ],
  w1: [
    'work as the edge advances',
    'w₁/w₂',
    0,
    1,
    false,
    [
      [0, 'none'],
      [0.25, '¼'],
      [0.5, '½'],
      [1, 'as on the way out'],
    ],
    () => true,
  ],
};
/** What the sliders stand for, where units are shown: see scale(). */
const SHOWN_AS = { R: 'a', A: 'd', L: 'a', k: 'k' };
const CHOICES = {
  shape: ['power', 'sphere', 'wavy', 'table'],
  medium: ['half', 'graded', 'springs', 'wave'],
  control: ['d', 'F', 'D'],
  axis: ['lin', 'sqrt', 'log'],
  unit: Object.keys(UNITS),
  view: ['body', 'scale', 'springs'],
  graph: ['force', 'fold'],
  ghost: ['off', 'on'],
};
/** E*, w and R of one's own, SI: what is allowed. */
const OWN = { uR: [1e-10, 1e4], uE: [1e-2, 1e13], uw: [1e-9, 1e4] };
/** The symbol, the unit, and the powers of ten of the units that may be written for each of them. */
const OWN_UNITS = {
  uR: ['R', 'm', { m: 0, mm: -3, um: -6, µm: -6, μm: -6, nm: -9, pm: -12 }],
  uE: ['E*', 'Pa', { Pa: 0, kPa: 3, MPa: 6, GPa: 9 }],
  uw: ['w', 'J/m²', { 'J/m²': 0, 'J/m^2': 0, 'mJ/m²': -3, 'mJ/m^2': -3, 'N/m': 0, 'mN/m': -3 }],
};
const CONTROLS = {
  d: ['depth d', 'Depth held', 'depth d'],
  F: ['force F', 'Force held', 'force F'],
  D: ['machine', 'Position of the machine', 'position D'],
};
/** The words of a control: on a button, above its slider, and in a sentence. On a wave forces are mean pressures. */
const controlWords = () => (onWave() && P.control === 'F' ? ['pressure', 'Mean pressure held', 'mean pressure F'] : CONTROLS[P.control]);
/** Of waves, folds without end: beyond this radius neither folds nor the range of the control are shown. */
const WAVES_SHOWN = 1.45;
/** Near n = ½ folds are at 10¹⁷⁵ R₀: the range of the control does not go so far. */
const FOLDS_SHOWN = 1e3;
