/**
 * The precompiled header as the browser keeps it, so that it is made once: in a cache of its own, which
 * the service worker's editions leave alone. Enter with keptHeader() and keepHeader(). Where the browser
 * keeps nothing, it is made each time. The service worker forgets it with all else.
 *
 * `version` is an address that has no other content: the name of what the header is made of has a hash.
 */
const cacheName = "mjcourse prepared C++";

export async function keptHeader(version: string): Promise<Uint8Array | undefined> {
  try {
    const cache = await caches.open(cacheName);
    const kept = await cache.match(version);
    return kept && new Uint8Array(await kept.arrayBuffer());
  } catch {
    return undefined;
  }
}

/** As if none had been kept. */
export async function forgetHeader(): Promise<void> {
  await caches.delete(cacheName);
}

/** In place of those of other versions. */
export async function keepHeader(version: string, header: Uint8Array): Promise<void> {
  try {
    await caches.delete(cacheName);
    const cache = await caches.open(cacheName);
    await cache.put(version, new Response(header as Uint8Array<ArrayBuffer>));
  } catch {
    // no room, or not allowed
  }
}
