import { command, currentHand, heldObject, isController, scene } from "../studio";
import type { SceneObject } from "../protocol";
import { texts } from "../texts";
import { Menu, type MenuEntry } from "../ui/menu";
import { contextMenu } from "../world/signals";

interface Place {
  object: SceneObject;
  part: string | null;
  point: [number, number, number];
}

/** The part and what is around it, innermost first. */
function partAndAround(object: SceneObject, part: string | null): SceneObject["parts"] {
  const found = object.parts.find((one) => one.id === part);
  return found === undefined ? [] : [found, ...partAndAround(object, found.within)];
}

function entry(label: string, reason: string | null, fields: Record<string, unknown>): MenuEntry {
  const onChoose = () => void command({ hand: currentHand.value, ...fields });
  return reason === null ? { label, onChoose } : { label, reason, disabled: true, onChoose };
}

/** What a hand may do with what was clicked, and why not. */
function entriesAt({ object, part, point }: Place): MenuEntry[] {
  const { menu, menuReasons: reasons } = texts;
  const held = heldObject.value;
  const around = partAndAround(object, part);
  const ids = around.map(({ id }) => id);
  const control =
    object.controls.find((one) => ids.includes(one.id) || ids.some((id) => one.parts.includes(id))) ??
    object.controls[0];
  const pressed = ids.find((id) => control?.parts.includes(id));
  const pointed = around.find(({ pointable }) => pointable)?.id ?? object.id;
  const watching = isController.value ? null : reasons.watching;
  const idle = watching ?? (held === null ? null : reasons.handFull);
  const bonds =
    watching ?? (held !== null && held !== object.id ? reasons.onlyHeld : object.bonds ? null : reasons.noBonds);
  return [
    entry(menu.trigger, control ? idle : reasons.noControl, {
      do: "trigger",
      control: control?.id,
      ...(pressed === undefined ? {} : { part: pressed }),
    }),
    entry(menu.point, idle, { do: "point", part: pointed }),
    entry(menu.fasten, bonds, { do: "fasten", object: object.id, point }),
    entry(menu.loosen, bonds, { do: "loosen", object: object.id, point }),
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
      entries={entriesAt({ object, part: at.part, point: at.point })}
      onClose={() => (contextMenu.value = null)}
    />
  );
}
