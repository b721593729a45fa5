/** A sweep's stops as they are published: each as what is other than in the one before (raywalk/sweeps/differences.py). */
export type Table = Readonly<Record<string, unknown>>;

const INNER = "columns"; // the part that is a table itself

const laid = (before: Table, other: Table): Table => Object.fromEntries(Object.entries({ ...before, ...other }).filter(([, value]) => value !== null));

/** The tables whose differences these are. */
export function wholeAgain(given: readonly Table[]): Table[] {
  const tables: Table[] = [];
  for (const each of given) {
    const before = tables.at(-1);
    if ("whole" in each || !before) tables.push(each.whole as Table);
    else tables.push({ ...laid(before, each), ...(each[INNER] ? { [INNER]: laid(before[INNER] as Table, each[INNER] as Table) } : {}) });
  }
  return tables;
}
