// Runs a shipped study with scripted participants at once, each at a page of a real browser with a mouse of its own:
//   npm run scripted-study -- STUDY.json DATA [PARTICIPANTS]   (default 12)
// Then checks the data, and makes the report of the study.

import { spawnSync } from "node:child_process";
import { resolve } from "node:path";
import { StudyServer } from "./participant.mjs";
import { numbersOf, ScriptedParticipant } from "./scripted_participant.mjs";
import { Browser, SMILE } from "./workbench.mjs";

async function main([study, data, count = "12"]) {
  const [file, folder] = [resolve(study), resolve(data)];
  const browser = new Browser();
  await browser.start();
  const server = await StudyServer.start(file, folder, Number(count));
  const begun = Date.now();
  const seconds = () => Math.round((Date.now() - begun) / 1000);
  try {
    await Promise.all(
      server.links.map(async (link, k) => {
        const participant = await ScriptedParticipant.at(browser.browser, link);
        const code = await participant.takePart(numbersOf(k));
        console.log(`participant ${k + 1}: ${code} after ${seconds()} s`);
        await participant.context.close();
      }),
    );
  } finally {
    await server.stop();
    await browser.close();
  }
  for (const what of ["check", "report"]) spawnSync(SMILE, ["study", what, folder], { stdio: "inherit" });
}

await main(process.argv.slice(2));
