/**
 * Objects with a fixed set of members, where an unknown name is an error and not undefined.
 *
 * Members are the object's own properties, so reading one costs what it costs anywhere; only a name
 * that is not there reaches the prototype, a proxy that throws.
 */
import { Fault } from "./fault.js";
import type { Field, Numbers } from "./native.js";
import { checkWrite, strictArray } from "./strict-array.js";
import { suggest } from "./suggest.js";
import { boundsOf, type Bounds } from "./writable.js";

/** `label` is how scripts write the object: "data", "model.opt", "body('box')". */
export function strictStruct(label: string, members: PropertyDescriptorMap): object {
  const unknown = (key: string) =>
    new Fault(
      "E-script-name",
      `${label}.${key} does not exist`,
      [key, label],
      suggest(key, Object.keys(members), `${label}.`),
    );
  const refuse: ProxyHandler<object> = {
    get(_, key) {
      if (typeof key === "symbol") return undefined;
      throw unknown(key);
    },
    set(_, key) {
      throw unknown(String(key));
    },
  };
  return Object.create(new Proxy(Object.create(null) as object, refuse), members) as object;
}

/** A member that cannot be replaced: `why` says what to do instead. */
export function fixedMember(value: unknown, label: string, why: string): PropertyDescriptor {
  return { enumerable: true, get: () => value, set: () => refuseWrite(label, why) };
}

/** The array that `view` gives, asked for when first read: a model has hundreds of fields. */
export function arrayMember(
  view: () => Numbers,
  label: string,
  bounds?: Bounds | null,
): PropertyDescriptor {
  let array: Numbers | undefined;
  const how = bounds === null ? computed : `it is an array: ${label}[0] = …, or ${label}.set([…])`;
  return {
    enumerable: true,
    get: () => (array ??= strictArray(view(), label, bounds)),
    set: () => refuseWrite(label, how),
  };
}

/** The field's number at `index`, as MuJoCo has it now. */
export function numberMember(field: Field, index: number, label: string): PropertyDescriptor {
  return {
    enumerable: true,
    get: () => field.view[index],
    set: (value: unknown) => {
      checkWrite(field.view, value, label, label, boundsOf(field));
      field.view[index] = value as number;
    },
  };
}

/** A number that MuJoCo computes: read it, never write it. */
export function computedMember(field: Field, label: string): PropertyDescriptor {
  const set = () => refuseWrite(label, computed);
  return { enumerable: true, get: () => field.view[0], set };
}

const computed = "MuJoCo computes it from the model";

/** The error for a write to `label`: `why` says what to do instead. */
export function refuseWrite(label: string, why: string): never {
  throw new Fault("E-script-value", `${label} cannot be assigned`, [label], why);
}
