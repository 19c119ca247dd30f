/** What clang and the linker print, as data. Enter with compilerDiagnostics() or linkerDiagnostics(). */
import type { Diagnostic } from "./messages.js";
import type { ToolResult } from "./tool.js";

/**
 * Of clang's lines, with the flags of flags.ts:
 *
 *   /program/fall.cpp:6:9:{6:3-6:9}: error: use of undeclared identifier 'modell'
 *
 * Without a range, one ends where it begins. A line without a place belongs to the one before it. A file
 * that the program names by `#line` has that name. `nameOf` gives the name by which the reader knows a path.
 * Where the compiler fails and no line says why, all that it printed does.
 */
export function compilerDiagnostics(
  { ok, text }: ToolResult,
  nameOf: (path: string) => string,
): readonly Diagnostic[] {
  const found: Diagnostic[] = [];
  for (const line of text.split("\n")) {
    const placed = placedLine.exec(line)?.groups;
    const plain = placed ?? plainLine.exec(line)?.groups;
    if (!plain) continue;
    const { path = "", ranges = "", severity, message } = plain;
    const begin = { line: Number(placed?.["line"] ?? 0), column: Number(placed?.["column"] ?? 0) };
    found.push({
      file: path && nameOf(path),
      ...begin,
      ...(rangeAround(begin, ranges) ?? { endLine: begin.line, endColumn: begin.column }),
      severity: severity === "fatal error" ? "error" : (severity as Diagnostic["severity"]),
      message: message!,
    });
  }
  const isExplained = ok || found.some(({ severity }) => severity === "error");
  return isExplained ? found : [...found, withoutPlace(text.trim() || "the compiler fails")];
}

const placedLine =
  /^(?<path>.+?):(?<line>\d+):(?<column>\d+):(?<ranges>(?:\{[\d:-]+\})*:?) (?<severity>fatal error|error|warning|note): (?<message>.*)$/;
const plainLine = /^(?<severity>fatal error|error|warning): (?<message>.*)$/;

interface Place {
  readonly line: number;
  readonly column: number;
}

/** The first range that holds the place, as clang gives several where it speaks of two operands. */
function rangeAround(place: Place, ranges: string) {
  for (const range of ranges.matchAll(/\{(\d+):(\d+)-(\d+):(\d+)\}/g)) {
    const [line, column, endLine, endColumn] = range.slice(1).map(Number) as [
      number,
      number,
      number,
      number,
    ];
    const holds =
      !isBefore(place, { line, column }) && isBefore(place, { line: endLine, column: endColumn });
    if (holds) return { line, column, endLine, endColumn };
  }
  return undefined;
}

const isBefore = (a: Place, b: Place) =>
  a.line < b.line || (a.line === b.line && a.column < b.column);

/** Of the linker's lines, which have no place: what the program calls and nobody has. */
export function linkerDiagnostics(text: string): readonly Diagnostic[] {
  const missing = text.matchAll(/undefined symbol: (.*)$/gm);
  const names = [...new Set([...missing].map(([, name]) => name!))];
  const [, crash] = /^error: (.*)$/m.exec(text) ?? [];
  const messages = names.length > 0 ? names.map(explained) : [crash ?? text.trim()];
  return messages.map(withoutPlace);
}

const withoutPlace = (message: string): Diagnostic => ({
  ...{ file: "", line: 0, column: 0, endLine: 0, endColumn: 0 },
  severity: "error",
  message,
});

function explained(name: string): string {
  const draws = /^(mjr|mjui)_|^OSMesa|^gl[A-Z]/.test(name);
  return draws
    ? `${name}: a page has no OpenGL to draw with`
    : `${name} is declared and used, but defined nowhere`;
}
