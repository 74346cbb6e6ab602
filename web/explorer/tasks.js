// Guided tasks: predict first, then play and measure.

/** Name, index of a preset, parameters beside it, the value to begin at, where the control goes, the event that is asked for, and
 * the question. The quantity that is guessed is the value of the control at the event. */
const TASKS = [
  ['JKR', 0, {}, 0.25, 'low', ['detached'], 'The ball is pulled up. At which depth does it let go?'],
  ['Depth or weight', 3, {}, 0.3, 'low', ['detached'], 'Now a weight pulls, and not a grip. At which force does it let go?'],
  ['Through n = ½', 1, { n: 0.3 }, -0.3, 'high', ['complete'], 'An exponent of 0.3 is pressed, from apart. At which depth do the surfaces come into complete contact?'],
  ['Sharp tip', 2, {}, 0.12, 'high', ['complete'], 'Pressed further, this tip suddenly sinks in. At which depth?'],
  ['Three folds', 4, {}, -0.02, 'high', ['jump', 'jump-in'], 'The machine presses. At which of its positions does the contact jump for the last time on the way in?'],
  ['Waves', 5, {}, 0, 'low', ['jump', 'detached'], 'Pulled off a wavy ball, the contact first jumps from crest to crest. At which depth does that begin?'],
];
/** Tasks that ask for the last event of their kind, not for the first. */
const LAST = new Set([4]);
let task = -1;
const done = new Set();

function openTask(index) {
  const [, number, parameters, from, , , question] = TASKS[index];
  task = index;
  preset(number);
  if (Object.keys(parameters).length) change(parameters);
  value = within(from, range);
  S = settle(from < 0 && P.control === 'd' && P.n < 0.5 ? 'detached' : origin.start);
  clearTrail();
  origin = { value, start: origin.start };
  $('tasks').hidden = false;
  $('task-text').textContent = `Task ${index + 1} of ${TASKS.length}, ${TASKS[index][0]}. ${question} Drag your guess.`;
  $('task-answer').textContent = '';
  const guess = $('guess');
  set(guess, { min: range[0], max: range[1] });
  guess.value = range[0] + 0.5 * (range[1] - range[0]);
  guess.disabled = $('task-play').disabled = false;
  showGuess();
  request();
}
function showGuess() {
  const text = show(+$('guess').value, heldKind());
  $('guess-out').textContent = text;
  set($('guess'), { 'aria-valuetext': `${CONTROLS[P.control][2]} ${text}` });
}
/** Moves the control to the end of the task; what the guess was off by. */
function measure() {
  const [, , , , end, kinds] = TASKS[task];
  const to = end === 'low' ? range[0] : range[1];
  const events = engine.advance(S.kind === 1 ? S.a : -1, value, to) || [];
  const found = events.filter(([number]) => kinds.includes(KINDS[number]));
  const event = LAST.has(task) ? found[found.length - 1] : found[0];
  remember('task');
  note = '';
  move(to);
  $('guess').disabled = $('task-play').disabled = true;
  if (!event) return void ($('task-answer').textContent = 'Nothing of the kind has happened here.');
  const [guess, at] = [+$('guess').value, event[1]];
  const off = Math.abs(guess - at) / (range[1] - range[0]);
  const words = off < 0.02 ? 'Very close.' : off < 0.08 ? 'Near.' : 'Far off: look at the two curves where they touch.';
  $('task-answer').textContent =
    `It happens at ${CONTROLS[P.control][2]} = ${show(at, heldKind())}; your guess was ${show(guess, heldKind())}. ${words}`;
  done.add(task);
  saveSoon();
}
function closeTasks() {
  task = -1;
  $('tasks').hidden = true;
  saveSoon();
}
/** The buttons; `tasks=` of the address holds the one that is open and those that are done. */
function tasks() {
  const button = document.createElement('button');
  Object.assign(button, { type: 'button', id: 'tasks-open', textContent: 'Predict it …' });
  button.onclick = () => {
    turnPage();
    openTask([...TASKS.keys()].find((i) => !done.has(i)) || 0);
    $('guess').focus();
  };
  $('presets').prepend(button);
  $('guess').oninput = showGuess;
  $('task-play').onclick = measure;
  $('task-next').onclick = () => openTask((task + 1) % TASKS.length);
  $('task-close').onclick = closeTasks;
}
const taskAddress = () => (task < 0 ? [] : [`task=${task + 1}`]).concat(done.size ? `done=${[...done].map((i) => i + 1).join('.')}` : []);
/** Opens the task of an address; true where it names one. */
function restoreTask(query) {
  for (const i of (query.get('done') || '').split('.').map((x) => x - 1)) if (TASKS[i]) done.add(i);
  const index = Number(query.get('task')) - 1;
  if (TASKS[index]) openTask(index);
  else if (task >= 0) closeTasks();
  return Boolean(TASKS[index]);
}
