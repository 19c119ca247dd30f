/** The field table of a model or its data, with views on the memory as it lies now. */
import type { Pointer } from "./glue.js";
import type { Memory } from "./memory.js";
import type { Field } from "../../press/script/native.js";

/** Words of an mjcField (physics/field_table.h): seven, each a pointer or an int. */
const words = 7;

export function modelFields(memory: Memory, model: Pointer): Field[] {
  return readTable(memory, (fields, capacity) =>
    memory.call("mjc_model_fields", model, fields, capacity),
  );
}

export function dataFields(memory: Memory, model: Pointer, data: Pointer): Field[] {
  return readTable(memory, (fields, capacity) =>
    memory.call("mjc_data_fields", model, data, fields, capacity),
  );
}

/** `write` is one of C's two functions: it writes up to `capacity` fields, and gives their number. */
function readTable(memory: Memory, write: (fields: Pointer, capacity: number) => number): Field[] {
  const count = write(0, 0);
  return memory.withRoom(count * words * 4, (fields) => {
    write(fields, count);
    const rows = Array.from({ length: count }, (_, i) => readField(memory, fields + i * words * 4));
    return rows.filter((field) => field !== undefined);
  });
}

/** Undefined for text. */
function readField(memory: Memory, address: Pointer): Field | undefined {
  const [owner, name, type, first, rows, columns, scalar] = memory.words(address, words);
  const view = memory.view(type!, first!, rows! * columns!);
  return (
    view && {
      owner: memory.text(owner!),
      name: memory.text(name!),
      view,
      rows: rows!,
      columns: columns!,
      scalar: scalar !== 0,
      integer: view instanceof Int32Array,
    }
  );
}
