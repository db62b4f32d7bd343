// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Files in, files out, and what happens when one is bad.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { inspect, make, readMesh, transform, writeMesh } from 'mortise';

import { choose, download, dropFiles, idle, reportOf, useBrowser, withPage } from './support/browser.mjs';
import { runCommands } from './support/command.mjs';
import { areaOf, coloursOf } from './support/pixels.mjs';

useBrowser();

const ball = await make('icosphere', { radius: 1, levels: 4 });
const rod = await transform(await make('cylinder', { radius: 0.4, height: 3, around: 48 }), [{ translate: [0.1, 0, -1.5] }, { rotateX: 30 }]);

/** A mesh as a file. */
const fileOf = async (name, mesh, format) => ({ name, bytes: await writeMesh(mesh, { format }) });

const twoFiles = async () => [await fileOf('ball.stl', ball, 'stl'), await fileOf("the rod's.obj", rod, 'obj')];
const sheet = async () => fileOf('sheet.off', await make('gridSheet', { width: 2, depth: 2, cellsX: 3, cellsY: 2 }), 'off');

test(
  'two dropped files are the operands, and the result is that of the command',
  withPage(async (page, t) => {
    const files = await twoFiles();
    assert.equal(await dropFiles(page, files), 'done');
    assert.match(await page.textContent('#parts'), /ball\.stl.*the rod's\.obj/s);
    for (const choice of ['union', 'first', 'second', 'intersect']) {
      await choose(page, choice);
      const shown = await reportOf(page);
      const { report, bytes } = runCommands(t, await page.textContent('#commands'), files);
      assert.equal(shown.Triangles, report.triangles, choice);
      assert.equal(shown.Volume, report.volume, choice);
      assert.deepEqual((await download(page, 'ply')).bytes, bytes);
    }
  }),
);

test(
  'a download in any format holds the result',
  withPage(async (page) => {
    await dropFiles(page, await twoFiles());
    await choose(page, 'first');
    const shown = await reportOf(page);
    for (const format of ['ply', 'ply-ascii', 'obj', 'off', 'stl-ascii', 'stl']) {
      const { name, bytes } = await download(page, format);
      assert.equal(name, `a-minus-b.${format.replace('-ascii', '')}`);
      const mesh = await readMesh(bytes, { format });
      const report = await inspect(mesh);
      assert.equal(report.triangles, shown.Triangles, format);
      assert.equal(report.closed, true, format);
      if (format === 'stl') assert.ok(Math.abs(report.volume - shown.Volume) < 1e-6, 'rounded to float32');
      else assert.equal(report.volume, shown.Volume, format);
    }
  }),
);

test(
  'one dropped file replaces the chosen part, another may be added, parts may be removed',
  withPage(async (page) => {
    const [first, second] = await twoFiles();
    await page.check('#parts input[value="0"]');
    await dropFiles(page, [first]);
    assert.match(await page.textContent('#parts'), /A.*ball\.stl.*B.*ring/s);
    await page.setInputFiles('#add-files', { name: second.name, mimeType: '', buffer: Buffer.from(second.bytes) });
    await idle(page);
    assert.match(await page.textContent('#parts'), /ball\.stl.*ring.*the rod's\.obj/s);
    assert.equal(await page.textContent('#title-first'), 'A − others');
    assert.match(await page.textContent('#commands'), /union ball\.stl b-placed\.ply 'the rod'\\''s\.obj/);
    await page.click('#remove');
    await idle(page);
    assert.equal(await page.locator('#parts input').count(), 2);
    await page.setInputFiles('#choose-files', { name: 'again.off', mimeType: '', buffer: Buffer.from((await fileOf('', rod, 'off')).bytes) });
    assert.equal(await idle(page), 'done');
    assert.match(await page.textContent('#parts'), /ball\.stl.*again\.off/s);
  }),
);

test(
  'parts far from the origin keep their shape on the screen and in the numbers',
  withPage(async (page) => {
    const far = [{ translate: [512_000.5, 5_403_000.25, 310] }];
    const files = [await fileOf('ball.ply', await transform(ball, far), 'ply'), await fileOf('rod.ply', await transform(rod, far), 'ply')];
    assert.equal(await dropFiles(page, files), 'done');
    await page.locator('.view').screenshot();
    const colours = await coloursOf(page, await page.screenshot(), await areaOf(page, '#canvas'));
    assert.ok(colours.blue > 200 && colours.orange > 200, JSON.stringify(colours));
    await page.fill('#turn-z', '90');
    assert.equal(await idle(page), 'done');
    assert.match(await page.textContent('#commands'), /rod\.ply --translate=-512000\.\S+ --rotate-z=90 --translate=512000\./);
  }),
);

test(
  'an open surface is explained and marked, and the last good result is kept',
  withPage(async (page) => {
    const before = await reportOf(page);
    assert.equal(await dropFiles(page, [await sheet()]), 'trouble');
    const words = await page.innerText('#trouble');
    assert.match(words, /B \(sheet\.off\)/);
    assert.match(words, /B is a sheet, not a solid: 10 open edges/);
    assert.match(words, /NOT_CLOSED/);
    assert.match(words, /10 edges are marked in the view/);
    assert.match(words, /last good result is kept/);
    assert.equal(await page.isVisible('#old'), true);
    assert.deepEqual(await reportOf(page), before);
    const seen = await page.locator('#canvas').screenshot();
    await page.click('#show-places');
    assert.notDeepEqual(await page.locator('#canvas').screenshot(), seen, 'the view goes to the places');
    await page.click('#samples');
    assert.equal(await idle(page), 'done');
    assert.equal(await page.isVisible('#trouble'), false);
    assert.equal(await page.isVisible('#old'), false);
    assert.deepEqual((await reportOf(page)).Volume, before.Volume);
  }),
);

test(
  'a damaged file is named, and nothing changes',
  withPage(async (page) => {
    const parts = await page.textContent('#parts');
    const [good] = await twoFiles();
    const bad = { name: 'bad.off', bytes: new TextEncoder().encode('OFF\n3 1 0\n0 0 0\n1 0 oops\n0 1 0\n3 0 1 2\n') };
    assert.equal(await dropFiles(page, [good, bad]), 'trouble');
    const words = await page.innerText('#trouble');
    assert.match(words, /bad\.off/);
    assert.match(words, /PARSE_FAILED/);
    assert.equal(await page.textContent('#parts'), parts);
    assert.equal(await page.isVisible('#old'), false);
    await choose(page, 'intersect');
    assert.equal(await page.isVisible('#trouble'), false);
  }),
);
