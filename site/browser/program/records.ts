/** What a run reported for the lesson (generator/evaluate/programs/records.h): results and tables. */
import type { Columns } from "../../press/script/plot/written.js";

export type Result = number | string;

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

function isTable(value: unknown): value is Columns {
  if (!Array.isArray(value)) return false;
  const columns = value as readonly unknown[];
  const isColumn = (column: unknown): column is [string, number[]] =>
    Array.isArray(column) && typeof column[0] === "string" && Array.isArray(column[1]);
  if (!columns.every(isColumn)) return false;
  const lengths = new Set(columns.map(([, numbers]) => numbers.length));
  return lengths.size === 1 && !lengths.has(0);
}

interface Record {
  readonly result?: unknown;
  readonly table?: unknown;
  readonly value?: unknown;
}

function parsed(line: string): Record | undefined {
  try {
    const json: unknown = JSON.parse(line);
    return typeof json === "object" && json !== null ? json : undefined;
  } catch {
    return undefined;
  }
}
