import { isCommandOffered } from "../allowed";
import type { Command } from "../commands";
import { command, currentHand, heldObject, scene, state } from "../studio";
import type { SceneObject } from "../protocol";
import { texts } from "../texts";
import { Menu, type MenuEntry } from "../ui/menu";
import { isFixed } from "../world/hands";
import { contextMenu } from "../world/signals";
import { useAllowed } from "./use_allowed";

interface Place {
  object: SceneObject;
  part: string | null;
  button: string | null;
  point: [number, number, number];
}

/** The part and what is around it, innermost first. */
function partAndAround(object: SceneObject, part: string | null): SceneObject["parts"] {
  const found = object.parts.find((one) => one.id === part);
  return found === undefined ? [] : [found, ...partAndAround(object, found.within)];
}

type Control = SceneObject["controls"][number];

const isLights = ({ kind }: Control) => kind === "indicatorLights";

/** The control that was clicked; elsewhere what there is to trigger in the least part around, if it is one thing only. */
function controlAt(object: SceneObject, part: string | null, around: string[]): Control | null {
  const isClicked = ({ id, parts }: Control) => around.includes(id) || id === part || parts.includes(part ?? "");
  const clicked = object.controls.find(isClicked);
  if (clicked) return clicked;
  const others = object.controls.filter((one) => !isLights(one));
  const within = (part: string) => others.filter(({ id }) => partAndAround(object, id).some((one) => one.within === part));
  const nearest = [...around, object.id].map(within).find((found) => found.length > 0);
  return nearest?.length === 1 ? nearest[0]! : null;
}

interface Choice {
  label: string;
  /** Null where there is nothing that a command could name. */
  wanted: Command | null;
  /** What is meant where that is refused. */
  otherwise?: Command | undefined;
}

/** What a hand might do with what was clicked. */
function choicesAt({ object, part, button, point }: Place): Choice[] {
  const { menu } = texts;
  const hand = currentHand.value;
  const around = partAndAround(object, part);
  const ids = around.map(({ id }) => id);
  const control = controlAt(object, part, ids);
  const triggered = [button, part, ...ids].find((id) => id !== null && control?.parts.includes(id)) ?? null;
  const pointed = around.find(({ pointable }) => pointable)?.id ?? object.id;
  const trigger: Command | null = control && {
    do: "trigger",
    hand,
    control: control.id,
    ...(triggered === null ? {} : { part: triggered }),
  };
  const held = heldObject.value;
  const tool = scene.value?.objects.find(({ id }) => id === held)?.tool;
  // What a tool in the hand would do, or in grey why not: how far its tip is from the work.
  const uses: Choice[] =
    held === null
      ? []
      : [
          { label: menu.use(held, state.value?.uses[held]), wanted: { do: "use", hand } },
          ...(tool?.turns ? [{ label: menu.useLoosening(held), wanted: { do: "use", hand, loosen: true } } as const] : []),
        ];
  const take: Choice[] =
    held === null && !isFixed(object.id) ? [{ label: menu.take, wanted: { do: "grasp", hand, object: object.id, point } }] : [];
  return [
    ...uses,
    // One button of a rocker is always down: the other one is meant.
    { label: menu.trigger, wanted: trigger, otherwise: control && triggered ? { do: "trigger", hand, control: control.id } : undefined },
    ...take,
    { label: menu.point, wanted: { do: "point", hand, part: pointed } },
    { label: menu.fasten, wanted: { do: "fasten", hand, object: object.id, point } },
    { label: menu.loosen, wanted: { do: "loosen", hand, object: object.id, point } },
  ];
}

/** Each choice, or in grey why the program refuses it. */
function ChoiceMenu(props: { object: string; x: number; y: number; choices: Choice[] }) {
  const wanted = props.choices.flatMap((choice) => [choice.wanted, choice.otherwise]).filter((one) => one != null);
  const allowed = useAllowed(wanted.map((one) => ({ do: "command", command: one })));
  if (allowed.includes(null)) return null;
  const entries = props.choices.map(({ label, wanted: first, otherwise }): MenuEntry => {
    if (first === null) {
      return { label, reason: texts.menuReasons.noControl, disabled: true, onChoose: () => {} };
    }
    const may = [first, otherwise].find((one) => one !== undefined && allowed[wanted.indexOf(one)] === true);
    if (may) return { label, onChoose: () => void command(may) };
    return { label, reason: String(allowed[wanted.indexOf(first)]), disabled: true, onChoose: () => {} };
  });
  return (
    <Menu
      label={texts.menu.title(props.object)}
      x={props.x}
      y={props.y}
      entries={entries}
      onClose={() => (contextMenu.value = null)}
    />
  );
}

export function ContextMenu() {
  const at = contextMenu.value;
  const object = scene.value?.objects.find((one) => one.id === at?.object);
  if (!at || !object) return null;
  const all = choicesAt({ object, part: at.part, button: at.button, point: at.point });
  const choices = all.filter(({ wanted }) => isCommandOffered(wanted?.do ?? "trigger"));
  if (choices.length === 0) return null;
  return <ChoiceMenu key={`${at.x} ${at.y}`} object={object.id} x={at.x} y={at.y} choices={choices} />;
}
