/** `model` and `data`: every field of the field table under MuJoCo's own name. */
import type { Field } from "./native.js";
import {
  arrayMember,
  computedMember,
  fixedMember,
  numberMember,
  strictStruct,
} from "./strict-struct.js";

/** The struct `label` over `fields`, with the structs inside it. */
export function structOf(label: string, fields: readonly Field[], owner = ""): object {
  const members: PropertyDescriptorMap = {};
  for (const field of fields) {
    if (field.owner === owner) {
      members[field.name] = memberOf(field, `${label}.${field.name}`);
      continue;
    }
    const inner = innerStruct(field.owner, owner);
    if (inner === "" || inner in members) continue;
    const innerLabel = `${label}.${inner}`;
    const path = owner === "" ? inner : `${owner}.${inner}`;
    const struct = structOf(innerLabel, fields, path);
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
  if (!field.scalar) return arrayMember(field.view, label);
  // whole numbers of the structs themselves are sizes and counts
  const isSize = field.owner === "" && field.view instanceof Int32Array;
  return isSize ? computedMember(field.view, label) : numberMember(field.view, 0, label);
}
