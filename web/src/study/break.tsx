import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { send } from "./server";
import { useSecondsLeft } from "./seconds_left";

const { study: words } = texts;

export function Break({ step, content }: { step: string; content: { seconds: number } }) {
  const left = useSecondsLeft(content.seconds);
  return (
    <main class="study-text">
      <h2>{words.breakTitle}</h2>
      <p>{words.breakText}</p>
      {left > 0 && <p>{words.breakLeft(left)}</p>}
      <div class="study-buttons">
        <Button label={words.next} kind="accent" disabled={left > 0} onClick={() => send({ do: "done", step })} />
      </div>
    </main>
  );
}
