/** What went wrong with loading, as the sentence a person reads. */
import { LoadError } from "./load";
import { TROUBLE } from "./words";

export function troubleOfTrace(error: unknown, n: number): string {
  if (error instanceof LoadError && error.why === "old browser") return TROUBLE.noUnpacking;
  return error instanceof LoadError && error.why === "missing" ? TROUBLE.traceMissing(n) : TROUBLE.traceDamaged(n);
}

export function troubleOfScene(error: unknown): string {
  if (error instanceof LoadError && error.why === "old browser") return TROUBLE.noUnpacking;
  return error instanceof LoadError && error.why === "missing" ? TROUBLE.sceneMissing : TROUBLE.sceneDamaged;
}
