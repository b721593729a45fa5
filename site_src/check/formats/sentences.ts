/** A sentence for each thing that may be wrong with a file. {slots} are a PictureFault's figures. */
export const SENTENCES = {
  noBytes: "The file is empty.",
  tooManyBytes: "The file has {megabytes} MB; at most {most} MB are read.",
  unknown: "This is no picture that can be read: neither PNG, JPEG, PPM, PGM, BMP, TGA, PFM nor numbers as text.",
  otherFormat: "This is a file of the kind {format}, whatever its name says. Save the picture as PNG or PPM.",
  utf16: "The numbers are text in UTF-16. Save the file as UTF-8 or plain ASCII.",
  empty: "The {format} file says that its picture is {width} by {height} pixels: there is nothing in it.",
  tooLarge: "The {format} file says that its picture is {width} by {height} pixels; at most {most} by {most} are read.",
  truncated: "The {format} file ends too early: {needed} bytes are needed, {has} are there. Was it still being written?",
  header: "The header of the {format} file is damaged: {what}.",
  damaged: "The {format} file is damaged: {what}.",
  variant: "This kind of {format} file is not read: {what}. Save it as {instead}.",
  tooMuch: "The {format} file unpacks to more than the {width} by {height} pixels that it claims.",
  aboveMost: "A value in the {format} file is {value}, but its header says that {most} is the largest.",
  notANumber: "Line {line} has \"{text}\" where a number is expected.",
  notFinite: "Pixel {x}, {y} (column, row, from the top left) is {value}: a picture has finite numbers only.",
  columns: "Line {line} has {has} numbers, those before it have {expected}.",
  layout: "The table has {rows} lines of {columns} numbers: expected are n lines of 3n numbers, lines of x, y, r, g, b, or n times n lines of r, g, b.",
  pixelTwice: "Line {line} gives pixel {x}, {y} a second time.",
  pixelMissing: "Pixel {x}, {y} is not given: {has} of {expected} are there.",
  pixelPlace: "Line {line} names pixel {x}, {y}: expected are whole numbers from 0 on, less than {most}.",
} as const;

export type FaultWord = keyof typeof SENTENCES;

/** The sentence with its figures in place. */
export function sentenceOf(fault: { word: FaultWord; figures: Record<string, string | number> }): string {
  return SENTENCES[fault.word].replace(/\{(\w+)\}/g, (slot, name: string) => String(fault.figures[name] ?? slot));
}
