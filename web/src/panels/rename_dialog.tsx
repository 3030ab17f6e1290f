import { useSignal } from "@preact/signals";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { Dialog } from "../ui/dialog";
import { renamed } from "./page";
import { MAX_TITLE_LENGTH, recordingOf, renameRecording, titleOf } from "./recordings";

const { library: words } = texts;

/** Title and notes of a recording. */
export function RenameDialog({ id }: { id: string }) {
  const title = useSignal(titleOf(id));
  const notes = useSignal(recordingOf(id)?.notes ?? "");
  const close = () => (renamed.value = null);
  const save = async () => {
    if (await renameRecording(id, { title: title.value, notes: notes.value })) close();
  };
  return (
    <Dialog
      title={words.rename}
      onClose={close}
      actions={
        <>
          <Button label={texts.cancel} onClick={close} />
          <Button label={words.save} kind="accent" onClick={() => void save()} />
        </>
      }
    >
      <form
        onSubmit={(event) => {
          event.preventDefault();
          void save();
        }}
      >
        <label class="field">
          <span class="field-label">{words.name}</span>
          <input
            type="text"
            value={title.value}
            maxLength={MAX_TITLE_LENGTH}
            onInput={(event) => (title.value = event.currentTarget.value)}
          />
        </label>
        <label class="field">
          <span class="field-label">{words.notes}</span>
          <textarea
            rows={4}
            value={notes.value}
            maxLength={4000}
            onInput={(event) => (notes.value = event.currentTarget.value)}
          />
        </label>
      </form>
    </Dialog>
  );
}
