import { ask, command } from "../studio";
import { listenToKeys } from "../keys";
import { isPaused, isPlayback, isRecording, mayAct, mayControl } from "./now";
import { isHelpOpen } from "./page";
import { finishRecording } from "./recordings";

/** Keys that are not the world's. A key does what its button does, and nothing where that is grey. */
export function listenToShortcuts(): () => void {
  return listenToKeys({
    "record.toggle": () => {
      if (isRecording.value) {
        if (mayControl.value) void finishRecording();
      } else if (mayAct.value) {
        void command({ do: "start" });
      }
    },
    "record.undo": () => mayAct.value && void command({ do: "undo" }),
    "record.redo": () => mayAct.value && void command({ do: "redo" }),
    "time.pause": () => mayControl.value && !isPlayback.value && void ask(isPaused.value ? "resume" : "pause"),
    help: () => (isHelpOpen.value = true),
  });
}
