/** Remembers the last value; makes it anew when one of the things it was made from is another. */
export function lastly<T>() {
  let from: readonly unknown[] = [];
  let value: T;
  return (needs: readonly unknown[], make: () => T): T => {
    if (needs.length !== from.length || needs.some((need, k) => need !== from[k])) {
      value = make();
      from = needs;
    }
    return value;
  };
}
