// What this page may ask for now. Each state from the program contains it; the page adds only
// whether it is connected and controls.

import type { Command } from "./commands";
import { isConnected, isController, offers, state } from "./studio";
import type { Allowed, Wanted } from "./protocol";
import { settled } from "./settled";
import { texts } from "./texts";

const permissions = settled(() => state.value?.allowed ?? null);

/** Whether the program has such a request at all; what needs it is left out otherwise. */
export function isOffered(what: Wanted): boolean {
  return offers.value?.requests.includes(what) ?? true;
}

/** The same of a command. */
export function isCommandOffered(what: Command["do"]): boolean {
  return offers.value?.commands.includes(what) ?? true;
}

/** Whether this page may ask for anything but to watch. */
export function mayControlNow(): Allowed {
  if (!isConnected.value) return texts.connection.none;
  return isController.value || texts.people.watchingReason;
}

/** Whether a request is carried out now; the reason why not. */
export function may(what: Wanted): Allowed {
  const control = mayControlNow();
  return control === true ? (permissions.value?.requests[what] ?? true) : control;
}

/** The same of a command that needs no object. */
export function mayCommand(what: "start" | "finish" | "undo" | "redo"): Allowed {
  const control = may("command");
  return control === true ? (permissions.value?.commands[what] ?? true) : control;
}

/** For a button: as it is, or grey with the reason; null: that is not known yet. */
export function when(allowed: Allowed | null | undefined, title?: string): { disabled: boolean; title: string | undefined } {
  return allowed === true ? { disabled: false, title } : { disabled: true, title: allowed ?? title };
}
