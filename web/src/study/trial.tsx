import { useEffect, useRef, useState } from "preact/hooks";
import { useSignalEffect } from "@preact/signals";
import { mayCommand, when } from "../allowed";
import { listenToKeys } from "../keys";
import { ContextMenu } from "../panels/context_menu";
import { mayAct, mayControl } from "../panels/derived_signals";
import { HandChoice, releaseHeld } from "../panels/hands_panel";
import { Stage } from "../panels/stage";
import { ask, clients, command, connect, currentHand, disconnect, heldObject, isConnected, request, state } from "../studio";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { Notices } from "../ui/notices";
import { areAidsFixed, guides, hasRings } from "../world/signals";
import { InputLog } from "./input_log";
import type { TrialContent } from "./messages";
import { useSecondsUntil } from "./seconds_left";
import { send, sessionFolder } from "./server";

const { study: words } = texts;
const TURNS = [-45, -5, 5, 45];

/** Connects the table of the trial; recording begins with control, and goes on if the page comes back. */
function useSession(content: TrialContent): { isReady: boolean } {
  const isStarted = useRef(false);
  const [isReady, setReady] = useState(false);
  useEffect(() => {
    areAidsFixed.value = true;
    guides.value = content.aids.ghost;
    hasRings.value = content.aids.rings;
    connect(sessionFolder);
    return disconnect;
  }, []);
  // After a reload, control is free as soon as the page before is gone.
  useSignalEffect(() => {
    if (isConnected.value && clients.value !== null && clients.value.controller === null) void ask("take_control");
  });
  useSignalEffect(() => {
    if (!mayControl.value || state.value === null || isStarted.current) return;
    isStarted.current = true;
    const isRecording = state.value.recording !== null;
    const start = async () => {
      await ask("snap", { to: content.aids.snap });
      if (!isRecording) await command({ do: "start", name: "trial" });
      setReady(true);
    };
    void start();
  });
  return { isReady };
}

/** Turns what is held about the vertical. */
function turn(degrees: number): void {
  void ask("command", { command: { do: "rotate", hand: currentHand.value, angles: [0, 0, degrees] }, exact: true });
}

function Actions() {
  const isHolding = heldObject.value !== null && mayAct.value;
  return (
    <div class="study-actions" role="group" aria-label={words.actions}>
      <Button label={texts.hands.release} disabled={!isHolding} onClick={releaseHeld} />
      {TURNS.map((degrees) => (
        <button
          key={degrees}
          type="button"
          class="button plain small"
          aria-label={words.turnBy(degrees)}
          disabled={!isHolding}
          onClick={() => turn(degrees)}
        >
          {degrees > 0 ? `+${degrees}°` : `−${-degrees}°`}
        </button>
      ))}
      <Button label={texts.record.undo} icon="undo" {...when(mayCommand("undo"))} onClick={() => void command({ do: "undo" })} />
      <Button label={texts.record.redo} icon="redo" {...when(mayCommand("redo"))} onClick={() => void command({ do: "redo" })} />
    </div>
  );
}

function listenToUndo(): () => void {
  return listenToKeys({
    "record.undo": () => mayCommand("undo") === true && void command({ do: "undo" }),
    "record.redo": () => mayCommand("redo") === true && void command({ do: "redo" }),
  });
}

/** The studio's table with what a participant needs, until the participant or the time ends it. */
export function Trial(props: { step: string; content: TrialContent; end: number }) {
  const { step, content, end } = props;
  const { isReady } = useSession(content);
  const [isEnding, setEnding] = useState(false);
  const log = useRef<InputLog | null>(null);
  const left = useSecondsUntil(end);
  const finish = async (reason: "done" | "limit") => {
    if (isEnding) return;
    setEnding(true);
    await request("command", { command: { do: "finish" } }).catch(() => undefined);
    disconnect();
    log.current?.close();
    send({ do: "trial_end", step, reason });
  };
  useEffect(() => {
    log.current = new InputLog();
    const quit = listenToUndo();
    return () => {
      log.current?.close();
      quit();
    };
  }, []);
  useEffect(() => {
    if (left === 0) void finish("limit");
  }, [left]);
  return (
    <div class="study-trial">
      <div class="study-bar">
        <p class="study-task">{content.text}</p>
        <span class="study-time" role="timer" aria-label={words.timeLeft}>
          {words.clock(left)}
        </span>
        <Button label={words.finish} kind="accent" isBusy={isEnding} disabled={!isReady} onClick={() => void finish("done")} />
      </div>
      <Stage>
        <div class="banners">
          <Notices />
        </div>
      </Stage>
      <div class="study-tools">
        <HandChoice />
        <Actions />
      </div>
      <ContextMenu />
    </div>
  );
}
