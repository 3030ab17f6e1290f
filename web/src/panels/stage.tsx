import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { useSignalEffect } from "@preact/signals";
import { heldObject, scene } from "../studio";
import { texts } from "../texts";
import { mountWorld } from "../world/world";
import { measured, switchMeasuring } from "../world/measured";
import { canDraw, PRESETS } from "../world/signals";
import { keyHint } from "./key_names";
import { Measure } from "./measure";
import { chosenObject, detail, world } from "./page";

function ViewPresets({ isForLooking }: { isForLooking: boolean }) {
  const object = heldObject.value ?? chosenObject.value;
  return (
    <div class="views" role="group" aria-label={texts.views.group}>
      {scene.value?.view && (
        <button type="button" title={texts.views.sceneWhy} onClick={() => world.value?.showScenesView()}>
          {texts.views.scene}
        </button>
      )}
      {PRESETS.map((view) => (
        <button key={view} type="button" {...keyHint(`view.${view}`)} onClick={() => world.value?.showPreset(view)}>
          {texts.views[view]}
        </button>
      ))}
      {!isForLooking && (
        <button
          type="button"
          {...keyHint("view.focus", texts.views.focusWhy)}
          disabled={object === null}
          onClick={() => object !== null && world.value?.focus(object)}
        >
          {texts.views.focus}
        </button>
      )}
      <button
        type="button"
        {...keyHint("measure", texts.measure.why)}
        aria-pressed={measured.value !== null}
        onClick={switchMeasuring}
      >
        {texts.measure.title}
      </button>
    </div>
  );
}

/** The world, and what lies over it; where nothing can be taken or selected, it is for looking only. */
export function Stage({ children, isForLooking = false }: { children: ComponentChildren; isForLooking?: boolean }) {
  const host = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const mounted = mountWorld(host.current!);
    world.value = mounted;
    return () => {
      world.value = null;
      mounted.dispose();
    };
  }, []);
  useSignalEffect(() => world.value?.setLowDetail(detail.value));
  return (
    <main class="stage">
      <div class="world" ref={host} role="group" aria-label={texts.views.world} />
      {!canDraw.value && <p class="stage-note">{texts.views.cannotDraw}</p>}
      <ViewPresets isForLooking={isForLooking} />
      <Measure />
      {children}
    </main>
  );
}
