// The address: the state of the page, and the steps of the button Back.

function address() {
  const written = (k) => {
    if (k === 'table') return packTable(unpackTable(P.table), 6);
    return typeof P[k] === 'number' ? +P[k].toPrecision(6) : P[k];
  };
  const ofTable = (k) => k === 'table' || k === 'smooth';
  const skipped = (k) => P[k] === DEFAULTS[k] || (ofTable(k) && P.shape !== 'table') || (k in OWN && P.unit !== 'own');
  const parts = Object.keys(DEFAULTS)
    .filter((k) => !skipped(k))
    .map((k) => `${k}=${written(k)}`);
  const { only, mode } = document.body.dataset;
  if (only) parts.push(`only=${only}`);
  if (mode) parts.push(mode);
  parts.push(...taskAddress());
  parts.push(`v=${+value.toPrecision(5)}`, `a=${S.kind === 1 ? +S.a.toPrecision(5) : S.kind === 2 ? 'all' : 0}`);
  return '#' + parts.join('&');
}
const ONLY = ['balance', 'body', 'force'];
/** Rubbish is left out or clipped; a long table is `weighed` first. */
function restore(hash, weighed) {
  const query = new URLSearchParams(hash.slice(1));
  const only = query.get('only');
  if (ONLY.includes(only)) document.body.dataset.only = only;
  lecture(query.has('lecture'));
  stop();
  finish();
  probe = null;
  note = '';
  if (restoreTask(query)) return undefined;
  if (!query.has('v')) return preset(0);
  P = { ...DEFAULTS };
  for (const [key, text] of query) {
    const span = SLIDERS[key] ? SLIDERS[key].slice(2, 4) : OWN[key];
    if (span && text.trim() !== '' && Number.isFinite(+text)) P[key] = within(+text, span);
    else if (CHOICES[key] && CHOICES[key].includes(text)) P[key] = text;
    else if (key === 'table' && unpackTable(text).length >= 4) P.table = packTable(unpackTable(text));
    else if (key === 'smooth' && +text > 0 && Number.isFinite(+text)) P.smooth = +text;
  }
  if (P.shape === 'table' && !P.smooth && !weighed && unpackTable(P.table).length > FEW_ROWS) return weighFirst(hash, P.table);
  Object.assign(P, together(P.shape === 'power' ? {} : { shape: P.shape }));
  if (!rebuild()) {
    P = { ...DEFAULTS };
    rebuild();
  }
  value = within(+query.get('v') || 0, range);
  const a = query.get('a');
  S = a === '0' ? away() : a === 'all' ? complete() : +a > 0 ? settle('nearest', +a) : settle('largest');
  clearTrail();
  origin = { value, start: 'largest' };
  markPreset();
  sync();
}

/** A tip that is quick to follow, while the table of an address is weighed. */
function weighFirst(hash, table) {
  preset(OWN_TIP);
  weigh(table).then((found) => pad.offer(found, (smooth) => restore(smooth ? `${hash}&smooth=${smooth}` : hash, true)));
}

let saving = 0;
let ownAddress = '';
let step = false; // whether the next address is a step of its own for the button Back of the browser
function saveSoon() {
  if (!saving) saving = setTimeout(save, 300);
}
/** What follows can be taken back by the button Back of the browser; a frame leaves that of its page alone. */
function turnPage() {
  if (!$('explorer').dataset.ready.startsWith('t') || document.body.dataset.only) return;
  clearTimeout(saving);
  save();
  step = true;
}
function save() {
  saving = 0;
  const hash = address();
  // Another address that a reader has just given is about to be followed.
  if (hash === location.hash || location.hash !== ownAddress) return;
  try {
    history[step ? 'pushState' : 'replaceState'](null, '', hash);
    step = false;
  } catch {
    location.replace(hash);
  }
  // As the browser writes it.
  ownAddress = location.hash;
}
