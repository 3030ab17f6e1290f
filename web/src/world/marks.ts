import { guideColors, handColors } from "../colors";
import { HANDS } from "../protocol";
import { state } from "../studio";
import type { Models } from "./models";
import { Outline } from "./outline";
import { hovered } from "./signals";

const HELD_PIXELS = 3.5;
const HOVER_PIXELS = 2.5;

/** Lines around what the hands hold, in their colors, and around what is under the mouse. */
export class Marks {
  private readonly held = HANDS.map((hand) => ({
    hand,
    outline: new Outline(HELD_PIXELS, handColors[hand]),
  }));
  private readonly hover = new Outline(HOVER_PIXELS, guideColors.hover);

  update(models: Models): void {
    const hands = state.value?.hands;
    const isHeld = HANDS.some((hand) => hands?.[hand].object === hovered.value);
    for (const { hand, outline } of this.held) outline.show(meshesOf(models, hands?.[hand].object ?? null));
    this.hover.show(meshesOf(models, isHeld ? null : hovered.value));
  }

  setSize(width: number, height: number): void {
    for (const { outline } of this.held) outline.setSize(width, height);
    this.hover.setSize(width, height);
  }
}

function meshesOf(models: Models, object: string | null) {
  return object === null ? [] : models.piecesOf(object).map(({ mesh }) => mesh);
}
