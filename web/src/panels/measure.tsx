import { scene } from "../studio";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { addMeasured, angleAt, type MeasuredPoint, measured, switchMeasuring, wayBetween } from "../world/measured";
import { chosenObject, world } from "./page";

const { measure: words } = texts;

/** What the points are, the distances between them in order, and the angle between three. */
function linesOf(measuredPoints: MeasuredPoint[], millimetersPerUnit: number): string[] {
  const points = measuredPoints.map(({ place }) => place);
  const named = measuredPoints.map(({ kind, object }, k) => words.point("ABC"[k]!, object === "" ? "other" : kind, object));
  const distances = points.slice(1).map((point, k) => {
    const { along, length } = wayBetween(points[k]!, point);
    return words.distance(`${"ABC"[k]}${"ABC"[k + 1]}`, length, length * millimetersPerUnit, along);
  });
  const lines = [...named, ...distances];
  if (points.length === 3) {
    const angle = angleAt([points[0]!, points[1]!, points[2]!]);
    lines.push(angle === null ? words.noAngle : words.angle(angle));
  }
  return lines;
}

/** Distances and angles between points that are clicked, or origins of objects. */
export function Measure() {
  const points = measured.value;
  if (points === null) return null;
  const object = chosenObject.value;
  const place = object === null ? null : (world.value?.placeOf(object) ?? null);
  return (
    <section class="measure" aria-label={words.title}>
      <div role="status">
        {points.length < 2 && <p>{words.hint}</p>}
        {linesOf(points, 1000 * (scene.value?.metersPerUnit ?? 0)).map((line) => (
          <p key={line}>{line}</p>
        ))}
      </div>
      <div class="row">
        <Button
          label={object === null ? words.addOrigin : words.addOriginOf(object)}
          title={words.addOriginWhy}
          disabled={place === null}
          onClick={() => {
            const now = object === null ? null : (world.value?.placeOf(object) ?? null);
            if (object !== null && now !== null) addMeasured({ kind: "origin", object, place: now });
          }}
        />
        <Button label={words.clear} disabled={points.length === 0} onClick={() => (measured.value = [])} />
        <Button label={words.end} onClick={switchMeasuring} />
      </div>
    </section>
  );
}
