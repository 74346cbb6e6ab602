// By hand: what is dragged in a picture.

function drag(node, begin, step, end) {
  node.addEventListener('pointerdown', (e) => {
    e.preventDefault();
    node.setPointerCapture(e.pointerId);
    stop();
    remember.what = '';
    note = '';
    const memory = begin(e);
    const go = (m) => {
      note = '';
      step(m, memory);
    };
    node.addEventListener('pointermove', go);
    const done = (m) => {
      node.removeEventListener('pointermove', go);
      node.removeEventListener('pointerup', done);
      node.removeEventListener('pointercancel', done);
      if (end) end(m, memory);
    };
    node.addEventListener('pointerup', done);
    node.addEventListener('pointercancel', done);
  });
}
function pointers() {
  const share = () => (range[1] - range[0]) / 260; // of the control for a pixel, where it is no length
  const pull = (to) => {
    remember('drag');
    move(to);
  };
  const vertical = (plot) => (e, m) => pull(m.value + (at(e).y - m.y) * (P.control === 'd' ? plot.perY() : share()));
  const at = (e) => ({ x: e.clientX / magnification(), y: e.clientY / magnification() });
  const grip = (e) => ({ ...at(e), value });
  drag(balance.hit, grip, vertical(balance));
  drag(body.solid, grip, vertical(body));
  drag(force.hit, grip, (e, m) => {
    const up = -(at(e).y - m.y) * force.perY();
    if (P.graph === 'fold') return pull(m.value + up);
    const across = ((at(e).x - m.x) * (force.now[1] - force.now[0])) / (force.box[2] - force.box[0]);
    pull(m.value + controlled(across, up));
  });
  const hold = (e) => {
    if (S.kind !== 1) return;
    probe = Math.min(reach, balance.radius((e.clientX - balance.svg.getBoundingClientRect().left) / magnification()));
    request();
  };
  drag(balance.handle, () => ({}), hold, release);
  balance.handle.onkeydown = (e) => {
    const step = { ArrowLeft: -1, ArrowRight: 1, ArrowDown: -1, ArrowUp: 1 }[e.key];
    if (step) stop();
    if (step && S.kind === 1) probe = within((probe || S.a) + step * reach * 0.02, [1e-5, reach]);
    else if (e.key === 'Enter' || e.key === ' ') release();
    else if (e.key === 'Escape') probe = null;
    else return;
    e.preventDefault();
    request();
  };
  balance.handle.onblur = release;
}
