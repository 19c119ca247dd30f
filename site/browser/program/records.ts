/** What a run reported for the lesson (generator/evaluate/programs/records.h): results and tables. */
import type { Columns } from "../../press/script/plot/written.js";

export type Result = number | string;

/** A state, by the names that mjData's fields have; `time` in seconds. */
export interface Snapshot {
  readonly time: number;
  readonly fields: ReadonlyMap<string, readonly number[]>;
}

/** By their names. What a text cannot quote is left out: lists, tables, snapshots, broken lines. JSON has
 * no number that is not finite, so the helper header writes null. */
export function readResults(records: string): Map<string, Result> {
  const results = new Map<string, Result>();
  for (const line of records.split("\n")) {
    const record = parsed(line);
    if (typeof record?.result !== "string") continue;
    const { result, value } = record;
    if (value === null) results.set(result, "not finite");
    if (typeof value === "number" || typeof value === "string") results.set(result, value);
  }
  return results;
}

/** One of those by which a program judges what its reader wrote. */
export interface Check {
  readonly what: string;
  readonly holds: boolean;
  /** What it means that it does not, and the values of it; "" for none. */
  readonly meaning: string;
  readonly found: string;
}

/** In the order in which they were made first; of two of a name, the later failed. */
export function readChecks(records: string): Check[] {
  const checks = new Map<string, Check>();
  for (const line of records.split("\n")) {
    const record = parsed(line);
    if (typeof record?.check !== "string") continue;
    const { check: what, value } = record;
    if (typeof value !== "object" || value === null) continue;
    const { holds, meaning, found } = value as Readonly<Record<string, unknown>>;
    checks.set(what, { what, holds: holds === true, meaning: text(meaning), found: text(found) });
  }
  return [...checks.values()];
}

const text = (value: unknown): string => (typeof value === "string" ? value : "");

/** By their names; for one that nothing can be drawn of, a clause that says why. */
export function readTables(records: string): Map<string, Columns | string> {
  const tables = new Map<string, Columns | string>();
  for (const line of records.split("\n")) {
    const record = parsed(line);
    if (typeof record?.table !== "string" || !isTable(record.value)) continue;
    tables.set(record.table, fault(record.value) ?? record.value);
  }
  return tables;
}

/** By their names, in the order in which they were made first; of two of a name, the later one. */
export function readSnapshots(records: string): Map<string, Snapshot> {
  const snapshots = new Map<string, Snapshot>();
  for (const line of records.split("\n")) {
    const record = parsed(line);
    if (typeof record?.snapshot !== "string") continue;
    const { value } = record;
    if (typeof value !== "object" || value === null) continue;
    const { time, ...rest } = value as Readonly<Record<string, unknown>>;
    const fields = Object.entries(rest).filter((entry): entry is [string, number[]] =>
      Array.isArray(entry[1]),
    );
    if (typeof time === "number") snapshots.set(record.snapshot, { time, fields: new Map(fields) });
  }
  return snapshots;
}

function isTable(value: unknown): value is Columns {
  if (!Array.isArray(value)) return false;
  const columns = value as readonly unknown[];
  const isColumn = (column: unknown): column is [string, number[]] =>
    Array.isArray(column) && typeof column[0] === "string" && Array.isArray(column[1]);
  return columns.every(isColumn);
}

function fault(columns: Columns): string | undefined {
  const lengths = new Set(columns.map(([, numbers]) => numbers.length));
  if (lengths.size > 1) return "its columns differ in length";
  if (lengths.size === 0 || lengths.has(0)) return "it has no row";
  for (const [name, numbers] of columns) {
    const row = numbers.findIndex((number) => !Number.isFinite(number));
    if (row >= 0) return `“${name}” is not finite in row ${row + 1}`;
  }
  return undefined;
}

interface Line {
  readonly result?: unknown;
  readonly table?: unknown;
  readonly snapshot?: unknown;
  readonly check?: unknown;
  readonly value?: unknown;
}

function parsed(line: string): Line | undefined {
  try {
    const json: unknown = JSON.parse(line);
    return typeof json === "object" && json !== null ? json : undefined;
  } catch {
    return undefined;
  }
}
