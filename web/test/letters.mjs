// A person builds the letters U and M of scenes/um.xml at the page.
//
//   z = 2.5   Cyan1      Red2      [      LongPlank      ]
//   z = 1.5   Red1       Green1    Green2  Blue2  Magenta2
//   z = 0.5   [  ShortPlank  ]     Blue1  Magenta1  Orange1
//       x =   -4.5       -1.5      1       3       5          all at y = 1
//
// examples/um.jsonl has them 0.25 units further left: here they stand on the grid that drags snap to.

const FOOT = ["ShortPlank", [-3, 1, 0.5]];
const LETTERS = [
  ["Red1", [-4.5, 1, 1.5]],
  ["Green1", [-1.5, 1, 1.5]],
  ["Cyan1", [-4.5, 1, 2.5]],
  ["Red2", [-1.5, 1, 2.5]],
  ["Blue1", [1, 1, 0.5]],
  ["Magenta1", [3, 1, 0.5]],
  ["Orange1", [5, 1, 0.5]],
  ["Green2", [1, 1, 1.5]],
  ["Blue2", [3, 1, 1.5]],
  ["Magenta2", [5, 1, 1.5]],
  ["LongPlank", [3, 1, 2.5]],
];
const CLEARANCE = 1; // so that it is carried on the grid, too [units]
const THERE = 0.02; // [units]

/** What is put, one after the other. */
export const ORDER = [FOOT, ...LETTERS].map(([id]) => id);
/** From where examples/um.jsonl has the letters [units]. */
export const SHIFT = [0.25, 0, 0];

/** The foot of the U by typed numbers, all else by drags that snap. */
export async function buildLetters(person) {
  await person.press("Grid");
  await layFoot(person);
  for (const [id, place] of LETTERS) {
    await person.grasp(id);
    await person.carryOnto(id, place, CLEARANCE);
    await releaseAt(person, id, place);
  }
}

async function layFoot(person) {
  const [id, place] = FOOT;
  const [x, y, z] = place;
  await person.grasp(id);
  await person.dragTo(id, [null, null, z + CLEARANCE]);
  await person.typePlace({ x, y });
  await isAt(person, id, raised(place));
  await person.typePlace({ z });
  await releaseAt(person, id, place);
}

function raised([x, y, z]) {
  return [x, y, z + CLEARANCE];
}

/** A held object follows the hand: a release before it has arrived drops it. */
async function releaseAt(person, id, place) {
  await isAt(person, id, place);
  await person.release();
}

async function isAt({ witness }, id, place) {
  const away = () => Math.hypot(...place.map((value, axis) => value - witness.positionOf(id)[axis]));
  await witness.until(() => away() < THERE, `${id} is at ${place}`);
}
