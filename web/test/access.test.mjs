// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Keyboard, names, contrast, narrow screens. With a remeshed result, which brings the last controls.

import assert from 'node:assert/strict';
import test from 'node:test';

import { idle, reportOf, useBrowser, withPage } from './support/browser.mjs';

useBrowser();

/** Remeshes the result: then all controls are there. The focus is not moved: Tab begins at the top. */
async function remesh(page) {
  await page.evaluate(() => document.getElementById('remesh').click());
  assert.equal(await idle(page), 'done');
}

test(
  'the keys 1 to 4 choose the operation; W, E, R the handle; F frames; fields keep their keys',
  withPage(async (page) => {
    const volumes = new Set();
    for (const [key, choice] of [['2', 'intersect'], ['3', 'first'], ['4', 'second'], ['1', 'union']]) {
      await page.keyboard.press(key);
      assert.equal(await idle(page), 'done');
      assert.equal(await page.getAttribute('[data-choice][aria-pressed=true]', 'data-choice'), choice);
      volumes.add((await reportOf(page)).Volume);
    }
    assert.equal(volumes.size, 4);
    for (const [key, mode] of [['e', 'rotate'], ['r', 'scale'], ['w', 'translate']]) {
      await page.keyboard.press(key);
      assert.equal(await page.getAttribute('[data-mode][aria-pressed=true]', 'data-mode'), mode);
    }
    await page.focus('#move-x');
    await page.keyboard.press('2');
    assert.equal(await page.getAttribute('[data-choice][aria-pressed=true]', 'data-choice'), 'union');
  }),
);

/** What the keyboard gets to: the element with the focus after each Tab, and whether one can see that it has it. */
async function tabThrough(page) {
  await page.evaluate(() => document.activeElement?.blur());
  const seen = [];
  for (let i = 0; i < 80; ++i) {
    await page.keyboard.press('Tab');
    const focused = await page.evaluate(() => {
      const element = document.activeElement;
      const outlined = [element, element.parentElement].some((one) => getComputedStyle(one).outlineStyle !== 'none');
      const name = element.id || element.dataset.choice || element.dataset.mode || element.name || element.textContent;
      return element === document.body ? undefined : { name, outlined };
    });
    if (focused === undefined) break;
    seen.push(focused);
  }
  return seen;
}

test(
  'Tab reaches every control, and the focus is seen',
  withPage(async (page) => {
    await remesh(page);
    const seen = await tabThrough(page);
    const names = seen.map(({ name }) => name);
    const controls = await page.evaluate(() => {
      const all = [...document.querySelectorAll('button, input, select, a, canvas, pre')];
      const usable = all.filter((one) => !one.disabled && one.checkVisibility() && !(one.type === 'radio' && !one.checked));
      return usable.map((one) => one.id || one.dataset.choice || one.dataset.mode || one.name || one.textContent);
    });
    assert.ok(controls.length > 40 && controls.includes('angle-bin'), `${controls}`);
    assert.deepEqual(controls.filter((name) => !names.includes(name)), []);
    assert.deepEqual(seen.filter(({ outlined }) => !outlined), []);
  }),
);

test(
  'every control has a name',
  withPage(async (page) => {
    await remesh(page);
    const session = await page.context().newCDPSession(page);
    const { nodes } = await session.send('Accessibility.getFullAXTree');
    const focusable = nodes.filter(({ ignored, properties = [] }) => !ignored && properties.some(({ name, value }) => name === 'focusable' && value.value));
    const named = focusable.filter(({ role }) => role.value !== 'RootWebArea');
    assert.ok(named.length > 40);
    assert.deepEqual(named.filter(({ name }) => !name?.value.trim()).map(({ role }) => role.value), []);
  }),
);

/** Words whose contrast to what is behind them is below 4.5 to 1. Runs in the page. */
function faintWords() {
  const pen = new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true });
  const paint = (colours) => {
    pen.clearRect(0, 0, 1, 1);
    for (const colour of colours) {
      pen.fillStyle = colour;
      pen.fillRect(0, 0, 1, 1);
    }
    return [...pen.getImageData(0, 0, 1, 1).data].slice(0, 3).map((x) => (x <= 10 ? x / 3294.6 : ((x / 255 + 0.055) / 1.055) ** 2.4));
  };
  const luminance = ([r, g, b]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;
  const behind = (element) => (element === null ? [] : [...behind(element.parentElement), getComputedStyle(element).backgroundColor]);
  const ratio = (element) => {
    const ground = [getComputedStyle(document.body).backgroundColor, ...behind(element)];
    const [low, high] = [luminance(paint(ground)), luminance(paint([...ground, getComputedStyle(element).color]))].sort((a, b) => a - b);
    return (high + 0.05) / (low + 0.05);
  };
  const hasWords = (element) => [...element.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.data.trim() !== '');
  const shown = [...document.body.querySelectorAll('*')].filter((one) => hasWords(one) && one.checkVisibility() && !one.closest(':disabled'));
  return shown.map((one) => [one.textContent.trim(), ratio(one)]).filter(([, value]) => value < 4.5);
}

for (const colorScheme of ['light', 'dark']) {
  test(
    `words stand out from their ground (${colorScheme})`,
    withPage(
      async (page) => {
        await remesh(page);
        assert.deepEqual(await page.evaluate(faintWords), []);
      },
      { colorScheme },
    ),
  );
}

test(
  'a result is announced',
  withPage(async (page) => {
    await page.keyboard.press('2');
    await idle(page);
    await page.waitForTimeout(900);
    assert.match(await page.textContent('[role=status]'), /^Intersection: [\d,]+ triangles, volume/);
  }),
);

test(
  'on a narrow screen the panel is a sheet that folds',
  withPage(
    async (page) => {
      const heightOf = async (selector) => (await page.locator(selector).boundingBox()).height;
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
      const { x, y, width } = await page.locator('#panel').boundingBox();
      assert.deepEqual([x, width], [0, 390]);
      assert.ok(y > 350, 'below the view');
      const before = await heightOf('#canvas');
      await page.tap('#fold');
      assert.equal(await page.getAttribute('#fold', 'aria-expanded'), 'false');
      assert.ok((await heightOf('#canvas')) > before + 100);
      await page.tap('[data-choice=first]');
      assert.equal(await idle(page), 'done');
      await page.tap('#fold');
      await page.tap('#remesh');
      assert.equal(await idle(page), 'done');
      await page.locator('#download').scrollIntoViewIfNeeded();
      assert.equal(await page.isVisible('#download'), true);
      const fold = await page.locator('#fold').boundingBox();
      assert.ok(fold.y >= y && fold.y < y + 12, 'the handle of the sheet stays at its top');
      const clipped = await page.evaluate(() => {
        const words = [...document.querySelectorAll('button, h1, h2')].filter((one) => one.clientWidth > 1);
        return words.filter((one) => one.scrollWidth > one.clientWidth + 1).map((one) => one.textContent);
      });
      assert.deepEqual(clipped, []);
    },
    { viewport: { width: 390, height: 800 }, hasTouch: true, isMobile: true },
  ),
);
