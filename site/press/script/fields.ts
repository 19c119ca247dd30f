/** `model` and `data`: every field of the field table under MuJoCo's own name. */
import type { Field } from "./native.js";
import {
  arrayMember,
  computedMember,
  fixedMember,
  numberMember,
  strictStruct,
} from "./strict-struct.js";
import { boundsOf } from "./writable.js";

/** The struct `label` over `fields`, with the structs inside it. */
export function structOf(label: string, fields: readonly Field[]): object {
  const groups = new Map<string, Field[]>();
  for (const field of fields) {
    const group = groups.get(field.owner);
    if (group === undefined) groups.set(field.owner, [field]);
    else group.push(field);
  }
  return build(label, "", groups);
}

function build(label: string, owner: string, groups: ReadonlyMap<string, Field[]>): object {
  const members: PropertyDescriptorMap = {};
  for (const field of groups.get(owner) ?? []) {
    members[field.name] = memberOf(field, `${label}.${field.name}`);
  }
  for (const path of groups.keys()) {
    const inner = innerStruct(path, owner);
    if (inner === "" || inner in members) continue;
    const innerLabel = `${label}.${inner}`;
    const struct = build(innerLabel, owner === "" ? inner : `${owner}.${inner}`, groups);
    members[inner] = fixedMember(struct, innerLabel, "assign its members one by one");
  }
  return strictStruct(label, members);
}

/** The next name on the way from `owner` to `path`: "global" from "vis" to "vis.global". */
function innerStruct(path: string, owner: string): string {
  const prefix = owner === "" ? "" : `${owner}.`;
  return path.startsWith(prefix) ? path.slice(prefix.length).split(".")[0]! : "";
}

function memberOf(field: Field, label: string): PropertyDescriptor {
  if (!field.scalar) return arrayMember(() => field.view, label, boundsOf(field));
  return boundsOf(field) === null ? computedMember(field, label) : numberMember(field, 0, label);
}
