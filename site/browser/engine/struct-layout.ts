/** MuJoCo's structs read in place, by the engine's own table of where their members lie. */
import type { Pointer } from "./glue.js";
import type { Memory } from "./memory.js";
import type { Numbers } from "../../press/script/native.js";

/** A struct's members by MuJoCo's names: numbers in place, and text as it is when read. */
export interface Struct {
  readonly numbers: Readonly<Record<string, Numbers>>;
  readonly text: (member: string) => string;
}

interface Member {
  readonly name: string;
  readonly type: number;
  readonly offset: number;
  readonly count: number;
}

export class Layout {
  constructor(
    private readonly memory: Memory,
    /** Bytes from one struct of an array to the next. */
    readonly size: number,
    private readonly members: readonly Member[],
  ) {}

  /** The struct at `address`; made anew when memory has grown. */
  at(address: Pointer): Struct {
    const { memory } = this;
    const numbers: Record<string, Numbers> = {};
    const offsets = new Map<string, number>();
    for (const { name, type, offset, count } of this.members) {
      const view = memory.view(type, address + offset, count);
      if (view === undefined) offsets.set(name, offset);
      else numbers[name] = view;
    }
    return {
      numbers,
      text: (member) => {
        const offset = offsets.get(member);
        if (offset === undefined) throw new TypeError(`${member} is not a text`);
        return memory.text(address + offset);
      },
    };
  }
}

/** Every layout of wasm/struct_layout.c by MuJoCo's name of the struct. */
export function readLayouts(memory: Memory): ReadonlyMap<string, Layout> {
  const layouts = new Map<string, Layout>();
  for (let index = 0; ; index++) {
    const address = memory.call("mjc_layout", index);
    if (address === 0) return layouts;
    const [name, size, count, members] = memory.words(address, 4);
    const read = Array.from({ length: count! }, (_, i) => readMember(memory, members! + i * 16));
    layouts.set(memory.text(name!), new Layout(memory, size!, read));
  }
}

/** An mjcMember: four words. */
function readMember(memory: Memory, address: Pointer): Member {
  const [name, type, offset, count] = memory.words(address, 4);
  return { name: memory.text(name!), type: type!, offset: offset!, count: count! };
}
