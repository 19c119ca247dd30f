// The browser of the tests: headless, without a graphics card, and silent on the network.

import { chromium } from "../../site/node_modules/playwright-core/index.mjs";

const quiet = [
  "--no-sandbox",
  "--use-angle=swiftshader", // WebGL without a graphics card
  "--enable-unsafe-swiftshader",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",
];

// Without a card it is the quicker way to draw a page, with a few other pixels.
const quicker = ["--disable-gpu-rasterization"];

// `asPictured`: draws pages as the browser would by itself.
export function launch({ asPictured = false } = {}) {
  const args = asPictured ? quiet : [...quiet, ...quicker];
  return chromium.launch({
    executablePath: "/usr/bin/chromium-headless-shell",
    args,
  });
}
