// The site's service worker, sw.js: what a reader has opened can be read without a network.
//
// The generator writes the name of this edition's manifest in front of it (generator/page/
// edition_manifest.h), so every build of another site is another worker. When it is installed, the
// core is kept, what an earlier edition kept is taken over where it is the same, and fetched anew where
// it has changed. All else is kept when it is first asked for. It takes over from an earlier worker
// when the reader says so, or once no page of the site is open; the earlier edition is forgotten then.
//
// Editions never mix. Only files with the manifest's hash are kept. A page that comes otherwise is of
// a newer deployment: it is handed on and not kept. Its files come from the network too, since only
// what a kept page asks for is answered from the cache. A file of a kept page that comes otherwise is
// refused. In both cases the browser is asked to look for the newer worker.

import type { Answers, Keeping, Message } from "../client/offline/messages.js";
import { forgetHeader } from "../cpp/kept-header.js";
import { cachesOf, Edition } from "./edition.js";
import { ranged } from "./ranged.js";

declare const self: ServiceWorkerGlobalScope & { readonly mjcourseEdition: string };

const root = self.registration.scope;
const offlinePage = "offline.html";
const atOnce = 6;

let opening: Promise<Edition> | undefined;

function edition(): Promise<Edition> {
  opening ??= Edition.open(root, self.mjcourseEdition).catch((error: unknown) => {
    opening = undefined; // the next time may be a better one
    throw error;
  });
  return opening;
}

/** The reader has asked the browser to. */
function savesData(): boolean {
  const { connection } = navigator as { connection?: { saveData?: boolean } };
  return connection?.saveData === true;
}

async function keep(path: string): Promise<Keeping> {
  const own = await edition();
  if (await own.kept(path)) return "kept";
  const found = await own.fetch(path).catch(() => undefined);
  if (!found) return "no network";
  if (!found.own) return "changed";
  return own.put(path, found.response).then(
    () => "kept",
    () => "no room",
  );
}

async function keepAll(paths: readonly string[], needed: boolean): Promise<void> {
  const waiting = [...paths];
  const work = async () => {
    for (let path = waiting.pop(); path !== undefined; path = waiting.pop()) {
      const became = await keep(path);
      if (needed && became !== "kept") throw new Error(`${path}: ${became}`);
    }
  };
  await Promise.all(Array.from({ length: atOnce }, work));
}

async function install(): Promise<void> {
  const own = await edition();
  const wanted: string[] = [];
  let all = false;
  for (const name of await cachesOf(root)) {
    if (name === own.cacheName) continue;
    const former = await Edition.open(root, name.slice(name.lastIndexOf(" ") + 1)).catch(
      () => null,
    );
    if (!former) continue;
    wanted.push(...(await own.takeOver(former)));
    all ||= await former.isAllWanted();
  }
  await keepAll(own.core, true);
  await own.wantAll(all);
  if (!savesData()) await keepAll(all ? own.paths : wanted, false);
}

async function activate(): Promise<void> {
  const { cacheName } = await edition();
  const former = (await cachesOf(root)).filter((name) => name !== cacheName);
  await Promise.all(former.map((name) => caches.delete(name)));
  await self.clients.claim();
}

/** Where a navigation ends that has no network. */
function toOfflinePage(address: string): Response {
  const page = encodeURIComponent(address.slice(root.length));
  return Response.redirect(`${root}${offlinePage}?page=${page}`);
}

/** Whether the page, or the file, that asks is of this edition. */
async function isOwn(own: Edition, asking: string): Promise<boolean> {
  if (!asking.startsWith(root)) return true; // nobody says
  const path = own.pathOf(asking);
  return path !== undefined && (await own.kept(path)) !== undefined;
}

/**
 * It comes as it goes on to who asks, so that he sees how far it is; whether it is of this edition shows
 * at its end, and only then is it kept.
 */
async function answerLarge(own: Edition, path: string, event: FetchEvent): Promise<Response> {
  const response = await fetch(event.request);
  if (response.ok) event.waitUntil(own.putOwn(path, response.clone()).catch(() => undefined));
  return response;
}

async function answerOwn(own: Edition, path: string, event: FetchEvent): Promise<Response> {
  const { request } = event;
  const kept = await own.kept(path);
  if (kept) return ranged(kept, request);
  if (own.isAsked(path)) return answerLarge(own, path, event);
  const found = await own.fetch(path);
  if (found.own) {
    // Before the page has it, as only what is kept may ask for more. Without room it goes as it is.
    await own.put(path, found.response).catch(() => undefined);
    return ranged(found.response, request);
  }
  void self.registration.update().catch(() => undefined);
  return request.mode === "navigate" ? found.response : Response.error();
}

async function answer(event: FetchEvent): Promise<Response> {
  const { request } = event;
  const navigates = request.mode === "navigate";
  try {
    const own = await edition();
    const path = own.pathOf(request.url);
    const ours = path !== undefined && (navigates || (await isOwn(own, request.referrer)));
    return await (ours ? answerOwn(own, path, event) : fetch(request));
  } catch {
    return navigates ? toOfflinePage(request.url) : Response.error();
  }
}

async function obey({ kind, path }: Message): Promise<Answers[keyof Answers]> {
  const own = await edition();
  switch (kind) {
    case "inventory":
      return { files: own.sizes(), asked: own.asked, kept: await own.keptPaths() };
    case "keep": {
      const known = path === undefined ? undefined : own.pathOf(root + path);
      return known === undefined ? "changed" : keep(known);
    }
    case "has all":
      await own.wantAll(true);
      return true;
    case "forget": {
      await own.wantAll(false);
      const spare = (await own.keptPaths()).filter((one) => !own.core.includes(one));
      await Promise.all([...spare.map((one) => own.drop(one)), forgetHeader()]);
      return true;
    }
    case "take over":
      await self.skipWaiting();
      return true;
  }
}

self.addEventListener("install", (event) => event.waitUntil(install()));
self.addEventListener("activate", (event) => event.waitUntil(activate()));
self.addEventListener("fetch", (event) => {
  const { method, url } = event.request;
  if (method === "GET" && url.startsWith(root)) event.respondWith(answer(event));
});
self.addEventListener("message", (event) => {
  const reply = obey(event.data as Message).then((said) => event.ports[0]?.postMessage(said));
  event.waitUntil(reply.catch(() => undefined));
});
