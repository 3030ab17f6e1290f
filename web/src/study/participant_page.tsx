import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { texts } from "../texts";
// Its choice of theme and its colors are those of the studio.
import "../panels/page";
import { Break } from "./break";
import { Consent } from "./consent";
import { Instruction } from "./instruction";
import type { StepMessage } from "./messages";
import { Questions } from "./questions";
import { isConnected, obstacle, refusal, step } from "./server";
import { Thanks } from "./thanks";
import { TrialStep } from "./trial_step";

const { study: words } = texts;

function content(now: StepMessage) {
  switch (now.kind) {
    case "consent":
      return <Consent {...now} />;
    case "instruction":
      return <Instruction {...now} />;
    case "practice":
    case "task":
      return <TrialStep {...now} />;
    case "questions":
      return <Questions {...now} />;
    case "break":
      return <Break {...now} />;
    case "thanks":
      return <Thanks {...now} />;
  }
}

/** How far the participant is, and what the server last refused. */
function Head({ now }: { now: StepMessage }) {
  return (
    <header class="study-head">
      <h1>{now.study}</h1>
      <progress aria-label={words.progress} value={now.index} max={Math.max(1, now.count - 1)} />
      <span class="visually-hidden">{words.stepOf(now.index + 1, now.count)}</span>
    </header>
  );
}

function Notice({ children }: { children: ComponentChildren }) {
  return (
    <main class="study-text">
      <p role="alert">{children}</p>
    </main>
  );
}

export function ParticipantPage() {
  const now = step.value;
  const top = useRef<HTMLDivElement>(null);
  // A new step begins at its top, for eyes and for screen readers.
  useEffect(() => {
    top.current?.scrollTo(0, 0);
    top.current?.focus();
    if (now !== null) document.title = now.study;
  }, [now?.step]);
  if (obstacle.value !== null) return <Notice>{words.obstacles[obstacle.value]}</Notice>;
  if (now === null) return <Notice>{words.connecting}</Notice>;
  return (
    <div class="study" ref={top} tabIndex={-1}>
      <Head now={now} />
      {!isConnected.value && (
        <p class="study-banner" role="alert">
          {words.lost}
        </p>
      )}
      {refusal.value !== "" && (
        <p class="study-banner" role="alert">
          {refusal.value}
        </p>
      )}
      <div key={now.step} class="study-step">
        {content(now)}
      </div>
    </div>
  );
}
