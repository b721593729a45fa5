/** The one thing that browsers and node share and ES2022 does not name. */
declare class TextDecoder {
  decode(bytes: Uint8Array): string;
}
