// A profile of one's own, drawn or pasted; and the pictures to take away.

const pad = {
  /** The profile that is open, and its text where that is not being typed. */
  show() {
    const units = system();
    const points = unpackTable(P.table);
    if (document.activeElement !== $('table-text')) $('table-text').value = tableFile(units);
    const [width, height] = [300, 150];
    this.right = this.dragging ? this.right : Math.max(...points.map(([r]) => r));
    this.top = this.dragging ? this.top : 1.15 * Math.max(...points.map(([, f]) => f));
    const line = points.map(
      ([r, f]) => `${((r / this.right) * width).toFixed(1)} ${(height - 8 - (f / this.top) * (height - 16)).toFixed(1)}`,
    );
    set($('pad').querySelector('path'), { d: `M${line.join('L')}` });
  },
  /** The row next to the pointer takes its height; between two events, all that were passed. */
  draw(e) {
    const box = $('pad').getBoundingClientRect();
    const r = within(((e.clientX - box.left) / box.width) * this.right, [0, this.right]);
    const f = ((box.bottom - e.clientY) / box.height) * 150;
    const to = [r, Math.max(0, ((f - 8) / 134) * this.top)];
    const from = this.last || to;
    this.last = to;
    const [low, high] = [Math.min(from[0], r), Math.max(from[0], r)];
    const step = this.right / (this.points.length - 1) / 2;
    this.points.forEach((point, i) => {
      if (i === 0 || point[0] < low - step || point[0] > high + step) return;
      const t = high > low ? within((point[0] - from[0]) / (to[0] - from[0]), [0, 1]) : 1;
      point[1] = from[1] + t * (to[1] - from[1]);
    });
    change({ table: packTable(this.points, 6) });
  },
  begin() {
    this.dragging = true;
    this.last = null;
    const known = unpackTable(P.table);
    const at = (r) => {
      const i = Math.max(
        1,
        known.findIndex((row) => row[0] >= r),
      );
      const [[r0, f0], [r1, f1]] = [known[i - 1], known[i]];
      return r <= known[0][0] ? known[0][1] : f0 + ((f1 - f0) * (r - r0)) / (r1 - r0);
    };
    this.points = Array.from({ length: 33 }, (_, i) => (i / 32) * this.right).map((r) => [r, r ? at(r) : 0]);
  },
  paste(text) {
    let table;
    try {
      table = readTable(text);
    } catch (error) {
      return this.refuse(error.message);
    }
    // A table in metres needs units to be shown in, and so small radii are metres without saying so.
    const widest = Math.max(...table.points.map(([r]) => r));
    if (P.unit === 'none' && (table.metric || widest < 1e-3)) {
      Object.assign(P, { unit: 'own', uR: 2 * widest, uE: widest < 1e-6 ? 1e9 : P.uE });
    }
    const { radius, height } = system();
    const points = table.points.map(([r, f]) => [r / radius, f / height]);
    change({ shape: 'table', table: packTable(points) });
    return this.refuse(trouble);
  },
  refuse(words) {
    $('table-note').textContent = words ? `Refused: ${words}` : '';
  },
};

// ---------------------------------------------------------------- to take away
function download(name, type, text) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
/** The pictures as one SVG with the colours that are shown. */
function picture() {
  const style = getComputedStyle(document.documentElement);
  const colours = ['bg', 'panel', 'ink', 'muted', 'line', 'grid', 'adh', 'ela', 'loss', 'body', 'body-edge', 'half', 'half-edge'];
  const variables = colours.map((name) => `--${name}:${style.getPropertyValue('--' + name).trim()}`).join(';');
  const rules = [...$('figures').sheet.cssRules].map((rule) => rule.cssText);
  const shapes = PARTS.map((id) => $(id)).map((svg) => [svg, svg.getBoundingClientRect()]);
  const left = Math.max(shapes[0][1].width, shapes[1][1].width);
  const right = Math.max(shapes[2][1].width, shapes[3][1].width);
  const heights = shapes.map(([, box]) => box.height);
  const at = [
    [0, 0],
    [0, heights[0] + 16],
    [left + 16, 0],
    [left + 16, heights[2] + 16],
  ];
  const size = [left + right + 16, Math.max(heights[0] + heights[1], heights[2] + heights[3]) + 16];
  const parts = shapes.map(([svg, box], i) => {
    const copy = svg.cloneNode(true);
    for (const name of ['role', 'aria-labelledby', 'id']) copy.removeAttribute(name);
    copy.querySelectorAll('.hit, .probe, [display="none"]').forEach((node) => node.remove());
    Object.entries({ x: at[i][0], y: at[i][1], width: box.width, height: box.height }).forEach(([k, v]) =>
      copy.setAttribute(k, v),
    );
    return new XMLSerializer().serializeToString(copy).replaceAll('xmlns="http://www.w3.org/2000/svg" ', '');
  });
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="-16 -16 ${size[0] + 32} ${size[1] + 32}" width="${size[0] + 32}" height="${size[1] + 32}">
<title>An adhesive contact: ${$('value-label').textContent} ${$('value-out').textContent}</title><desc>${$('story').textContent}</desc>
<style>svg{${variables}} ${rules.join(' ').replaceAll('<', '&lt;')}</style>
<rect x="-16" y="-16" width="100%" height="100%" style="fill:var(--panel)"/>
${parts.join('\n')}
</svg>
`;
}
