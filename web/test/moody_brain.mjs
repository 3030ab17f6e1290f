// A brain that imitates as the learner does, but gives up at each third attempt, the first one included.

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

const LEARNER = fileURLToPath(new URL("../../python/learner", import.meta.url));

/** Writes it into a folder, in which it counts its attempts. */
export function writeMoodyBrain(folder) {
  const count = join(folder, "attempts");
  writeFileSync(
    join(folder, "moody.py"),
    `# smile: imitates
import os, sys
sys.path.insert(0, ${JSON.stringify(LEARNER)})
count = ${JSON.stringify(count)}
before = os.path.getsize(count) if os.path.exists(count) else 0
with open(count, "a") as file:
    file.write("x")
if before % 3 == 0:
    def step(sensor, motor, aux):
        aux.exit = True
else:
    from learner import *
`,
  );
}
