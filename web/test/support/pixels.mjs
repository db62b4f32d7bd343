// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What a screenshot shows.

/** Counts colours in an area of a PNG; the page decodes it. */
export function coloursOf(page, png, area) {
  return page.evaluate(
    async ([base64, { x, y, width, height }]) => {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
      const pen = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
      pen.drawImage(bitmap, 0, 0);
      const { data } = pen.getImageData(x, y, width, height);
      const kinds = { all: new Set(), blue: new Set(), orange: new Set() };
      for (let i = 0; i < data.length; i += 4) {
        const [r, g, b] = data.subarray(i, i + 3);
        const colour = (r << 16) | (g << 8) | b;
        kinds.all.add(colour);
        if (b > r + 40) kinds.blue.add(colour);
        if (r > b + 60) kinds.orange.add(colour);
      }
      return Object.fromEntries(Object.entries(kinds).map(([kind, colours]) => [kind, colours.size]));
    },
    [Buffer.from(png).toString('base64'), area],
  );
}

/** The rectangle of an element in pixels of the screenshot. */
export async function areaOf(page, selector) {
  const { x, y, width, height } = await page.locator(selector).boundingBox();
  return { x: Math.round(x), y: Math.round(y), width: Math.round(width), height: Math.round(height) };
}
