// Serves a built site on a free port of this machine, one folder below the root: an address that
// works only at the root of a domain is a mistake.

import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join } from "node:path";

const types = {
  ".cpp": "text/x-c++src; charset=utf-8",
  ".css": "text/css; charset=utf-8",
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".json": "application/json",
  ".mjs": "text/javascript; charset=utf-8",
  ".mp4": "video/mp4",
  ".png": "image/png",
  ".svg": "image/svg+xml",
  ".txt": "text/plain; charset=utf-8",
  ".wasm": "application/wasm",
  ".webp": "image/webp",
  ".woff2": "font/woff2",
};

// Gives the address of the site's root, and what ends the server. Without a port, one that is free.
export async function serve(folder, { base = "/some/course/", port = 0 } = {}) {
  const server = createServer(async (request, response) => {
    const path = decodeURIComponent(new URL(request.url, "http://localhost").pathname);
    try {
      if (!path.startsWith(base)) throw new Error("outside of the site");
      const bytes = await readFile(join(folder, path.slice(base.length) || "index.html"));
      response.writeHead(200, { "content-type": types[extname(path)] ?? "text/html" }).end(bytes);
    } catch {
      // As static hosts do.
      const missing = await readFile(join(folder, "404.html")).catch(() => "");
      response.writeHead(404, { "content-type": types[".html"] }).end(missing);
    }
  });
  await new Promise((listening) => server.listen(port, "127.0.0.1", listening));
  const root = `http://127.0.0.1:${server.address().port}${base}`;
  const close = () => {
    server.close();
    server.closeAllConnections(); // or a browser goes on asking
  };
  return { root, close };
}
