import { Vector3, type Object3D } from "three";
import { fps, isLowDetail } from "./signals";
import { numWaiting } from "../studio";
import type { Hands } from "./hands";
import { Models } from "./models";
import type { Picker } from "./pick";
import type { Axis, Rings } from "./rings";
import type { Stage } from "./stage";

/** What tests in a browser have to know of the world, which is but a picture to them. It only reads. */
export interface TestHook {
  /** Where on the page the middle of an object is [px]; null where there is none, or nothing of it is to be seen. */
  screenPointOf(objectId: string): { x: number; y: number } | null;
  /** Where on the page a point of the world is [px]. */
  screenPlaceOf(point: [x: number, y: number, z: number]): { x: number; y: number };
  /** Where on the page a ring is that turns the held object about "x", "y" or "z" [px]. */
  ringPointOf(axis: "x" | "y" | "z", degrees: number): { x: number; y: number } | null;
  /** Where the object is drawn: x, y, z [units]. */
  placeOf(objectId: string): number[] | null;
  /** Where the ghost of the held object is drawn: x, y, z [units]; null where none is. */
  ghostPlace(): number[] | null;
  /** Where the mark of a held tool is drawn: x, y, z [units]; null where none is. */
  toolMarkPlace(): number[] | null;
  /** Whether the program has answered everything that the page asked and commanded so far. */
  isAnswered(): boolean;
  fps(): number;
  /** From commands to the poses they caused, the last ones, oldest first [ms]. */
  lastLatencies(): number[];
  stats(): { calls: number; triangles: number; isLowDetail: boolean; isShown: boolean };
}

declare global {
  interface Window {
    smileStudio?: TestHook;
  }
}

export interface WhatTestsRead {
  stage: Stage;
  models: Models;
  picker: Picker;
  rings: Rings;
  hands: Hands;
  ghost: Object3D;
  toolMark: Object3D;
}

export function provideTestHook({ stage, models, picker, rings, hands, ghost, toolMark }: WhatTestsRead): void {
  window.smileStudio = {
    screenPointOf(objectId) {
      const ball = Models.ballAbout(models.piecesOf(objectId));
      return ball && picker.toPage(ball.center);
    },
    screenPlaceOf: (point) => picker.toPage(new Vector3(...point)),
    ringPointOf(axis, degrees) {
      if (!rings.root.visible) return null;
      return picker.toPage(rings.pointOn("xyz".indexOf(axis) as Axis, degrees));
    },
    placeOf: (objectId) => models.groupOf(objectId)?.position.toArray() ?? null,
    ghostPlace: () => (ghost.visible ? ghost.position.toArray() : null),
    toolMarkPlace: () => (toolMark.visible ? toolMark.position.toArray() : null),
    isAnswered: () => hands.isIdle && numWaiting() === 0,
    fps: () => fps.value,
    lastLatencies: () => [...hands.latency.recent],
    stats: () => ({
      calls: stage.counts.calls,
      triangles: stage.counts.triangles,
      isLowDetail: isLowDetail.value,
      isShown: models.root.visible,
    }),
  };
}
