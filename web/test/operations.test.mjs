// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Moving parts and the four operations, against the command on the same input.

import assert from 'node:assert/strict';
import test from 'node:test';

import { make, writeMesh } from 'mortise';

import { choose, download, dropFiles, idle, reportOf, setField, stateOf, until, useBrowser, withPage } from './support/browser.mjs';
import { runCommands } from './support/command.mjs';
import { areaOf, coloursOf } from './support/pixels.mjs';

const choices = ['union', 'intersect', 'first', 'second'];

useBrowser();

/** Asserts that the command lines of the page give what the page shows, byte for byte. */
async function compareWithCommand(page, t, files) {
  const shown = await reportOf(page);
  const { report, bytes } = runCommands(t, await page.textContent('#commands'), files);
  assert.equal(shown.Triangles, report.triangles);
  assert.equal(shown.Volume, report.volume);
  assert.equal(shown.Area, report.area);
  assert.deepEqual((await download(page, 'ply')).bytes, bytes, 'the same file');
  return shown;
}

/** Every operation compared; the results fit together. */
async function compareAll(page, t) {
  const volumes = {};
  for (const choice of choices) {
    await choose(page, choice);
    assert.equal(await page.getAttribute(`button[data-choice=${choice}]`, 'aria-pressed'), 'true');
    volumes[choice] = (await compareWithCommand(page, t)).Volume;
  }
  const { union, intersect, first, second } = volumes;
  assert.ok(intersect > 0.01, 'the parts cross');
  assert.ok(Math.abs(union - intersect - first - second) < 1e-9, JSON.stringify(volumes));
  return volumes;
}

/** Points round the middle of the view, near ones first. */
function* pointsRound({ x, y, width, height }) {
  for (let radius = 0; radius < 260; radius += 6) {
    const count = Math.max(1, Math.floor(radius / 2));
    for (let i = 0; i < count; ++i) {
      const angle = (2 * Math.PI * i) / count;
      yield [x + width / 2 + radius * Math.cos(angle), y + height / 2 + radius * Math.sin(angle)];
    }
  }
}

/** Moves the mouse until it is over a part of the handle, and tells where that is. */
async function findHandle(page, axis) {
  for (const [x, y] of pointsRound(await areaOf(page, '#canvas'))) {
    await page.mouse.move(x, y);
    if ((await page.getAttribute('#canvas', 'data-handle')) === axis) return [x, y];
  }
  return assert.fail(`the handle ${axis} is not to be found`);
}

async function drag(page, [x, y], [dx, dy]) {
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let step = 1; step <= 12; ++step) await page.mouse.move(x + (dx * step) / 12, y + (dy * step) / 12);
  await page.mouse.up();
  assert.equal(await idle(page), 'done');
}

const valuesOf = (page, field) => Promise.all(['x', 'y', 'z'].map(async (axis) => Number(await page.inputValue(`#${field}-${axis}`))));

test('as it opens, all four operations are those of the command', withPage(compareAll));

test(
  'a part dragged by its handle moves along the axis, and the result follows',
  withPage(async (page, t) => {
    const before = await reportOf(page);
    const placed = await valuesOf(page, 'move');
    await drag(page, await findHandle(page, 'Z'), [0, -40]);
    assert.equal((await reportOf(page)).Crossings, 0, 'counted after the drag');
    const moved = await valuesOf(page, 'move');
    assert.deepEqual(moved.slice(0, 2), placed.slice(0, 2));
    assert.ok(moved[2] > placed[2] + 0.05, `${moved}`);
    assert.notEqual((await reportOf(page)).Volume, before.Volume);
    await compareAll(page, t);
  }),
);

test(
  'a part dragged by the other handles turns and scales',
  withPage(async (page, t) => {
    await page.keyboard.press('e');
    const turned = await valuesOf(page, 'turn');
    await drag(page, await findHandle(page, 'Z'), [45, 20]);
    assert.notDeepEqual(await valuesOf(page, 'turn'), turned);
    await page.keyboard.press('r');
    await drag(page, await findHandle(page, 'X'), [30, 10]);
    assert.notDeepEqual(await valuesOf(page, 'scale'), [1, 1, 1]);
    await compareWithCommand(page, t);
  }),
);

test(
  'while a part is dragged crossings are not counted; when it is let go they are',
  withPage(async (page) => {
    const crossings = () => page.evaluate(() => document.querySelector('#report').innerText.match(/Crossings\s+(.*)/)[1]);
    assert.equal(await crossings(), 'none');
    const [x, y] = await findHandle(page, 'Z');
    await page.mouse.down();
    await page.mouse.move(x, y - 30, { steps: 4 });
    await until('a result under the hand', async () => (await crossings()) === 'not counted yet');
    assert.equal(await idle(page), 'done');
    await page.mouse.up();
    assert.equal(await idle(page), 'done');
    assert.equal(await crossings(), 'none');
  }),
);

test(
  'numbers typed into the fields place a part exactly',
  withPage(async (page, t) => {
    await page.check('#parts input[value="0"]');
    const fields = { 'move-x': 0.125, 'move-y': -0.1, 'move-z': 0.3, 'turn-x': 20, 'turn-y': -7.5, 'turn-z': 33, 'scale-x': 1.1, 'scale-y': 0.9, 'scale-z': 1.25 };
    for (const [id, value] of Object.entries(fields)) await setField(page, id, value);
    assert.match(await page.textContent('#commands'), /--scale=1.1,0.9,1.25 --rotate-x=20 --rotate-y=-7.5 --rotate-z=33 --translate=0.125,-0.1,0.3/);
    await compareAll(page, t);
    await page.click('#reset');
    await idle(page);
    assert.deepEqual(await valuesOf(page, 'move'), [0, 0, 0]);
    assert.doesNotMatch(await page.textContent('#commands'), /scale/);
  }),
);

test(
  'of many changes the last one counts',
  withPage(async (page, t) => {
    await page.evaluate(() => {
      const input = document.getElementById('move-x');
      for (let i = 0; i <= 40; ++i) {
        input.value = String(i / 100);
        input.dispatchEvent(new Event('input', { bubbles: true }));
      }
    });
    assert.equal(await idle(page), 'done');
    assert.equal(await page.inputValue('#move-x'), '0.4');
    await compareWithCommand(page, t);
  }),
);

test(
  'while a computation runs the last good result stays, and the moved part is shown',
  withPage(async (page) => {
    const before = await reportOf(page);
    const seen = await page.locator('#canvas').screenshot();
    const held = page.workers()[0].evaluate(() => {
      for (const end = Date.now() + 5000; Date.now() < end; );
    });
    await page.fill('#move-z', '1.5');
    const shot = await page.screenshot();
    assert.notDeepEqual(await page.locator('#canvas').screenshot(), seen);
    assert.deepEqual(await reportOf(page), before);
    assert.equal(await stateOf(page), 'busy');
    const colours = await coloursOf(page, shot, await areaOf(page, '#canvas'));
    assert.ok(colours.blue > 100 && colours.orange > 300, JSON.stringify(colours));
    await held;
    assert.equal(await idle(page), 'done');
    assert.notEqual((await reportOf(page)).Volume, before.Volume);
  }),
);

test(
  'a long computation shows its progress',
  withPage(async (page) => {
    await page.evaluate(() => {
      const bar = document.getElementById('progress');
      globalThis.fractions = [];
      const look = () => bar.checkVisibility() && bar.position >= 0 && globalThis.fractions.push(bar.value);
      new MutationObserver(look).observe(bar, { attributes: true });
    });
    const bytes = await writeMesh(await make('icosphere', { levels: 7 }), { format: 'stl' });
    assert.equal(await dropFiles(page, [{ name: 'fine.stl', bytes }]), 'done');
    const fractions = await page.evaluate(() => globalThis.fractions);
    assert.ok(fractions.some((x) => x > 0 && x < 1) && fractions.every((x) => x >= 0 && x <= 1), `${fractions}`);
    assert.deepEqual(fractions, [...fractions].sort((a, b) => a - b));
    assert.equal(await page.isVisible('#progress'), false);
  }),
);

test(
  'a click on a part chooses it',
  withPage(async (page) => {
    const { x, y, width, height } = await areaOf(page, '#canvas');
    assert.equal(await page.isChecked('#parts input[value="1"]'), true);
    await page.mouse.click(x + 0.64 * width, y + 0.72 * height);
    assert.equal(await page.isChecked('#parts input[value="0"]'), true);
    assert.equal(await page.textContent('#placement-part'), 'A');
    await page.mouse.click(x + 0.3 * width, y + 0.45 * height);
    assert.equal(await page.isChecked('#parts input[value="1"]'), true);
  }),
);

test(
  'mesh edges, intersection graph and faint parts are shown when wanted',
  withPage(async (page) => {
    await choose(page, 'intersect');
    for (const name of ['edges', 'graph', 'ghosts']) {
      const seen = await page.locator('#canvas').screenshot();
      const was = await page.isChecked(`#show-${name}`);
      await page.setChecked(`#show-${name}`, !was);
      const other = await page.locator('#canvas').screenshot();
      assert.notDeepEqual(other, seen, name);
      await page.setChecked(`#show-${name}`, was);
    }
  }),
);

test(
  'the command lines can be copied',
  withPage(async (page) => {
    await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
    await page.click('#copy');
    await page.getByRole('button', { name: 'Copied' }).waitFor();
    assert.equal(await page.evaluate(() => navigator.clipboard.readText()), await page.textContent('#commands'));
  }),
);
