#!/usr/bin/env bash
# with-display.sh COMMAND...: runs a command that draws. The display is that of
# $PIXELEXACT_TEST_DISPLAY, which a run of all tests shares, else a virtual one of its own; never the
# developer's.
set -euo pipefail
if [[ -n "${PIXELEXACT_TEST_DISPLAY:-}" ]]; then
  DISPLAY=$PIXELEXACT_TEST_DISPLAY exec "$@"
fi
# -noreset: without it the X server dies with the first of two windows of one process.
exec xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" "$@"
