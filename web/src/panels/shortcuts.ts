import { ask, command } from "../studio";
import { may, mayCommand } from "../allowed";
import { listenToKeys } from "../keys";
import { isPaused, isRecording } from "./derived_signals";
import { isHelpOpen } from "./page";
import { finishRecording } from "./recordings";

/** Keys that are not the world's. A key does what its button does, and nothing where that is grey. */
export function listenToShortcuts(): () => void {
  return listenToKeys({
    "record.toggle": () => {
      if (isRecording.value) {
        if (mayCommand("finish") === true) void finishRecording();
      } else if (mayCommand("start") === true) {
        void command({ do: "start" });
      }
    },
    "record.undo": () => mayCommand("undo") === true && void command({ do: "undo" }),
    "record.redo": () => mayCommand("redo") === true && void command({ do: "redo" }),
    "time.pause": () => {
      const what = isPaused.value ? "resume" : "pause";
      if (may(what) === true) void ask(what);
    },
    help: () => (isHelpOpen.value = true),
  });
}
