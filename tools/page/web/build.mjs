// Bundles the script and the style sheet of the report page.
//
//   node build.mjs PACKAGES OUTPUT    PACKAGES holds node_modules; OUTPUT gets page.js and page.css
//
// The page holds them inline and loads nothing, so the script is one function without imports.
import { createRequire } from 'node:module';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const here = path.dirname(fileURLToPath(import.meta.url));
const [packages = here, output = path.join(here, 'dist')] = process.argv.slice(2);
const esbuild = createRequire(path.join(path.resolve(packages), 'package.json'))('esbuild');

await esbuild.build({
  entryPoints: [path.join(here, 'src/page.js'), path.join(here, 'src/page.css')],
  nodePaths: [path.join(path.resolve(packages), 'node_modules')],
  outdir: output,
  bundle: true,
  minify: true,
  format: 'iife',
  target: ['chrome109', 'firefox115', 'safari16'],
  charset: 'utf8',
  legalComments: 'eof',  // three.js and fflate are MIT: their notices go along
  logLevel: 'warning',
});
