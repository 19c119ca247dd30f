/** The engine's memory and functions, as the other files of this folder use them. */
import { MemoryError, MujocoError } from "./errors.js";
import type { Glue, Pointer } from "./glue.js";
import type { Numbers } from "../../press/script/native.js";

/** The types of numbers by mjcFieldType (physics/field_table.h); text, the last, is not one. */
const kinds = [Float64Array, Float32Array, Int32Array, Uint8Array] as const;
/** mjcFIELD_FLOAT. */
export const float = 1;

export class Memory {
  constructor(private readonly glue: Glue) {}

  /** Another object when memory has grown, at which every view made before is empty. */
  get buffer(): ArrayBuffer {
    return this.glue.HEAPU8.buffer;
  }

  /** Calls C. An error of MuJoCo's is thrown as a MujocoError, and the engine works on. */
  call(name: string, ...args: number[]): number {
    const { glue } = this;
    const run = glue[`_${name}`];
    if (run === undefined) throw new TypeError(`the engine has no ${name}`);
    const stack = glue.stackSave();
    try {
      return run(...args);
    } catch (error) {
      // a C++ exception reaches JavaScript as its address, and leaves the stack where it was thrown
      if (typeof error !== "number") throw error;
      glue.stackRestore(stack);
      throw new MujocoError(this.text(this.call("mjc_exception_text", error)));
    }
  }

  /** Numbers in place; undefined for a `type` that is text. */
  view(type: number, address: Pointer, count: number): Numbers | undefined {
    const kind = kinds[type];
    // an empty field may have any address
    return kind && (count === 0 ? new kind(0) : new kind(this.buffer, address, count));
  }

  /** 32-bit words in place, which structs of pointers and ints are. */
  words(address: Pointer, count: number): Int32Array {
    return new Int32Array(this.buffer, address, count);
  }

  /** The text at `address`, "" for NULL. */
  text(address: Pointer): string {
    return address === 0 ? "" : this.glue.UTF8ToString(address);
  }

  /** Gives `use` a copy of `bytes` that lasts as long as the call; zeros are at its end. */
  withBytes<T>(bytes: Uint8Array, use: (address: Pointer) => T): T {
    return this.withRoom(bytes.length + 1, (address) => {
      this.glue.HEAPU8.set(bytes, address);
      this.glue.HEAPU8[address + bytes.length] = 0;
      return use(address);
    });
  }

  withText<T>(text: string, use: (address: Pointer) => T): T {
    return this.withBytes(new TextEncoder().encode(text), use);
  }

  /** Gives `use` room for so many bytes that lasts as long as the call. */
  withRoom<T>(size: number, use: (address: Pointer) => T): T {
    const address = this.call("malloc", size);
    if (address === 0) throw new MemoryError(`the engine has no ${size} bytes left`);
    try {
      return use(address);
    } finally {
      this.call("free", address);
    }
  }
}
