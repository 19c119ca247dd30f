/** Files that come as xz, while the page is told how far they are. Enter with Downloads. */
import { XzReadableStream } from "xz-decompress";

/** A file could not be had. */
export class NoNetwork extends Error {
  override readonly name = "NoNetwork";
}

export class Downloads {
  #done = 0;
  #total = 0;

  constructor(private readonly progress: (done: number, total: number) => void) {}

  /** Asks for all of them at once; each stream gives what is in the xz. The library unpacks one at a
   * time, so they are to be read in their order. */
  async start(addresses: readonly string[]): Promise<ReadableStream<Uint8Array<ArrayBuffer>>[]> {
    const responses = await Promise.all(addresses.map(asked));
    this.#total = responses.reduce((sum, { headers }) => sum + sizeOf(headers), 0);
    return responses.map(
      ({ body }) =>
        new XzReadableStream(body!.pipeThrough(this.#counter())) as ReadableStream<
          Uint8Array<ArrayBuffer>
        >,
    );
  }

  #counter(): TransformStream<Uint8Array, Uint8Array> {
    return new TransformStream({
      transform: (bytes, controller) => {
        this.#done += bytes.length;
        this.progress(this.#done, Math.max(this.#done, this.#total));
        controller.enqueue(bytes);
      },
    });
  }
}

async function asked(address: string): Promise<Response> {
  const response = await fetch(address).catch((error: unknown) => {
    throw new NoNetwork(String(error));
  });
  if (!response.ok || !response.body) throw new NoNetwork(`${address}: ${response.status}`);
  return response;
}

const sizeOf = (headers: Headers) => Number(headers.get("Content-Length") ?? 0);
