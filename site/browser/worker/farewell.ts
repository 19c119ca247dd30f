// What the preview serves as sw.js: a site that was looked at under the same address may have left its
// worker, which would show that site's pages in the place of the preview's. The browser takes this for
// its newer version; it goes at once, with all that was kept.

import { cachesOf } from "./edition.js";

declare const self: ServiceWorkerGlobalScope;

async function leave(): Promise<void> {
  const kept = await cachesOf(self.registration.scope);
  await Promise.all(kept.map((name) => caches.delete(name)));
  await self.registration.unregister();
  const pages = await self.clients.matchAll({ type: "window" });
  await Promise.all(pages.map((page) => page.navigate(page.url)));
}

self.addEventListener("install", (event) => event.waitUntil(self.skipWaiting()));
self.addEventListener("activate", (event) => event.waitUntil(leave()));
