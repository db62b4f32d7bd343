// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Remeshing the result: driven by keys and mouse, judged by what can be downloaded.

import assert from 'node:assert/strict';
import test from 'node:test';

import { inspect, make, readMesh, transform, writeMesh } from 'mortise';

import { beginDrop, choose, download, dropFiles, idle, reportOf, setField, stateOf, until, useBrowser, withPage } from './support/browser.mjs';
import { runCommands } from './support/command.mjs';

useBrowser();

/** Presses Remesh and waits for what comes of it. */
async function remesh(page) {
  await page.click('#remesh');
  return idle(page);
}

/** The numbers of the comparison, in full. */
function comparisonOf(page) {
  return page.evaluate(() => {
    const rows = [...document.querySelectorAll('#comparison tr')].map((row) => [row.querySelector('th').textContent, ...[...row.querySelectorAll('data')].map(({ value }) => Number(value))]);
    return Object.fromEntries(rows.map(([name, before, after]) => [name, { before, after }]));
  });
}

/** Angles, and 2 r / R, of triangles, from sides alone. */
function shapesOf({ positions, triangles }) {
  const point = (v) => positions.subarray(3 * v, 3 * v + 3);
  const length = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  return Array.from({ length: triangles.length / 3 }, (_, f) => {
    const [p, q, r] = [0, 1, 2].map((k) => point(triangles[3 * f + k]));
    const [a, b, c] = [length(q, r), length(r, p), length(p, q)];
    const angle = (across, u, v) => (180 / Math.PI) * Math.acos(Math.min(1, Math.max(-1, (u * u + v * v - across * across) / (2 * u * v))));
    const angles = [angle(a, b, c), angle(b, c, a), angle(c, a, b)];
    return { smallest: Math.min(...angles), largest: Math.max(...angles), ratio: ((b + c - a) * (c + a - b) * (a + b - c)) / (a * b * c) };
  });
}

/** Lengths of edges, each once. */
function lengthsOf({ positions, triangles }) {
  const edges = new Map();
  triangles.forEach((v, i) => {
    const w = triangles[i - (i % 3) + ((i + 1) % 3)];
    edges.set(`${Math.min(v, w)} ${Math.max(v, w)}`, Math.hypot(...[0, 1, 2].map((k) => positions[3 * v + k] - positions[3 * w + k])));
  });
  return [...edges.values()];
}

const near = (x, y, tolerance) => assert.ok(Math.abs(x - y) <= tolerance, `${x} is not ${y}`);

/** The comparison of one side against its mesh. */
function checkNumbers(comparison, side, mesh, size) {
  const shapes = shapesOf(mesh);
  const lengths = lengthsOf(mesh);
  assert.equal(comparison.Triangles[side], shapes.length);
  near(comparison['Smallest angle'][side], Math.min(...shapes.map(({ smallest }) => smallest)), 1e-3);
  near(comparison['Largest angle'][side], Math.max(...shapes.map(({ largest }) => largest)), 1e-3);
  near(comparison['Mean 2 r / R'][side], shapes.reduce((sum, { ratio }) => sum + ratio, 0) / shapes.length, 1e-6);
  const inBand = lengths.filter((length) => length >= size / Math.SQRT2 && length <= size * Math.SQRT2).length;
  near(comparison['Edges in the band'][side], inBand / lengths.length, 1e-3);
}

/** The middle of the view: what lies over its borders shows which control has the focus. */
async function viewOf(page) {
  const { x, y, width, height } = await page.locator('#canvas').boundingBox();
  return page.screenshot({ clip: { x, y: y + 110, width, height: height - 180 } });
}

const meshOf = async (page) => readMesh((await download(page, 'ply')).bytes, { format: 'ply' });

test(
  'the sample union is remeshed; its numbers are those of the files, before and after',
  withPage(async (page, t) => {
    const before = await meshOf(page);
    assert.equal(await page.isVisible('#remeshed'), false);
    assert.equal(await page.isChecked('#show-edges'), false);
    const size = Number(await page.inputValue('#size'));
    await until('the prediction', async () => (await page.getAttribute('#predicted', 'data-count')) !== '');
    const predicted = Number(await page.getAttribute('#predicted', 'data-count'));
    assert.equal(await remesh(page), 'done');
    assert.equal(await page.isChecked('#show-edges'), true, 'triangles are seen');
    const comparison = await comparisonOf(page);
    const { name, bytes } = await download(page, 'ply');
    assert.equal(name, 'union-remeshed.ply');
    const after = await readMesh(bytes, { format: 'ply' });
    checkNumbers(comparison, 'before', before, size);
    checkNumbers(comparison, 'after', after, size);
    near(predicted / comparison.Triangles.after, 1, 0.15);
    assert.ok(comparison['Smallest angle'].before < 1 && comparison['Smallest angle'].after > 30);
    const report = await inspect(after);
    assert.deepEqual([report.closed, report.genus, report.selfIntersections], [true, 1, 0]);
    assert.match(await page.textContent('#remesh-notes'), /^No new crossings, no triangle had to stay\./);
    const command = runCommands(t, await page.textContent('#commands'));
    assert.deepEqual(command.bytes, bytes, 'the command lines give the same bytes');
    t.diagnostic(await page.textContent('#status'));
  }),
);

test(
  'before and after are looked at with the same camera, and taken away as they are shown',
  withPage(async (page) => {
    const shot = () => viewOf(page);
    await page.focus('#show-edges');
    await page.keyboard.press('Space');
    const lines = await page.textContent('#commands');
    const [seen, { bytes }] = [await shot(), await download(page, 'ply')];
    await remesh(page);
    const remeshed = await shot();
    assert.ok(!remeshed.equals(seen));
    await page.focus('[data-side=before]');
    await page.keyboard.press('Enter');
    assert.equal(await page.getAttribute('[data-side=before]', 'aria-pressed'), 'true');
    assert.ok((await shot()).equals(seen), 'the same picture');
    assert.match(await page.textContent('#status'), /^Union: 7,200 triangles, volume/);
    assert.equal(await page.textContent('#download'), 'Download');
    assert.deepEqual((await download(page, 'ply')).bytes, bytes);
    assert.equal(await page.textContent('#commands'), lines);
    await page.click('[data-side=after]');
    assert.ok((await shot()).equals(remeshed), 'the same picture');
    assert.match(await page.textContent('#commands'), /--remesh=/);
    await page.click('#unremesh');
    assert.equal(await page.isVisible('#remeshed'), false);
    assert.equal(await page.evaluate(() => document.activeElement.id), 'remesh');
    assert.deepEqual((await download(page, 'ply')).bytes, bytes);
  }),
);

test(
  'sliders are driven by keys and mouse, and what they say is done',
  withPage(async (page, t) => {
    const sizeOf = async () => Number(await page.inputValue('#size'));
    const first = await sizeOf();
    await page.focus('#size-slider');
    for (let i = 0; i < 8; ++i) await page.keyboard.press('ArrowRight');
    const larger = await sizeOf();
    near(larger / first, 100 ** (8 / 100), 0.03);
    const { x, y, width, height } = await page.locator('#size-slider').boundingBox();
    await page.mouse.click(x + 0.7 * width, y + height / 2);
    assert.ok((await sizeOf()) > larger);
    await page.focus('#layers');
    for (let i = 0; i < 3; ++i) await page.keyboard.press('ArrowRight');
    assert.equal(await page.textContent('#layers + output'), '3');
    assert.equal(await remesh(page), 'done');
    const { bytes } = await download(page, 'ply');
    assert.match(await page.textContent('#commands'), /--remesh=\S+ --layers=3$/);
    assert.deepEqual(runCommands(t, await page.textContent('#commands')).bytes, bytes);
    const all = (await comparisonOf(page)).Triangles.after;
    assert.equal(await page.isDisabled('#growth'), true);
    await page.check('#finer');
    await page.focus('#growth');
    await page.keyboard.press('ArrowRight');
    assert.equal(await page.textContent('#growth + output'), '× 1.25');
    assert.equal(await remesh(page), 'done');
    assert.ok((await comparisonOf(page)).Triangles.after > all, 'finer along the cut');
    assert.equal(await page.isVisible('#command-note'), true, 'the command has no words for that');
    assert.doesNotMatch(await page.textContent('#commands'), /--remesh/);
  }),
);

test(
  'a larger feature angle makes edges of the model disappear',
  withPage(async (page) => {
    await page.focus('#feature-angle');
    await page.keyboard.press('Home');
    await remesh(page);
    const { Triangles: sharp } = await comparisonOf(page);
    await page.focus('#feature-angle');
    await page.keyboard.press('End');
    assert.equal(await page.textContent('#feature-angle + output'), '90°');
    await remesh(page);
    const { Triangles: smooth } = await comparisonOf(page);
    assert.notEqual(sharp.after, smooth.after);
  }),
);

test(
  'the histogram has its numbers in words, and marks the triangles of a bar',
  withPage(async (page) => {
    await remesh(page);
    const smallest = shapesOf(await meshOf(page)).map((shape) => shape.smallest);
    const counted = (from, to) => smallest.filter((angle) => angle >= from && angle < to).length;
    assert.match(await page.textContent('#histogram figcaption'), new RegExp(`below 30°: [\\d.]+ % before, ${(100 * counted(0, 30)) / smallest.length} % after`));
    await page.mouse.move(4, 400);
    const seen = await viewOf(page);
    const chooser = page.locator('#angle-bin');
    await chooser.focus();
    for (let i = 0; i < 25; ++i) await page.keyboard.press('ArrowRight');
    const words = await page.textContent('#histogram figcaption');
    assert.equal(await chooser.getAttribute('aria-valuetext'), words);
    near(Number(/^50° to 52°: [\d,]+ before, ([\d,]+) after$/.exec(words)[1].replaceAll(',', '')), counted(50, 52), 2);
    assert.ok(!(await viewOf(page)).equals(seen), 'triangles are marked');
    await page.focus('#remesh');
    assert.ok((await viewOf(page)).equals(seen), 'no more');
    const { width, height } = await chooser.boundingBox();
    await chooser.hover({ position: { x: 0.9 * width, y: height / 2 } });
    assert.match(await page.textContent('#histogram figcaption'), /^54° to 56°/);
    assert.ok(!(await viewOf(page)).equals(seen), 'also under the pointer');
    const bars = await page.locator('#histogram .bar').evaluateAll((all) => all.map((bar) => Number(bar.getAttribute('height'))));
    assert.equal(bars.length, 30);
    const highest = bars.indexOf(Math.max(...bars));
    assert.ok(counted(2 * highest, 2 * highest + 2) >= Math.max(...bars.map((_, bin) => counted(2 * bin, 2 * bin + 2))) - 2);
  }),
);

test(
  'what is remeshed goes when a part moves or the operation changes',
  withPage(async (page, t) => {
    await remesh(page);
    await setField(page, 'move-z', 0.7);
    assert.equal(await page.isVisible('#remeshed'), false);
    assert.equal(await page.isChecked('#show-edges'), false, 'as before');
    const { report } = runCommands(t, await page.textContent('#commands'));
    assert.equal((await reportOf(page)).Triangles, report.triangles);
    assert.equal((await download(page, 'ply')).name, 'union.ply');
    await remesh(page);
    await choose(page, 'first');
    assert.equal(await page.isVisible('#remeshed'), false);
    assert.equal(await remesh(page), 'done');
    assert.match(await page.textContent('#status'), /^A − B, remeshed/);
    assert.equal((await download(page, 'ply')).name, 'a-minus-b-remeshed.ply');
  }),
);

test(
  'sizes that are none, and sizes too small, are refused in words; the page goes on',
  withPage(async (page) => {
    const size = await page.inputValue('#size');
    await page.fill('#size', '0.0001');
    await page.getByText('too many for this page').waitFor();
    assert.equal(await remesh(page), 'trouble');
    assert.ok((await page.locator('#trouble').boundingBox()).y >= 0, 'it is in sight');
    assert.match(await page.innerText('#trouble'), /Remeshing.*ask for about 5,[\d,]+ triangles.*RESULT_TOO_LARGE.*fewer triangles.*a larger size/s);
    for (const wrong of ['0', '-1', '']) {
      await page.fill('#size', wrong);
      await page.press('#size', 'Enter');
      assert.equal(await idle(page), 'trouble');
      assert.match(await page.innerText('#trouble'), /size must be a positive number.*INVALID_ARGUMENT.*larger than 0/s);
    }
    assert.equal(await page.isVisible('#old'), false, 'the result is what it was');
    await page.fill('#size', size);
    await page.press('#size', 'Enter');
    assert.equal(await idle(page), 'done');
    assert.equal(await page.isVisible('#trouble'), false);
    assert.equal(await page.isVisible('#remeshed'), true);
  }),
);

const fractionOf = (page) => page.evaluate(() => (document.getElementById('work').hidden ? -1 : document.getElementById('progress').position));

/** Begins a remeshing of about a million triangles, and waits until its progress is seen. */
async function beginLong(page) {
  await page.fill('#size', '0.0075');
  await page.click('#remesh');
  await page.locator('#work-title').getByText('Remeshing').waitFor();
  await until('its progress', async () => (await fractionOf(page)) > 0);
}

test(
  'Escape cancels it: the result stays, and the next one is as it should be',
  withPage(async (page) => {
    const { bytes } = await download(page, 'ply');
    await beginLong(page);
    await page.keyboard.press('Escape');
    assert.equal(await stateOf(page), 'cancelled');
    assert.equal(await page.isVisible('#old'), false);
    assert.equal(await page.isVisible('#trouble'), false);
    assert.equal(await page.isVisible('#remeshed'), false);
    assert.deepEqual((await download(page, 'ply')).bytes, bytes);
    await page.fill('#size', '0.1');
    assert.equal(await remesh(page), 'done');
    await until('the end of the first worker', () => page.workers().length === 1);
    assert.ok((await comparisonOf(page))['Smallest angle'].after > 25);
  }),
);

test(
  'a part that moves stops it at once',
  withPage(async (page, t) => {
    await beginLong(page);
    const begin = performance.now();
    await setField(page, 'move-z', 0.9);
    t.diagnostic(`the new result after ${Math.round(performance.now() - begin)} ms`);
    assert.equal(await stateOf(page), 'done');
    assert.equal(await page.isVisible('#remeshed'), false);
    const { report } = runCommands(t, await page.textContent('#commands'));
    assert.equal((await reportOf(page)).Volume, report.volume);
  }),
);

test(
  'a result that is still being computed is waited for',
  withPage(async (page) => {
    const before = await reportOf(page);
    await page.evaluate(() => {
      const input = document.getElementById('move-z');
      input.value = '0.8';
      input.dispatchEvent(new Event('input', { bubbles: true }));
      document.getElementById('remesh').click();
    });
    assert.equal(await idle(page), 'done');
    await until('the remeshed result', () => page.isVisible('#remeshed'));
    const report = await reportOf(page);
    assert.notEqual(report.Volume, before.Volume);
    assert.equal((await comparisonOf(page)).Triangles.before, report.Triangles);
  }),
);

test(
  'your own files are remeshed, also without a cut',
  withPage(async (page) => {
    const ball = await make('icosphere', { radius: 30, levels: 3 });
    const apart = await transform(ball, [{ translate: [100, 0, 0] }]);
    const files = await Promise.all([ball, apart].map(async (mesh, i) => ({ name: `ball-${i}.stl`, bytes: await writeMesh(mesh, { format: 'stl' }) })));
    await dropFiles(page, files);
    const size = Number(await page.inputValue('#size'));
    assert.ok(size > 1 && size < 10, `${size} suits the parts`);
    assert.deepEqual([await page.isDisabled('#finer'), await page.isDisabled('#layers')], [true, true]);
    assert.equal(await remesh(page), 'done');
    const report = await inspect(await meshOf(page));
    assert.deepEqual([report.closed, report.components], [true, 2]);
    await beginDrop(page, [files[0]]);
    await until('the page without it', async () => !(await page.isVisible('#remeshed')));
    assert.equal(await idle(page), 'done');
  }),
);

test(
  'what was remeshed is announced',
  withPage(async (page) => {
    await remesh(page);
    await page.waitForTimeout(900);
    assert.match(await page.textContent('#announcement'), /^Union, remeshed: [\d,]+ triangles, angles [\d.]+° to [\d.]+°/);
  }),
);
