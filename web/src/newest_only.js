// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Runs one job at a time and, of those that came meanwhile, only the newest.
// @ts-check

/**
 * @param {() => Promise<void>} run looks at the state of the moment; does not throw
 * @returns {() => void} asks for a run
 */
export function newestOnly(run) {
  let running = false;
  let wanted = false;
  return async () => {
    wanted = true;
    if (running) return;
    running = true;
    while (wanted) {
      wanted = false;
      await run();
    }
    running = false;
  };
}
