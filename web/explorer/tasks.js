// Guided tasks: predict first, then play and measure.

/** A preset with parameters beside it, the value to begin at, and the end of the range to which the control goes. The quantity that is
 * guessed is the value of the control at the first event of these kinds, or at the last one. `press`: where it is pressed to before. */
const TASKS = [
  {
    name: 'JKR', number: 0, from: 0.25, to: 'low', kinds: ['detached'],
    question: 'The ball is pulled up. At which depth does it let go?',
  },
  {
    name: 'Depth or weight', number: 3, from: 0.3, to: 'low', kinds: ['detached'],
    question: 'Now a weight pulls, and not a grip. At which force does it let go?',
  },
  {
    name: 'Through n = ½', number: 1, parameters: { n: 0.3 }, from: -0.3, to: 'high', kinds: ['complete'],
    question: 'An exponent of 0.3 is pressed, from apart. At which depth do the surfaces come into complete contact?',
  },
  {
    name: 'Sharp tip', number: 2, from: 0.12, to: 'high', kinds: ['complete'],
    question: 'Pressed further, this tip suddenly sinks in. At which depth?',
  },
  {
    name: 'Three folds', number: 4, from: -0.02, to: 'high', kinds: ['jump', 'jump-in'], last: true,
    question: 'The machine presses. At which of its positions does the contact jump for the last time on the way in?',
  },
  {
    name: 'Waves', number: 5, from: 0, to: 'low', kinds: ['jump', 'detached'],
    question: 'Pulled off a wavy ball, the contact first jumps from crest to crest. At which depth does that begin?',
  },
  {
    name: 'Two works of adhesion', number: 11, parameters: { w1: 0.05, control: 'F' }, from: -0.05, to: 'low', press: 0.05, kinds: ['detached'],
    question: 'Surfaces that have touched hold twenty times as firmly as they attract. The ball is pressed lightly, by a force of %, and pulled. At which force does it let go?',
  },
];
let task = -1;
const done = new Set();

function openTask(index) {
  const { name, number, parameters, from, press, question } = TASKS[index];
  task = index;
  preset(number);
  if (parameters) change(parameters);
  value = within(from, range);
  const apart = press || (from < 0 && P.control === 'd' && P.n < 0.5);
  S = settle(apart ? 'detached' : origin.start);
  clearTrail();
  origin = { value, start: origin.start };
  if (press) {
    move(press);
    finish();
    note = '';
  }
  $('tasks').hidden = false;
  $('note').textContent = ''; // that of the preset may give the answer away
  $('task-text').textContent = `Task ${index + 1} of ${TASKS.length}, ${name}. ${question.replace('%', show(press, heldKind()))} Drag your guess.`;
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
  set($('guess'), { 'aria-valuetext': `${controlWords()[2]} ${text}` });
}
/** Moves the control to the end of the task; what the guess was off by. */
function measure() {
  const { to: end, kinds, last } = TASKS[task];
  const to = end === 'low' ? range[0] : range[1];
  const events = engine.advance(S.kind === 1 ? S.a : -1, value, to) || [];
  const found = events.filter(([number]) => kinds.includes(KINDS[number]));
  const event = last ? found[found.length - 1] : found[0];
  remember('task');
  note = '';
  move(to);
  $('guess').disabled = $('task-play').disabled = true;
  if (!event) return void ($('task-answer').textContent = 'Nothing of the kind has happened here.');
  const [guess, at] = [+$('guess').value, event[1]];
  const off = Math.abs(guess - at) / (range[1] - range[0]);
  const words = off < 0.02 ? 'Very close.' : off < 0.08 ? 'Near.' : 'Far off: look at the two curves where they touch.';
  $('task-answer').textContent =
    `It happens at ${controlWords()[2]} = ${show(at, heldKind())}; your guess was ${show(guess, heldKind())}. ${words}`;
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
