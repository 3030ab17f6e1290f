import { useEffect, useRef } from "preact/hooks";
import { useSignal } from "@preact/signals";
import { may, when } from "../allowed";
import { ask, isConnected, request } from "../studio";
import { Refused } from "../connection";
import type { Diagnostic } from "../protocol";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { Dialog } from "../ui/dialog";
import { Icon } from "../ui/icons";
import { draft, editedScene } from "./page";

const { editor: words } = texts;
/** Time between the last key and the check of the text. */
const PAUSE_MS = 350;
/** Of a line of the text [px]; styles/editor.css has the same. */
const LINE_HEIGHT = 20;

type Findings = { state: "checking" | "unknown" } | { state: "checked"; diagnostics: Diagnostic[] };

async function check(name: string, xml: string): Promise<Findings> {
  try {
    const reply = await request("check", { name, xml });
    return { state: "checked", diagnostics: reply.diagnostics ?? [] };
  } catch (error) {
    if (!(error instanceof Refused)) return { state: "unknown" };
    const message = { file: name, line: 1, element: "", message: error.message };
    return { state: "checked", diagnostics: error.reply.diagnostics ?? [message] };
  }
}

function Gutter({ lines, wrong, top }: { lines: number; wrong: Set<number>; top: number }) {
  return (
    <div class="editor-gutter" aria-hidden="true">
      <div style={{ transform: `translateY(${-top}px)` }}>
        {Array.from({ length: lines }, (_, k) => (
          <div key={k} class={wrong.has(k + 1) ? "wrong" : ""}>
            {k + 1}
          </div>
        ))}
      </div>
    </div>
  );
}

function FindingList({ findings, onGo }: { findings: Findings; onGo: (line: number) => void }) {
  if (findings.state !== "checked") {
    return <p class="hint">{findings.state === "checking" ? words.checking : words.wait}</p>;
  }
  if (findings.diagnostics.length === 0) {
    return (
      <p class="hint right">
        <Icon name="check" size={18} />
        {words.isRight}
      </p>
    );
  }
  return (
    <ul class="findings" aria-label={words.findings}>
      {findings.diagnostics.map((finding, k) => (
        <li key={k}>
          <button type="button" onClick={() => onGo(finding.line)}>
            <strong>{words.line(finding.line)}</strong> {finding.element} {finding.message}
          </button>
        </li>
      ))}
    </ul>
  );
}

/** The findings in a scene, checked after a moment without typing. */
function useFindings(name: string, xml: string) {
  const findings = useSignal<Findings>({ state: "checking" });
  useEffect(() => {
    let isLatest = true;
    const timer = setTimeout(() => {
      void check(name, xml).then((found) => {
        if (isLatest) findings.value = found;
      });
    }, PAUSE_MS);
    return () => {
      isLatest = false;
      clearTimeout(timer);
    };
  }, [xml, name, isConnected.value]);
  return findings;
}

/** A scene as text, checked while it is written; errors are marked at their lines. */
export function SceneEditor() {
  const given = editedScene.value!;
  const name = useSignal(given.name);
  const xml = useSignal(given.xml);
  const findings = useFindings(name.value, xml.value);
  const top = useSignal(0);
  const isLoading = useSignal(false);
  const area = useRef<HTMLTextAreaElement>(null);
  const close = () => (editedScene.value = null);
  const forget = () => {
    draft.value = null;
    close();
  };
  const isChanged = xml.value !== given.xml || name.value !== given.name || draft.value !== null;

  const change = (text: string) => {
    xml.value = text;
    draft.value = { name: name.value, xml: text };
  };
  const lines = xml.value.split("\n");
  const diagnostics = findings.value.state === "checked" ? findings.value.diagnostics : [];
  const wrong = new Set(diagnostics.map((finding) => finding.line));
  const goTo = (line: number) => {
    const begin = lines.slice(0, line - 1).reduce((sum, text) => sum + text.length + 1, 0);
    area.current?.focus();
    area.current?.setSelectionRange(begin, begin + (lines[line - 1]?.length ?? 0));
    area.current?.scrollTo({ top: (line - 5) * LINE_HEIGHT });
  };
  const load = async () => {
    isLoading.value = true;
    const reply = await ask("load", { xml: xml.value, name: name.value });
    isLoading.value = false;
    if (reply !== null) forget();
  };
  return (
    <Dialog
      title={words.title}
      class="editor"
      onClose={close}
      actions={
        <>
          {isChanged && <Button label={words.discard} kind="danger" onClick={forget} />}
          <Button label={isChanged ? words.later : texts.close} onClick={close} />
          <Button
            label={words.load}
            kind="accent"
            isBusy={isLoading.value}
            title={when(may("load")).title}
            disabled={may("load") !== true || diagnostics.length > 0 || name.value === ""}
            onClick={() => void load()}
          />
        </>
      }
    >
      <label class="field">
        <span class="field-label">{words.name}</span>
        <input type="text" value={name.value} maxLength={80} onInput={(event) => (name.value = event.currentTarget.value)} />
      </label>
      <div class="editor-text">
        <Gutter lines={lines.length} wrong={wrong} top={top.value} />
        <textarea
          ref={area}
          aria-label={words.text}
          aria-invalid={diagnostics.length > 0}
          spellcheck={false}
          autocapitalize="off"
          wrap="off"
          value={xml.value}
          onInput={(event) => change(event.currentTarget.value)}
          onScroll={(event) => (top.value = event.currentTarget.scrollTop)}
        />
      </div>
      <div class="editor-findings" role="status">
        {diagnostics.length > 0 && <strong>{words.errors(diagnostics.length)}</strong>}
        <FindingList findings={findings.value} onGo={goTo} />
      </div>
    </Dialog>
  );
}
