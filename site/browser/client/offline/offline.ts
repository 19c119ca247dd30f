// Registers the site's worker, hands it what this page was made of, and says when a newer version of the
// course has come. Where the reader saves data, nothing is begun that was not asked for.

import { addressOf } from "../search/scripts.js";
import { ask } from "./messages.js";
import { announceNewer } from "./newer.js";
import { register } from "./register.js";

/** This page, which came before there was a worker that could keep it, and all that it loads. */
async function keepThisPage(worker: ServiceWorker): Promise<void> {
  const root = addressOf("");
  const keep = async (address: string) =>
    address.startsWith(root) && (await ask(worker, "keep", address.slice(root.length)));
  if ((await keep(location.href)) !== "kept") return;
  const observer = new PerformanceObserver((list) => {
    for (const { name } of list.getEntries()) void keep(name);
  });
  observer.observe({ type: "resource", buffered: true });
}

async function begin(): Promise<void> {
  const isFirst = !navigator.serviceWorker.controller; // by and by the first one has this page, too
  const registration = await register();
  if (!registration) return;
  announceNewer(registration);
  const { active } = await navigator.serviceWorker.ready;
  if (isFirst && active) await keepThisPage(active);
}

void begin();
