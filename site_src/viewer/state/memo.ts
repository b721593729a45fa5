/** Remembers the last value; makes it anew when one of the things that it was made from has changed. */
export function memo<T>() {
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

/** Makes a value once for each key, and lets it go with the key. */
export function onceFor<Key extends object, T>(make: (key: Key) => T) {
  const values = new WeakMap<Key, T>();
  return (key: Key): T => {
    if (!values.has(key)) values.set(key, make(key));
    return values.get(key)!;
  };
}
