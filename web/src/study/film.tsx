import { texts } from "../texts";
import { fileOf } from "./server";

/** A film of a demonstration; it has no sound. */
export function Film({ path }: { path: string }) {
  return <video class="study-film" src={fileOf(path)} controls muted playsInline preload="auto" aria-label={texts.study.film} />;
}
