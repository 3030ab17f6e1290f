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

function entry(label: string, reason: string | null, fields: Record<string, unknown>): MenuEntry {
  const onChoose = () => void command({ hand: currentHand.value, ...fields });
  return reason === null ? { label, onChoose } : { label, reason, disabled: true, onChoose };
}

/** The innermost part that may be pointed at, or the whole object. */
function pointableAround(object: SceneObject, part: string | null): string {
  const found = object.parts.find((one) => one.id === part);
  if (!found) return object.id;
  return found.pointable ? found.id : pointableAround(object, found.within);
}

/** What a hand may do with what was clicked, and why not. */
function entriesAt({ object, part, point }: Place): MenuEntry[] {
  const { menu, menuReasons: reasons } = texts;
  const held = heldObject.value;
  const control = object.controls.find((one) => one.id === part || (part !== null && one.parts.includes(part))) ?? object.controls[0];
  const watching = isController.value ? null : reasons.watching;
  const idle = watching ?? (held === null ? null : reasons.handFull);
  const bonds =
    watching ?? (held !== null && held !== object.id ? reasons.onlyHeld : object.bonds ? null : reasons.noBonds);
  const pressed = part !== null && control?.parts.includes(part) ? { part } : {};
  return [
    entry(menu.trigger, control ? idle : reasons.noControl, { do: "trigger", control: control?.id, ...pressed }),
    entry(menu.point, idle, { do: "point", part: pointableAround(object, part) }),
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
