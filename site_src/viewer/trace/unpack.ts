/** Base64 of gzip of JSON, as the scripts hand it over. Works in browsers and in node. */
import { TraceError, damaged } from "./errors";

/** The JSON inside; throws TraceError "damaged" if the text is cut or changed. */
export async function unpack(base64: string): Promise<unknown> {
  try {
    const text = atob(base64);
    const bytes = new Uint8Array(text.length);
    for (let k = 0; k < text.length; k++) bytes[k] = text.charCodeAt(k);
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    return JSON.parse(await new Response(stream).text());
  } catch (error) {
    throw error instanceof TraceError ? error : damaged(`${error}`);
  }
}
