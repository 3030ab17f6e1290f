// The tables of texts: the same messages in all languages, all of them used, and no text outside of them.

import assert from "node:assert/strict";
import { readdirSync, readFileSync, statSync } from "node:fs";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { build } from "esbuild";
import { Browser } from "./workbench.mjs";

const ROOT = new URL("../..", import.meta.url);
const read = (path) => readFileSync(new URL(path, ROOT), "utf8");
const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const tableOf = (language) => new Map(leaves(JSON.parse(read(`texts/${language}.json`))));
const sources = readdirSync(new URL("web/src", ROOT), { recursive: true })
  .filter((name) => /\.tsx?$/.test(name))
  .map((name) => ({ name, text: read(`web/src/${name}`) }));
const en = tableOf("en");
const others = readdirSync(new URL("texts", ROOT)).map((name) => name.replace(".json", "")).filter((name) => name !== "en");

/** Messages of the program: the test architecture.Messages compares them with its calls. */
const isOfProgram = (id) => id.startsWith("program.");

/** Each message with its id. */
function leaves(table, id = "") {
  return Object.entries(table).flatMap(([key, value]) => {
    const path = id === "" ? key : `${id}.${key}`;
    return typeof value === "string" ? [[path, value]] : leaves(value, path);
  });
}

/** The contents of the outermost braces of a text. */
function braced(text) {
  const found = [];
  for (let k = 0, depth = 0, open = 0; k < text.length; k++) {
    if (text[k] === "{" && depth++ === 0) open = k;
    if (text[k] === "}" && --depth === 0) found.push(text.slice(open + 1, k));
  }
  return found;
}

/** The names of a message's arguments, sorted. */
function argumentsOf(message) {
  const names = braced(message).flatMap((field) => {
    const [name, kind] = field.split(",").map((part) => part.trim());
    return kind === "plural" || kind === "select" ? [name, ...braced(field).flatMap(argumentsOf)] : [name];
  });
  return [...new Set(names)].sort();
}

for (const language of others) {
  test(`${language} has the messages of English, with the same arguments`, () => {
    const table = tableOf(language);
    assert.deepEqual([...table.keys()].sort(), [...en.keys()].sort());
    for (const [id, message] of en) assert.deepEqual(argumentsOf(table.get(id)), argumentsOf(message), id);
    // Words that both languages have are short: a sentence that is the same was not translated.
    const same = [...en].filter(([id, message]) => table.get(id) === message && /\p{Ll}{2,} \p{Ll}{2,} \p{Ll}{2,}/u.test(message));
    assert.deepEqual(same, []);
  });
}

test("each message with arguments is said with these, in one place", () => {
  const text = read("web/src/texts.ts");
  const said = new Map();
  for (const { 0: call, 1: id, index } of text.matchAll(/say\(\s*t\.([\w.]+),\s*(?=\{)/g)) {
    let [given] = braced(text.slice(index + call.length));
    while (/\([^()]*\)/.test(given)) given = given.replace(/\([^()]*\)/g, "");
    said.set(id, given.split(",").map((one) => one.split(":")[0].trim()).filter(Boolean).sort());
  }
  for (const [id, message] of en) {
    const wanted = argumentsOf(message);
    if (wanted.length > 0 && !isOfProgram(id)) assert.deepEqual(said.get(id), wanted, id);
  }
});

test("the last word of each id is used", () => {
  const all = sources.map(({ text }) => text).join("\n");
  // Tables whose entries the program, the page's state or a list names.
  const named = new RegExp(
    "^(properties|progress|keys|keyNames|theme|tour[.]steps|help[.]mouseHelp|.*[.](names|meanings|sentences|axes|axisNames|" +
      "snaps|snapsWhy|directions|details|cameras|moods|statuses|levels|stopsHow|kinds|formats|outcome|obstacles|titles|parts|" +
      "how|arms|causeNames)|views[.](front|robot|top|left|right)$)",
  );
  const isUsed = (key) => new RegExp(`[.]${key}\\b|const \\{[^}]*\\b${key}\\b[^}]*\\} = texts`).test(all);
  const unused = [...en.keys()].filter((id) => !isOfProgram(id) && !named.test(id) && !isUsed(id.split(".").at(-1)));
  assert.deepEqual(unused, []);
});

test("no element has a text of its own, and the view of the tables has none", () => {
  const [, view] = read("web/src/texts.ts").replace(/template: `[^`]*`/, "").split("export const texts");
  assert.deepEqual(view.match(/(?<=[:>?] )["`][^"`\n]*[A-Za-z]{2}[^"`\n]*["`]/g) ?? [], []);
  const texts = sources.filter(({ name }) => name.endsWith(".tsx")).flatMap(({ name, text }) => {
    const found = text.match(/<(\w+)[^<>=]*>\s*[A-Z][a-z]+ ?[^<{]*<\/\1>|\b(?:aria-label|title|label|alt|placeholder)="[A-Za-z][^"]*"/g);
    return (found ?? []).map((one) => `${name}: ${one}`);
  });
  assert.deepEqual(texts, []);
});

test("the page is at most 250 kB to transfer, in each language", () => {
  const bytesOf = (file) => statSync(new URL(`build/page/${file}.gz`, ROOT)).size;
  const common = ["index.html", "studio.css", "studio.js"].map(bytesOf).reduce((sum, one) => sum + one);
  for (const language of ["en", ...others]) assert.ok(common + bytesOf(`${language}.js`) <= 250_000, language);
});

/** A module of the page, in a browser with these languages. */
async function moduleOf(path, { html = "web/index.html", languages }) {
  const entryPoints = [new URL(path, ROOT).pathname];
  const { outputFiles } = await build({ entryPoints, bundle: true, write: false, format: "esm", target: "es2022" });
  const named = /<html[^>]* data-language="(\w+)"/.exec(read(html));
  const document = { documentElement: { dataset: named === null ? {} : { language: named[1] } } };
  const localStorage = { getItem: () => null, setItem: () => undefined };
  globalThis.surroundings = { document, localStorage, navigator: { languages } };
  const text = `const { document, localStorage, navigator } = globalThis.surroundings; ${outputFiles[0].text}`;
  // A module of its own for each document and language, as texts differ.
  return import(`data:text/javascript,${encodeURIComponent(`${text}\n// ${html} ${languages}`)}`);
}

test("the page of a study is English, whatever the browser prefers; the studio follows it", async () => {
  const languageOf = async (html, ...languages) => (await moduleOf("web/src/language.ts", { html, languages })).language;
  assert.equal(await languageOf("web/study.html", "de"), "en");
  assert.equal(await languageOf("web/index.html", "fr", "de-AT"), "de");
  assert.equal(await languageOf("web/index.html", "fr"), "en");
});

test("numbers, plurals and lists are those of the language", async () => {
  const { texts: german } = await moduleOf("web/src/texts.ts", { languages: ["de"] });
  const { texts: english } = await moduleOf("web/src/texts.ts", { languages: ["en"] });
  const said = ({ seconds, objects, people, timeline, datasets }) => [
    seconds(1234.56), objects.show(1), objects.show(2), objects.placeAt([1, -0.5, 0]), people.wanted([3, 5]),
    timeline.overKeeps(["left"]), datasets.episodes(1, 2),
  ];
  assert.deepEqual(said(english), [
    "1234.6 s", "1 object", "2 objects", "1.00, −0.50, 0.00", "Visitors 3 and 5 request control.",
    "Keep what the left hand does", "1 of 2 episodes",
  ]);
  assert.deepEqual(said(german), [
    "1234,6 s", "1 Objekt", "2 Objekte", "1,00; −0,50; 0,00", "Die Besucher 3 und 5 bitten um die Steuerung.",
    "Behalten, was die linke Hand tut", "1 von 2 Episoden",
  ]);
});

test("actions have the program's words in English, and others in German", async () => {
  const { texts: english } = await moduleOf("web/src/texts.ts", { languages: ["en"] });
  const { texts: german } = await moduleOf("web/src/texts.ts", { languages: ["de"] });
  const actions = [
    [{ do: "take", hand: "left", what: "b03" }, "left hand takes b03", "linke Hand nimmt b03"],
    [{ do: "put", hand: "both", what: "b03", on: "b01" }, "both hands put b03 on b01", "beide Hände stellen b03 auf b01 ab"],
    [{ do: "drop", hand: "right", what: "b03", into: "" }, "right hand drops b03 into the table", "rechte Hand lässt b03 in den Tisch fallen"],
    [{ do: "put", hand: "any", what: "b03", on: "" }, "any hand puts b03 on the table", "irgendeine Hand stellt b03 auf dem Tisch ab"],
    [{ do: "cut", hand: "left", what: "String", with: "Knife" }, "left hand cuts String with Knife", "linke Hand schneidet String mit Knife"],
    [{ do: "cut", hand: "left", what: "Rope between link 4 and 5", with: "Knife" }, "left hand cuts Rope between link 4 and 5 with Knife", "linke Hand schneidet Rope zwischen Glied 4 und 5 mit Knife"],
    [{ do: "cut", hand: "left", what: "Rope between start and link 0" }, "left hand cuts Rope between start and link 0", "linke Hand schneidet Rope zwischen Anfang und Glied 0"],
    [{ do: "cut", hand: "left", what: "Rope between link 9 and end" }, "left hand cuts Rope between link 9 and end", "linke Hand schneidet Rope zwischen Glied 9 und Ende"],
    [{ do: "point", hand: "left", what: "b03" }, "left hand points at b03", "linke Hand zeigt auf b03"],
    [{ do: "clear", hand: null, what: "5 objects" }, "cleared the table of 5 objects", "Tisch abgeräumt: 5 Objekte"],
    [{ do: "move", hand: null, what: "b03" }, "moved b03", "b03 verschoben"],
  ];
  for (const [action, inEnglish, inGerman] of actions) {
    assert.equal(english.action(action), inEnglish);
    assert.equal(german.action(action), inGerman);
  }
});

test("messages of the program are in the language of the page", async () => {
  const { parse } = await moduleOf("web/src/said.ts", { languages: ["de"] });
  const hand = { say: "hands.name", with: { hand: "left" } };
  const sent = { error: { say: "hands.holds", with: { hand, object: "b03" } }, allowed: [true, "as it is"] };
  assert.equal(
    JSON.stringify(parse(JSON.stringify(sent))),
    '{"error":"die linke Hand hält „b03“","allowed":[true,"as it is"]}',
  );
  const far = { say: "tools.isTilted", with: { tool: "T", degrees: 12, object: "S", limit: 7.5 } };
  assert.equal(parse(JSON.stringify(far)), "„T“ steht 12 Grad schräg zu „S“, höchstens 7,5 sind erlaubt");
  assert.equal(parse('{"say":"of.anotherVersion"}'), "of.anotherVersion");
});

test("numbers are typed with a comma or a point, and shown as the language does", async () => {
  const { typed, numberIn } = await moduleOf("web/src/message_format.ts", { languages: ["de"] });
  assert.deepEqual([typed(-0.5, 2), typed(-0.001, 2), typed(3, 0)], ["-0,50", "0,00", "3"]);
  assert.deepEqual(["1,5", "1.5", " -2 ", "−0,25", "", "1,5,5", "a"].map(numberIn), [1.5, 1.5, -2, -0.25, null, null, null]);
  const english = await moduleOf("web/src/message_format.ts", { languages: ["en"] });
  assert.deepEqual([english.typed(-0.5, 2), english.numberIn("1.5"), english.numberIn("1,5")], ["-0.50", 1.5, 1.5]);
});

const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

/** All that people or screen readers read on the page. */
function words() {
  const read = [];
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    // The names of files are the same in each language.
    if (walker.currentNode.parentElement.closest(".scene-name") === null) read.push(walker.currentNode.textContent.trim());
  }
  for (const element of document.querySelectorAll("*")) {
    for (const name of ["aria-label", "title", "placeholder", "alt"]) read.push(element.getAttribute(name)?.trim());
  }
  return read.filter(Boolean);
}

/** @param names  of objects and cameras in files, which are no words of the page */
async function judge(page, state, names = []) {
  const german = tableOf("de");
  const english = new Set([...en].filter(([id, message]) => german.get(id) !== message).map(([, message]) => message));
  for (const message of [...german.values(), ...names]) english.delete(message);
  assert.deepEqual((await page.evaluate(words)).filter((word) => english.has(word)), [], state);
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert.ok(overflow <= 0, `${state}: ${overflow} px too wide`);
  const cut = await page.evaluate(() =>
    [...document.querySelectorAll("button:not(.title-in-place), [role=tablist], .record")]
      .filter((one) => one.clientWidth > 1 && one.scrollWidth > one.clientWidth + 1)
      .map((one) => one.textContent),
  );
  assert.deepEqual(cut, [], `${state}: wider than their places`);
}

async function hasNoBarrier(page) {
  await page.evaluate(AXE);
  const { violations } = await page.evaluate(() => window.axe.run(document, { resultTypes: ["violations"] }));
  assert.deepEqual(violations.filter(({ impact }) => impact === "serious" || impact === "critical").map(({ id }) => id), []);
}

test("in a German browser the page is German, and English where that is chosen", async (t) => {
  const { page } = await browser.workplace(t, { studio: ["--no-pictures"], page: { locale: "de-DE" } });
  assert.equal(await page.locator("html").getAttribute("lang"), "de");
  await page.getByRole("button", { name: "Aufnehmen", disabled: false }).click();
  await page.getByRole("button", { name: "Beenden", disabled: false }).waitFor();
  for (const tab of ["Bibliothek", "Roboter", "Gehirn", "Hände", "Objekte"]) {
    await page.getByRole("tab", { name: tab }).click();
    await judge(page, tab);
  }
  await page.getByRole("button", { name: "Hilfe" }).click();
  await page.getByRole("dialog").waitFor();
  await judge(page, "Hilfe");
  await hasNoBarrier(page);

  await page.getByLabel("Sprache").selectOption("en");
  await page.getByRole("button", { name: "Help" }).waitFor();
  assert.equal(await page.locator("html").getAttribute("lang"), "en");
});

test("what the program refuses, and what it names, is German in a German browser", async (t) => {
  const dock = new URL("scenes/dock.xml", ROOT).pathname;
  const { page, witness, person } = await browser.workplace(t, {
    studio: [dock, "--no-robot", "--no-pictures"],
    page: { locale: "de-DE" },
  });
  await person.press("Oben");
  const undo = page.getByRole("button", { name: "Rückgängig", exact: true });
  assert.match(await undo.getAttribute("title"), /es gibt nichts rückgängig zu machen/);
  const lamp = [-4.9, 0.6, 0.98];
  const menu = await person.menuAt(lamp);
  const trigger = person.entry("Drücken", menu);
  assert.equal(await trigger.getAttribute("aria-disabled"), "true");
  await trigger.getByText("eine Reihe von Lampen").waitFor();
  await page.keyboard.press("Escape");

  await page.getByRole("button", { name: "Aufnehmen", disabled: false }).click();
  await person.grasp("Spare");
  await page.getByText("irgendeine Hand nimmt Spare").first().waitFor();
  await judge(page, "with an object", ["Bin"]);
  // Fields of numbers have a comma, and take a point, too.
  const height = page.getByRole("group", { name: /^Ort/ }).getByRole("spinbutton", { name: "z", exact: true });
  for (const typed of ["3,25", "2.75"]) {
    await height.fill(typed);
    await height.press("Enter");
    const wanted = Number(typed.replace(",", "."));
    await witness.until(() => Math.abs(witness.handOf("Spare").place[2] - wanted) < 1e-6, `it is at ${typed}`);
    await page.waitForFunction(([field, text]) => field.value === text, [await height.elementHandle(), typed.replace(".", ",")]);
  }
  await height.press("ArrowUp");
  await height.press("Enter");
  await witness.until(() => Math.abs(witness.handOf("Spare").place[2] - 2.85) < 1e-6, "a step up");
});

test("the large dialogs, the timeline and the tour are German, and their words fit", async (t) => {
  const tower = new URL("scenes/tower.xml", ROOT).pathname;
  const { page, witness, person } = await browser.workplace(t, { studio: [tower, "--no-pictures"], page: { locale: "de-DE" } });
  const german = tableOf("de");
  await page.getByRole("button", { name: "Aufnehmen", disabled: false }).click();
  await person.grasp("RedBlock");
  await person.dragTo("RedBlock", [-1, null, 0.8]);
  await person.press("Loslassen");
  await witness.until(() => !witness.isHolding, "it is released");
  await person.press("Beenden");
  await page.getByRole("button", { name: german.get("timeline.trim"), disabled: true }).waitFor();
  await judge(page, "timeline");

  await person.showPanel("Bibliothek");
  for (const id of ["datasets.generateEntry", "filming.entry", "exporting.entry", "library.analyze", "library.rename"]) {
    await page.getByRole("button", { name: /^Aktionen für/ }).first().click();
    await page.getByRole("menuitem", { name: german.get(id) }).click();
    if (id === "library.analyze") await page.getByText(/notwendig; sonst: RedBlock liegt noch da/).waitFor();
    await judgeDialog(id);
  }
  const segments = page.getByRole("list", { name: german.get("timeline.segments"), exact: true });
  await segments.getByRole("button").nth(1).click();
  for (const id of ["timeline.trim", "timeline.shift", "timeline.drop"]) {
    await page.getByRole("button", { name: german.get(id), disabled: false }).click();
    await judgeDialog(id);
  }
  await person.showPanel("Objekte");
  await page.getByRole("button", { name: german.get("objects.write"), exact: true }).click();
  await judgeDialog("scene editor");
  await person.press("Hilfe");
  await page.getByRole("button", { name: german.get("help.tour") }).click();
  await page.getByText(german.get("tour.steps.welcome.0")).waitFor();
  await judge(page, "tour");

  async function judgeDialog(state) {
    const dialog = page.getByRole("dialog");
    await dialog.waitFor();
    await judge(page, state, ["left", "right"]);
    await page.keyboard.press("Escape");
    await dialog.waitFor({ state: "detached" });
  }
});

test("German fits a telephone", async (t) => {
  const { page } = await browser.workplace(t, {
    studio: ["--no-pictures"],
    page: { locale: "de-DE", viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true },
  });
  await judge(page, "at the beginning");
  await page.getByRole("button", { name: "Hilfe" }).click();
  await page.getByRole("dialog").waitFor();
  await judge(page, "Hilfe");
  await hasNoBarrier(page);
});
