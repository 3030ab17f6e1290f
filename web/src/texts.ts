// The texts of the page, by subject, in the language of the page: the tables in texts/ as they are, and a
// function for each message with arguments. Messages of the program are in `program`, by their ids there.

import { numberOfObjects, partsOf, placeInChain } from "./action_parts";
import type { Missing } from "./world/alignment";
import type { ActionSummary, HandName, Job, ToolUse } from "./protocol";
import { language, type Language } from "./language";
import { allOf, anyOf, decimal, mapped, named, say, type Arguments } from "./message_format";
import type { SharedEvent } from "./shared/recording";

type Table = typeof import("../../texts/en.json");

// Only the table of the page's language is loaded.
const tables: Record<Language, () => Promise<{ default: Table }>> = {
  en: () => import("../../texts/en.json"),
  de: () => import("../../texts/de.json"),
};
const { default: t } = await tables[language]();

/** What a tool would do that is not loosening. */
const workOf = (use: ToolUse | undefined) => use?.do.find((one) => one !== "loosen") ?? "none";

/** Texts for x, y and z. */
type Axes = readonly [string, string, string];

const percent = (fraction: number) => Math.round(100 * fraction);
const armName = (arm: string) => named(t.robot.arms, arm);
const yes = (is: boolean) => (is ? "yes" : "no");
const sentences = (hands: HandName[]) => allOf(hands.map((hand) => t.hands.sentences[hand]));

export const texts = {
  ...t,
  seconds: (seconds: number) => say(t.seconds, { seconds }),
  /** A message of the program; its id, if this page is older than the program and lacks it. */
  ofProgram: (id: string, given: Arguments) => {
    const message = programMessage(id);
    return message === undefined ? id : say(message, mapped(given, partWords));
  },
  action: (action: ActionSummary) => actionWords(action),

  hands: {
    ...t.hands,
    axes: t.hands.axes as unknown as Axes,
    axisNames: t.hands.axisNames as unknown as Axes,
    notNow: (reason: string) => say(t.notNow, { reason: capital(reason) }),
    turnBy: (axis: string, degrees: number) => say(t.hands.turnBy, { degrees, axis }),
    planeBy: (degrees: number) => say(t.hands.planeBy, { degrees }),
    step: (millimeters: number) => say(t.hands.step, { millimeters }),
    unit: (millimeters: number) => say(t.hands.unit, { millimeters }),
    bringWhy: (target: string) => say(t.hands.bringWhy, { target }),
  },

  properties: t.properties as Record<string, string>,
  progress: t.progress as Record<string, string>,

  record: {
    ...t.record,
    saved: (title: string) => say(t.record.saved, { title }),
    kept: (title: string) => say(t.record.kept, { title }),
    keptEmpty: (title: string) => say(t.record.keptEmpty, { title }),
    keptHeld: (title: string, object: string) => say(t.record.keptHeld, { title, object }),
  },

  failure: {
    ...t.failure,
    kept: (title: string) => say(t.failure.kept, { title }),
    lost: (title: string) => say(t.failure.lost, { title }),
  },

  time: {
    ...t.time,
    factor: (factor: number) => say(t.time.factor, { factor }),
    framesPerSecond: (fps: number) => say(t.time.framesPerSecond, { fps }),
    measured: (speed: number) => say(t.time.measured, { speed }),
  },

  views: { ...t.views, detailIs: (detail: string) => say(t.views.detailIs, { detail }) },

  eye: { ...t.eye, cameraOf: (camera: string) => named(t.eye.cameras, camera) },

  people: {
    ...t.people,
    watching: (number: number) => say(t.people.watching, { number }),
    give: (client: number) => say(t.people.give, { client }),
    wanted: (clients: number[]) => say(t.people.wanted, { number: clients.length, clients: allOf(clients) }),
    kept: (client: number) => say(t.people.kept, { client }),
  },

  menu: {
    ...t.menu,
    /** @param use  what it would do now, if anything */
    use: (tool: string, use: ToolUse | undefined) =>
      say(t.menu.use, { tool, what: workOf(use) }),
    useLoosening: (tool: string) => say(t.menu.useLoosening, { tool }),
    title: (object: string) => say(t.menu.title, { object }),
  },

  toolHint: {
    ...t.toolHint,
    can: (tool: string, verbs: readonly string[], target: string) =>
      say(t.toolHint.can, { tool, verbs: anyOf(verbs), target }),
    missing: (arrow: string, millimeters: number, target: string) => say(t.toolHint.missing, { arrow, millimeters, target }),
    byHand: (entry: string, turns: boolean, isTouch: boolean) =>
      say(t.toolHint.byHand, { turns: yes(turns), touch: yes(isTouch), entry }),
    hasCut: (tool: string, target: string) => say(t.toolHint.hasCut, { tool, target }),
    byGripper: (turns: boolean) => say(t.toolHint.byGripper, { turns: yes(turns) }),
  },

  placement: {
    ...t.placement,
    stopped: (objects: string[]) => say(t.placement.stopped, { objects: allOf(objects) }),
    slideFirst: (objects: string[], sliding: string) => say(t.placement.slideFirst, { objects: allOf(objects), sliding }),
    rests: (isInside: boolean, objects: string[]) => say(t.placement.rests, { inside: yes(isInside), objects: allOf(objects) }),
    flush: (faces: string[]) => say(t.placement.flush, { faces: allOf(faces) }),
    of: (parts: string[], object: string) => say(t.placement.of, { parts: allOf(parts), object }),
    ends: (number: number) => say(t.placement.ends, { number }),
    sides: (number: number) => say(t.placement.sides, { number }),
    centered: (objects: string[]) => say(t.placement.centered, { objects: allOf(objects) }),
    drops: (millimeters: number, doesAdvise: boolean) => say(t.placement.drops, { millimeters, advice: yes(doesAdvise) }),
    tilts: (degrees: number) => say(t.placement.tilts, { degrees }),
    turned: (degrees: number, object: string, doesAdvise: boolean) =>
      say(t.placement.turned, { degrees, object, advice: yes(doesAdvise) }),
    touches: (objects: string[]) => say(t.placement.touches, { objects: allOf(objects) }),
    missing: (arrow: string, millimeters: number, to: Missing["to"], object: string) =>
      say(t.placement.missing, { arrow, millimeters, to, object }),
  },

  objects: {
    ...t.objects,
    /** @param shape  that the scene names: of its own elements, or any word */
    kindOf: (shape: string) => named(t.objects.kinds, shape),
    heldBy: (hand: HandName) => say(t.objects.heldBy, { hand }),
    onFloor: (ids: string[]) => say(t.objects.onFloor, { objects: ids.join(", ") }),
    show: (number: number) => say(t.objects.show, { number }),
    paletteWhy: (title: string) => say(t.objects.paletteWhy, { title }),
    placeAt: ([x = 0, y = 0, z = 0]: number[]) => say(t.objects.placeAt, { x, y, z }),
    picture: (title: string) => say(t.objects.picture, { title }),
  },

  selection: { ...t.selection, title: (number: number) => say(t.selection.title, { number }) },

  editor: {
    ...t.editor,
    errors: (number: number) => say(t.editor.errors, { number }),
    line: (line: number) => say(t.editor.line, { line }),
    goOn: (name: string) => say(t.editor.goOn, { name }),
    template: `<?xml version="1.0" encoding="UTF-8"?>
<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
  <block id="Red" location="(-1,0,0.5)" color="red"/>
  <block id="Blue" location="(1,0,0.5)" color="blue"/>
</tabletop>
`,
  },

  robot: {
    ...t.robot,
    moods: t.robot.moods as Record<string, string>,
    markers: (number: number) => say(t.robot.markers, { number }),
    arm: (arm: string) => (/arm/i.test(arm) ? capital(arm) : capital(say(t.robot.armOf, { name: armName(arm) }))),
    gripper: (arm: string) => capital(say(t.robot.gripperOf, { name: armName(arm) })),
    gripperOf: (arm: string) => capital(armName(arm)),
    less: (joint: string) => say(t.robot.less, { joint }),
    further: (joint: string) => say(t.robot.further, { joint }),
    closeGripper: (arm: string) => say(t.robot.closeGripper, { arm: armName(arm) }),
    openGripper: (arm: string) => say(t.robot.openGripper, { arm: armName(arm) }),
    limits: (lower: number, upper: number, digits: number) =>
      say(t.robot.limits, { lower: decimal(lower, digits), upper: decimal(upper, digits) }),
  },

  brain: {
    ...t.brain,
    statuses: t.brain.statuses as Record<string, string>,
    program: (name: string, kind: string) => say(t.brain.program, { name, kind }),
    copyPlace: (place: string) => say(t.brain.copyPlace, { place }),
    copied: (text: string) => say(t.brain.copied, { text }),
    sceneOfDemonstration: (name: string) => say(t.brain.sceneOfDemonstration, { name }),
    scored: (percent: number) => say(t.brain.scored, { percent }),
    meanError: (millimeters: number) => say(t.brain.meanError, { millimeters }),
    took: (seconds: number) => say(t.brain.took, { seconds }),
  },

  library: {
    ...t.library,
    segments: (number: number) => say(t.library.segments, { number }),
    typeTitle: (title: string) => say(t.library.typeTitle, { title }),
    binned: (title: string) => say(t.library.binned, { title }),
    isBack: (title: string) => say(t.library.isBack, { title }),
    picture: (title: string) => say(t.library.picture, { title }),
    actions: (title: string) => say(t.library.actions, { title }),
  },

  datasets: {
    ...t.datasets,
    generateTitle: (title: string) => say(t.datasets.generateTitle, { title }),
    levelOf: (level: string) => named(t.datasets.levels, level),
    stopWhy: ({ do: what }: Job) => t.datasets.stopsHow[what],
    stopNamed: (name: string) => say(t.datasets.stopNamed, { name }),
    dismissNamed: (name: string) => say(t.datasets.dismissNamed, { name }),
    renameTitle: (name: string) => say(t.datasets.renameTitle, { name }),
    pictureOf: (name: string) => say(t.datasets.pictureOf, { name }),
    causeOf: (word: string) => named(t.datasets.causeNames, word),
    cause: (number: number, word: string) => say(t.datasets.cause, { number, word: named(t.datasets.causeNames, word) }),
    progressOf: (name: string) => say(t.datasets.progressOf, { name }),
    episodes: (done: number, wanted: number | null) =>
      wanted === null ? say(t.datasets.episodes, { number: done }) : say(t.datasets.episodesOf, { done, wanted }),
    yield: (attempts: number, yielded: number | null, interval: [number, number] | null) =>
      [
        say(t.datasets.attempts, { number: attempts }),
        ...(yielded === null ? [] : [say(t.datasets.yielded, { percent: percent(yielded) })]),
        ...(interval === null
          ? []
          : [say(t.datasets.interval, { from: percent(interval[0]), to: percent(interval[1]) })]),
      ].join(" · "),
    jobTitle: ({ do: what, name }: Job) => say(t.datasets.jobTitle, { work: what, name }),
    status: (job: Job) =>
      ({
        waiting: t.datasets.waiting,
        running: progressOf(job),
        stopping: t.datasets.stops,
        done: t.datasets.done,
        failed: t.datasets.failed,
        stopped: job.do === "generate" ? t.datasets.stoppedKept : t.datasets.stoppedLost,
      })[job.status],
    ended: ({ status, name }: Job) => say(t.datasets.ended, { status, name }),
  },

  variations: {
    ...t.variations,
    title: (kinds: string[]) =>
      kinds.length === 0 ? t.variations.notVaried : say(t.variations.varied, { kinds: kinds.join(", ") }),
    kind: (kind: string) => named(t.variations.kinds, kind),
    /** @param ranges  such as "0.2..0.4,1" */
    degree: (name: string, ranges: string) =>
      say(t.variations.degree, { name, ranges: ranges.split(",").map(rangeOf).join(", ") }),
  },

  attempts: {
    ...t.attempts,
    recording: (set: string, seed: number) => say(t.attempts.recording, { set, seed }),
    of: (name: string) => say(t.attempts.of, { name }),
    seed: (seed: number) => say(t.attempts.seed, { seed }),
    found: (found: number, all: number) => say(t.attempts.found, { found, all }),
    more: (left: number) => say(t.attempts.more, { left }),
  },

  exporting: {
    ...t.exporting,
    title: (title: string) => say(t.exporting.title, { title }),
    formatOf: (format: string) => named(t.exporting.formats, format),
    place: (folder: string, name: string) => say(t.exporting.place, { folder, name }),
  },

  filming: {
    ...t.filming,
    title: (title: string) => say(t.filming.title, { title }),
    cameraOf: (camera: string) => named(t.filming.cameras, camera),
    place: (folder: string, name: string) => say(t.filming.place, { folder, name }),
    downloadOf: (name: string) => say(t.filming.downloadOf, { name }),
  },

  timeline: {
    ...t.timeline,
    corrects: (title: string, seconds: number) => say(t.timeline.corrects, { title, seconds }),
    overKeeps: (hands: HandName[]) => say(t.timeline.overKeeps, { hands: sentences(hands), number: hands.length }),
    overPaused: (hands: HandName[]) => say(t.timeline.overPaused, { hands: sentences(hands), number: hands.length }),
    overLeft: (actions: number) => say(t.timeline.overLeft, { actions }),
    overConflict: (hand: HandName | null, reason: string) =>
      hand === null ? reason : say(t.timeline.overConflict, { hand, reason }),
    of: (seconds: number, length: number) => say(t.timeline.of, { seconds, length }),
  },

  analysis: {
    ...t.analysis,
    title: (recording: string) => say(t.analysis.title, { recording }),
    property: (object: string | null, tried: string | null, harm: string | null) => {
      const what = object === null ? t.analysis.everything : say(t.analysis.colorOf, { object });
      const result = harm ?? t.analysis.same;
      return tried === null
        ? say(t.analysis.property, { what, result })
        : say(t.analysis.triedProperty, { what, tried, result });
    },
    notMoved: (reason: string) => say(t.analysis.notMoved, { reason }),
    subtask: (number: number, what: string, without: string | null) =>
      without === null
        ? say(t.analysis.redundant, { number, what: capital(what) })
        : say(t.analysis.necessary, { number, what: capital(what), without }),
    order: (after: number, before: number, otherwise: string) => say(t.analysis.order, { after, before, otherwise }),
    anyOrder: (isAll: boolean) => say(t.analysis.anyOrder, { all: yes(isAll) }),
    enough: (numbers: number[]) => say(t.analysis.enough, { numbers: numbers.join(", ") }),
    nameOf: (recording: string) => say(t.analysis.nameOf, { recording }),
  },

  sharing: {
    ...t.sharing,
    title: (title: string) => say(t.sharing.title, { title }),
    reachable: (origin: string) => say(t.sharing.reachable, { origin }),
    made: (when: string) => say(t.sharing.made, { when }),
  },

  shared: {
    ...t.shared,
    event: ({ seconds, kind, words, object = "", arm = "", state = "" }: SharedEvent) => {
      const what = words ?? say(t.shared.what, { kind, object, arm: armName(arm), state });
      return say(t.shared.event, { seconds, what: capital(what) });
    },
  },

  measure: {
    ...t.measure,
    distance: (name: string, units: number, millimeters: number, [x = 0, y = 0, z = 0]: number[]) =>
      say(t.measure.distance, { name, units, millimeters, x, y, z }),
    angle: (degrees: number) => say(t.measure.angle, { degrees }),
    point: (name: string, kind: string, object: string) => say(t.measure.point, { name, kind, object }),
    addOriginOf: (object: string) => say(t.measure.addOriginOf, { object }),
  },

  tracks: {
    ...t.tracks,
    clip: (what: string, begin: number, end: number) => say(t.tracks.clip, { what, begin, end }),
    parts: {
      whole: (clip: string) => say(t.tracks.parts.whole, { clip }),
      begin: (clip: string) => say(t.tracks.parts.begin, { clip }),
      end: (clip: string) => say(t.tracks.parts.end, { clip }),
    },
    conflicts: {
      tried: (seconds: number, reason: string) => say(t.tracks.conflicts.tried, { seconds, reason }),
      kept: (seconds: number, reason: string) => say(t.tracks.conflicts.kept, { seconds, reason }),
      leftOut: (seconds: number, reason: string) => say(t.tracks.conflicts.leftOut, { seconds, reason }),
    },
  },

  edit: {
    ...t.edit,
    titles: {
      drop: (segment: string) => say(t.edit.titles.drop, { segment }),
      trim: (segment: string) => say(t.edit.titles.trim, { segment }),
      shift: (segment: string) => say(t.edit.titles.shift, { segment }),
    },
    dropToo: (segment: string) => say(t.edit.dropToo, { segment }),
    lasts: (after: number, before: number) => say(t.edit.lasts, { after, before }),
    leftOut: (reason: string) => say(t.edit.leftOut, { reason }),
    displaced: (id: string, millimeters: number, degrees: number) => {
      const distance =
        millimeters >= 10
          ? say(t.edit.centimeters, { length: millimeters / 10 })
          : say(t.edit.millimeters, { length: millimeters });
      return degrees >= 1
        ? say(t.edit.displacedAndTurned, { id, distance, degrees })
        : say(t.edit.displaced, { id, distance });
    },
    gone: (id: string) => say(t.edit.gone, { id }),
    thereAgain: (id: string) => say(t.edit.thereAgain, { id }),
    control: (id: string, before: string, after: string) => say(t.edit.control, { id, before, after }),
    hostPoint: (id: string) => say(t.edit.hostPoint, { id }),
    joint: (id: string) => say(t.edit.joint, { id }),
    andMore: (number: number) => say(t.edit.andMore, { number }),
    nameOf: (title: string) => say(t.edit.nameOf, { title }),
    saved: (title: string) => say(t.edit.saved, { title }),
  },

  tour: {
    ...t.tour,
    step: (number: number, total: number) => say(t.tour.step, { number, total }),
    steps: t.tour.steps as unknown as Record<string, readonly [title: string, words: string]>,
  },

  study: {
    ...t.study,
    stepOf: (number: number, total: number) => say(t.study.stepOf, { number, total }),
    limit: (seconds: number) =>
      say(t.study.limit, {
        time:
          seconds >= 120
            ? say(t.study.minutes, { minutes: Math.floor(seconds / 60) })
            : say(t.study.fewSeconds, { seconds }),
      }),
    clock: (seconds: number) =>
      say(t.study.clock, { minutes: Math.floor(seconds / 60), seconds: String(seconds % 60).padStart(2, "0") }),
    tryAgain: (attempt: number, total: number) => say(t.study.tryAgain, { attempt, total }),
    turnBy: (degrees: number) => say(t.study.turnBy, { degrees }),
    numMissing: (number: number) => say(t.study.numMissing, { number }),
    breakLeft: (seconds: number) => say(t.study.breakLeft, { seconds }),
  },
};

function programMessage(id: string): string | undefined {
  const subjects: Record<string, Record<string, string>> = t.program;
  const [subject = "", name = ""] = id.split(".");
  return subjects[subject]?.[name];
}

/** The name of a part, most of which are ids. */
function partWords(name: string): string {
  const found = placeInChain(name);
  if (found === null) return name;
  const { chain, place, before, after } = found;
  return say(t.actions.between, { chain, place, before, after });
}

/** What an action did, as the program's own words of it. */
function actionWords(action: ActionSummary): string {
  const { hand, tool, where, object } = partsOf(action);
  const number = numberOfObjects(action.what);
  const what = number === null ? partWords(action.what) : say(t.actions.objects, { number });
  return {
    take: () => say(t.actions.take, { hand, what }),
    put: () => say(t.actions.put, { hand, what, where, object }),
    drop: () => say(t.actions.drop, { hand, what, where, object }),
    release: () => say(t.actions.release, { hand, what }),
    destroy: () => say(t.actions.destroy, { hand, what }),
    point: () => say(t.actions.point, { hand, what }),
    trigger: () => say(t.actions.trigger, { hand, what }),
    fasten: () => say(t.actions.fasten, { hand, what, tool }),
    loosen: () => say(t.actions.loosen, { hand, what, tool }),
    cut: () => say(t.actions.cut, { hand, what, tool }),
    add: () => say(t.actions.add, { what }),
    remove: () => say(t.actions.remove, { what }),
    move: () => say(t.actions.move, { what }),
    clear: () => say(t.actions.clear, { what }),
    load: () => say(t.actions.load, { what }),
  }[action.do]();
}

function progressOf({ do: what, done = 0, total }: Job): string {
  if (total === undefined) return t.datasets.starts;
  return what === "film"
    ? say(t.datasets.filmed, { done, total })
    : say(t.datasets.episodesOf, { done, wanted: total });
}

function rangeOf(range: string): string {
  const [lower, upper] = range.split("..");
  return upper === undefined ? range : say(t.variations.range, { lower: lower ?? "", upper });
}

function capital(word: string): string {
  return word.charAt(0).toUpperCase() + word.slice(1);
}
