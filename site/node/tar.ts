/** The files of a tar archive in memory (POSIX ustar), by their names. */
export function* filesOfTar(tar: Uint8Array): Generator<readonly [string, Uint8Array]> {
  const block = 512;
  const field = (at: number, length: number) => {
    const bytes = tar.subarray(at, at + length);
    const end = bytes.indexOf(0);
    return new TextDecoder().decode(end < 0 ? bytes : bytes.subarray(0, end));
  };
  for (let at = 0; at + block <= tar.length;) {
    const name = field(at, 100);
    if (name === "") return;
    const prefix = field(at + 257, 5) === "ustar" ? field(at + 345, 155) : "";
    const size = parseInt(field(at + 124, 12), 8);
    const kind = field(at + 156, 1);
    const begin = at + block;
    if (kind === "0" || kind === "") {
      yield [prefix ? `${prefix}/${name}` : name, tar.subarray(begin, begin + size)];
    }
    at = begin + block * Math.ceil(size / block);
  }
}
