import { useState } from "preact/hooks";
import { texts } from "../texts";
import type { Answers, Question } from "./messages";
import { Paragraphs } from "./paragraphs";
import { send } from "./server";

const { study: words } = texts;
const SCALE_STEP = 5;
const SCALE_MAX = 100;

interface Field {
  question: Question;
  answer: string | number | undefined;
  onAnswer: (answer: string | number) => void;
}

/** A slider without a value until it is touched: no answer is suggested. */
function Scale({ question, answer, onAnswer }: Field) {
  const take = (input: HTMLInputElement) => onAnswer(input.valueAsNumber);
  return (
    <div class={`study-scale ${answer === undefined ? "is-open" : ""}`}>
      <input
        type="range"
        aria-label={question.prompt}
        aria-valuetext={answer === undefined ? words.unanswered : `${answer}`}
        min={0}
        max={SCALE_MAX}
        step={SCALE_STEP}
        value={answer ?? SCALE_MAX / 2}
        onInput={(event) => take(event.currentTarget)}
        onClick={(event) => take(event.currentTarget)}
      />
      <div class="study-ends" aria-hidden="true">
        <span>{question.labels[0]}</span>
        <span>{answer ?? words.unanswered}</span>
        <span>{question.labels[1]}</span>
      </div>
    </div>
  );
}

function Choice({ question, answer, onAnswer }: Field) {
  return (
    <div class="study-choices">
      {question.labels.map((label, k) => (
        <label key={k}>
          <input type="radio" name={question.name} checked={answer === k} onChange={() => onAnswer(k)} />
          <span>{label}</span>
        </label>
      ))}
    </div>
  );
}

function FreeText({ question, answer, onAnswer }: Field) {
  return (
    <textarea
      aria-label={question.prompt}
      rows={4}
      maxLength={2500}
      value={answer ?? ""}
      onInput={(event) => onAnswer(event.currentTarget.value)}
    />
  );
}

function fieldOf(question: Question) {
  if (question.scale) return Scale;
  return question.labels.length > 0 ? Choice : FreeText;
}

/** All questions of a questionnaire at once; missing answers are marked when it is sent. */
export function Questions(props: { step: string; content: { preamble: string; questions: Question[] } }) {
  const { step, content } = props;
  const [answers, setAnswers] = useState<Answers>({});
  const [isTried, setTried] = useState(false);
  const isMissing = ({ name, required }: Question) => required && (answers[name] === undefined || answers[name] === "");
  const missing = content.questions.filter(isMissing);
  const submit = (event: Event) => {
    event.preventDefault();
    setTried(true);
    if (missing.length === 0) send({ do: "answers", step, answers });
  };
  return (
    <main class="study-text">
      <h2>{words.questions}</h2>
      <Paragraphs text={content.preamble} />
      <form onSubmit={submit} noValidate>
        {content.questions.map((question) => {
          const Field = fieldOf(question);
          const isMarked = isTried && isMissing(question);
          return (
            <fieldset key={question.name} class={`study-question ${isMarked ? "is-missing" : ""}`}>
              <legend>
                {question.prompt}
                {!question.required && <small> {words.optional}</small>}
              </legend>
              <Field
                question={question}
                answer={answers[question.name]}
                onAnswer={(answer) => setAnswers((before) => ({ ...before, [question.name]: answer }))}
              />
              {isMarked && <p class="study-missing">{words.missing}</p>}
            </fieldset>
          );
        })}
        {isTried && missing.length > 0 && <p role="alert">{words.numMissing(missing.length)}</p>}
        <div class="study-buttons">
          <button type="submit" class="button accent">
            <span class="button-label">{words.next}</span>
          </button>
        </div>
      </form>
    </main>
  );
}
