/**
 * JavaScript's own objects, made so that a script cannot change them: the checks of the world rest on
 * them. For a realm of its own; in a page they belong to others too.
 */

/** Fixes what the names of `globals` stand for in `realm`, and what literals are made of. */
export function fixBuiltins(realm: Record<string, unknown>, globals: Iterable<string>): void {
  for (const name of globals) {
    if (!(name in realm)) continue;
    fix(realm[name]);
    Object.defineProperty(realm, name, { writable: false, configurable: false });
  }
  for (const literal of unnamed()) fix(literal.constructor, Object.getPrototypeOf(literal));
}

function fix(...values: unknown[]): void {
  for (const value of values) {
    if ((typeof value !== "object" || value === null) && typeof value !== "function") continue;
    Object.freeze(value);
    if (typeof value === "function") Object.freeze((value as { prototype?: object }).prototype);
  }
}

/** One of each kind that no name stands for, but a script can make. */
function unnamed(): object[] {
  const typedArrays = Object.getPrototypeOf(Float64Array.prototype) as object;
  const iterators = [[][Symbol.iterator](), new Map().entries(), new Set().values()];
  const strings = [""[Symbol.iterator](), "".matchAll(/x/g)];
  const numbers = function* () {
    yield 0;
  };
  const later = async function* () {
    yield await Promise.resolve(0);
  };
  const functions = [numbers, later, async () => Promise.resolve(0)];
  const errors = [new TypeError(), new RangeError(), new SyntaxError(), new ReferenceError()];
  const prototypes = [...iterators, ...strings, numbers(), later()].flatMap(chainOf);
  return [
    ...prototypes,
    ...functions,
    ...errors,
    Object.create(typedArrays) as object,
    /x/,
    0n,
    Promise.resolve(),
  ] as object[];
}

/** `value`, and an object for each prototype above its own, but for Object's. */
function chainOf(value: object): object[] {
  const above = Object.getPrototypeOf(Object.getPrototypeOf(value)) as object | null;
  if (above === null || above === Object.prototype) return [value];
  return [value, ...chainOf(Object.create(above) as object)];
}
