// How cuboids stand to each other, without a browser.

import assert from "node:assert/strict";
import { test } from "node:test";
import { build } from "esbuild";

const entryPoints = [new URL("../src/world/alignment.ts", import.meta.url).pathname];
const { outputFiles } = await build({ entryPoints, bundle: true, write: false, format: "esm", target: "es2022" });
const { alignmentsOf, turnedFrom } = await import(`data:text/javascript,${encodeURIComponent(outputFiles[0].text)}`);

/** A cuboid of these sizes [m], turned about the vertical [degrees]. */
function cuboid(object, center, size, degrees = 0) {
  const [c, s] = [Math.cos, Math.sin].map((of) => of((degrees * Math.PI) / 180));
  return { object, center, axes: [[c, s, 0], [-s, c, 0], [0, 0, 1]], half: size.map((length) => length / 2) };
}

const PLANK = cuboid("Plank", [0, 0, 0.05], [0.5, 0.1, 0.1]);
const cube = (x, y, z, degrees) => cuboid("Cube", [x, y, z], [0.1, 0.1, 0.1], degrees);
const NOTHING = { touches: false, ends: 0, sides: 0, isTopLevel: false, isBottomLevel: false, isCentered: false, missing: [] };
const aligned = (one, other, what) => assert.deepEqual(alignmentsOf(one, [other]), [{ ...NOTHING, object: other.object, ...what }]);

test("faces within half a millimeter are flush, and those of a plank's short sides are its ends", () => {
  aligned(cube(-0.2, 0, 0.15), PLANK, { ends: 1, sides: 2 });
  aligned(cube(-0.2004, 0, 0.15), PLANK, { ends: 1, sides: 2 });
  aligned(cube(-0.2, 0.03, 0.15), PLANK, { ends: 1 });
  aligned(cube(-0.2, 0, 0.16), PLANK, { ends: 1, sides: 2 });
  aligned(cube(-0.2, 0, 0.15, 90), PLANK, { ends: 1, sides: 2 });
  aligned(cube(0, 0.04, 0.15), PLANK, { isCentered: true });
});

test("what is missing to faces that are flush or touch is told up to 3 cm, for each axis", () => {
  const missing = (one, other) => {
    const [found] = alignmentsOf(one, [other]);
    return found?.missing.map(({ distance, toward, to }) => `${Math.round(1000 * distance)} ${to} ${toward.slice(0, 2).map(Math.round)}`).join(" | ");
  };
  assert.deepEqual(missing(cube(-0.188, 0, 0.15), PLANK), "12 flush -1,0");
  assert.deepEqual(missing(cube(-0.188, 0.008, 0.15), PLANK), "12 flush -1,0 | 8 flush 0,-1");
  assert.deepEqual(missing(cube(-0.165, 0, 0.15), PLANK), "");
  assert.deepEqual(missing(cube(-0.321, 0, 0.05), PLANK), "21 touching 1,0");
  // Where it is flush already, what is missing to the other face does not matter.
  assert.deepEqual(missing(cube(0.2, 0, 0.15), cuboid("Short", [0.205, 0, 0.05], [0.11, 0.1, 0.1])), "");
});

test("what stands beside touches; a level top counts only for what lies on nothing", () => {
  const neighbor = cuboid("Neighbor", [0.1, 0, 0.15], [0.1, 0.1, 0.1]);
  aligned(cube(0, 0.03, 0.15), neighbor, { touches: true, isTopLevel: true, isBottomLevel: true });
  const both = alignmentsOf(cube(0, 0.03, 0.15), [PLANK, neighbor]);
  assert.deepEqual(both.map(({ object, touches, isTopLevel }) => [object, touches, isTopLevel]), [
    ["Plank", false, false], ["Neighbor", true, false],
  ]);
});

test("nothing is aligned with what is far away or turned", () => {
  assert.deepEqual(alignmentsOf(cube(-0.2, 0, 0.17), [PLANK]), []);
  assert.deepEqual(alignmentsOf(cube(-0.2, 0, 0.15, 2), [PLANK]), []);
  assert.deepEqual(alignmentsOf(cube(-0.2, 0.3, 0.15), [PLANK]), []);
});

test("an upright cuboid is turned from the nearest other one, to the next right angle", () => {
  const turned = (one, ...others) => {
    const found = turnedFrom(one, [cuboid("", [0, 0, 0], [2, 1, 0]), ...others]);
    return found && `${found.object} ${Math.round(10 * found.degrees) / 10}`;
  };
  assert.equal(turned(cube(0, 0.1, 0.15, 15), PLANK), "Plank 15");
  assert.equal(turned(cube(0, 0.1, 0.15, -100), PLANK), "Plank 10");
  assert.equal(turned(cube(0, 0.1, 0.15, 90.3), PLANK), null);
  assert.equal(turned(cube(0, 0.1, 0.15, 15), PLANK, cuboid("Nearer", [0, 0.15, 0.15], [0.1, 0.1, 0.1], 18)), "Nearer 3");
  assert.equal(turned(cube(0, 0.4, 0.15, 15), PLANK), null, "far from all");
  assert.equal(turned(cube(0, 0.4, 0.05, 15)), null, "the table does not matter");
});
