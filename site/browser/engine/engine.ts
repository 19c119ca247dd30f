/**
 * MuJoCo in the page. Enter with loadEngine(); it works in a page, in a worker, and, given the bytes
 * of engine.wasm, in Node.
 *
 *   const engine = await loadEngine({ glue: "engine.mjs" });
 *   const simulation = engine.load("arm.xml", { "arm.xml": mjcf, "arm.stl": bytes });
 *   simulation.step(10);
 *   const { data } = simulation.world;
 */
import { LoadError } from "./errors.js";
import { loadGlue, type Pointer, type Source } from "./glue.js";
import { Memory } from "./memory.js";
import { Simulation } from "./simulation.js";

/** Files of a model by name; text is MJCF. */
export type ModelFiles = Readonly<Record<string, string | Uint8Array>>;

export async function loadEngine(source: Source): Promise<Engine> {
  return new Engine(new Memory(await loadGlue(source)));
}

export class Engine {
  /** @internal Use loadEngine(). */
  constructor(private readonly memory: Memory) {}

  /**
   * The simulation of the model in `files[name]`, in its initial state. Files that it names are
   * searched among `files` by the last part of their path. Throws a LoadError.
   */
  load(name: string, files: ModelFiles): Simulation {
    const { memory } = this;
    for (const [added, content] of Object.entries(files)) this.addFile(added, content);
    const handle = memory.withText(name, (text) => memory.call("mjc_load", text));
    if (handle === 0) throw this.loadError();
    return new Simulation(memory, handle);
  }

  private addFile(name: string, content: string | Uint8Array): void {
    const { memory } = this;
    const bytes = typeof content === "string" ? new TextEncoder().encode(content) : content;
    memory.withText(name, (text) =>
      memory.withBytes(bytes, (copy) => memory.call("mjc_add_file", text, copy, bytes.length)),
    );
  }

  private loadError(): LoadError {
    const { memory } = this;
    const error: Pointer = memory.call("mjc_load_error");
    const [file, message, cure, line, column] = memory.words(error, 5);
    const text = (address: Pointer | undefined) => memory.text(address!);
    return new LoadError(text(message), text(file), line!, column!, text(cure));
  }
}
