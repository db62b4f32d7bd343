// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Opens the built page in Chromium. Whatever the page complains about fails the test that opened it.

import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { after, before } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';

import { chromium } from 'playwright-core';
import { preview } from 'vite';

const root = fileURLToPath(new URL('../..', import.meta.url));
const flags = '--no-sandbox --disable-quic --no-first-run --disable-background-networking --disable-component-update --disable-sync';
const software = '--use-angle=swiftshader --enable-unsafe-swiftshader';
const mostWait = 60_000;

let server;
let browser;

/** Serves the page and starts a browser for the tests of a file. */
export function useBrowser() {
  before(async () => {
    assert.ok(existsSync(`${root}/dist/index.html`), 'the page is not built: scripts/build-page');
    server = await preview({ root, logLevel: 'silent' });
    const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
    browser = await chromium.launch({ executablePath, args: [...flags.split(' '), ...software.split(' ')] });
  });
  after(async () => {
    await browser?.close();
    await server?.close();
  });
}

/** Notes every use of WebAssembly on the main thread, and breaches of the content policy. Runs in the page before its scripts. */
function watchPage() {
  globalThis.mainThreadWasm = [];
  globalThis.policyBreaches = [];
  for (const name of ['instantiate', 'instantiateStreaming', 'compile', 'compileStreaming', 'Module', 'Instance']) {
    WebAssembly[name] = new Proxy(WebAssembly[name], {
      apply: (target, self, args) => (globalThis.mainThreadWasm.push(name), Reflect.apply(target, self, args)),
      construct: (target, args) => (globalThis.mainThreadWasm.push(name), Reflect.construct(target, args)),
    });
  }
  document.addEventListener('securitypolicyviolation', (event) => globalThis.policyBreaches.push(`${event.violatedDirective} ${event.blockedURI}`));
}

/** What has to hold for every page at the end of its test. */
async function checkPage(page, problems) {
  assert.deepEqual(problems, [], 'the page wrote no errors');
  assert.deepEqual(await page.evaluate(() => globalThis.mainThreadWasm), [], 'no WebAssembly on the main thread');
  assert.deepEqual(await page.evaluate(() => globalThis.policyBreaches), [], 'the content policy holds');
}

/** A new page, not opened yet. */
export async function newPage(t, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 860 }, colorScheme: 'light', ...options });
  await context.addInitScript(watchPage);
  const page = await context.newPage();
  const problems = [];
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && problems.push(message.text()));
  page.on('pageerror', (error) => problems.push(String(error)));
  page.problems = problems;
  t.after(() => context.close());
  return page;
}

/** The page with its two sample parts united. */
export async function openPage(t, options = {}) {
  const page = await newPage(t, options);
  await page.goto(server.resolvedUrls.local[0]);
  await idle(page);
  return page;
}

/** Runs a test body on an opened page, then checks the page. */
export function withPage(body, options = {}) {
  return async (t) => {
    const page = await openPage(t, options);
    await body(page, t);
    await checkPage(page, page.problems);
  };
}

/** Waits until a value of the page is as wanted. The content policy forbids what waitForFunction does. */
export async function until(what, look) {
  const end = Date.now() + mostWait;
  while (!(await look())) {
    assert.ok(Date.now() < end, `waited in vain for: ${what}`);
    await sleep(20);
  }
}

export const stateOf = (page) => page.evaluate(() => document.getElementById('status')?.dataset.state);

/** Waits until nothing is being computed or read; answers 'done' or 'trouble'. */
export async function idle(page) {
  await until('the end of the computation', async () => !['busy', undefined].includes(await stateOf(page)));
  return stateOf(page);
}

/** The numbers of the report panel, in full. */
export function reportOf(page) {
  return page.evaluate(() => {
    const terms = [...document.querySelectorAll('#report dt')];
    return Object.fromEntries(terms.map((term) => [term.textContent, Number(term.nextElementSibling.querySelector('data')?.value)]));
  });
}

/** Presses one of the four operation buttons. */
export async function choose(page, choice) {
  await page.click(`button[data-choice=${choice}]`);
  assert.equal(await idle(page), 'done');
}

/** Sets a numeric field. */
export async function setField(page, id, value) {
  await page.fill(`#${id}`, String(value));
  await idle(page);
}

/** Drops files on the page as a desktop does: a DataTransfer with their bytes. Does not wait. */
export async function beginDrop(page, files) {
  const plain = files.map(({ name, bytes }) => ({ name, base64: Buffer.from(bytes).toString('base64') }));
  await page.evaluate((dropped) => {
    const dataTransfer = new DataTransfer();
    for (const { name, base64 } of dropped) {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      dataTransfer.items.add(new File([bytes], name));
    }
    for (const type of ['dragenter', 'dragover', 'drop']) {
      document.body.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
    }
  }, plain);
}

/** Drops files and waits for what comes of it. */
export async function dropFiles(page, files) {
  await beginDrop(page, files);
  return idle(page);
}

/** The bytes of a download in a format. */
export async function download(page, format) {
  await page.selectOption('#format', format);
  const [item] = await Promise.all([page.waitForEvent('download'), page.click('#download')]);
  const chunks = [];
  for await (const chunk of await item.createReadStream()) chunks.push(chunk);
  return { name: item.suggestedFilename(), bytes: new Uint8Array(Buffer.concat(chunks)) };
}
