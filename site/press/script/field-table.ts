/**
 * The field table as the generator gives it: text for all fields at once, and a view for a field
 * when it is first read. A check opens hundreds of worlds, and a script reads few of the 380 fields.
 */
import type { Field, Numbers } from "./native.js";

export interface Table {
  /** JSON: a Row for each field. */
  readonly rows: string;
  /** The numbers of row `index`, in place. */
  readonly view: (index: number) => Numbers;
}

type Row = [
  owner: string,
  name: string,
  rows: number,
  columns: number,
  scalar: boolean,
  integer: boolean,
];

export function fieldsOf({ rows, view }: Table): Field[] {
  return (JSON.parse(rows) as Row[]).map((row, index) => new TableField(row, () => view(index)));
}

class TableField implements Field {
  readonly owner: string;
  readonly name: string;
  readonly rows: number;
  readonly columns: number;
  readonly scalar: boolean;
  readonly integer: boolean;
  private made: Numbers | undefined;

  constructor(
    row: Row,
    private readonly make: () => Numbers,
  ) {
    [this.owner, this.name, this.rows, this.columns, this.scalar, this.integer] = row;
  }

  get view(): Numbers {
    return (this.made ??= this.make());
  }
}
