import type { Command } from "../commands";
import { command, currentHand, heldObject, isController, scene, state } from "../studio";
import type { SceneObject } from "../protocol";
import { texts } from "../texts";
import { Menu, type MenuEntry } from "../ui/menu";
import { contextMenu } from "../world/signals";

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

function entry(label: string, reason: string | null, wanted: Command): MenuEntry {
  const onChoose = () => void command(wanted);
  return reason === null ? { label, onChoose } : { label, reason, disabled: true, onChoose };
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

/** Why it cannot be triggered there at all. */
function whyNoTrigger(control: Control | null, part: string | null): string | null {
  const { menuReasons: reasons } = texts;
  if (control === null) return reasons.noControl;
  if (isLights(control)) return reasons.lights;
  return part !== null && state.value?.pressed.includes(part) ? reasons.isDown : null;
}

/** What a hand may do with what was clicked, and why not. */
function entriesAt({ object, part, button, point }: Place): MenuEntry[] {
  const { menu, menuReasons: reasons } = texts;
  const hand = currentHand.value;
  const held = heldObject.value;
  const around = partAndAround(object, part);
  const ids = around.map(({ id }) => id);
  const control = controlAt(object, part, ids);
  const triggered = [button, part, ...ids].find((id) => id !== null && control?.parts.includes(id)) ?? null;
  const pointed = around.find(({ pointable }) => pointable)?.id ?? object.id;
  const watching = isController.value ? null : reasons.watching;
  const idle = watching ?? (held === null ? null : reasons.handFull);
  const bonds =
    watching ?? (held !== null && held !== object.id ? reasons.onlyHeld : object.bonds ? null : reasons.noBonds);
  return [
    entry(menu.trigger, whyNoTrigger(control, triggered) ?? idle, {
      do: "trigger",
      hand,
      control: control?.id ?? "",
      ...(triggered === null ? {} : { part: triggered }),
    }),
    entry(menu.point, idle, { do: "point", hand, part: pointed }),
    entry(menu.fasten, bonds, { do: "fasten", hand, object: object.id, point }),
    entry(menu.loosen, bonds, { do: "loosen", hand, object: object.id, point }),
  ];
}

export function ContextMenu() {
  const at = contextMenu.value;
  const object = scene.value?.objects.find((one) => one.id === at?.object);
  if (!at || !object) return null;
  return (
    <Menu
      key={`${at.x} ${at.y}`}
      label={texts.menu.title(object.id)}
      x={at.x}
      y={at.y}
      entries={entriesAt({ object, part: at.part, button: at.button, point: at.point })}
      onClose={() => (contextMenu.value = null)}
    />
  );
}
