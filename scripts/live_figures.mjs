// The still pictures of the book's figures that move: book/assets/live, one for each line of FIGURES in book/src/spine.rs, as the
// explorer draws them, light and dark in one file. After `make site`: node scripts/live_figures.mjs
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { launch, open } from '../web/tests/browser.mjs';

const source = readFileSync(new URL('../book/src/spine.rs', import.meta.url), 'utf8');
const figures = [...source.matchAll(/live\(\s*"([\w-]+)",\s*"([^"]*)",\s*"(\w+)",/g)];
const folder = new URL('../book/assets/live/', import.meta.url);
mkdirSync(folder, { recursive: true });
const browser = await launch();
for (const [, name, state, only] of figures) {
  const drawn = {};
  for (const colorScheme of ['light', 'dark']) {
    const page = await open(browser, `#${state}&only=${only}`, { colorScheme, viewport: { width: 760, height: 560 } });
    drawn[colorScheme] = await page.evaluate((only) => explorer.picture([only]), only);
    await page.close();
  }
  const colours = (svg) => svg.match(/<style>svg\{([^}]*?)[ }]/)[1];
  const dark = `@media (prefers-color-scheme:dark){svg{${colours(drawn.dark)}}}`;
  writeFileSync(new URL(`${name}.svg`, folder), drawn.light.replace('</style>', `${dark}</style>`));
  console.log(name);
}
await browser.close();
