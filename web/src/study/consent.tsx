import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { Paragraphs } from "./paragraphs";
import { send } from "./server";

const { study: words } = texts;

/** The text of the consent, and whether the participant agrees. */
export function Consent({ step, content }: { step: string; content: { text: string; declined: boolean } }) {
  const answer = (agreed: boolean) => send({ do: "consent", step, agreed });
  return (
    <main class="study-text">
      <h2>{words.consent}</h2>
      <Paragraphs text={content.text} />
      {content.declined && <p role="status">{words.declined}</p>}
      <div class="study-buttons">
        <Button label={words.agree} kind="accent" onClick={() => answer(true)} />
        {!content.declined && <Button label={words.decline} onClick={() => answer(false)} />}
      </div>
    </main>
  );
}
