// Films are asked for piece by piece, and some browsers play none that comes otherwise.

/** The piece of `response` that `request` wants, or all of it. */
export async function ranged(response: Response, request: Request): Promise<Response> {
  const range = /^bytes=(\d+)-(\d*)$/.exec(request.headers.get("range") ?? "");
  if (!range || response.status !== 200) return response;
  const bytes = await response.arrayBuffer();
  const first = Number(range[1]);
  const last = Math.min(range[2] ? Number(range[2]) : Infinity, bytes.byteLength - 1);
  const headers = new Headers(response.headers);
  if (first > last) {
    headers.set("content-range", `bytes */${bytes.byteLength}`);
    return new Response(null, { status: 416, headers });
  }
  headers.set("content-range", `bytes ${first}-${last}/${bytes.byteLength}`);
  return new Response(bytes.slice(first, last + 1), { status: 206, headers });
}
