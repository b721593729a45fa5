/** "damaged": bytes missing or changed; "not-a-trace": another kind of file; "version": written
 *  for another reader; "scene": of another scene or resolution. */
export type TraceErrorCode = "damaged" | "not-a-trace" | "version" | "scene";

/** A trace file that must not be used, and why. */
export class TraceError extends Error {
  constructor(
    readonly code: TraceErrorCode,
    message: string,
  ) {
    super(message);
  }
}

export const damaged = (what: string) => new TraceError("damaged", what);
