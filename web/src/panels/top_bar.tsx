import { useRef } from "preact/hooks";
import { useSignal } from "@preact/signals";
import { may, mayCommand, when } from "../allowed";
import { ask, command, scene, state } from "../studio";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { Menu } from "../ui/menu";
import { fps } from "../world/signals";
import { Control } from "./control";
import { keyFor } from "./key_names";
import { isPaused, isRecording, isWatched, mayControl } from "./derived_signals";
import { DETAILS, detail, isHelpOpen, theme, THEMES } from "./page";
import { finishRecording } from "./recordings";

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4];

/** Record and Finish, Undo and Redo. */
function RecordButtons() {
  const { record: words } = texts;
  const seconds = state.value?.recording?.seconds ?? 0;
  return (
    <div class="record" role="group" aria-label={words.group}>
      {isRecording.value ? (
        <Button
          label={words.finish}
          icon="stop"
          kind="danger"
          class="record-button is-recording"
          keys={keyFor("record.toggle")}
          tour="record"
          {...when(mayCommand("finish"))}
          onClick={() => void finishRecording()}
        >
          <span class="record-time" aria-hidden="true">{texts.seconds(seconds)}</span>
        </Button>
      ) : (
        <Button
          label={words.start}
          icon="record"
          class="record-button"
          keys={keyFor("record.toggle")}
          tour="record"
          {...when(mayCommand("start"))}
          onClick={() => void command({ do: "start" })}
        />
      )}
      <Button
        label={words.undo}
        icon="undo"
        keys={keyFor("record.undo")}
        tour="undo"
        {...when(mayCommand("undo"))}
        onClick={() => void command({ do: "undo" })}
      />
      <Button
        label={words.redo}
        icon="redo"
        keys={keyFor("record.redo")}
        tour="redo"
        {...when(mayCommand("redo"))}
        onClick={() => void command({ do: "redo" })}
      />
    </div>
  );
}

/** How fast time goes by, and whether. */
function Time() {
  const { time: words } = texts;
  const factor = useSignal(1);
  const choose = async (next: number) => {
    if ((await ask("speed", { factor: next })) !== null) factor.value = next;
  };
  return (
    <div class="time" role="group" aria-label={words.group}>
      <Button
        label={isPaused.value ? words.resume : words.pause}
        icon={isPaused.value ? "play" : "pause"}
        kind="quiet"
        isIconOnly
        keys={keyFor("time.pause")}
        isPressed={isPaused.value}
        {...when(may(isPaused.value ? "resume" : "pause"))}
        onClick={() => void ask(isPaused.value ? "resume" : "pause")}
      />
      <select
        class="quiet"
        aria-label={words.speed}
        title={words.speed}
        value={factor.value}
        disabled={!mayControl.value}
        onChange={(event) => void choose(Number(event.currentTarget.value))}
      >
        {SPEEDS.map((speed) => (
          <option key={speed} value={speed}>
            {words.factor(speed)}
          </option>
        ))}
      </select>
      <Figures />
    </div>
  );
}

/** How fast everything is; behind it how finely the world is drawn. */
function Figures() {
  const { time: words, views } = texts;
  const at = useSignal<{ x: number; y: number } | null>(null);
  const button = useRef<HTMLButtonElement>(null);
  const open = () => {
    const box = button.current!.getBoundingClientRect();
    at.value = { x: box.left, y: box.bottom + 4 };
  };
  const entries = DETAILS.map((one) => ({
    label: views.detailIs(views.details[one]),
    ...(one === detail.value ? { icon: "check" as const } : {}),
    onChoose: () => void (detail.value = one),
  }));
  return (
    <>
      <button type="button" class="figures" ref={button} title={words.figures} onClick={open}>
        <span>{words.framesPerSecond(fps.value)}</span>
        <span>{words.measured(state.value?.speed ?? 0)}</span>
      </button>
      {at.value && <Menu label={views.detail} {...at.value} entries={entries} onClose={() => (at.value = null)} />}
    </>
  );
}

function ThemeButton() {
  const next = () => (theme.value = THEMES[(THEMES.indexOf(theme.value) + 1) % THEMES.length]!);
  const icons = { system: "sun", light: "sun", dark: "moon" } as const;
  return (
    <Button
      label={texts.theme[theme.value]}
      icon={icons[theme.value]}
      kind="quiet"
      isIconOnly
      class={theme.value === "system" ? "theme-system" : ""}
      onClick={next}
    />
  );
}

export function TopBar() {
  return (
    <header class="top-bar">
      <div class="name">
        <img src="icon.svg" alt="" width="24" height="24" />
        <h1>
          <span class="visually-hidden">{texts.title}: </span>
          {scene.value?.name ?? texts.title}
        </h1>
      </div>
      {isWatched.value ? (
        <div class="time" role="group" aria-label={texts.time.group}>
          <Figures />
        </div>
      ) : (
        <>
          <RecordButtons />
          <Time />
          <Control />
        </>
      )}
      <div class="page-buttons">
        <ThemeButton />
        {!isWatched.value && (
          <Button
            label={texts.help.open}
            icon="help"
            kind="quiet"
            isIconOnly
            keys={keyFor("help")}
            onClick={() => (isHelpOpen.value = true)}
          />
        )}
      </div>
    </header>
  );
}
