// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Cancelling: what is under way stops, the last good result stays, and the page goes on as if nothing had been.

import assert from 'node:assert/strict';
import { appendFileSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test from 'node:test';

import { make, transform, writeMesh } from 'mortise';

import { beginDrop, choose, download, dropFiles, idle, reportOf, stateOf, until, useBrowser, withPage } from './support/browser.mjs';
import { runCommands } from './support/command.mjs';

useBrowser();

/** A ball of 327,680 triangles as a file. */
async function largeFile(name, x) {
  const mesh = await transform(await make('icosphere', { levels: 7 }), [{ rotateX: 10 }, { translate: [x, 0.1, 0.2] }]);
  return { name, bytes: await writeMesh(mesh, { format: 'stl' }) };
}

/** Keeps the worker from hearing anything from now on, until it is stopped. */
function holdWorker(page) {
  return page.workers()[0].evaluate(() => {
    setTimeout(() => {
      for (const end = Date.now() + 60_000; Date.now() < end; );
    });
  });
}

const fractionOf = (page) => page.evaluate(() => (document.getElementById('work').hidden ? -1 : document.getElementById('progress').position));

test(
  'a computation is cancelled by the button; the last good result stays, the next one is that of the command',
  withPage(async (page, t) => {
    const files = [await largeFile('left.stl', 0), await largeFile('right.stl', 0.7)];
    const before = await reportOf(page);
    await beginDrop(page, files);
    await until('the computation', async () => (await fractionOf(page)) > 0);
    const begin = performance.now();
    await page.click('#cancel', { force: true });
    assert.equal(await stateOf(page), 'cancelled');
    t.diagnostic(`cancelled after ${Math.round(performance.now() - begin)} ms`);
    assert.equal(await page.textContent('#status'), 'Cancelled');
    assert.equal(await page.isVisible('#old'), true);
    assert.equal(await page.isVisible('#work'), false);
    assert.deepEqual(await reportOf(page), before);
    assert.match(await page.textContent('#parts'), /left\.stl.*right\.stl/s);
    await choose(page, 'intersect');
    assert.equal(page.workers().length, 1);
    assert.equal(await page.isVisible('#old'), false);
    const shown = await reportOf(page);
    const { report, bytes } = runCommands(t, await page.textContent('#commands'), files);
    assert.equal(shown.Triangles, report.triangles);
    assert.equal(shown.Volume, report.volume);
    assert.deepEqual((await download(page, 'ply')).bytes, bytes);
  }),
);

test(
  'Escape cancels the reading of a file: the parts stay as they were',
  withPage(async (page) => {
    const [parts, before] = [await page.textContent('#parts'), await reportOf(page)];
    await holdWorker(page);
    await beginDrop(page, [await largeFile('large.stl', 0)]);
    await page.getByText('Reading large.stl').waitFor();
    await page.keyboard.press('Escape');
    assert.equal(await stateOf(page), 'cancelled');
    assert.equal(await page.isVisible('#old'), false, 'nothing changed');
    assert.equal(await page.isVisible('#trouble'), false);
    assert.equal(await page.textContent('#parts'), parts);
    assert.deepEqual(await reportOf(page), before);
    await choose(page, 'intersect');
    assert.notEqual((await reportOf(page)).Volume, before.Volume);
  }),
);

test(
  'what waited for its turn is dropped too; what was asked for before can be taken away, and computed when wanted',
  withPage(async (page, t) => {
    const [before, { bytes }] = [await reportOf(page), await download(page, 'ply')];
    await holdWorker(page);
    await page.fill('#move-z', '1.1');
    await page.fill('#move-z', '1.2');
    await page.focus('#move-z');
    const saved = download(page, 'ply');
    await page.locator('#cancel').waitFor();
    await page.press('#move-z', 'Escape');
    assert.deepEqual((await saved).bytes, bytes);
    assert.equal(await stateOf(page), 'cancelled');
    assert.deepEqual(await reportOf(page), before);
    await page.waitForTimeout(900);
    assert.equal(await page.textContent('[role=status]'), 'Cancelled');
    await page.click('#again');
    assert.equal(await idle(page), 'done');
    const { report } = runCommands(t, await page.textContent('#commands'));
    assert.match(await page.textContent('#commands'), /--translate=0\.3,-0\.7,1\.2/);
    assert.equal((await reportOf(page)).Volume, report.volume);
  }),
);

test(
  'when nothing is under way Escape does nothing',
  withPage(async (page) => {
    const [worker] = page.workers();
    await page.keyboard.press('Escape');
    assert.equal(await stateOf(page), 'done');
    assert.equal(page.workers()[0], worker);
  }),
);

test(
  'a file that was changed since cannot be read again, and this is said',
  withPage(async (page, t) => {
    const folder = mkdtempSync(join(tmpdir(), 'mortise-page-'));
    t.after(() => rmSync(folder, { recursive: true, force: true }));
    const path = join(folder, 'ball.off');
    const ball = { name: 'ball.off', bytes: await writeMesh(await make('icosphere', { levels: 2 }), { format: 'off' }) };
    writeFileSync(path, ball.bytes);
    await page.setInputFiles('#choose-files', path);
    assert.equal(await idle(page), 'done');
    await holdWorker(page);
    appendFileSync(path, '# changed\n');
    await page.press('body', '2');
    await page.keyboard.press('Escape');
    await page.press('body', '3');
    assert.equal(await idle(page), 'trouble');
    assert.match(await page.innerText('#trouble'), /B \(ball\.off\).*cannot be read.*FILE_FAILED/s);
    assert.equal(await dropFiles(page, [ball]), 'done');
    assert.equal(await page.isVisible('#trouble'), false);
  }),
);
