// What the bundles of the browser's files share, and the way from plain names to hashed ones.

import path from "node:path";

// What the browsers that run this site understand: light-dark(), nested CSS.
const targets = ["chrome123", "firefox121", "safari17.5"];

// How esbuild makes all of them, of the sources in `site`.
export const forBrowsers = (site, out) => ({
  absWorkingDir: site,
  outdir: path.resolve(out),
  bundle: true,
  minify: true,
  charset: "utf8",
  target: targets,
  logLevel: "warning",
});

// {"site.css": "assets/site-1A2B3C4D.css", …}, paths below `out`, of the outputs that `wanted` picks.
export function manifestOf(metafile, site, out, wanted = () => true) {
  const entries = Object.entries(metafile.outputs)
    .filter(([, output]) => wanted(output))
    .map(([file]) => {
      const hashed = path.relative(path.resolve(out), path.resolve(site, file));
      const plain = path.basename(hashed).replace(/-[A-Z0-9]{8}(?=\.\w+$)/, "");
      return [plain, hashed.split(path.sep).join("/")];
    });
  return Object.fromEntries(entries.sort(([a], [b]) => (a < b ? -1 : 1)));
}
