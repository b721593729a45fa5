/** What the address says after its #: which scene is checked, and whether the picture that was checked last is shown again. Links to
 *  pages of mistakes carry the scene, and these lead back. */

const [SCENE, REPORT] = ["scene", "report"];

export function readAddress(hash: string): { scene: string | null; isReport: boolean } {
  const said = new URLSearchParams(hash.slice(1));
  return { scene: said.get(SCENE), isReport: said.has(REPORT) };
}

export const addressOf = (scene: string, isReport: boolean): string => `#${new URLSearchParams({ [SCENE]: scene, ...(isReport ? { [REPORT]: "1" } : {}) })}`;
