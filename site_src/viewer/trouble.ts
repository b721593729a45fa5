/** What went wrong with loading, as the sentence a person reads. */
import { LoadError } from "./load";
import { say } from "./words";

export function troubleOfTrace(error: unknown, n: number): string {
  if (error instanceof LoadError && error.why === "old browser") return say("trouble.noUnpacking");
  return error instanceof LoadError && error.why === "missing" ? say("trouble.traceMissing", { n }) : say("trouble.traceDamaged", { n });
}

export function troubleOfScene(error: unknown): string {
  if (error instanceof LoadError && error.why === "old browser") return say("trouble.noUnpacking");
  return error instanceof LoadError && error.why === "missing" ? say("trouble.sceneMissing") : say("trouble.sceneDamaged");
}
