/** A text of several paragraphs, as it was written. */
export function Paragraphs({ text }: { text: string }) {
  return (
    <>
      {text
        .split(/\n\s*\n/)
        .filter((paragraph) => paragraph.trim() !== "")
        .map((paragraph, k) => (
          <p key={k}>{paragraph}</p>
        ))}
    </>
  );
}
