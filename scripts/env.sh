# SPDX-FileCopyrightText: the Mortise authors
# SPDX-License-Identifier: MIT
# Sourced by every script: the repository as working folder, our own node first in PATH, where the shared meshes are.

MORTISE_REPOSITORY=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$MORTISE_REPOSITORY" || exit 1
export PATH="$MORTISE_REPOSITORY/.tools/node_modules/.bin:$PATH"
MORTISE_DATA=${MORTISE_DATA:-../shared/data}
[ -d "$MORTISE_DATA" ] && MORTISE_DATA=$(cd "$MORTISE_DATA" && pwd)
export MORTISE_DATA
# Set for em++ by some installations; programs under test must not see it (cmake/emscripten.cmake sets it for em++).
unset NODE_PATH
# A clone elsewhere finds what another one compiled.
export CCACHE_BASEDIR=$MORTISE_REPOSITORY CCACHE_NOHASHDIR=1
