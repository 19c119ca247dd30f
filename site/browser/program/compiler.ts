/**
 * The page's one compiler, in a worker: enter at Compiler.of(). It takes seconds to open and has some
 * hundred megabytes then, so it is opened when a program is, and runs one program at a time. A program
 * that has no end is stopped with its worker; the next run opens another, of what the browser has kept.
 */
import type {
  Diagnostic,
  End,
  FromWorker,
  LoadedModel,
  OutputChanges,
  Program,
  Stage,
  StatedOutput,
  ToWorker,
} from "../cpp/messages.js";

export interface Addresses {
  readonly worker: string;
  readonly llvm: string;
  readonly pack: string;
  readonly engine: string;
  readonly wasm: string;
}

export interface Compiled {
  readonly diagnostics: readonly Diagnostic[];
  readonly ok: boolean;
}

/** Hears of a run as it goes on. */
export interface Listener {
  compiled(compiled: Compiled): void;
  output(stream: "out" | "err", text: string): void;
}

export interface Ended {
  readonly end: End;
  readonly records: string;
  readonly model: LoadedModel | undefined;
  readonly changes: OutputChanges | undefined;
  readonly seconds: number;
}

export type Progress = (stage: Stage, done: number, total: number) => void;

/** Why there is no compiler, or no more. */
export class NoCompiler extends Error {
  override readonly name = "NoCompiler";
  constructor(
    readonly why: "network" | "memory" | "unknown" | "stopped",
    message: string,
  ) {
    super(message);
  }
}

interface Run {
  readonly id: number;
  readonly listener: Listener;
  readonly resolve: (ended: Ended | undefined) => void;
}

let compiler: Compiler | undefined;

export class Compiler {
  readonly #addresses: Addresses;
  readonly #followers = new Set<Progress>();
  #worker: Worker | undefined;
  #opening: Promise<void> | undefined;
  #refuse: (reason: NoCompiler) => void = () => undefined;
  #run: Run | undefined;
  #runs = 0;

  private constructor(addresses: Addresses) {
    this.#addresses = addresses;
  }

  /** All programs of a page name the same. */
  static of(addresses: Addresses): Compiler {
    return (compiler ??= new Compiler(addresses));
  }

  get isRunning(): boolean {
    return this.#run !== undefined;
  }

  /** Until it can compile. Rejects with NoCompiler; then it may be asked again. */
  async open(progress: Progress): Promise<void> {
    this.#followers.add(progress);
    try {
      await (this.#opening ??= this.#start());
    } finally {
      this.#followers.delete(progress);
    }
  }

  /** Nothing for a program that does not compile. It must be open, and not running. */
  run(
    program: Program,
    stated: readonly StatedOutput[],
    listener: Listener,
  ): Promise<Ended | undefined> {
    const id = ++this.#runs;
    return new Promise((resolve, reject) => {
      this.#run = { id, listener, resolve };
      this.#refuse = reject;
      this.#send({ kind: "run", id, program, stated });
    });
  }

  /** Ends what it does, whatever that is. */
  stop(): void {
    this.#close(new NoCompiler("stopped", "It was stopped."));
  }

  #start(): Promise<void> {
    const { worker, llvm, pack, engine, wasm } = this.#addresses;
    return new Promise((resolve, reject) => {
      this.#refuse = reject;
      this.#worker = new Worker(worker, { type: "module" });
      this.#worker.onmessage = ({ data }: MessageEvent<FromWorker>) => this.#hear(data, resolve);
      // Before it could say anything itself.
      this.#worker.onerror = ({ message }) =>
        this.#close(new NoCompiler(message ? "unknown" : "network", message));
      this.#send({ kind: "open", llvm, pack, engineGlue: engine, engineWasm: wasm });
    });
  }

  #send(message: ToWorker): void {
    this.#worker?.postMessage(message);
  }

  #close(reason: NoCompiler): void {
    this.#worker?.terminate();
    this.#worker = this.#opening = this.#run = undefined;
    this.#refuse(reason);
  }

  #hear(message: FromWorker, opened: () => void): void {
    switch (message.kind) {
      case "progress":
        for (const tell of this.#followers) tell(message.stage, message.done, message.total);
        return;
      case "ready":
        opened();
        return;
      case "failed":
        this.#close(new NoCompiler(message.why, message.message));
        return;
      default:
        if (message.id === this.#run?.id) this.#hearOfRun(message, this.#run);
    }
  }

  #hearOfRun(message: Extract<FromWorker, { readonly id: number }>, run: Run): void {
    switch (message.kind) {
      case "compiled":
        run.listener.compiled(message);
        if (!message.ok) this.#end(run, undefined);
        return;
      case "output":
        run.listener.output(message.stream, message.text);
        return;
      case "ended": {
        const { end, records, model, changes, seconds } = message;
        this.#end(run, { end, records, model, changes, seconds: seconds.run });
      }
    }
  }

  #end({ resolve }: Run, ended: Ended | undefined): void {
    this.#run = undefined;
    resolve(ended);
  }
}
