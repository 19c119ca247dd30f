// A checkout with sources of the site's, to be edited while a preview runs: the repository's
// own stay as they are, also when a test is killed.

import { cpSync, mkdirSync, mkdtempSync, rmSync, symlinkSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

const edited = ["browser", "bundle", "press", "package.json"];

// From here on `mjcourse` finds its assets there. ROOT/site lies beside ROOT/build/release/assets.
export function checkOut(site, assets) {
  const root = mkdtempSync(join(tmpdir(), "checkout-"));
  mkdirSync(join(root, "site"));
  mkdirSync(join(root, "build/release"), { recursive: true });
  for (const part of edited) {
    cpSync(join(site, part), join(root, "site", part), { recursive: true });
  }
  symlinkSync(resolve(site, "node_modules"), join(root, "site/node_modules"));
  cpSync(assets, join(root, "build/release/assets"), { recursive: true });
  process.env.MJCOURSE_ASSETS = join(root, "build/release/assets");
  return { site: join(root, "site"), remove: () => rmSync(root, { recursive: true }) };
}
