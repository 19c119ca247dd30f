/**
 * Typed arrays that refuse what JavaScript lets pass: an index past the end (undefined), a write of
 * NaN, a whole array used as one number. Everything else a typed array can do, they can.
 */
import { cureOfNumber, Fault, show } from "./fault.js";
import type { Numbers } from "./native.js";
import { suggest } from "./suggest.js";
import type { Bounds } from "./writable.js";

const views = new WeakMap<object, Numbers>();

/** The array under a strict array, or the typed array itself; undefined for anything else. */
export function viewOf(value: unknown): Numbers | undefined {
  if (typeof value !== "object" || value === null) return undefined;
  return views.get(value) ?? (isNumbers(value) ? value : undefined);
}

function isNumbers(value: unknown): value is Numbers {
  return ArrayBuffer.isView(value) && !(value instanceof DataView);
}

/**
 * `view` made strict; `label` is how scripts write it, "data.qpos". Its numbers keep to `bounds`; with
 * null they are read alone. The view itself never comes into a script's hands.
 */
export function strictArray<T extends Numbers>(view: T, label: string, bounds?: Bounds | null): T {
  const strict: Strict = { view, label, bounds };
  const proxy: T = new Proxy(view, {
    get(target, key) {
      const value: unknown = Reflect.get(target, key);
      if (typeof value === "number") return value;
      if (key === Symbol.toPrimitive) return (hint: string) => primitive(target, label, hint);
      if (typeof value === "function" && key !== "constructor") {
        return bound(strict, proxy, key, value);
      }
      if (typeof key === "string" && (value === undefined || key === "buffer")) {
        throw missing(target, label, key);
      }
      return value;
    },
    set(target, key, value) {
      if (typeof key === "symbol" || !(key in target)) throw missing(target, label, String(key));
      checkWrite(target, value, `${label}[${key}]`, label, bounds);
      return Reflect.set(target, key, value);
    },
    defineProperty: () => false,
    setPrototypeOf: () => false,
    preventExtensions: () => false,
  });
  views.set(proxy, view);
  return proxy;
}

/** An array of MuJoCo's, and what a script may do with it. */
interface Strict {
  readonly view: Numbers;
  readonly label: string;
  readonly bounds: Bounds | null | undefined;
}

/** Throws unless `value` may be written to `view`; `place` is how the script names the element. */
export function checkWrite(
  view: Numbers,
  value: unknown,
  place: string,
  label: string,
  bounds?: Bounds | null,
): void {
  if (bounds === null) {
    const cure = "MuJoCo takes its place in memory from it; change the model instead";
    throw new Fault("E-script-value", `${place} cannot be assigned`, [place, label], cure);
  }
  let wanted = "";
  if (typeof value !== "number") wanted = "number";
  else if (!Number.isFinite(value)) wanted = "finite number";
  else if (view instanceof Int32Array && (value | 0) !== value) wanted = "whole number";
  else if (view instanceof Uint8Array && (value & 255) !== value) wanted = "whole number in 0..255";
  else if (bounds !== undefined && (value < bounds[0] || value > bounds[1])) {
    wanted = `whole number in ${bounds[0]}..${bounds[1]}`;
  }
  if (wanted === "") return;
  const message = `${place} = ${show(value)}: not a ${wanted}`;
  throw new Fault("E-script-value", message, [place, label], cureOfNumber(value));
}

/** What typed arrays have besides numbers. */
const members = [Float64Array.prototype, Object.getPrototypeOf(Float64Array.prototype) as object]
  .flatMap((prototype) => Object.getOwnPropertyNames(prototype))
  .filter((name) => name !== "buffer")
  .sort();

/** The error for a key that is no index of the array, and no member either. */
function missing(view: Numbers, label: string, key: string): Fault {
  const place = `${label}[${key}]`;
  if (Number.isNaN(Number(key))) {
    const cure = suggest(key, members, `${label}.`);
    return new Fault("E-script-name", `${label} has no \`${key}\``, [key, label], cure);
  }
  const what =
    view.length === 0
      ? `${place} does not exist: ${label} is empty`
      : `${place} is out of range 0..${view.length - 1}`;
  return new Fault("E-script-range", what, [place, label]);
}

/** An array of one number stands for that number in arithmetic; a longer one does not. */
function primitive(view: Numbers, label: string, hint: string): number | string {
  if (hint === "string") return view.join(", ");
  if (view.length === 1) return view[0]!;
  const message = `${label} is an array of length ${view.length}, not a number`;
  throw new Fault("E-script-value", message, [label], `take one of its numbers: ${label}[0]`);
}

/** What changes the order of the numbers, and so each of them. */
const moves: readonly PropertyKey[] = ["sort", "reverse", "copyWithin"];

/** A method of the typed array, which works on the array itself and gives strict arrays. */
function bound(strict: Strict, proxy: object, key: PropertyKey, method: unknown) {
  const { view, label, bounds } = strict;
  const call = method as (...args: unknown[]) => unknown;
  return (...args: unknown[]): unknown => {
    const all = `every number of ${label}`;
    if (key === "fill") checkWrite(view, args[0], all, label, bounds);
    if (moves.includes(key) && bounds === null) checkWrite(view, 0, all, label, bounds);
    if (key === "set") args[0] = checkedNumbers(strict, args[0], args[1]);
    if (key === "at") checkAt(view, label, Number(args[0]));
    const result = Reflect.apply(call, view, args.map(withStrictArguments));
    if (result === view) return proxy;
    if (!isNumbers(result)) return result;
    // a part of the array shares its memory; all others are the script's own
    const shared = key === "subarray" ? bounds : undefined;
    return strictArray(result, `${label}.${String(key)}(…)`, shared);
  };

  /** A function that the method calls is given the strict array in the place of the view. */
  function withStrictArguments(arg: unknown): unknown {
    if (typeof arg !== "function") return arg;
    const callback = arg as (...inner: unknown[]) => unknown;
    return (...inner: unknown[]) =>
      callback(...inner.map((value) => (value === view ? proxy : value)));
  }
}

/** The numbers of `source`, which may give others when it is asked again. */
function checkedNumbers(strict: Strict, source: unknown, offset: unknown): number[] {
  const { view, label, bounds } = strict;
  const numbers = Array.from(source as ArrayLike<unknown>);
  const start = Number(offset ?? 0);
  numbers.forEach((value, index) =>
    checkWrite(view, value, `${label}[${start + index}]`, label, bounds),
  );
  if (start >= 0 && start + numbers.length <= view.length) return numbers as number[];
  const message = `${label}.set: ${numbers.length} numbers from ${start} on pass its end, ${view.length}`;
  throw new Fault("E-script-range", message, [`${label}.set`, label]);
}

function checkAt(view: Numbers, label: string, index: number): void {
  if (index < view.length && index >= -view.length) return;
  throw missing(view, label, String(index));
}
