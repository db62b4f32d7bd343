// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The page as it opens.

import assert from 'node:assert/strict';
import { createReadStream, existsSync, mkdirSync, readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';

import { idle, newPage, openPage, reportOf, stateOf, until, useBrowser, withPage } from './support/browser.mjs';
import { areaOf, coloursOf } from './support/pixels.mjs';

const dist = fileURLToPath(new URL('../dist/', import.meta.url));
const screenshots = fileURLToPath(new URL('../../build/', import.meta.url));

useBrowser();

test(
  'it opens with two sample parts united, computed in a worker',
  withPage(async (page, t) => {
    t.diagnostic(`united ${Math.round(await page.evaluate(() => performance.now()))} ms after the address was entered`);
    assert.equal(await stateOf(page), 'done');
    assert.equal(await page.locator('#parts input').count(), 2);
    assert.equal(await page.getAttribute('button[data-choice=union]', 'aria-pressed'), 'true');
    const report = await reportOf(page);
    assert.ok(report.Triangles > 1000 && report.Volume > 4.608, 'more than the block alone');
    assert.equal(report.Genus, 1);
    assert.match(await page.textContent('#report'), /✓ closed.*✓ manifold.*✓ certified/);
    assert.equal(page.workers().length, 1);
    t.diagnostic(await page.textContent('#status'));
  }),
);

test(
  'it shows a shaded result in the colours of both parts',
  withPage(async (page, t) => {
    await until('a drawn frame', async () => (await coloursOf(page, await page.screenshot(), await areaOf(page, '#canvas'))).orange > 100);
    mkdirSync(screenshots, { recursive: true });
    const png = await page.screenshot({ path: `${screenshots}page.png` });
    const colours = await coloursOf(page, png, await areaOf(page, '#canvas'));
    t.diagnostic(`colours of the view: ${JSON.stringify(colours)}`);
    assert.ok(colours.blue > 100 && colours.orange > 300, JSON.stringify(colours));
  }),
);

/** Does code made from text run? Not asked directly: what the debugger evaluates is free of the policy. */
const evaluates = () =>
  new Promise((resolve) => {
    setTimeout(() => {
      try {
        resolve(Function('return true')());
      } catch (error) {
        resolve(error.name);
      }
    });
  });

test('its content policy forbids evaluated code, in the page and in the worker', async (t) => {
  const page = await openPage(t);
  assert.equal(await page.evaluate(evaluates), 'EvalError');
  assert.equal(await page.workers()[0].evaluate(evaluates), 'EvalError');
  await until('the note of the breach', async () => (await page.evaluate(() => globalThis.policyBreaches.length)) > 0);
});

test('the built page names what is in it and asks nothing of other sites', () => {
  const notices = readFileSync(`${dist}THIRD_PARTY_NOTICES.txt`, 'utf8');
  assert.match(notices, /three\.js authors/);
  assert.match(notices, /fast_float/);
  assert.match(notices, /musl/);
  assert.match(readFileSync(`${dist}LICENSE.txt`, 'utf8'), /MIT License/);
  const html = readFileSync(`${dist}index.html`, 'utf8');
  assert.deepEqual([...html.matchAll(/(?:src|href)="(?!\.\/)([^"]*)"/g)].map(([, address]) => address), [], 'all addresses are relative');
});

/** A server that knows files and their types, nothing else; the page lives in /some/folder/. */
async function plainServer(t) {
  const types = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.wasm': 'application/octet-stream', '.svg': 'image/svg+xml' };
  const server = createServer(({ url }, response) => {
    const path = url.replace(/^\/some\/folder\//, dist).replace(/\/$/, '/index.html');
    if (!path.startsWith(dist) || !existsSync(path)) return response.writeHead(404).end();
    response.writeHead(200, { 'content-type': types[extname(path)] ?? 'text/plain' });
    return createReadStream(path).pipe(response);
  });
  await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
  t.after(() => server.close());
  return `http://127.0.0.1:${server.address().port}/some/folder/`;
}

test('it works in a folder of any site, also where .wasm has no type of its own', async (t) => {
  const page = await newPage(t);
  await page.goto(await plainServer(t));
  assert.equal(await idle(page), 'done');
  assert.ok((await reportOf(page)).Triangles > 1000);
  assert.deepEqual(page.problems, []);
});

test('without its core it says so', async (t) => {
  const page = await newPage(t);
  const address = await plainServer(t);
  await page.context().route(/core.*\.wasm$/, (route) => route.fulfill({ status: 404, body: '' }));
  await page.goto(address);
  assert.equal(await idle(page), 'trouble');
  assert.match(await page.textContent('#trouble'), /the sample parts.*HTTP 404/s);
});

test('without WebGL everything but the view works', async (t) => {
  const page = await newPage(t);
  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  await page.goto(await plainServer(t));
  assert.equal(await idle(page), 'done');
  assert.equal(await page.isVisible('#no-scene'), true);
  assert.ok((await reportOf(page)).Triangles > 1000);
});
