import { notices } from "../studio";
import { Icon } from "./icons";

/** Announced by screen readers, too: errors at once, the rest politely. */
export function Notices() {
  const list = (isError: boolean) =>
    notices.value
      .filter((notice) => notice.isError === isError)
      .map((notice) => (
        <div key={notice.id} class={`notice ${isError ? "error" : ""}`}>
          <Icon name={isError ? "warning" : "check"} size={18} />
          <span>{notice.text}</span>
        </div>
      ));
  return (
    <div class="notices">
      <div role="status" aria-live="polite">
        {list(false)}
      </div>
      <div role="alert">{list(true)}</div>
    </div>
  );
}
