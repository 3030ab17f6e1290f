import { useSignal } from "@preact/signals";
import { request } from "../studio";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { Dialog } from "../ui/dialog";
import { refreshSets } from "./datasets";
import { NameField } from "./job_dialog";
import { renamedSet } from "./page";

const { datasets: words } = texts;

/** The name of a generated set, which is that of its folder. */
export function RenameSetDialog({ name: before }: { name: string }) {
  const name = useSignal(before);
  const error = useSignal<string | null>(null);
  const close = () => (renamedSet.value = null);
  const save = async () => {
    try {
      await request("rename_set", { set: before, name: name.value });
    } catch (reason) {
      error.value = (reason as Error).message;
      return;
    }
    close();
    await refreshSets();
  };
  return (
    <Dialog
      title={words.renameTitle(before)}
      onClose={close}
      actions={
        <>
          <Button label={texts.cancel} onClick={close} />
          <Button label={texts.library.save} kind="accent" onClick={() => void save()} />
        </>
      }
    >
      <form
        onSubmit={(event) => {
          event.preventDefault();
          void save();
        }}
      >
        <NameField label={words.name} name={name} />
        {error.value !== null && (
          <p class="said trouble" role="alert">
            {error.value}
          </p>
        )}
      </form>
    </Dialog>
  );
}
