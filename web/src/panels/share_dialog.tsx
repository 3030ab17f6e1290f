import { useEffect, useRef } from "preact/hooks";
import { useSignal } from "@preact/signals";
import { may, when } from "../allowed";
import type { AnswerTo, ShareLink } from "../protocol";
import { ask, notify } from "../studio";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { Dialog } from "../ui/dialog";
import { shared } from "./page";
import { titleOf, whenMade } from "./recordings";

const { sharing: words } = texts;

type Links = AnswerTo<"share_links">;

/** The address of a link: where this page is, if links work on this machine only, for then the way to it may be a tunnel. */
function addressOf({ secret }: ShareLink, { origin, is_local }: Links): string {
  return `${is_local ? location.origin : origin}/shared/${secret}`;
}

function LinkRow(props: { address: string; made: string; onStop: () => void }) {
  const field = useRef<HTMLInputElement>(null);
  const copy = async () => {
    field.current!.select();
    try {
      await navigator.clipboard.writeText(props.address);
      notify(words.copied);
    } catch {
      // Without TLS, browsers give pages of other machines no clipboard; the link stays selected.
      notify(words.notCopied, true);
    }
  };
  return (
    <li class="share-link">
      <input
        type="text"
        readOnly
        ref={field}
        aria-label={words.link}
        value={props.address}
        onFocus={(event) => event.currentTarget.select()}
      />
      <Button label={words.copy} icon="copy" onClick={() => void copy()} />
      <small>{words.made(whenMade(props.made))}</small>
      <Button label={words.stop} kind="danger" {...when(may("stop_sharing"))} onClick={props.onStop} />
    </li>
  );
}

/** Makes links to a recording, and ends them. */
export function ShareDialog({ recording }: { recording: string }) {
  const known = useSignal<Links | null>(null);
  const isBusy = useSignal(false);
  const refresh = async () => {
    known.value = (await ask("share_links", { recording })) ?? known.value;
  };
  useEffect(() => void refresh(), []);
  const make = async () => {
    isBusy.value = true;
    await ask("share", { recording });
    await refresh();
    isBusy.value = false;
  };
  const stop = async (secret: string) => {
    if ((await ask("stop_sharing", { recording, secret })) !== null) notify(words.stopped);
    await refresh();
  };
  const close = () => (shared.value = null);
  const now = known.value;
  return (
    <Dialog
      title={words.title(titleOf(recording))}
      onClose={close}
      actions={
        <>
          <Button label={texts.close} onClick={close} />
          <Button label={words.make} kind="accent" isBusy={isBusy.value} {...when(may("share"))} onClick={() => void make()} />
        </>
      }
    >
      <p>{words.explanation}</p>
      {now !== null && (
        <>
          <p class="hint">{now.is_local ? words.onlyHere : words.reachable(now.origin)}</p>
          {now.links.length === 0 ? (
            <p class="said">{words.none}</p>
          ) : (
            <ul class="share-links" aria-label={words.links}>
              {now.links.map((link) => (
                <LinkRow
                  key={link.secret}
                  address={addressOf(link, now)}
                  made={link.made}
                  onStop={() => void stop(link.secret)}
                />
              ))}
            </ul>
          )}
        </>
      )}
    </Dialog>
  );
}
