/** What browsers and node share and ES2022 does not name. */
declare class TextDecoder {
  decode(bytes: Uint8Array): string;
}
declare class DecompressionStream {
  constructor(format: "gzip");
}
declare class Blob {
  constructor(parts: Uint8Array<ArrayBuffer>[]);
  stream(): { pipeThrough(through: DecompressionStream): unknown };
}
declare class Response {
  constructor(body: unknown);
  arrayBuffer(): Promise<ArrayBuffer>;
}
