/** The decoder alone: jpeg-js types the package's front only, which brings the encoder too. */
declare module "jpeg-js/lib/decoder" {
  interface Options {
    useTArray: true;
    formatAsRGBA: false;
    tolerantDecoding: boolean;
    maxMemoryUsageInMB: number;
  }
  export default function decode(bytes: Uint8Array, options: Options): { width: number; height: number; data: Uint8Array };
}
