// What the pages of the book keep, and what this page keeps for them.

const keep = (name, what) => {
  try {
    localStorage.setItem(name, what);
  } catch {
    // no storage for this page
  }
};
const kept = (name) => {
  try {
    return localStorage.getItem(name);
  } catch {
    return null;
  }
};
/** The fonts of the book, where its pages have said that they lie beside this one: alone, the page asks nobody for anything. */
function bookFonts() {
  if (kept('mdr-fonts') !== new URL('.', location.href).href) return;
  for (const [family, file, style] of [
    ['Pagella', 'pagella-regular', {}],
    ['Pagella', 'pagella-italic', { style: 'italic' }],
    ['Pagella', 'pagella-bold', { weight: '700' }],
    ['Inter', 'inter-regular', {}],
    ['Inter', 'inter-semibold', { weight: '600' }],
  ]) {
    const face = new FontFace(family, `url(fonts/${file}.woff2)`, style);
    face.load().then(
      (loaded) => document.fonts.add(loaded),
      () => {},
    );
  }
}
