import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { Film } from "./film";
import type { InstructionContent } from "./messages";
import { Paragraphs } from "./paragraphs";
import { fileOf, send } from "./server";

export function Instruction({ step, content }: { step: string; content: InstructionContent }) {
  return (
    <main class="study-text">
      <h2>{content.title}</h2>
      <Paragraphs text={content.text} />
      {content.picture !== "" && <img class="study-picture" src={fileOf(content.picture)} alt={content.title} />}
      {content.film !== "" && <Film path={content.film} />}
      <div class="study-buttons">
        <Button label={texts.study.next} kind="accent" onClick={() => send({ do: "done", step })} />
      </div>
    </main>
  );
}
