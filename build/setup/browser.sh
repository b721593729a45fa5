#!/bin/sh
# Sees to a Chromium for the viewer's tests: the one that is there, else Debian's package. Firefox is welcome but not
# needed: where it can be had as easily it is fetched once; where not, its tests say why they are skipped.
set -eu

is_debian_root() { [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; }
if ! command -v firefox-esr >/dev/null && ! command -v firefox >/dev/null && [ -z "${FIREFOX:-}" ] &&
    is_debian_root && [ ! -e node_modules/.no-firefox ]; then
    echo "no Firefox here: trying Debian's (about 80 MB)"
    { apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends firefox-esr; } \
        >/dev/null 2>&1 || touch node_modules/.no-firefox
fi

[ -n "${CHROMIUM:-}" ] && [ -x "$CHROMIUM" ] && exit 0
for name in chromium chromium-browser google-chrome google-chrome-stable; do
    command -v "$name" >/dev/null 2>&1 && exit 0
done
if is_debian_root; then
    echo "no Chromium here: installing Debian's (about 100 MB)"
    apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq chromium >/dev/null
else
    echo "The viewer's tests need Chromium. Install it (sudo apt-get install chromium)," >&2
    echo "or say where one is: CHROMIUM=/path/to/chromium make test" >&2
    exit 1
fi
