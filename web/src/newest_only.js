// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Runs one job at a time and, of those that came meanwhile, only the newest.
// @ts-check

/**
 * @param {() => Promise<void>} run looks at the state of the moment; does not throw
 * @param {(step: 1 | -1) => void} [countBusy] called before the first and after the last of a row of runs
 */
export function newestOnly(run, countBusy = () => {}) {
  let running = false;
  let wanted = false;
  return {
    /** Asks for a run. */
    async ask() {
      wanted = true;
      if (running) return;
      running = true;
      countBusy(1);
      while (wanted) {
        wanted = false;
        await run();
      }
      running = false;
      countBusy(-1);
    },
    /** Nothing more is wanted after the job that runs. */
    drop() {
      wanted = false;
    },
  };
}
