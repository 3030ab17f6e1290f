import { Group, type PerspectiveCamera, type Sprite, Vector3 } from "three";
import { guideColors, handColors } from "../colors";
import { type HandName, HANDS } from "../protocol";
import { state } from "../studio";
import { disc } from "./disc";
import { Models } from "./models";
import { Outline } from "./outline";
import { selected } from "./selection";
import { hovered } from "./signals";
import { apparentDistance } from "./view_camera";

const HELD_PIXELS = 3.5;
const HOVER_PIXELS = 2.5;
const BADGE_ORDER = 33;
/** Of a badge's height to the distance from the eye. */
const BADGE_SIZE = 0.024;

/** Lines around what the hands hold, in their colors, with a badge, and around what is under the mouse. */
export class Marks {
  readonly root = new Group();
  private readonly held = HANDS.map((hand) => ({
    hand,
    outline: new Outline(HELD_PIXELS, handColors[hand]),
    badge: badgeOf(hand),
  }));
  private readonly selection = new Outline(HELD_PIXELS, guideColors.selected);
  private readonly hover = new Outline(HOVER_PIXELS, guideColors.hover);

  constructor() {
    for (const { badge } of this.held) this.root.add(badge);
  }

  update(models: Models, camera: PerspectiveCamera): void {
    const hands = state.value?.hands;
    const isHeld = HANDS.some((hand) => hands?.[hand].object === hovered.value);
    for (const { hand, outline, badge } of this.held) {
      const pieces = piecesOf(models, hands?.[hand].object ?? null);
      outline.show(pieces.map(({ mesh }) => mesh));
      const ball = Models.ballAbout(pieces);
      badge.visible = ball !== null;
      if (ball === null) continue;
      const size = BADGE_SIZE * apparentDistance(camera, ball.center);
      badge.scale.setScalar(size);
      const up = new Vector3().setFromMatrixColumn(camera.matrixWorld, 1);
      badge.position.copy(ball.center).addScaledVector(up, 1.3 * ball.radius + size);
    }
    this.selection.show(selected.value.flatMap((object) => models.piecesOf(object).map(({ mesh }) => mesh)));
    this.hover.show(piecesOf(models, isHeld ? null : hovered.value).map(({ mesh }) => mesh));
  }

  setSize(width: number, height: number): void {
    for (const { outline } of this.held) outline.setSize(width, height);
    this.selection.setSize(width, height);
    this.hover.setSize(width, height);
  }
}

function piecesOf(models: Models, object: string | null) {
  return object === null ? [] : models.piecesOf(object);
}

/** The hand's first letter, for those who see colors otherwise. */
function badgeOf(hand: HandName): Sprite {
  return disc(hand.charAt(0).toUpperCase(), handColors[hand], BADGE_ORDER);
}
