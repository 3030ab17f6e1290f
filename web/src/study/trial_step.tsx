import { useEffect, useState } from "preact/hooks";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { Film } from "./film";
import type { TrialContent } from "./messages";
import { Paragraphs } from "./paragraphs";
import { deadline, send } from "./server";
import { Trial } from "./trial";

const { study: words } = texts;

/** What the participant is told beside the task. */
function remarkOn(kind: "practice" | "task", content: TrialContent): string | null {
  if (content.interrupted) return words.interrupted;
  if (kind === "practice" && content.completed > 0) return words.tryAgain(content.completed + 1, content.attempts ?? 1);
  return null;
}

/** A task or the practice: first its text and film, then the table. */
export function TrialStep(props: { step: string; kind: "practice" | "task"; content: TrialContent }) {
  const { step, kind, content } = props;
  const [isBegun, setBegun] = useState(false);
  // Each message about the step is the end of the trial before.
  useEffect(() => setBegun(false), [content]);
  if (deadline.value !== null) return <Trial step={step} content={content} end={deadline.value} />;
  const remark = remarkOn(kind, content);
  const begin = () => {
    setBegun(true);
    send({ do: "trial_begin", step });
  };
  return (
    <main class="study-text">
      <h2>{content.title}</h2>
      {remark !== null && (
        <p class="study-remark" role="status">
          {remark}
        </p>
      )}
      <Paragraphs text={content.text} />
      {content.film !== "" && <Film path={content.film} />}
      <p class="hint">{words.limit(content.limit)}</p>
      <div class="study-buttons">
        <Button label={words.begin} kind="accent" isBusy={isBegun} onClick={begin} />
      </div>
    </main>
  );
}
