/**
 * A lab as it is, in a link: what the reader set, where the simulation is, how one looks at it, the
 * edited model. The value of `?lab=` has four parts with points between: a version, the lab's id, how
 * many bytes of MJCF it brings, and deflated JSON in base64url; a state's doubles are kept bit by bit.
 *
 * A link comes from anybody. headOf() unpacks nothing of it, so that its reader can be asked first. A
 * value that was made up gives nothing worse than no lab.
 */
import type { CameraPlace } from "../lab-module.js";
import { fromBase64Url, toBase64Url } from "./base64url.js";
import type { ControlValue } from "./controls.js";
import { deflate, inflate } from "./deflate.js";
import type { RunState } from "./run.js";

/** What a link says of itself. */
export interface LinkHead {
  /** The lab's id in its page: "lab-1". */
  readonly id: string;
  /** Bytes of the edited text; 0 where it was not edited. */
  readonly mjcfBytes: number;
  /** Of the link's value: how large it is before it is unpacked. */
  readonly characters: number;
}

/** What a link brings back; what it does not mention is as the lab begins. It may name overlays or
 * controls that this lab does not have. */
export interface LabLink {
  /** As in LinkHead. */
  readonly id: string;
  readonly camera?: CameraPlace;
  readonly overlays?: readonly string[];
  readonly speed?: number;
  /** Run.state, for Run.restore(). */
  readonly run?: Partial<RunState>;
  /** The edited text, where it was edited: for Run.recompile(), before restore(). */
  readonly mjcf?: string;
}

const version = "2";

/** Characters of a value: many servers refuse an address of more than 8 KB. */
const mostCharacters = 7500;

/** Bytes of JSON. */
const mostJson = 1 << 18;

/** The value of `?lab=`. Without the state of the simulation where that would make it too long;
 * undefined where it is too long all the same. */
export async function encodeLink({ id, ...link }: LabLink): Promise<string | undefined> {
  const { run, ...rest } = link;
  const settings = run?.settings;
  const stateless = settings === undefined ? rest : { ...rest, run: { settings } };
  const head = `${version}.${id}.${bytesIn(link.mjcf)}.`;
  for (const candidate of [link, stateless]) {
    const json = new TextEncoder().encode(JSON.stringify(candidate, replaceDoubles));
    const text = head + toBase64Url(await deflate(json));
    if (json.length <= mostJson && text.length <= mostCharacters) return text;
  }
  return undefined;
}

/** Undefined for what is no such value. */
export function headOf(text: string): LinkHead | undefined {
  const { id, mjcfBytes } = partsOf(text) ?? {};
  if (id === undefined || mjcfBytes === undefined) return undefined;
  return { id, mjcfBytes, characters: text.length };
}

/** Undefined for what is no such value, or brings something else than it says; it never throws. */
export async function decodeLink(text: string): Promise<LabLink | undefined> {
  const parts = partsOf(text);
  if (!parts) return undefined;
  const { id, mjcfBytes, packed } = parts;
  try {
    const json = await inflate(fromBase64Url(packed), mostJson);
    const link = readLink(JSON.parse(new TextDecoder().decode(json)));
    return bytesIn(link.mjcf) === mjcfBytes ? { id, ...link } : undefined;
  } catch {
    return undefined;
  }
}

function partsOf(text: string) {
  if (text.length > mostCharacters) return undefined;
  const [, of, id, mjcf, packed] = /^(\d+)\.(.+)\.(\d{1,6})\.([\w-]+)$/.exec(text) ?? [];
  if (of !== version || id === undefined || packed === undefined) return undefined;
  return { id, mjcfBytes: Number(mjcf), packed };
}

function bytesIn(text = ""): number {
  return new TextEncoder().encode(text).length;
}

function replaceDoubles(_: string, value: unknown): unknown {
  return value instanceof Float64Array ? toBase64Url(bytesOf(value)) : value;
}

/** The doubles' bytes, lowest first on every machine that runs a browser. */
function bytesOf({ buffer, byteOffset, byteLength }: Float64Array): Uint8Array {
  return new Uint8Array(buffer, byteOffset, byteLength);
}

// Reading takes what it knows and checks each part; the first that is wrong throws.

function readLink(json: unknown): Omit<LabLink, "id"> {
  const { camera, overlays, speed, run, mjcf } = record(json);
  return {
    ...(camera === undefined ? {} : { camera: readCamera(camera) }),
    ...(overlays === undefined ? {} : { overlays: list(overlays).map(string) }),
    ...(speed === undefined ? {} : { speed: Math.min(4, Math.max(0.1, finite(speed))) }),
    ...(run === undefined ? {} : { run: readRun(run) }),
    ...(mjcf === undefined ? {} : { mjcf: string(mjcf) }),
  };
}

function readCamera(json: unknown): CameraPlace {
  const { azimuth, elevation, distance, target } = record(json);
  const [x, y, z] = list(target).map(finite);
  return {
    azimuth: finite(azimuth),
    elevation: finite(elevation),
    distance: finite(distance),
    target: [finite(x), finite(y), finite(z)],
  };
}

function readRun(json: unknown): Partial<RunState> {
  const { settings, run, ghost } = record(json);
  return {
    ...(settings === undefined ? {} : { settings: list(settings).map(controlValue) }),
    ...(run === undefined ? {} : { run: readMoment(run) }),
    ...(ghost === undefined ? {} : { ghost: readMoment(ghost) }),
  };
}

function readMoment(json: unknown): RunState["run"] {
  const { how, state } = record(json);
  if (how === "reset") return { how, state: undefined };
  if (how !== "forward" && how !== "step") throw wrong(how);
  const doubles = new Float64Array(fromBase64Url(string(state)).buffer);
  if (!doubles.every(Number.isFinite)) throw wrong(state);
  return { how, state: doubles };
}

function controlValue(json: unknown): ControlValue {
  return json === null || typeof json === "boolean" ? json : finite(json);
}

function record(json: unknown): Readonly<Record<string, unknown>> {
  if (typeof json !== "object" || json === null) throw wrong(json);
  return json as Readonly<Record<string, unknown>>;
}

function list(json: unknown): readonly unknown[] {
  if (!Array.isArray(json)) throw wrong(json);
  return json;
}

function string(json: unknown): string {
  if (typeof json !== "string") throw wrong(json);
  return json;
}

function finite(json: unknown): number {
  if (typeof json !== "number" || !Number.isFinite(json)) throw wrong(json);
  return json;
}

function wrong(json: unknown): TypeError {
  return new TypeError(`not of a lab's link: ${String(json)}`);
}
