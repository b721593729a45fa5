/** What a person gives: a scene, and a file by choosing, dropping or pasting it. */
import { languageCode, say } from "../../viewer/words";
import type { Files } from "./files";

export interface Chosen {
  id: string;
  title: string;
  objects: string[]; // their names in the page's language
  url: string; // of the scene's page
}

const find = <E extends HTMLElement>(selector: string) => document.querySelector<E>(selector)!;

export function chosenScene(): Chosen {
  const { value, dataset } = find<HTMLInputElement>("[name=scene]:checked");
  return { id: value, title: dataset.title!, objects: JSON.parse(dataset.objects!), url: dataset.url! };
}

const radios = () => [...document.querySelectorAll<HTMLInputElement>("[name=scene]")];
const radioOf = (id: string | null) => radios().find(({ value }) => value === id);

/** Of all scenes, by id. */
export const titles = (): Record<string, string> => Object.fromEntries(radios().map(({ value, dataset }) => [value, dataset.title!]));

/** Nothing if there is no such scene. */
export function choose(id: string | null) {
  const radio = radioOf(id);
  if (radio) radio.checked = true;
}

/** given: a file. changed: another scene. coming: a file is being chosen or dragged here. */
export function listenToAsked(given: (file: File) => void, changed: () => void, coming: () => void) {
  const [drop, input] = [find("#drop"), find<HTMLInputElement>("#file")];
  const first = (files: FileList | null | undefined) => files?.[0] && given(files[0]);
  input.addEventListener("change", () => {
    first(input.files);
    input.value = ""; // the same file again, mended meanwhile, is a change too
  });
  input.addEventListener("click", coming);
  document.addEventListener("dragenter", coming);
  // On all of the page: a picture that misses the field must not take the page's place.
  document.addEventListener("dragover", (event) => {
    event.preventDefault();
    drop.classList.add("is-over");
  });
  document.addEventListener("dragleave", (event) => event.relatedTarget || drop.classList.remove("is-over"));
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    drop.classList.remove("is-over");
    first(event.dataTransfer?.files);
  });
  document.addEventListener("paste", (event) => first(event.clipboardData?.files));
  find("#asked").addEventListener("submit", (event) => event.preventDefault());
  find(".check-scenes").addEventListener("change", changed);
}


export async function showSizes(files: Files, id: string) {
  const { own, others } = await files.about(id);
  if (id !== chosenScene().id) return;
  const sizes = [...own, ...others].sort((a, b) => a - b).map(String);
  find("#sizes").textContent = say("check.exactSizes", { sizes: new Intl.ListFormat(languageCode(), { type: "disjunction" }).format(sizes) });
}
