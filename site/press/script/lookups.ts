/**
 * What scripts find by name: `qpos('hinge')`, `body('box').xpos`, `sensor('imu')`, `ctrl('motor')`.
 * Everything found is a view on MuJoCo's memory, made once for each name.
 */
import { constants } from "./constants.js";
import { Fault } from "./fault.js";
import type { Field, Native, Numbers } from "./native.js";
import { strictArray } from "./strict-array.js";
import { arrayMember, numberMember, strictStruct } from "./strict-struct.js";
import { boundsOf } from "./writable.js";
import { suggest } from "./suggest.js";

/** Fields of mjData with a row for each body or joint, which their names do not tell. */
const rowsOf: Readonly<Record<string, string>> = {
  body:
    "xfrc_applied xpos xquat xmat xipos ximat subtree_com cinert crb " +
    "cvel subtree_linvel subtree_angmom cacc cfrc_int cfrc_ext",
  jnt: "xanchor xaxis",
};

/** Numbers in qpos and in qvel, by mjtJoint. */
const jointSizes = [
  { qpos: 7, qvel: 6 },
  { qpos: 4, qvel: 3 },
  { qpos: 1, qvel: 1 },
  { qpos: 1, qvel: 1 },
];

export function lookups(native: Native) {
  const view = (fields: readonly Field[], name: string): Numbers =>
    fields.find((field) => field.owner === "" && field.name === name)!.view;
  const model = (name: string) => view(native.modelFields, name);
  const data = (name: string) => view(native.dataFields, name);

  const jointPart = (state: "qpos" | "qvel", joint: number) => {
    const start = model(state === "qpos" ? "jnt_qposadr" : "jnt_dofadr")[joint]!;
    const size = jointSizes[model("jnt_type")[joint]!]![state];
    return data(state).subarray(start, start + size);
  };
  const jointState = (state: "qpos" | "qvel") =>
    byName(native, state, "joint", constants.mjOBJ_JOINT, (id, label) =>
      strictArray(jointPart(state, id), label),
    );
  const element = (kind: string, prefix: string, type: number, more: MoreMembers = () => ({})) =>
    byName(native, kind, kind, type, (id, label) =>
      strictStruct(label, { ...rowMembers(native, prefix, id, label), ...more(id, label) }),
    );

  return {
    qpos: jointState("qpos"),
    qvel: jointState("qvel"),
    body: element("body", "body", constants.mjOBJ_BODY),
    geom: element("geom", "geom", constants.mjOBJ_GEOM),
    site: element("site", "site", constants.mjOBJ_SITE),
    joint: element("joint", "jnt", constants.mjOBJ_JOINT, (id, label) => ({
      qpos: arrayMember(() => jointPart("qpos", id), `${label}.qpos`),
      qvel: arrayMember(() => jointPart("qvel", id), `${label}.qvel`),
    })),
    sensor: byName(native, "sensor", "sensor", constants.mjOBJ_SENSOR, (id, label) => {
      const start = model("sensor_adr")[id]!;
      return strictArray(
        data("sensordata").subarray(start, start + model("sensor_dim")[id]!),
        label,
      );
    }),
    ctrl: byName(native, "ctrl", "actuator", constants.mjOBJ_ACTUATOR, (id, label) =>
      strictArray(data("ctrl").subarray(id, id + 1), label),
    ),
  };
}

/** Members that a kind of object has besides its rows. */
type MoreMembers = (id: number, label: string) => PropertyDescriptorMap;

/** A function from an object's name to what `make` gives for its id; `noun` is for messages. */
function byName(
  native: Native,
  lookup: string,
  noun: string,
  type: number,
  make: (id: number, label: string) => unknown,
): (name: unknown) => unknown {
  const made = new Map<unknown, unknown>();
  const names = native.names[type]!;
  return (name) => {
    const known = made.get(name);
    if (known !== undefined) return known;
    const text = String(name);
    const id = text === "" ? -1 : names.indexOf(text);
    if (id < 0) {
      const message = `no ${noun} is named \`${text}\``;
      throw new Fault("E-script-name", message, [text, lookup], suggest(text, names));
    }
    const value = make(id, `${lookup}('${text}')`);
    made.set(name, value);
    return value;
  };
}

/** Row `id` of every field that has a row for each object of the kind, without the kind's prefix. */
function rowMembers(native: Native, prefix: string, id: number, label: string) {
  const members: PropertyDescriptorMap = {};
  const alsoRows = (rowsOf[prefix] ?? "").split(" ");
  for (const field of [...native.modelFields, ...native.dataFields]) {
    const { owner, name, columns } = field;
    const prefixed = name.startsWith(`${prefix}_`);
    if (owner !== "" || !(prefixed || alsoRows.includes(name))) continue;
    const member = prefixed ? name.slice(prefix.length + 1) : name;
    const place = `${label}.${member}`;
    members[member] =
      columns === 1
        ? numberMember(field, id, place)
        : arrayMember(
            () => field.view.subarray(id * columns, (id + 1) * columns),
            place,
            boundsOf(field),
          );
  }
  return members;
}
