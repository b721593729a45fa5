#!/bin/sh
# Sees to a Chromium for the viewer's tests: the one that is there, else Debian's package.
set -eu
[ -n "${CHROMIUM:-}" ] && [ -x "$CHROMIUM" ] && exit 0
for name in chromium chromium-browser google-chrome google-chrome-stable; do
    command -v "$name" >/dev/null 2>&1 && exit 0
done
if [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
    echo "no Chromium here: installing Debian's (about 100 MB)"
    apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq chromium >/dev/null
else
    echo "The viewer's tests need Chromium. Install it (sudo apt-get install chromium)," >&2
    echo "or say where one is: CHROMIUM=/path/to/chromium make test" >&2
    exit 1
fi
