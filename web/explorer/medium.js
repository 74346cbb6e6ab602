// What the body is pressed into: Δl(a) and the stiffness of its springs, and two works of adhesion.

/** The period of a wave, in R₀: a strip in contact is at most one R₀ wide on each side. */
const PERIOD = 2;
const onWave = () => P.medium === 'wave';
/** Whether an edge that recedes needs another work of adhesion than one that advances gains. */
const twoWorks = () => P.w1 < 1;
/** Waves that are higher than this for their length make folds by the hundred. */
const highestWaves = ({ L, rho }) => 0.5 * L * L * rho;
/** Parameters with what has to go with them: off a half-space g of a power law is a closed form, and that of other shapes takes
 * too long for a page; so do folds by the thousand. */
function together(parameters) {
  const next = { ...P, ...parameters };
  const all = { ...parameters };
  const apart = next.medium === 'wave' ? 'shape' in parameters : next.medium !== 'half' && next.shape !== 'power';
  if (apart && 'shape' in parameters) all.medium = 'half';
  else if (apart) all.shape = 'power';
  if (next.shape === 'wavy') all.A = Math.min(next.A, highestWaves(next));
  return all;
}
/** t = tan(πa/λ) and Λ = ln(1 + 1/t²) of a strip in each period. */
function strip(a) {
  const t = Math.tan((Math.PI * within(a, [1e-9, 1 - 1e-9])) / PERIOD);
  return [t, Math.log1p(1 / (t * t))];
}
/** Half of the height of Johnson's wave from a trough to a crest: h₀ = √(2wλ/π²E*)/α. */
const amplitude = () => Math.sqrt((2 * WORK * PERIOD) / Math.PI ** 2) / P.alpha;
/** Δl(a), what adhesion can hold; with two works of adhesion at an edge that recedes. */
function elongation(a) {
  if (onWave()) {
    const [t, logarithm] = strip(a);
    return amplitude() * P.alpha * logarithm * Math.sqrt(t);
  }
  return { half: Math.sqrt(a), graded: a ** ((1 - P.grade) / 2), springs: 1 }[P.medium];
}
/** The exponent of Δl(a), where the regimes of power laws meet: ½, (1 − k)/2, or 0. */
const meeting = () => ({ half: 0.5, graded: (1 - P.grade) / 2, springs: 0, wave: 0.5 })[P.medium];
/** Of Δl(a), what an edge that advances can hold: Δl grows with the root of the work. */
const ofAdvancing = () => Math.sqrt(P.w1);
/** S(a), the stiffness of a contact of a size that is held. */
function stiffness(a) {
  if (onWave()) return Math.PI / (PERIOD * strip(a)[1]);
  return { half: 2 * a, graded: (2 * a ** (1 + P.grade)) / (1 + P.grade), springs: a * a }[P.medium];
}
/** S'(a)/2: the energy changes with the radius as this times (g − d)² − Δl². */
function weight(a) {
  if (onWave()) {
    const [t, logarithm] = strip(a);
    return (Math.PI / PERIOD) ** 2 / (t * logarithm * logarithm);
  }
  return { half: 1, graded: a ** P.grade, springs: a }[P.medium];
}
/** By how much g − d exceeds what holds the edge: negative where it advances, 0 where it is pinned. */
function excess(y, most) {
  const least = twoWorks() ? most * ofAdvancing() : most;
  return y < least ? y - least : y > most ? y - most : 0;
}
/** What drives the edge, (g − d)² − Δl², with the work of adhesion of the way that it goes. */
function drive(y, most) {
  const least = twoWorks() ? most * ofAdvancing() : most;
  return y < least ? y * y - least * least : y > most ? y * y - most * most : 0;
}
/** [medium] of a scene in some units; nothing for a half-space. */
function mediumLines({ radius, modulus }) {
  return {
    half: [],
    graded: ['kind = "graded"', `exponent = ${P.grade}`, `coefficient = ${modulus / radius ** P.grade}`],
    springs: ['kind = "winkler"', `modulus = ${modulus / (Math.PI * radius)}`],
    wave: ['kind = "periodic"', `wavelength = ${PERIOD * radius}`],
  }[P.medium];
}
/** The same in words. */
const mediumInWords = () =>
  ({ half: '', graded: 'half-space graded as E ∝ zᵏ', springs: 'Winkler foundation', wave: 'wave' })[P.medium];
