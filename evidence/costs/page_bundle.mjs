// Bundles an entry with the modules that a page loads, minified: the size in bytes, compressed with gzip.
// node page_bundle.mjs ESBUILD ENTRY MODULES..., of which the first is esbuild's own module.
import { gzipSync } from "node:zlib";

const [esbuild, entry, ...modules] = process.argv.slice(2);
const { build } = await import(esbuild);
const loaded = new Set(modules);
const rest = {
  // what is loaded later stays outside
  name: "rest",
  setup(made) {
    made.onResolve({ filter: /^\./ }, ({ path, resolveDir }) => {
      const file = new URL(path, `file://${resolveDir}/`).pathname;
      return loaded.has(file) ? undefined : { path, external: true };
    });
  },
};
const { outputFiles } = await build({
  entryPoints: [entry],
  bundle: true,
  minify: true,
  format: "esm",
  target: "es2022",
  write: false,
  plugins: [rest],
});
console.log(gzipSync(outputFiles[0].contents, { level: 9 }).length);
