import { signal } from "@preact/signals";
import { parse } from "../said";

export interface SceneCatalog {
  scenes: { name: string; title: string; picture: string | null }[];
  presets: { name: string; title: string }[];
}

/** Scenes and presets that the server offers; null before the first answer. */
export const sceneCatalog = signal<SceneCatalog | null>(null);
export const isSceneCatalogLost = signal(false);

export async function refreshSceneCatalog(): Promise<void> {
  try {
    const answer = await fetch("/scenes");
    if (!answer.ok) throw new Error(answer.statusText);
    sceneCatalog.value = parse(await answer.text()) as SceneCatalog;
    isSceneCatalogLost.value = false;
  } catch {
    isSceneCatalogLost.value = sceneCatalog.value === null;
  }
}

/** Returns the XML text of a scene; null if it cannot be read. */
export async function textOfScene(name: string): Promise<string | null> {
  try {
    const answer = await fetch(`/scenes/${encodeURIComponent(name)}.xml`);
    return answer.ok ? await answer.text() : null;
  } catch {
    return null;
  }
}

export function pictureOfScene(name: string): string {
  return `/scenes/${encodeURIComponent(name)}.png`;
}
