import { texts } from "../texts";
import { Paragraphs } from "./paragraphs";

const { study: words } = texts;

export function Thanks({ content }: { content: { text: string; code: string; url: string } }) {
  return (
    <main class="study-text">
      <h2>{words.thanks}</h2>
      <Paragraphs text={content.text} />
      <p>
        {words.code} <output class="study-code">{content.code}</output>
      </p>
      {content.url !== "" && (
        <p>
          <a href={content.url} rel="noreferrer">
            {words.complete}
          </a>
        </p>
      )}
    </main>
  );
}
