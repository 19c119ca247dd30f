/**
 * What a program writes, as text in pieces that a page can show in time. The first lines are told one by
 * one, as somebody may look for where a program hangs; a program that prints on and on sends no
 * message for each line.
 */
import type { Stream } from "./wasi.js";

/** So many pieces are told at once. */
const first = 200;
/** In characters; and in milliseconds, after which a shorter piece is told too. */
const large = 4096;
const late = 50;

export class OutputText {
  readonly #decoders = { out: new TextDecoder(), err: new TextDecoder() };
  #stream: Stream = "out";
  #text = "";
  #pieces = 0;
  #told = 0;

  constructor(private readonly tell: (stream: Stream, text: string) => void) {}

  add(stream: Stream, bytes: Uint8Array): void {
    if (stream !== this.#stream) this.#flush();
    this.#stream = stream;
    this.#text += this.#decoders[stream].decode(bytes, { stream: true });
    const isLate = performance.now() - this.#told >= late;
    if (this.#pieces < first || isLate || this.#text.length >= large) this.#flush();
  }

  /** Tells what is left. */
  end(): void {
    this.#flush();
  }

  #flush(): void {
    if (this.#text !== "") this.tell(this.#stream, this.#text);
    this.#text = "";
    this.#pieces++;
    this.#told = performance.now();
  }
}
