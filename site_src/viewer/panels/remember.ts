/** Small choices that outlast a visit: which tab, what is folded. Browsers may refuse to keep anything. */
export function recall(name: string): string | null {
  try {
    return localStorage.getItem(`raywalk ${name}`);
  } catch {
    return null;
  }
}

export function remember(name: string, value: string) {
  try {
    localStorage.setItem(`raywalk ${name}`, value);
  } catch {
    // then it is chosen anew next time
  }
}
