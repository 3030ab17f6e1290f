import { MathUtils, type Object3D, type PerspectiveCamera, Vector3 } from "three";
import { guideColors } from "../colors";
import type { Point } from "../protocol";
import { currentHand, scene, state } from "../studio";
import { texts } from "../texts";
import { type Alignment, alignmentsOf, type Turned, turnedFrom } from "./alignment";
import { cuboidsOf, type Place } from "./cuboids";
import type { Rest } from "./ghost";
import { Models } from "./models";
import type { Picker } from "./pick";
import { areAidsFixed, guides, isOnRail, restHeight } from "./signals";
import { supportsOf } from "./supports";

const { placement: words } = texts;
/** From the middle of the object to the text, in radii of the object; the rings are between both. */
const AWAY = 1.5;
/** From the text to the edge of the picture, and to its top, where the buttons of the views are [px]. */
const MARGIN = 8;
const TOP_MARGIN = 52;
/** A released object that has moved this far since it came to rest is no longer described [m]. */
const FAR = 0.002;
/** Less is not said about a release: to fall [m], and to tilt [degrees]. */
const LEAST_FALL = 0.01;
const LEAST_TILT = 3;

/**
 * Placement label: says beside the held object what it would rest on and what it is aligned with, and after the
 * release what it does rest on, until it is moved.
 */
export class PlacementLabel {
  readonly output = document.createElement("output");
  private object: string | null = null;
  /** Where the released object came to rest; null before. */
  private restPlace: Vector3 | null = null;
  private ghostPlace = "";
  /** What it is aligned with or turned from, and its center there. */
  private aligned: { center: Vector3; with: Alignment[]; turned: Turned | null } | null = null;
  /** Of what it rests on. */
  private lines: string[] = [];
  /** Of the hand: what stops it, and how the object would fall from there. */
  private stops: string[] = [];
  private falls: string[] = [];
  private supports: readonly string[] = [];
  private said = "";

  constructor(
    private readonly host: HTMLElement,
    private readonly models: Models,
    private readonly picker: Picker,
  ) {
    this.output.className = "placement-label";
    this.output.ariaLabel = words.name;
    this.output.style.borderColor = guideColors.ghost;
    host.append(this.output);
  }

  dispose(): void {
    this.output.remove();
  }

  /** The object that it says the held one is turned from. */
  get turnedFrom(): string | null {
    return this.aligned?.turned?.object ?? null;
  }

  /** Forgets what was released. */
  forget(): void {
    this.object = null;
  }

  /**
   * Call once a picture, when the poses of all objects are known.
   * @param held  object of the current hand, if this page may move it
   * @param rest  what the held object would rest on, if that is known
   * @param ghost  where it would rest, if that is shown: there the text is placed, and what it says is about that place
   * @param isNew  whether anything has moved, or looks different, since the last time
   */
  update(camera: PerspectiveCamera, held: string | null, rest: Rest | null, ghost: Object3D | null, isNew: boolean): void {
    // What follows a rail can only be where that leads.
    if (!guides.value || (held !== null && isOnRail.value)) this.object = null;
    else if (held !== null) {
      // The ghost follows the object a little later.
      const place = ghost === null ? "" : [...ghost.position, ...ghost.quaternion].join();
      if (isNew || place !== this.ghostPlace || held !== this.object || this.restPlace !== null) {
        this.aligned = this.alignmentsAt(held, this.lowered(held, ghost));
      }
      this.ghostPlace = place;
      this.restPlace = null;
      this.object = held;
      // While the program is finding out where it would rest, what was found last is shown.
      this.stops = stopLines();
      this.lines = rest?.object === held ? restLines(rest.supports) : [];
      this.falls = rest?.object === held && rest.supports !== null ? this.fallLines(held, ghost) : [];
      this.supports = (rest?.object === held && rest.supports?.on) || [];
    } else if (this.object !== null) this.describeReleased(this.object);
    const doesFall = this.object !== null && held !== null && this.fallTo(held, ghost) > 0;
    restHeight.value = doesFall ? ghost?.position.z ?? null : null;
    const ball = this.object === null ? null : Models.ballAbout(this.models.piecesOf(this.object));
    this.say(ball === null ? [] : [...this.stops, ...this.lines, ...this.falls, ...this.alignmentLines()]);
    if (ball !== null) this.place(camera, ghost?.position ?? ball.center, ball.radius);
  }

  private describeReleased(object: string): void {
    this.stops = this.falls = [];
    const group = this.models.groupOf(object);
    const { metersPerUnit } = scene.value ?? {};
    if (group === null || metersPerUnit === undefined) return this.forget();
    if (this.restPlace !== null && this.restPlace.distanceTo(group.position) * metersPerUnit > FAR) return this.forget();
    if (this.models.moved.size > 0 || state.value?.still !== true || this.restPlace !== null) return;
    this.restPlace = group.position.clone();
    const meshes = this.models.piecesOf(object).map(({ mesh }) => mesh);
    const supports = supportsOf(meshes, object, this.picker, 1 / metersPerUnit);
    this.lines = restLines(supports);
    this.supports = supports.on;
    this.aligned = this.alignmentsAt(object, null);
  }

  /**
   * Where the held object is once it is let down: where it would come to rest, or straight above that if the fall alone
   * moves it sideways. People lower it first, and numbers and label then agree.
   */
  private lowered(held: string, ghost: Object3D | null): Place | null {
    const group = this.models.groupOf(held);
    if (ghost === null || group === null || scene.value === null) return ghost;
    const aside = Math.hypot(group.position.x - ghost.position.x, group.position.y - ghost.position.y) * scene.value.metersPerUnit;
    const tilt = MathUtils.radToDeg(group.quaternion.angleTo(ghost.quaternion));
    if (aside > LEAST_FALL || tilt >= LEAST_TILT) return ghost;
    return { position: group.position.clone().setZ(ghost.position.z), quaternion: group.quaternion };
  }

  /** That it would fall from here, and tilt: in the picture, neither is easily seen. */
  private fallLines(held: string, ghost: Object3D | null): string[] {
    const group = this.models.groupOf(held);
    if (ghost === null || group === null || scene.value === null) return [];
    const fall = this.fallTo(held, ghost) * scene.value.metersPerUnit;
    const tilt = MathUtils.radToDeg(group.quaternion.angleTo(ghost.quaternion));
    return [
      ...(fall > 0 ? [words.drops(Math.round(fall * 1000), !areAidsFixed.value)] : []),
      ...(tilt >= LEAST_TILT ? [words.tilts(Math.round(tilt))] : []),
    ];
  }

  /** How far it would fall to its ghost [units]; 0 if that is nearly nothing. */
  private fallTo(held: string, ghost: Object3D | null): number {
    const group = this.models.groupOf(held);
    if (ghost === null || group === null || scene.value === null) return 0;
    const fall = group.position.z - ghost.position.z;
    return fall * scene.value.metersPerUnit < LEAST_FALL ? 0 : fall;
  }

  private alignmentsAt(object: string, elsewhere: Place | null): typeof this.aligned {
    if (scene.value === null) return null;
    const cuboids = cuboidsOf(this.models, scene.value, new Map(elsewhere === null ? [] : [[object, elsewhere]]));
    const own = cuboids.get(object);
    cuboids.delete(object);
    if (own === undefined) return null;
    const center = new Vector3(...own.center).divideScalar(scene.value.metersPerUnit);
    const others = [...cuboids.values()];
    // What is round can be turned as it likes.
    const hasSides = (id: string) => this.models.piecesOf(id).some(({ visual }) => visual.block !== undefined);
    const turned = hasSides(object) ? turnedFrom(own, others.filter((other) => hasSides(other.object))) : null;
    return { center, with: alignmentsOf(own, others), turned };
  }

  /** Anew for each picture: arrows turn with the camera. */
  private alignmentLines(): string[] {
    const { aligned } = this;
    if (aligned === null) return [];
    const { turned } = aligned;
    return [
      ...(turned === null ? [] : [words.turned(Math.round(turned.degrees), turned.object, !areAidsFixed.value)]),
      ...linesOf(aligned.with, this.supports, (toward) => this.picker.arrow(aligned.center, new Vector3(...toward))),
    ];
  }

  /** The element stays while it is empty, and changes only with its words: screen readers then announce them once. */
  private say(lines: string[]): void {
    const text = lines.join("\n");
    if (text === this.said) return;
    this.said = text;
    this.output.replaceChildren(
      ...lines.map((line) => Object.assign(document.createElement("span"), { textContent: line })),
    );
  }

  private place(camera: PerspectiveCamera, center: Vector3, radius: number): void {
    const box = this.host.getBoundingClientRect();
    const right = new Vector3().setFromMatrixColumn(camera.matrixWorld, 0);
    const { x, y } = this.picker.toPage(center);
    const away = this.picker.toPage(center.clone().addScaledVector(right, AWAY * radius)).x - x;
    const { offsetWidth, offsetHeight, style } = this.output;
    // To the right; where there is no room, to the left or above.
    const sides = [x - box.left + away, x - box.left - away - offsetWidth];
    const room = box.width - offsetWidth - MARGIN;
    const beside = sides.find((side) => side >= MARGIN && side <= room);
    const up = beside === undefined ? away + offsetHeight : offsetHeight / 2;
    style.left = `${beside ?? within(x - box.left - offsetWidth / 2, box.width - offsetWidth)}px`;
    style.top = `${within(y - box.top - up, box.height - offsetHeight, TOP_MARGIN)}px`;
  }
}

const nameOf = (object: string) => (object === "" ? words.table : object);

/** What keeps the held object from where the hand pulls it, and what would help. */
function stopLines(): string[] {
  const { stopped_by: stoppers = [], slide_first: sliding } = state.value?.hands[currentHand.value] ?? {};
  if (stoppers.length === 0) return [];
  const names = stoppers.map(nameOf);
  return [sliding === undefined ? words.stopped(names) : words.slideFirst(names, sliding)];
}

function restLines(supports: Rest["supports"]): string[] {
  if (supports === null) return [words.falls];
  const { on, isInside } = supports;
  return on.length > 0 ? [words.rests(isInside, on.map(nameOf))] : [];
}

/** @param supports  what it rests on: what is missing to that is said, and to the nearest of the others */
function linesOf(alignments: Alignment[], supports: readonly string[], arrow: (toward: Point) => string): string[] {
  const flush = alignments.flatMap((alignment) => {
    const parts = partsOf(alignment);
    return parts.length > 0 ? [words.of(parts, nameOf(alignment.object))] : [];
  });
  const those = (isIt: (alignment: Alignment) => boolean) => alignments.filter(isIt).map(({ object }) => nameOf(object));
  const centered = those(({ isCentered }) => isCentered);
  const touched = those(({ touches }) => touches);
  const least = ({ missing }: Alignment) => Math.min(...missing.map(({ distance }) => distance));
  const byDistance = alignments.filter(({ missing }) => missing.length > 0).sort((one, other) => least(one) - least(other));
  const below = byDistance.find(({ object }) => supports.includes(object));
  const nearest = byDistance.find((alignment) => alignment !== below);
  const missing = [below, nearest].flatMap((alignment) => (alignment?.missing ?? []).map((one) => ({ ...one, object: alignment!.object })));
  return [
    ...(flush.length > 0 ? [words.flush(flush)] : []),
    ...(centered.length > 0 ? [words.centered(centered)] : []),
    ...(touched.length > 0 ? [words.touches(touched)] : []),
    ...missing.map(({ distance, toward, to, object }) => words.missing(arrow(toward), Math.ceil(distance * 1000), to, object)),
  ];
}

function partsOf({ ends, sides, isTopLevel, isBottomLevel }: Alignment): string[] {
  return [
    ...(ends > 0 ? [words.ends(ends)] : []),
    ...(sides > 0 ? [words.sides(sides)] : []),
    ...(isTopLevel ? [words.top] : []),
    ...(isBottomLevel ? [words.bottom] : []),
  ];
}

/** Between the margins of the picture [px]. */
function within(at: number, room: number, margin = MARGIN): number {
  return Math.max(margin, Math.min(at, room - MARGIN));
}
