import { useEffect, useRef } from "preact/hooks";
import { useSignal, useSignalEffect } from "@preact/signals";
import { listenToKeys } from "../keys";
import { keyFor } from "../panels/key_names";
import { isEyeOpen, world } from "../panels/page";
import { RateChoice, Scrubber } from "../panels/scrubber";
import { SegmentCard } from "../panels/segment_card";
import { Stage } from "../panels/stage";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { Notices } from "../ui/notices";
import { eyePicture, folder, isPlaying, length, load, obstacle, pause, play, rate, recording, seconds, seek, showAll } from "./player";
import type { Recording, SharedEvent } from "./recording";

const { shared: words, timeline } = texts;

function togglePlaying(): void {
  if (isPlaying.value) pause();
  else play();
}

/** What there is instead of a recording. */
function Notice() {
  return (
    <main class="shared-notice">
      <h1>{words.title}</h1>
      <p role={obstacle.value === null ? "status" : "alert"}>
        {obstacle.value === null ? words.loading : obstacle.value === "unknown" ? words.unknown : words.failed}
      </p>
      {obstacle.value === "failed" && <Button label={words.tryAgain} kind="accent" onClick={() => void load()} />}
    </main>
  );
}

/** The last picture of the robot's eye, where there is one. */
function Eye() {
  const number = eyePicture.value;
  const shown = useSignal<string | null>(null);
  const wanted = useRef<string | null>(null);
  useEffect(() => {
    const source = number === null ? null : `${folder}eye/${number}.png`;
    wanted.current = source;
    if (source === null) return void (shown.value = null);
    // Shown as soon as it is there, if no other one is wanted by then: so the view does not flicker.
    const image = new Image();
    image.onload = () => {
      if (wanted.current === source) shown.value = source;
    };
    image.src = source;
  }, [number]);
  if (!isEyeOpen.value) {
    return (
      <div class="eye-closed">
        <Button label={texts.eye.show} icon="eye" onClick={() => (isEyeOpen.value = true)} />
      </div>
    );
  }
  return (
    <figure class="eye shared-eye">
      <figcaption>
        <span>{texts.eye.title}</span>
        <Button label={texts.eye.hide} icon="cross" kind="quiet" isIconOnly onClick={() => (isEyeOpen.value = false)} />
      </figcaption>
      {shown.value === null ? (
        <p class="eye-none">{texts.eye.none}</p>
      ) : (
        <img src={shown.value} alt={texts.eye.alt} draggable={false} />
      )}
    </figure>
  );
}

function Events({ events }: { events: SharedEvent[] }) {
  if (events.length === 0) return null;
  return (
    <ul class="shared-events" aria-label={words.events}>
      {events.map((event, k) => (
        <li key={k}>
          <button type="button" class="chip" onClick={() => seek(event.seconds)}>
            {words.event(event)}
          </button>
        </li>
      ))}
    </ul>
  );
}

function Timeline({ description: { segments, events } }: Recording) {
  const now = seconds.value;
  return (
    <section class="timeline" aria-label={timeline.title}>
      <header class="timeline-head">
        <Button
          label={isPlaying.value ? timeline.stop : timeline.play}
          icon={isPlaying.value ? "pause" : "play"}
          kind="accent"
          keys={keyFor("time.pause")}
          onClick={togglePlaying}
        />
        <RateChoice rate={rate.value} onChoose={(chosen) => (rate.value = chosen)} />
        <span class="timeline-moment">{timeline.of(now, length.value)}</span>
      </header>
      <Scrubber
        seconds={now}
        length={length.value}
        marks={segments.slice(1).map(({ begin }) => begin)}
        onMoment={seek}
      />
      <ol class="segments" aria-label={timeline.segments}>
        {segments.map(({ number, deed, begin, end }) => (
          <SegmentCard
            key={number}
            picture={`${folder}segments/${number}.png`}
            segment={{ number, deed, seconds: end - begin }}
            isNow={now > begin && now <= end}
            isChosen={false}
            onChoose={() => seek(begin)}
          />
        ))}
      </ol>
      <Events events={events} />
    </section>
  );
}

function Player({ shown }: { shown: Recording }) {
  useSignalEffect(() => {
    if (world.value !== null) showAll();
  });
  useEffect(() => listenToKeys({ "time.pause": togglePlaying }), []);
  const { title, scene, eye } = shown.description;
  return (
    <div class="shared">
      <header class="shared-head">
        <h1>{title}</h1>
        <p>
          {scene.name !== title && `${scene.name} · `}
          {words.readOnly}
        </p>
      </header>
      <Stage isForLooking>
        {eye.length > 0 && <Eye />}
        <div class="banners">
          <Notices />
        </div>
      </Stage>
      <Timeline {...shown} />
    </div>
  );
}

/** A shared recording: it is played in the browser, and nothing of it can be changed. */
export function SharedPage() {
  return recording.value === null ? <Notice /> : <Player shown={recording.value} />;
}
