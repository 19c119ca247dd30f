/**
 * What a lab needs from the network, each thing fetched once: the engine that all labs of a page
 * share, a lab's own module, the files of its model. What fails, fails with a sentence for readers.
 */
import { type Engine, loadEngine, type ModelFiles } from "../../engine/engine.js";
import type { LabModule, ModelSource } from "../lab-module.js";

/** Something did not arrive; the message says to readers what, and what they can do. */
export class Unreachable extends Error {
  override readonly name = "Unreachable";
}

/** Addresses of engine.mjs and engine.wasm, absolute. */
export interface EngineAddress {
  readonly glue: string;
  readonly wasm: string;
}

const engines = new Map<string, Promise<Engine>>();

/** The page's engine. It is loaded when it is first asked for, and again after it failed. */
export function openEngine(address: EngineAddress): Promise<Engine> {
  const known = engines.get(address.wasm);
  if (known !== undefined) return known;
  const opened = arrive("The simulator", loadEngine(address)).catch((error: unknown) => {
    engines.delete(address.wasm);
    throw error;
  });
  engines.set(address.wasm, opened);
  return opened;
}

/** The lab at the absolute address `url`. */
export function loadModule(url: string): Promise<LabModule> {
  return arrive("The lab", import(url) as Promise<LabModule>);
}

/** The files of the model of the lab at `moduleUrl`, ready for Engine.load(). */
export async function fetchFiles(moduleUrl: string, model: ModelSource): Promise<ModelFiles> {
  const assets = Object.entries(model.assets).map(async ([name, address]) => {
    const bytes = await arrive("A part of the model", fetchBytes(new URL(address, moduleUrl)));
    return [name, bytes] as const;
  });
  return { ...model.texts, ...Object.fromEntries(await Promise.all(assets)) };
}

async function fetchBytes(url: URL): Promise<Uint8Array> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${response.status} ${response.statusText}`);
  return new Uint8Array(await response.arrayBuffer());
}

/** Gives what `arriving` brings; says of what does not come that it is `what`. */
export async function arrive<T>(what: string, arriving: Promise<T>): Promise<T> {
  try {
    return await arriving;
  } catch (cause) {
    const message = `${what} could not be loaded. Check your connection, then reload the page.`;
    throw new Unreachable(message, { cause });
  }
}
