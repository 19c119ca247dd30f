// The browser of the tests: headless, without a graphics card, and silent on the network.

import { chromium } from "../../site/node_modules/playwright-core/index.mjs";

const quiet = [
  "--no-sandbox",
  "--use-angle=swiftshader", // WebGL without a graphics card
  "--enable-unsafe-swiftshader",
  "--disable-gpu-rasterization", // without a card it is the slower way
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",
];

export function launch() {
  return chromium.launch({ executablePath: "/usr/bin/chromium-headless-shell", args: quiet });
}
