/**
 * Makes a lab of the page live: enter at openLab(), which client/lab-loader.ts calls when it has loaded
 * this module. However many labs a page has, there is one engine and one WebGL context.
 */
import type { Engine, ModelFiles } from "../engine/engine.js";
import { LiveLab } from "./live/live-lab.js";
import type { LabModule } from "./lab-module.js";
import { wear } from "./page/stylesheet.js";
import { arrive, fetchFiles, loadModule, openEngine } from "./run/resources.js";
import { Run } from "./run/run.js";
import { isOutOfMemory, whyNoStart } from "./run/trouble.js";
import { Stage } from "./stage/stage.js";

export interface LabHandle {
  play(): void;
}

/** What a script of the page makes a lab of. */
export interface MadeLab {
  readonly module: LabModule;
  readonly files: ModelFiles;
}

/** Says to the reader why there is no live lab. The loader knows it by its name. */
class Refusal extends Error {
  override readonly name: string = "Refusal";
}

/** Other labs of the page have the memory. */
class NoMemory extends Refusal {
  override readonly name = "NoMemory";
}

let stage: Stage | undefined;
const liveLabs: LiveLab[] = [];

export async function openLab(lab: HTMLElement): Promise<LabHandle> {
  const opened = openStage();
  const address = (name: string): string => new URL(lab.dataset[name]!, document.baseURI).href;
  const module = address("module");
  const source = { glue: address("engine"), wasm: address("wasm") };
  const [engine, described] = await Promise.all([
    openEngine(source),
    loadModule(module),
    arrive("The lab’s stylesheet", wear(address("style"))),
  ]).catch(refuse);
  const files = await fetchFiles(module, described.lab.model).catch(refuse);
  const live = show(lab, start(engine, described, files), opened);
  live.offerLink(async (link, signal) => {
    const trial = import("./run/trial-worker.js");
    const { tryApart } = await arrive("What tries the link", trial);
    return tryApart({ module, engine: source, link }, signal);
  });
  return live;
}

/**
 * Of no module of the site: `make` has the engine, to look at a model first, and may throw what it
 * throws. `lab` has the elements of lab.hbs, and the addresses of engine and stylesheet.
 */
export async function openMadeLab(
  lab: HTMLElement,
  make: (engine: Engine) => MadeLab,
): Promise<LabHandle & { close(): void }> {
  const opened = openStage();
  const address = (name: string): string => new URL(lab.dataset[name]!, document.baseURI).href;
  const [engine] = await Promise.all([
    openEngine({ glue: address("engine"), wasm: address("wasm") }),
    arrive("The lab’s stylesheet", wear(address("style"))),
  ]).catch(refuse);
  const { module, files } = make(engine);
  return show(lab, start(engine, module, files), opened);
}

function show(lab: HTMLElement, run: Run, opened: Stage): LiveLab {
  const live = new LiveLab(lab, run, opened, () => liveLabs.splice(liveLabs.indexOf(live), 1));
  liveLabs.push(live);
  return live;
}

/** With its scenes, which take as much memory again. */
function start(engine: Engine, module: LabModule, files: ModelFiles): Run {
  let run: Run | undefined;
  try {
    run = new Run(engine, module, files);
    run.visualization.update();
    return run;
  } catch (cause) {
    run?.free();
    const Reason = isOutOfMemory(cause) ? NoMemory : Refusal;
    throw new Reason(whyNoStart(cause), { cause });
  }
}

/** The page's one. */
function openStage(): Stage {
  try {
    return (stage ??= watched(Stage.open()));
  } catch (cause) {
    const message =
      "This browser draws no 3D here: WebGL 2 is missing or switched off, so the lab stays a " +
      "picture. Another browser may draw it.";
    throw new Refusal(message, { cause });
  }
}

/** The browser may take the context away, and give it back. */
function watched(opened: Stage): Stage {
  opened.onLost = () => liveLabs.forEach((lab) => lab.viewLost(true));
  opened.onRestored = () => liveLabs.forEach((lab) => lab.viewLost(false));
  return opened;
}

/** What did not arrive has a sentence for readers (run/resources.ts). */
function refuse(error: unknown): never {
  if (error instanceof Error && error.name === "Unreachable") throw new Refusal(error.message);
  throw error;
}
