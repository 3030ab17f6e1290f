// Access: from other machines only with the link, from other sites never.

import assert from "node:assert/strict";
import { createServer } from "node:http";
import { networkInterfaces } from "node:os";
import { after, before, test } from "node:test";
import WebSocket from "ws";
import { Person } from "./person.mjs";
import { Browser, Studio, Witness } from "./workbench.mjs";

const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

const PLAIN = ["--no-robot", "--no-pictures"];

test("from elsewhere the printed link opens the studio, and nothing else does", async (t) => {
  const listen = ["--listen", addressForOthers(), ...PLAIN];
  const { studio, page, witness, person } = await browser.workplace(t, { studio: listen });
  const { origin, searchParams } = new URL(studio.link);
  assert.match(searchParams.get("token"), /^[0-9a-f]{32}$/);
  assert.equal(page.url(), `${origin}/`, "the token is no longer visible");
  assert.equal(await page.evaluate(() => document.cookie), "", "nor to be read");
  await page.reload();
  await page.waitForFunction(() => window.smileStudio?.stats().isShown);
  await person.grasp("RedBlock");
  await person.release();

  // Another studio at the same address is opened in the same browser: neither forgets the other.
  const other = await Studio.start(listen);
  studio.whenClosed.push(() => other.close());
  const second = await page.context().newPage();
  await second.goto(other.link);
  for (const one of [second, page, second]) {
    await one.reload();
    await one.waitForFunction(() => window.smileStudio?.stats().isShown);
  }

  const stranger = await page.context().browser().newContext();
  studio.whenClosed.push(() => stranger.close());
  const door = await stranger.newPage();
  for (const path of ["/", "/?token=", `/?token=${"0".repeat(32)}`, `/${new URL(other.link).search}`]) {
    const answer = await door.goto(origin + path);
    assert.equal(answer.status(), 403, path);
    await door.getByText("open the link that the program printed").waitFor();
  }
  assert.equal(await statusOf(new URL("/ws", origin.replace("http", "ws"))), 403);
  assert.equal(await statusOf(studio.door, { origin: "http://evil.example" }), 403, "not even with the token");
  assert.equal(await statusOf(studio.door, { origin }), 101);
  assert.ok(witness.state !== null);
});

test("pages of other sites have no access, also in the browser of who has", async (t) => {
  const { studio, page, witness } = await browser.workplace(t, { studio: PLAIN });
  const site = createServer((_, answer) => answer.end("<!doctype html><title>Another site</title>"));
  await new Promise((resolve) => site.listen(0, "127.0.0.1", resolve));
  t.after(() => site.close());
  const tab = await page.context().newPage();
  await tab.goto(`http://127.0.0.1:${site.address().port}/`);
  const endOf = await tab.evaluate((door) => {
    const socket = new WebSocket(door);
    return new Promise((resolve) => {
      socket.onopen = () => resolve("it was let in");
      socket.onclose = ({ code }) => resolve(code);
    });
  }, studio.door);
  assert.equal(endOf, 1006, "it was never open");
  const read = await tab.evaluate((link) => fetch(link).then((answer) => answer.text(), () => null), studio.link);
  assert.equal(read, null, "nor is anything read");
  assert.equal(await statusOf(studio.door, { origin: new URL(tab.url()).origin }), 403);
  assert.equal(await statusOf(studio.door, { origin: new URL(studio.link).origin }), 101);
  assert.equal(await statusOf(studio.door, { headers: { Host: "evil.example" } }), 403, "nor under another name");
  assert.equal(witness.state.mode, "live");
});

test("studios that start at once have doors and worlds of their own", async (t) => {
  const studios = await Promise.all([0, 1, 2].map(() => Studio.start(PLAIN)));
  for (const studio of studios) t.after(async () => assert.equal(await studio.close(), 0));
  assert.equal(new Set(studios.map(({ link }) => new URL(link).port)).size, 3);
  const [first, second] = await Promise.all(studios.slice(0, 2).map((studio) => Witness.of(studio)));
  const page = await browser.open(studios[0]);
  const person = new Person(page, first);
  await person.grasp("RedBlock");
  const { tick } = second.state;
  await second.request("ping");
  assert.ok(!second.isHolding, `nothing is held there at ${tick}`);
});

/** An address of this machine by which others reach it; where there is none, all of its addresses. */
function addressForOthers() {
  const all = Object.values(networkInterfaces()).flat();
  return all.find(({ family, internal }) => family === "IPv4" && !internal)?.address ?? "0.0.0.0";
}

/** The status of the response to a WebSocket request: 101 is acceptance. */
function statusOf(door, options = {}) {
  return new Promise((resolve, reject) => {
    const socket = new WebSocket(door, options);
    socket.on("unexpected-response", (request, answer) => {
      request.destroy();
      resolve(answer.statusCode);
    });
    socket.on("open", () => {
      socket.close();
      resolve(101);
    });
    socket.on("error", reject);
  });
}
