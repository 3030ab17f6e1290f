// What dialogs share that simulate a recording in another way, and save the result.

import { useRef } from "preact/hooks";
import { useSignal } from "@preact/signals";
import { ask, cancelableRequest, notify, progress } from "../studio";
import type { Requests } from "../protocol";
import { texts } from "../texts";
import { openRecording, refreshRecordings, titleOf } from "./recordings";

const { edit: words } = texts;
export type Edits = Requests["edit"]["fields"]["edits"];

/** That a request takes its time, and how far it is as soon as that is known. */
export function Waiting({ what, label }: { what: "analyze" | "try_edit" | "edit"; label: string }) {
  const known = progress.value?.what === what ? progress.value : null;
  return (
    <p class="hint">
      <span class="spinner" /> {label}
      <progress aria-label={label} value={known?.done} max={known?.total} />
    </p>
  );
}

/** Saves an edit as a new recording and shows it; can be canceled until it is there. */
export function useSaving(onSaved: () => void) {
  const isSaving = useSignal(false);
  /** null unless it is being saved. */
  const cancelSaving = useRef<(() => void) | null>(null);
  const save = async (recording: string, edits: Edits, name: string) => {
    isSaving.value = true;
    const saving = cancelableRequest("edit", { recording, edits, name });
    cancelSaving.current = saving.cancel;
    try {
      const { recording: made } = await saving.answer;
      cancelSaving.current = null;
      await refreshRecordings();
      await openRecording(made);
      await ask("show", { recording: made, seconds: 0 });
      notify(words.saved(titleOf(made)));
      onSaved();
    } catch (error) {
      // Who canceled it knows why it failed.
      if (cancelSaving.current !== null) notify((error as Error).message, true);
    }
    isSaving.value = false;
  };
  const cancel = () => {
    cancelSaving.current?.();
    cancelSaving.current = null;
  };
  return { isSaving, save, cancel };
}
