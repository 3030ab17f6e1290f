import { useEffect } from "preact/hooks";
import { effect } from "@preact/signals";
import { ask, clients, controlWantedBy, isConnected, isController, notify } from "../studio";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { MenuButton, type MenuEntry } from "../ui/menu";

/** Time after opening the page, or reconnecting, in which it takes control if no client has it. */
const ARRIVAL_MS = 3000;

export async function takeControl(byForce: boolean): Promise<void> {
  const reply = await ask("take_control", byForce ? { by_force: true } : {});
  if (reply === null) return;
  notify(reply.granted === true ? texts.people.taken : texts.people.asked);
}

function useControlOnArrival(): void {
  useEffect(() => {
    let arrived = -Infinity;
    return effect(() => {
      if (!isConnected.value) {
        arrived = -Infinity;
        return;
      }
      if (arrived === -Infinity) arrived = performance.now();
      const isFree = clients.value !== null && clients.value.controller === null;
      if (isFree && performance.now() - arrived < ARRIVAL_MS) void ask("take_control");
    });
  }, []);
}

function giveTo(client: number): void {
  void ask("give_control", { to: client });
}

function giving(client: number): MenuEntry {
  return { label: texts.people.give(client), onChoose: () => giveTo(client) };
}

function entries(): MenuEntry[] {
  const now = clients.value;
  if (now === null) return [];
  if (now.controller !== now.you) {
    return [
      { label: texts.people.take, onChoose: () => void takeControl(false) },
      { label: texts.people.takeByForce, onChoose: () => void takeControl(true) },
    ];
  }
  const others = now.clients.filter((client) => client !== now.you);
  return [
    ...others.map(giving),
    { label: texts.people.releaseControl, onChoose: () => void ask("give_control", { to: null }) },
  ];
}

/** Who is here, who controls, and how to change that. */
export function Control() {
  useControlOnArrival();
  const now = clients.value;
  const others = Math.max(0, (now?.clients.length ?? 1) - 1);
  const who = isController.value ? texts.people.youControl : now?.controller === null ? texts.people.noController : texts.people.youWatch;
  return (
    <div class="control">
      <span class={`lamp ${isConnected.value ? "on" : "off"}`} />
      <span class="control-words">
        {isConnected.value ? who : texts.connection.none}
        {isConnected.value && isController.value && others > 0 && <small>{texts.people.watching(others)}</small>}
      </span>
      {isConnected.value && <MenuButton label={texts.people.title} entries={entries()} />}
    </div>
  );
}

/** Reports beside the work, without interrupting it, that other clients want control. */
export function ControlWanted() {
  const waiting = controlWantedBy.value;
  const [first] = waiting;
  if (first === undefined) return null;
  const keep = () => {
    controlWantedBy.value = [];
    for (const from of waiting) void ask("keep_control", { from });
  };
  return (
    <div class="banner control-wanted" role="status" aria-label={texts.people.wantedTitle}>
      <span>
        {texts.people.wanted(waiting)} <small>{texts.people.wantedHint}</small>
      </span>
      <Button label={texts.people.keep} onClick={keep} />
      {waiting.length === 1 ? (
        <Button label={texts.people.handOver} kind="accent" onClick={() => giveTo(first)} />
      ) : (
        <MenuButton label={texts.people.handOver} isInWords entries={waiting.map(giving)} />
      )}
    </div>
  );
}
