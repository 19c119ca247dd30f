/** What a run reported for the lesson (generator/evaluate/programs/records.h): results and tables. */
import type { Columns } from "../../press/script/plot/written.js";

export type Result = number | string;

/** A state, by the names that mjData's fields have; `time` in seconds. */
export interface Snapshot {
  readonly time: number;
  readonly fields: ReadonlyMap<string, readonly number[]>;
}

/** By their names. What a text cannot quote is left out: lists, tables, snapshots, broken lines. */
export function readResults(records: string): Map<string, Result> {
  const results = new Map<string, Result>();
  for (const line of records.split("\n")) {
    const record = parsed(line);
    if (typeof record?.result !== "string") continue;
    const { result, value } = record;
    if (typeof value === "number" || typeof value === "string") results.set(result, value);
  }
  return results;
}

/** By their names, and with a row at least. */
export function readTables(records: string): Map<string, Columns> {
  const tables = new Map<string, Columns>();
  for (const line of records.split("\n")) {
    const record = parsed(line);
    if (typeof record?.table !== "string" || !isTable(record.value)) continue;
    tables.set(record.table, record.value);
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
  if (!columns.every(isColumn)) return false;
  const lengths = new Set(columns.map(([, numbers]) => numbers.length));
  return lengths.size === 1 && !lengths.has(0);
}

interface Line {
  readonly result?: unknown;
  readonly table?: unknown;
  readonly snapshot?: unknown;
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
