import type { Signal } from "@preact/signals";
import { useSignal } from "@preact/signals";
import type { FaceCommand } from "../commands";
import { command, scene, state } from "../studio";
import type { RobotDescription } from "../protocol";
import { texts } from "../texts";
import { Button, HoldButton } from "../ui/buttons";
import { Card, Empty } from "../ui/card";
import { Slider } from "../ui/slider";
import { Switch } from "../ui/switch";
import { layoutSwitch } from "../ui/preference";
import { isBrainAtWork, isPlayback, mayAct } from "./derived_signals";

type Joint = RobotDescription["joints"][number];

const { robot: words } = texts;
const MOODS: FaceCommand["mood"][] = ["idle", "watching", "working", "puzzled", "done"];
/** What is held down turns a joint at this share of its full speed. */
const HELD_SPEED = 0.4;
/** And a gripper so fast [units/s]. */
const GRIPPER_SPEED = 1;

const openCards: Record<string, Signal<boolean>> = {};
function isCardOpen(name: string): Signal<boolean> {
  return (openCards[name] ??= layoutSwitch(`robot-${name}-open`, name !== "others"));
}

/** Joints of arms turn, for people in degrees; rails go so far, in units. */
function shownPerUnit(joint: Joint): number {
  return joint.is_length ? 1 / (scene.value?.metersPerUnit ?? 1) : 180 / Math.PI;
}

/** Goes there at half of its speed, and stops at what is in the way: nothing jumps. */
function goTo(name: string, position: number): void {
  void command({ do: "trajectory", joints: [name], points: [{ seconds: 0, positions: [position] }] });
}

function turn(joint: Joint, share: number): void {
  void command({ do: "turn", joint: joint.name, velocity: share * HELD_SPEED * joint.speed });
}

/** The head's joints are of no arm. */
function groupOf(joint: Joint): string {
  return joint.arm || (joint.is_head ? "head" : "others");
}

function shortName(joint: Joint): string {
  const prefix = `${groupOf(joint)}_`;
  return joint.name.startsWith(prefix) ? joint.name.slice(prefix.length) : joint.name;
}

function JointRow({ joint }: { joint: Joint }) {
  const scale = shownPerUnit(joint);
  const digits = joint.is_length ? 2 : 0;
  const unit = joint.is_length ? texts.units : texts.degrees;
  const [lower, upper] = [joint.lower * scale, joint.upper * scale];
  return (
    <div class="joint">
      <HoldButton
        label={words.less(joint.name)}
        icon="minus"
        disabled={!mayAct.value}
        onPress={() => turn(joint, -1)}
        onRelease={() => turn(joint, 0)}
      />
      <div class="grow">
        <Slider
          label={joint.name}
          shortLabel={shortName(joint)}
          value={(state.value?.robot?.joints[joint.name] ?? 0) * scale}
          min={lower}
          max={upper}
          step={joint.is_length ? 0.01 : 1}
          digits={digits}
          unit={unit}
          disabled={!mayAct.value}
          onInput={(value) => goTo(joint.name, value / scale)}
        />
        <div class="limits" aria-hidden="true">
          {words.limits(lower, upper, digits)}
        </div>
      </div>
      <HoldButton
        label={words.further(joint.name)}
        icon="plus"
        disabled={!mayAct.value}
        onPress={() => turn(joint, 1)}
        onRelease={() => turn(joint, 0)}
      />
    </div>
  );
}

function GripperRow({ gripper, opening }: { gripper: RobotDescription["grippers"][number]; opening: number }) {
  const move = (velocity: number) => void command({ do: "gripper", arm: gripper.arm, velocity });
  const meters = scene.value?.metersPerUnit ?? 1;
  return (
    <div class="joint">
      <HoldButton
        label={words.closeGripper(gripper.arm)}
        icon="minus"
        disabled={!mayAct.value}
        onPress={() => move(-GRIPPER_SPEED)}
        onRelease={() => move(0)}
      />
      {gripper.stroke > 0 ? (
        <div class="grow">
          <Slider
            label={words.gripper(gripper.arm)}
            shortLabel={words.gripperOf(gripper.arm)}
            value={opening}
            min={0}
            max={gripper.stroke}
            step={0.01}
            digits={2}
            unit={texts.units}
            disabled={!mayAct.value}
            onInput={(value) => goTo(`${gripper.arm}_gripper`, value * meters)}
          />
          <div class="limits" aria-hidden="true">
            {words.limits(0, gripper.stroke, 2)}
          </div>
        </div>
      ) : (
        // A suction cup has no opening: it takes and releases.
        <div class="grow">{words.gripperOf(gripper.arm)}</div>
      )}
      <HoldButton
        label={words.openGripper(gripper.arm)}
        icon="plus"
        disabled={!mayAct.value}
        onPress={() => move(GRIPPER_SPEED)}
        onRelease={() => move(0)}
      />
    </div>
  );
}

function General({ robot }: { robot: RobotDescription }) {
  const pose = useSignal(robot.poses[0] ?? "");
  const now = state.value?.robot;
  return (
    <>
      <Switch
        label={words.show}
        isOn={now?.shown ?? true}
        disabled={!mayAct.value}
        onChange={(shown) => void command({ do: "robot", shown })}
      />
      {robot.poses.length > 0 && (
        <div class="row">
          <label class="grow inline-field">
            <span>{words.pose}</span>
            <select value={pose.value} onChange={(event) => (pose.value = event.currentTarget.value)}>
              {robot.poses.map((name) => (
                <option key={name}>{name}</option>
              ))}
            </select>
          </label>
          <Button
            label={words.go}
            kind="accent"
            disabled={!mayAct.value}
            onClick={() => void command({ do: "pose", name: pose.value })}
          />
        </div>
      )}
      <div class="row">
        <label class="grow inline-field">
          <span>{words.mood}</span>
          <select
            value={now?.mood ?? "idle"}
            disabled={!mayAct.value}
            onChange={(event) => void command({ do: "face", mood: event.currentTarget.value as FaceCommand["mood"] })}
          >
            {MOODS.map((mood) => (
              <option key={mood} value={mood}>
                {words.moods[mood]}
              </option>
            ))}
          </select>
        </label>
        <Button
          label={words.stop}
          icon="stop"
          title={words.stopWhy}
          disabled={!mayAct.value}
          onClick={() => robot.joints.forEach((joint) => turn(joint, 0))}
        />
      </div>
      <Markers />
    </>
  );
}

/** Points that a brain marked for people. */
function Markers() {
  const number = state.value?.markers.length ?? 0;
  if (number === 0) return null;
  return (
    <div class="row">
      <span class="grow">{words.markers(number)}</span>
      <Button
        label={words.forgetMarkers}
        disabled={!mayAct.value}
        onClick={() => void command({ do: "markers", points: [] })}
      />
    </div>
  );
}

/** Joints by the arm they belong to; in the order in which the robot has them. */
function groupsOf(robot: RobotDescription): { name: string; title: string; joints: Joint[] }[] {
  const groups = new Map<string, Joint[]>();
  for (const joint of robot.joints) {
    const name = groupOf(joint);
    groups.set(name, [...(groups.get(name) ?? []), joint]);
  }
  const titles: Record<string, string> = { head: words.head, others: words.others };
  return [...groups].map(([name, joints]) => ({ name, title: titles[name] ?? words.arm(name), joints }));
}

export function RobotPanel() {
  const robot = scene.value?.robot ?? null;
  if (robot === null) {
    return (
      <Empty icon="robot" text={words.none}>
        <p class="hint">{words.noneHint}</p>
      </Empty>
    );
  }
  if (isPlayback.value) {
    return (
      <Empty icon="robot" text={texts.timeline.playbackBanner}>
        <p class="hint">{words.playbackHint}</p>
      </Empty>
    );
  }
  const openings = state.value?.robot?.grippers ?? [];
  return (
    <>
      <Card
        title={robot.name || words.title}
        aside={state.value?.robot?.following && <span class="badge">{words.following}</span>}
      >
        {isBrainAtWork.value && <p class="hint">{words.driving}</p>}
        <General robot={robot} />
      </Card>
      {robot.grippers.length > 0 && (
        <Card title={words.grippers} isOpen={isCardOpen("grippers")}>
          {robot.grippers.map((gripper, k) => (
            <GripperRow key={gripper.arm} gripper={gripper} opening={openings[k] ?? 0} />
          ))}
        </Card>
      )}
      {groupsOf(robot).map(({ name, title, joints }) => (
        <Card key={name} title={title} isOpen={isCardOpen(name)}>
          {joints.map((joint) => (
            <JointRow key={joint.name} joint={joint} />
          ))}
        </Card>
      ))}
    </>
  );
}
