import { signal } from "@preact/signals";

export interface Gallery {
  scenes: { name: string; title: string; picture: string | null }[];
  presets: { name: string; title: string }[];
}

/** Null until it is there. */
export const gallery = signal<Gallery | null>(null);
export const isGalleryLost = signal(false);

export async function refreshGallery(): Promise<void> {
  try {
    const answer = await fetch("/scenes");
    if (!answer.ok) throw new Error(answer.statusText);
    gallery.value = (await answer.json()) as Gallery;
    isGalleryLost.value = false;
  } catch {
    isGalleryLost.value = gallery.value === null;
  }
}

/** A scene's text; null where it has none that can be read. */
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
