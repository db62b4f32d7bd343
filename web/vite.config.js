// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// How the page is built: relative addresses, so that it can live in any folder of a site.
// @ts-check

import { defineConfig } from 'vite';

import { contentPolicy, licences, policyInPage } from './tools/page_plugins.js';

export default defineConfig({
  base: './',
  build: { outDir: 'dist', modulePreload: { polyfill: false }, chunkSizeWarningLimit: 1000 },
  worker: { format: 'es' },
  preview: { port: 4173, headers: { 'Content-Security-Policy': contentPolicy } },
  plugins: [policyInPage(), licences()],
});
