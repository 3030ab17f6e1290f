import { useEffect, useRef } from "preact/hooks";
import { signal } from "@preact/signals";
import { isCommandOffered, isOffered, may } from "../allowed";
import { command, ask, currentHand, heldObject, scene, state } from "../studio";
import { axisColors, handColors } from "../colors";
import { HANDS, type HandName, type Point, type Reply, type SnapName } from "../protocol";
import { texts } from "../texts";
import { Button, Chips } from "../ui/buttons";
import { Card } from "../ui/card";
import { layoutSwitch } from "../ui/preference";
import { NumberField } from "../ui/number_field";
import { Slider } from "../ui/slider";
import { Switch } from "../ui/switch";
import { DIRECTIONS, type Direction, stepAlong, STEPS, stepSize } from "./directions";
import { turnFromTo } from "./fixed_axes";
import { keyFor, keyHint } from "./key_names";
import { attention, mayAct, snaps } from "./derived_signals";
import { guides, isBringing, isOnRail, restHeight } from "../world/signals";
import { world } from "./page";

const { hands: words } = texts;
const isMoveOpen = layoutSwitch("move-open", true);
const isTurnOpen = layoutSwitch("turn-open", true);
const isPlaneOpen = layoutSwitch("plane-open", true);
const isSnapOpen = layoutSwitch("snap-open", true);

export function releaseHeld(): void {
  void command({ do: "release", hand: currentHand.value });
}

/** After its answer, a command takes this long at most to show in the state. */
const FOLLOW_MS = 400;

/** Three numbers of a held object, of which people change one after the other, faster than the state follows. */
class Wanted {
  private last: { object: string; numbers: Point } | null = null;
  private unanswered = 0;
  private followedAt = 0;

  /**
   * Changes what was asked for last; the state's value if the state has followed, or the last was refused.
   * @param reading the values in the state
   */
  change(object: string, reading: Point, to: (old: Point) => Point, send: (from: Point, numbers: Point) => Promise<Reply | null>): void {
    const isFollowed = this.unanswered === 0 && performance.now() >= this.followedAt;
    const { last } = this;
    const from = last !== null && last.object === object && !isFollowed ? last.numbers : reading;
    const numbers = to(from);
    this.last = { object, numbers };
    ++this.unanswered;
    void send(from, numbers).then((answer) => {
      --this.unanswered;
      this.followedAt = performance.now() + FOLLOW_MS;
      if (answer === null) this.last = null;
    });
  }
}

const wantedPlace = new Wanted();
const wantedAngles = new Wanted();

function withNumber(numbers: Point, axis: number, value: number): Point {
  return numbers.map((old, k) => (k === axis ? value : old)) as Point;
}

/** Goals of hands refer to the point at which they took the object. What is stopped is moved from where it is. */
function moveHeld(to: (place: Point) => Point): void {
  const hand = currentHand.value;
  const { object, goal, place, stopped_at: stopped } = state.value?.hands[hand] ?? {};
  if (!object || !goal || !place) return;
  wantedPlace.change(object, stopped ?? place, to, (_, numbers) => {
    const position = goal.map((old, k) => old + numbers[k]! - place[k]!) as Point;
    return command({ do: "move_to", hand, position });
  });
}

function millimeters(units: number): number {
  return Math.round(1000 * units * (scene.value?.metersPerUnit ?? 0));
}

function nudge(direction: Direction, length: number): void {
  const step = stepAlong(direction, length);
  moveHeld((place) => place.map((old, k) => old + step[k]!) as Point);
}

/** The four hands, each with what it holds. */
export function HandChoice() {
  const nextHand = keyHint("hand.next");
  return (
    <div class="hands" role="radiogroup" aria-label={words.current} aria-keyshortcuts={nextHand["aria-keyshortcuts"]}>
      {HANDS.map((hand: HandName) => (
        <label key={hand} class="hand" style={{ "--hand": handColors[hand] }} title={`${words.meanings[hand]}. ${nextHand.title}`}>
          <input
            type="radio"
            name="hand"
            checked={hand === currentHand.value}
            onChange={() => (currentHand.value = hand)}
          />
          <span class="swatch" />
          <span class="hand-name">{words.names[hand]}</span>
          <span class="hand-object">{state.value?.hands[hand].object ?? words.isEmpty}</span>
        </label>
      ))}
    </div>
  );
}

function propertyChoices(object: string): { value: string; label: string }[] {
  const properties = scene.value?.objects.find((one) => one.id === object)?.properties ?? [];
  return properties.map((value) => ({ value, label: texts.properties[value] ?? value }));
}

/** Uses a held tool; if its tip is not where it can work, the program says how far it is. */
function UseTool({ object }: { object: string }) {
  const tool = scene.value?.objects.find((one) => one.id === object)?.tool;
  if (tool === undefined || !isCommandOffered("use")) return null;
  const hand = currentHand.value;
  const isInPlace = Object.hasOwn(state.value?.uses ?? {}, object);
  const work = state.value?.hands[hand].work;
  return (
    <>
      {work && !isInPlace && (
        <Button
          label={words.bring}
          icon="lower"
          class="wide"
          title={words.bringWhy(work.target)}
          disabled={!mayAct.value || isBringing.value}
          onClick={() => void world.value?.bringToWork()}
        />
      )}
      <Button
        label={texts.menu.use(object, state.value?.uses[object])}
        icon="check"
        class="wide"
        disabled={!mayAct.value}
        onClick={() => void command({ do: "use", hand })}
      />
      <p class="hint">{tool.turns ? words.useOrTurn : words.useHint}</p>
    </>
  );
}

function Held() {
  return (
    <div class="row">
      <Button
        label={words.release}
        kind="accent"
        class="grow"
        keys={keyFor("hand.release")}
        tour="release"
        disabled={!mayAct.value}
        onClick={releaseHeld}
      />
      {!isOnRail.value && (
        <>
          <Button label={words.straighten} class="grow" title={words.straightenWhy} disabled={!mayAct.value} onClick={straighten} />
          <Button
            label={words.lower}
            class="grow"
            title={words.lowerWhy}
            disabled={!mayAct.value || restHeight.value === null}
            onClick={() => moveHeld(([x, y, z]) => [x, y, restHeight.value ?? z])}
          />
        </>
      )}
      {isCommandOffered("destroy") && (
        <Button
          label={words.destroy}
          kind="danger"
          icon="trash"
          keys={keyFor("hand.destroy")}
          isKeyHidden
          title={words.destroyWhy}
          disabled={!mayAct.value}
          onClick={() => void command({ do: "destroy", hand: currentHand.value })}
        />
      )}
    </div>
  );
}

/** Which properties of the held object the robot should consider. */
function Attention({ object }: { object: string }) {
  const attended = attention.value[object] ?? [];
  const choices = propertyChoices(object);
  const toggle = (property: string) => {
    const properties = attended.includes(property) ? attended.filter((one) => one !== property) : [...attended, property];
    void command({ do: "attend", hand: currentHand.value, properties });
  };
  if (choices.length === 0) return null;
  return (
    <Card title={words.attention}>
      <p class="hint">{words.attentionWhy}</p>
      <Chips label={words.attention} choices={choices} chosen={attended} disabled={!mayAct.value} onToggle={toggle} />
    </Card>
  );
}

/** The object that was taken in the list: keys move it as soon as it is held, for users of the keyboard. */
export const takenInList = signal<string | null>(null);

/** Buttons and keys that carry the held object by small steps. */
function NudgePad() {
  const pad = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (takenInList.value === heldObject.value) pad.current?.focus();
    takenInList.value = null;
  }, []);
  const length = Number(stepSize.value);
  const go = (event: KeyboardEvent) => {
    const direction = (Object.keys(DIRECTIONS) as Direction[]).find((one) => DIRECTIONS[one].key === event.key);
    const isPad = event.target === pad.current;
    if (direction === undefined && !(isPad && event.key === "Enter")) return;
    event.preventDefault();
    event.stopPropagation();
    if (direction === undefined) releaseHeld();
    else nudge(direction, event.shiftKey ? 1 : length);
  };
  const button = (direction: Direction) => (
    <Button
      key={direction}
      label={words.directions[direction]}
      icon={DIRECTIONS[direction].icon}
      isIconOnly
      keys={keyFor(DIRECTIONS[direction].what)}
      class={`nudge-${direction}`}
      disabled={!mayAct.value}
      onClick={() => nudge(direction, length)}
    />
  );
  return (
    <div
      class="nudge"
      id="nudge"
      ref={pad}
      role="group"
      tabIndex={0}
      aria-label={words.nudge}
      title={words.nudgeHint}
      data-tour="nudge"
      onKeyDown={go}
    >
      {(Object.keys(DIRECTIONS) as Direction[]).map(button)}
      <label class="nudge-step">
        <span>{words.stepSize}</span>
        <select
          value={stepSize.value}
          onChange={(event) => (stepSize.value = event.currentTarget.value as (typeof STEPS)[number])}
        >
          {STEPS.map((step) => (
            <option key={step} value={step}>
              {words.step(millimeters(Number(step)))}
            </option>
          ))}
        </select>
      </label>
    </div>
  );
}

/** Where the object is, by numbers. */
function Position({ place }: { place: Point }) {
  return (
    <div class="row position" role="group" aria-label={`${words.position} (${texts.units})`}>
      {words.axisNames.map((axis, k) => (
        <NumberField
          key={axis}
          label={axis}
          isLabelled
          value={place[k]!}
          step={0.1}
          disabled={!mayAct.value}
          onCommit={(value) => moveHeld((old) => withNumber(old, k, value))}
        />
      ))}
    </div>
  );
}

/** By numbers: what is typed does not snap. */
function rotate(angles: Point): Promise<Reply | null> {
  return ask("command", { command: { do: "rotate", hand: currentHand.value, angles }, exact: true });
}

/** To right angles to the nearest object, or to the table. */
function straighten(): void {
  const turn = world.value?.straighteningTurn();
  if (turn) void rotate(turn);
}

function turnBy(axis: number, degrees: number): void {
  void rotate([0, 1, 2].map((k) => (k === axis ? degrees : 0)) as Point);
}

/** Gives the held object one angle of three, and keeps the others. */
function turnTo(object: string, reading: Point, axis: number, degrees: number): void {
  const to = (angles: Point) => withNumber(angles, axis, degrees);
  wantedAngles.change(object, reading, to, (from, numbers) => rotate(turnFromTo(from, numbers)));
}

/** About y half a turn suffices: three angles then specify every orientation once. */
const LARGEST = [180, 90, 180] as const;

function TurnSlider({ object, axis, reading }: { object: string; axis: 0 | 1 | 2; reading: Point }) {
  const quarter = (degrees: number) => (
    <button
      type="button"
      class="button plain small"
      aria-label={words.turnBy(words.axisNames[axis], degrees)}
      disabled={!mayAct.value}
      onClick={() => turnBy(axis, degrees)}
    >
      {degrees > 0 ? `+${degrees}` : `−${-degrees}`}
    </button>
  );
  return (
    <div class="turn-row">
      <Slider
        label={words.axes[axis]}
        value={Math.round(reading[axis])}
        min={-LARGEST[axis]}
        max={LARGEST[axis]}
        step={1}
        unit={texts.degrees}
        color={axisColors[axis]}
        disabled={!mayAct.value}
        onInput={(degrees) => turnTo(object, reading, axis, degrees)}
      />
      <div class="row tight">
        {quarter(-45)}
        {quarter(-1)}
        {quarter(1)}
        {quarter(45)}
      </div>
    </div>
  );
}

function Plane() {
  const angle = state.value?.hands[currentHand.value].plane ?? 0;
  return (
    <div class="row tight" role="group" aria-label={words.plane}>
      {[-90, -5].map((degrees) => planeButton(degrees))}
      <NumberField
        label={words.planeAngle}
        value={angle}
        digits={0}
        unit={texts.degrees}
        disabled={!mayAct.value}
        onCommit={(degrees) => world.value?.turnPlane(degrees - angle)}
      />
      {[5, 90].map((degrees) => planeButton(degrees))}
    </div>
  );
}

const PLANE_KEYS: Record<number, string> = { [-5]: "plane.right", 5: "plane.left", 90: "plane.quarter" };

function planeButton(degrees: number) {
  const what = PLANE_KEYS[degrees];
  return (
    <button
      key={degrees}
      type="button"
      class="button plain small"
      aria-label={words.planeBy(degrees)}
      {...(what === undefined ? { title: words.planeBy(degrees) } : keyHint(what, words.planeBy(degrees)))}
      disabled={!mayAct.value}
      onClick={() => world.value?.turnPlane(degrees)}
    >
      {degrees > 0 ? `+${degrees}` : `−${-degrees}`}
    </button>
  );
}

function Snapping() {
  const choices = (Object.keys(words.snaps) as (keyof typeof words.snaps)[]).map((value) => ({
    value,
    label: words.snaps[value],
    title: words.snapsWhy[value],
  }));
  const toggle = (snap: SnapName) => {
    const now = snaps.value;
    void ask("snap", { to: now.includes(snap) ? now.filter((one) => one !== snap) : [...now, snap] });
  };
  return (
    <>
      <Chips label={words.snap} choices={choices} chosen={snaps.value} disabled={!mayAct.value} onToggle={toggle} />
      {snaps.value.some((snap) => snap !== "rails") && <p class="hint">{words.snapHint}</p>}
      <Switch
        label={words.guides}
        isOn={guides.value}
        onChange={(isOn) => (guides.value = isOn)}
        more={keyHint("guides")}
      />
    </>
  );
}

function whyNothingIsHeld(): string {
  const allowed = may("command");
  if (allowed !== true) return words.notNow(allowed);
  const hands = state.value?.hands;
  const isEither = currentHand.value === "any" || currentHand.value === "both";
  return isEither && hands?.left.object && hands.right.object ? words.bothFull : words.nothingHeld;
}

export function HandsPanel() {
  const object = heldObject.value;
  const hand = state.value?.hands[currentHand.value];
  const angles: Point = hand?.angles ?? [0, 0, 0];
  return (
    <>
      <Card title={words.title}>
        <HandChoice />
        {object === null && <p class="hint">{whyNothingIsHeld()}</p>}
      </Card>
      {object !== null && (
        <Card title={`${words.held}: ${object}`}>
          <Held />
          <UseTool object={object} />
          {isOnRail.value && <p class="hint">{words.onRail}</p>}
        </Card>
      )}
      {isOffered("snap") && (
        <Card title={words.snap} isOpen={isSnapOpen}>
          <Snapping />
        </Card>
      )}
      {object !== null && (
        <>
          <Card title={words.move} isOpen={isMoveOpen}>
            <NudgePad />
            {hand?.place && <Position place={hand.stopped_at ?? hand.place} />}
            <p class="hint">{words.unit(millimeters(1))}</p>
          </Card>
          {!isOnRail.value && (
            <Card title={words.turn} isOpen={isTurnOpen}>
              <div data-tour="turn">
                {([0, 1, 2] as const).map((axis) => (
                  <TurnSlider key={`${object} ${axis}`} object={object} axis={axis} reading={angles} />
                ))}
              </div>
            </Card>
          )}
        </>
      )}
      <Card title={words.plane} isOpen={isPlaneOpen}>
        <Plane />
      </Card>
      {object !== null && <Attention object={object} />}
    </>
  );
}
