import { useEffect } from "preact/hooks";
import { useSignal } from "@preact/signals";
import { may, when } from "../allowed";
import { ask, eyeView } from "../studio";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { useResize } from "../ui/resize";
import { isRecording, recordedEye } from "./derived_signals";
import { eyeWidth, isEyeOpen } from "./page";

const WIDTHS = { min: 120, max: 640 };

/** The newest picture as something an image element shows. */
function usePicture(): string | null {
  const url = useSignal<string | null>(null);
  useEffect(() => {
    const stop = eyeView.subscribe((view) => {
      const before = url.peek();
      url.value = view === null ? null : URL.createObjectURL(view.png);
      if (before !== null) URL.revokeObjectURL(before);
    });
    return () => {
      stop();
      if (url.peek() !== null) URL.revokeObjectURL(url.peek()!);
    };
  }, []);
  return url.value;
}

function resize(width: number): void {
  eyeWidth.value = Math.round(Math.min(WIDTHS.max, Math.max(WIDTHS.min, width)));
}

/** The corner at which the inset is made larger: it grows up and to the left. */
function ResizeCorner() {
  return (
    <button
      type="button"
      class="eye-corner"
      role="slider"
      aria-label={texts.eye.resize}
      aria-valuemin={WIDTHS.min}
      aria-valuemax={WIDTHS.max}
      aria-valuenow={eyeWidth.value}
      title={texts.eye.resize}
      {...useResize({ edge: "left", width: () => eyeWidth.value, resize })}
    />
  );
}

/** The camera whose pictures recordings contain, where there are several. */
function CameraChoice() {
  const { camera, cameras } = recordedEye.value ?? { camera: "", cameras: [] };
  if (cameras.length < 2) return null;
  return (
    <select
      class="quiet eye-camera"
      aria-label={texts.eye.camera}
      value={camera}
      {...when(may("eye"), texts.eye.cameraWhy)}
      onChange={(event) => void ask("eye", { camera: event.currentTarget.value })}
    >
      {cameras.map((one) => (
        <option key={one} value={one}>
          {texts.eye.cameraOf(one)}
        </option>
      ))}
    </select>
  );
}

/** The robot's view, exactly as it is recorded. */
export function EyeView() {
  const url = usePicture();
  if (!isEyeOpen.value) {
    return (
      <div class="eye-closed">
        <Button label={texts.eye.show} icon="eye" onClick={() => (isEyeOpen.value = true)} />
      </div>
    );
  }
  return (
    <figure class="eye" style={{ width: `${eyeWidth.value}px` }}>
      <figcaption>
        <span>{texts.eye.title}</span>
        <CameraChoice />
        {isRecording.value && eyeView.value !== null && <span class="eye-records">{texts.eye.records}</span>}
        <Button
          label={texts.eye.hide}
          icon="cross"
          kind="quiet"
          isIconOnly
          onClick={() => (isEyeOpen.value = false)}
        />
      </figcaption>
      {url === null ? <p class="eye-none">{texts.eye.none}</p> : <img src={url} alt={texts.eye.alt} draggable={false} />}
      <ResizeCorner />
    </figure>
  );
}
