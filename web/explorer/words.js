// What the page says of the contact, and the numbers beside it.

function tell() {
  const broken = degenerate
    ? `At n = ${P.n === 0.5 ? '½' : +P.n.toPrecision(4)} and ρ at its threshold the two curves are one: at d = 0 every radius is an equilibrium (1.19). `
    : '';
  let [text, tone] = [note, jumps ? 'jump' : 'stable'];
  if (trouble) [text, tone] = [`This profile is refused: ${trouble}`, 'over'];
  else if (probe) [text, tone] = tellProbe();
  else if (!text) [text, tone] = tellState(tone);
  const story = $('story');
  if (story.textContent === broken + text) return;
  story.textContent = broken + text;
  story.dataset.tone = tone;
}
function tellProbe() {
  const here = engine.at(value, probe);
  if (here && twoWorks() && excess(here[1], here[2]) === 0)
    return [`You hold the edge at a = ${len(probe)}. What it asks for lies between both works of adhesion: let go, and it stays.`, 'stable'];
  const grows = here && here[2] > here[1];
  const words = grows
    ? 'Δl exceeds g − d: let go, and the contact grows (1.9).'
    : 'g − d exceeds Δl: let go, and it shrinks (1.8).';
  return [`You hold the edge at a = ${len(probe)}. ${words}`, grows ? 'stable' : 'over'];
}
function tellState(tone) {
  if (S.kind === 2)
    return [
      'Complete contact: the surfaces touch everywhere, and no pulling within this theory parts them. Start again.',
      'over',
    ];
  if (S.kind === 0) return ['The surfaces are apart.' + (value < 0 ? ' Press to bring them together.' : ''), 'over'];
  if (S.poised)
    return [
      'Poised on an unstable equilibrium. Drag the edge ▲ a little, or the depth: it shrinks to nothing, or spreads over the whole surface.',
      tone,
    ];
  if (twoWorks()) return [tellEdge(), tone];
  // Without numbers: a screen reader reads it out whenever it changes.
  const stable = restingStates().length;
  return [
    stable > 1
      ? `Stable contact, one of ${stable} that are stable here: which one it is depends on the past.`
      : 'Stable contact.',
    tone,
  ];
}

/** Which of both works of adhesion holds the edge. */
function tellEdge() {
  const here = engine.at(value, S.a);
  const share = here ? here[1] / here[2] : 1;
  if (share > 1 - 1e-6) return 'Stable contact, the edge about to recede: it is held by the larger work of adhesion.';
  if (share < ofAdvancing() + 1e-6) return 'Stable contact, the edge about to advance: it is drawn by the smaller work of adhesion.';
  return 'Pinned: the contact keeps its size, as a spring does, until the larger work of adhesion is overcome, or the smaller one drawn upon.';
}

/** The force over that at the fold with the strongest pull, F/F_c. */
function overCritical(known) {
  const own = folds.filter((f) => !f.advancing);
  const [strongest] = [...own].sort((one, other) => one.F - other.F);
  if (!strongest || !strongest.F) return [];
  const name = own.length > 1 ? 'the strongest pull, F/F<sub>c</sub>' : 'that at P, F/F<sub>c</sub>';
  return [[`force over ${name}`, known ? minus((S.F / strongest.F).toFixed(3)) : '—']];
}

function readout() {
  const known = S.kind !== 2;
  const table = [
    [`${radiusName()} a`, S.kind === 1 ? len(S.a) : known ? '0' : '∞'],
    ['depth d', known ? show(S.d, 'd') : '—'],
    ['force F', known ? show(S.F, 'F') : '—'],
    ...overCritical(known),
    [twoWorks() ? 'energy lost in jumps' : 'energy lost', unbounded ? '∞' : show(lostTotal, 'E', 4)],
    ...(twoWorks() ? [['lost by the edge that recedes', show(receded, 'E', 4)]] : []),
    ['folds', String(folds.length)],
  ];
  if (P.control === 'D') table.splice(2, 0, ['stiffness k', show(P.k, 'k')]);
  $('readout').innerHTML = table.map(([k, v]) => `<tr><th scope="row">${k}</th><td>${v}</td></tr>`).join('');
  const text = show(value, heldKind());
  $('value-out').textContent = text;
  const state = S.kind === 1 ? 'contact radius ' + len(S.a) : S.kind ? 'complete contact' : 'apart';
  set($('value'), { min: range[0], max: range[1], 'aria-valuetext': `${controlWords()[1]} ${text}; ${state}` });
  $('value').value = value;
  checkSoon();
  Object.assign($('explorer').dataset, {
    control: P.control,
    shape: P.shape,
    value: String(value),
    state: ['detached', 'contact', 'complete'][S.kind],
    ended,
    a: String(S.a),
    d: String(S.d),
    force: String(S.F),
    lost: String(lostTotal),
    receded: String(receded),
    unbounded,
    jumps,
    folds: folds.length,
    degenerate,
    failures,
  });
  const scene = $('scene');
  if (scene.closest('details').open) scene.textContent = sceneFile();
}

let checking = 0;
/** The second route takes longer than a frame may: it is asked when the contact has come to rest. */
function checkSoon() {
  clearTimeout(checking);
  checking = setTimeout(check, 80);
}
function check() {
  const checked = S.kind === 1 && S.a > 1e-9 && S.a < 0.999 * engine.outer() ? engine.verify(S.a) : null;
  const differ = checked && (checked[2] < 1e-16 ? 'nothing' : checked[2].toExponential(0));
  $('check').textContent = checked ? `Checked live: g(a) by its closed form and by quadrature of (1.1) differ by ${differ}.` : '';
  $('explorer').dataset.check = checked ? checked[2] : '';
}
