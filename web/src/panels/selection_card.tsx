import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { Card } from "../ui/card";
import { copied, copySelected, moveSelected, paste, select, selected } from "../world/selection";
import { mayAct } from "./derived_signals";
import { DIRECTIONS, type Direction, stepAlong, stepSize } from "./directions";
import { keyFor } from "./key_names";

const { selection: words } = texts;

/** What is done to several objects at once. */
export function SelectionCard() {
  const number = selected.value.length;
  if (number === 0 && copied.value.length === 0) return null;
  const isIdle = !mayAct.value || number === 0;
  return (
    <Card title={words.title(number)}>
      {number > 0 && <p class="hint">{selected.value.join(", ")}</p>}
      <div class="row tight" role="group" aria-label={words.move}>
        {(Object.keys(DIRECTIONS) as Direction[]).map((direction) => (
          <Button
            key={direction}
            label={words.directions[direction]}
            icon={DIRECTIONS[direction].icon}
            isIconOnly
            keys={keyFor(DIRECTIONS[direction].what)}
            disabled={isIdle}
            onClick={() => moveSelected(stepAlong(direction, Number(stepSize.value)))}
          />
        ))}
      </div>
      <div class="row">
        <Button
          label={words.copy}
          icon="copy"
          keys={keyFor("objects.copy")}
          isKeyHidden
          class="grow"
          disabled={number === 0}
          onClick={copySelected}
        />
        <Button
          label={words.paste}
          icon="plus"
          keys={keyFor("objects.paste")}
          isKeyHidden
          title={words.pasteWhy}
          class="grow"
          disabled={!mayAct.value || copied.value.length === 0}
          onClick={() => void paste()}
        />
        <Button
          label={words.deselect}
          icon="cross"
          isIconOnly
          kind="quiet"
          keys={keyFor("hand.stop")}
          disabled={number === 0}
          onClick={() => select([])}
        />
      </div>
    </Card>
  );
}
