import { texts } from "../texts";

const { timeline: words } = texts;
const RATES = [0.25, 0.5, 1, 2, 4];

/** The moment of a recording that is shown, to be chosen; times in seconds. */
export function Scrubber(props: {
  seconds: number;
  length: number;
  /** Times that are marked. */
  marks: number[];
  disabled?: boolean;
  onMoment: (seconds: number) => void;
}) {
  const percent = (seconds: number) => `${(100 * seconds) / Math.max(props.length, 1e-9)}%`;
  return (
    <div class="scrubber">
      <input
        type="range"
        aria-label={words.scrub}
        aria-valuetext={words.of(props.seconds, props.length)}
        min={0}
        max={props.length}
        step={0.05}
        value={props.seconds}
        disabled={props.disabled}
        style={{ "--filled": percent(props.seconds) }}
        onInput={(event) => props.onMoment(event.currentTarget.valueAsNumber)}
      />
      <div class="marks" aria-hidden="true">
        {props.marks.map((begin, k) => (
          <i key={k} style={{ left: percent(begin) }} />
        ))}
      </div>
    </div>
  );
}

/** How fast a recording is played. */
export function RateChoice({ rate, onChoose }: { rate: number; onChoose: (rate: number) => void }) {
  return (
    <select aria-label={words.rate} value={rate} onChange={(event) => onChoose(Number(event.currentTarget.value))}>
      {RATES.map((one) => (
        <option key={one} value={one}>
          {texts.time.factor(one)}
        </option>
      ))}
    </select>
  );
}
