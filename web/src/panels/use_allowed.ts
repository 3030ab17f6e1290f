import { useEffect } from "preact/hooks";
import { useSignal } from "@preact/signals";
import { may, mayControlNow } from "../allowed";
import type { Allowed, RequestWithFields } from "../protocol";
import { settled } from "../settled";
import { request, state } from "../studio";

/** All that may change what is allowed, but where things are. */
const situation = settled(() => {
  const { allowed, hands, controls, gone, fallen } = state.value ?? {};
  const held = Object.values(hands ?? {}).map(({ object }) => object);
  return { allowed, held, controls, gone, fallen };
});

/**
 * Of each request whether it would be carried out now: the program is asked whenever something has
 * changed. Null until it has answered.
 */
export function useAllowed(requests: RequestWithFields[]): (Allowed | null)[] {
  const answer = useSignal<{ of: string; allowed: Allowed[] } | null>(null);
  const control = mayControlNow();
  const wanted = JSON.stringify(requests);
  useEffect(() => {
    if (control !== true) return;
    let isStale = false;
    request("allowed", { requests: requests.map((one) => ({ ...one })) }).then(
      ({ allowed }) => {
        if (!isStale) answer.value = { of: wanted, allowed };
      },
      // A lost connection is reported elsewhere.
      () => {},
    );
    return () => {
      isStale = true;
    };
  }, [wanted, control, situation.value]);
  const allowed = answer.value?.of === wanted ? answer.value.allowed : null;
  return requests.map((one, k) => {
    const now = may(one.do);
    return now === true ? (allowed?.[k] ?? null) : now;
  });
}
