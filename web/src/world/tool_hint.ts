import { CanvasTexture, type PerspectiveCamera, Sprite, SpriteMaterial, SRGBColorSpace, Vector3 } from "three";
import { may } from "../allowed";
import { guideColors } from "../colors";
import type { ToolUse } from "../protocol";
import { currentHand, heldObject, scene, state } from "../studio";
import { texts } from "../texts";
import { isTouch } from "../ui/media";
import type { Models } from "./models";
import type { Picker } from "./pick";
import { areAidsFixed } from "./signals";
import { apparentDistance } from "./view_camera";

const { toolHint: words } = texts;
const MARK_ORDER = 34;
/** Diameter of the mark, relative to the distance from the eye. */
const MARK_SIZE = 0.034;
/** Opacity of the mark until the tool is in place. */
const FAINT = 0.55;
/** A tool is led to its work from here on [m]. */
const FAR = 0.5;
/** From the mark to the text, and from the text to the edge of the picture [px]. */
const GAP = 20;
const MARGIN = 8;

interface ToolInPlace {
  tool: string;
  use: ToolUse;
  /** The working point, in the object's frame. */
  point: Vector3;
  turns: boolean;
}

/** Tool hint: a mark at the working point of a held tool, and, once it is in place, a text that says what it can do there. */
export class ToolHint {
  readonly root = ringSprite();
  private readonly output = document.createElement("output");
  private said = "";

  constructor(
    private readonly host: HTMLElement,
    private readonly models: Models,
    private readonly picker: Picker,
    /** The other text beside the held object. */
    private readonly other: HTMLElement,
  ) {
    this.root.visible = false;
    this.output.className = "tool-hint";
    this.output.ariaLabel = words.name;
    this.output.style.borderColor = guideColors.tool;
    host.append(this.output);
  }

  dispose(): void {
    this.output.remove();
  }

  /** Call once a picture, when the poses of all objects are known. */
  update(camera: PerspectiveCamera): void {
    const shown = toolInPlace();
    const marked = shown ?? toolOf(heldObject.value);
    const group = marked && this.models.groupOf(marked.tool);
    this.root.visible = marked !== null && group !== null;
    if (marked === null || group === null) return this.say([]);
    const place = group.localToWorld(marked.point.clone());
    this.say(shown ? [words.can(shown.tool, shown.use.do, shown.use.target), howToUse(shown)] : this.wayToWork(place));
    this.root.position.copy(place);
    this.root.material.opacity = shown === null ? FAINT : 1;
    this.root.scale.setScalar(MARK_SIZE * apparentDistance(camera, place));
    this.placeText(place);
  }

  /** How far the tool of the current hand is from the nearest place at which it can work, if that is not far. */
  private wayToWork(from: Vector3): string[] {
    const work = state.value?.hands[currentHand.value].work;
    if (!work || scene.value === null) return [];
    const way = new Vector3(...work.by);
    const meters = way.length() * scene.value.metersPerUnit;
    if (meters > FAR) return [];
    const missing = words.missing(this.picker.arrow(from, way), Math.ceil(1000 * meters), work.target);
    return may("command") === true && !areAidsFixed.value ? [missing, words.bring] : [missing];
  }

  /** The element stays while it is empty, and changes only with its words: screen readers then announce them once. */
  private say(lines: string[]): void {
    const text = lines.join("\n");
    if (text === this.said) return;
    this.said = text;
    const [can, how] = lines;
    this.output.replaceChildren(...[element("strong", can), element("span", how)].flat());
  }

  private placeText(place: Vector3): void {
    const box = this.host.getBoundingClientRect();
    const { x, y } = this.picker.toPage(place);
    const { offsetWidth, offsetHeight, style } = this.output;
    const left = within(x - box.left + GAP, box.width - offsetWidth);
    const top = within(y - box.top + GAP, box.height - offsetHeight);
    const { offsetLeft, offsetTop, offsetHeight: otherHeight } = this.other;
    const isOver = otherHeight > 0 && offsetLeft < left + offsetWidth && offsetTop < top + offsetHeight && top < offsetTop + otherHeight;
    style.left = `${left}px`;
    style.top = `${isOver ? within(offsetTop + otherHeight + MARGIN, box.height - offsetHeight) : top}px`;
  }
}

/** Null for what is no tool. */
function toolOf(tool: string | null | undefined): Omit<ToolInPlace, "use"> | null {
  const described = scene.value?.objects.find(({ id }) => id === tool)?.tool;
  if (!tool || !described) return null;
  return { tool, point: new Vector3(...described.point), turns: described.turns };
}

/** The tool of the current hand, or else one of another hand or a gripper, if it is in place. */
function toolInPlace(): ToolInPlace | null {
  const uses = state.value?.uses ?? {};
  const tool = toolOf([heldObject.value, ...Object.keys(uses)].find((id) => id !== null && Object.hasOwn(uses, id)));
  return tool && { ...tool, use: uses[tool.tool]! };
}

/** What a person does to use it; empty if this page's hand cannot. */
function howToUse({ tool, use, turns }: ToolInPlace): string {
  const hands = state.value?.hands;
  if (may("command") !== true || !hands) return "";
  if (heldObject.value === tool) {
    const onlyLoosens = turns && !use.do.includes("fasten");
    const entry = onlyLoosens ? texts.menu.useLoosening(tool) : texts.menu.use(tool, use);
    return words.byHand(entry, turns, isTouch.value);
  }
  const isInOtherHand = Object.values(hands).some(({ object }) => object === tool);
  return isInOtherHand ? words.changeHand : words.byGripper(turns);
}

function element(name: "strong" | "span", text: string | undefined): HTMLElement[] {
  if (!text) return [];
  const made = document.createElement(name);
  made.textContent = text;
  return [made];
}

/** Between the margins of the picture [px]. */
function within(at: number, room: number): number {
  return Math.max(MARGIN, Math.min(at, room - MARGIN));
}

/** A ring with a bright edge, before everything else. */
function ringSprite(): Sprite {
  const size = 64; // [px]
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = size;
  const pen = canvas.getContext("2d");
  for (const [color, width] of [["#ffffff", 18], [guideColors.tool, 10]] as const) {
    if (!pen) break;
    pen.strokeStyle = color;
    pen.lineWidth = width;
    pen.beginPath();
    pen.arc(size / 2, size / 2, size / 2 - 10, 0, 2 * Math.PI);
    pen.stroke();
  }
  const map = new CanvasTexture(canvas);
  map.colorSpace = SRGBColorSpace;
  const sprite = new Sprite(new SpriteMaterial({ map, depthTest: false, toneMapped: false }));
  sprite.renderOrder = MARK_ORDER;
  return sprite;
}
