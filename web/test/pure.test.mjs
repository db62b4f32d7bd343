// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The parts of the page that need no browser.

import assert from 'node:assert/strict';
import test from 'node:test';

import { binOf, shareBelow } from '../src/angle_bins.js';
import { inOrder } from '../src/choices.js';
import { commandsOf } from '../src/commands.js';
import { newestOnly } from '../src/newest_only.js';
import { digitsFor, roundTo, stepsOf, unmoved } from '../src/placement.js';
import { firstSize, firstWish, lastPosition, positionOf, sizeAt } from '../src/remesh_wish.js';

test('a part that is only moved gets one step', () => {
  assert.deepEqual(stepsOf(unmoved(), [5, 5, 5]), []);
  assert.deepEqual(stepsOf({ ...unmoved(), move: [1, 0, -2] }, [5, 5, 5]), [{ translate: [1, 0, -2] }]);
});

test('scaling and turning are about the origin of the part', () => {
  const placement = { move: [0.1, 0, 0], turn: [0, 30, 0], scale: [2, 2, 2] };
  assert.deepEqual(stepsOf(placement, [0.2, 0, 7]), [{ translate: [-0.2, 0, -7] }, { scale: 2 }, { rotateY: 30 }, { translate: [0.3, 0, 7] }]);
  assert.deepEqual(stepsOf({ ...placement, move: [0, 0, 0] }, [0, 0, 0]), [{ scale: 2 }, { rotateY: 30 }]);
});

test('dragged lengths are rounded to what the size of the part makes worth reading', () => {
  assert.equal(roundTo(0.123456789, digitsFor(2.4)), 0.1235);
  assert.equal(roundTo(1234.56789, digitsFor(30_000)), 1235);
  assert.equal(Object.is(roundTo(-0.00001, 2), 0), true);
});

const operand = (name, placement = unmoved()) => ({ source: { kind: 'file', name }, placement, display: { origin: [0, 0, 0] } });

test('names of files are quoted for the shell', () => {
  const operands = [operand('a.stl'), operand('-b.stl'), operand("it's $HOME.stl")];
  assert.deepEqual(commandsOf({ operands, choice: 'second' }), ["npx mortise subtract ./-b.stl a.stl 'it'\\''s $HOME.stl' -o result.ply"]);
});

test('command lines write over no file they read', () => {
  const moved = { ...unmoved(), move: [1, 0, 0] };
  const operands = [operand('a-placed.ply', moved), operand('result.ply')];
  assert.deepEqual(commandsOf({ operands, choice: 'union' }), [
    'npx mortise transform a-placed.ply --translate=1,0,0 -o a-placed-2.ply',
    'npx mortise union a-placed-2.ply result.ply -o result-2.ply',
  ]);
});

test('B − A takes the second operand first', () => {
  assert.deepEqual(inOrder('second', ['a', 'b', 'c']), ['b', 'a', 'c']);
  assert.deepEqual(inOrder('first', ['a', 'b', 'c']), ['a', 'b', 'c']);
});

test('command lines say how the result was remeshed, where the command has words for it', () => {
  const last = (wish) => commandsOf({ operands: [operand('a.stl'), operand('b.stl')], choice: 'union' }, { ...firstWish(), size: 0.5, ...wish }).at(-1);
  assert.equal(last({}), 'npx mortise union a.stl b.stl -o result.ply --remesh=0.5');
  assert.equal(last({ layers: 3 }), 'npx mortise union a.stl b.stl -o result.ply --remesh=0.5 --layers=3');
  for (const wish of [{ finer: true }, { featureAngle: 30 }]) assert.equal(last(wish), 'npx mortise union a.stl b.stl -o result.ply');
});

test('the slider of sizes is logarithmic; sizes beyond it are at its ends', () => {
  assert.deepEqual([sizeAt(0, 40), sizeAt(lastPosition / 2, 40), sizeAt(lastPosition, 40)], [0.1, 1, 10]);
  for (let position = 0; position <= lastPosition; ++position) assert.equal(positionOf(sizeAt(position, 7), 7), position);
  assert.deepEqual([positionOf(1e-9, 1), positionOf(0, 1), positionOf(NaN, 1), positionOf(50, 1)], [0, 0, 0, lastPosition]);
  assert.equal(firstSize(4.1234), 0.082);
});

test('angles fall into bins of two degrees, 60 into the last one', () => {
  assert.deepEqual([0, 1.99, 2, 59.9, 60].map(binOf), [0, 0, 1, 29, 29]);
  const counts = Array.from({ length: 30 }, (_, bin) => (bin < 3 ? 1 : 0));
  assert.equal(shareBelow(counts, 4), 2 / 3);
  assert.equal(shareBelow(counts.fill(0), 30), 0);
});

test('while a job runs, of the new ones only the last is kept', async () => {
  let state = 0;
  const seen = [];
  const finish = [];
  const steps = [];
  const { ask, drop } = newestOnly(
    () => {
      seen.push(state);
      return new Promise((resolve) => finish.push(resolve));
    },
    (step) => steps.push(step),
  );
  for (state = 1; state <= 5; ++state) ask();
  state = 5;
  assert.deepEqual(seen, [1]);
  finish[0]();
  await new Promise(setImmediate);
  assert.deepEqual(seen, [1, 5]);
  assert.deepEqual(steps, [1], 'busy all the time');
  ask();
  drop();
  finish[1]();
  await new Promise(setImmediate);
  assert.deepEqual(seen, [1, 5], 'what was dropped is not run');
  assert.deepEqual(steps, [1, -1]);
});
