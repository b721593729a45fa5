/** Keys of an address that the viewer follows; address.ts says what each means. */
export const ADDRESS_KEYS: readonly string[] = ["scene", "n", "p", "rays", "tiles", "cam", "look", "wipe", "slice", "if", "colours", "sweep", "step", "answer", "e", "tab", "embed", "speed", "projector", "still", "gl"];
