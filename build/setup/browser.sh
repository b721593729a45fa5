#!/bin/sh
# Sees to a Chromium for the viewer's tests: the one that is there, else Debian's package. Its edition without windows is
# welcome, as it works less; so is Firefox, asked for by `sh build/setup/browser.sh firefox`. Where these can be had as
# easily they are fetched once; where not, all tests run in Chromium, and Firefox's say why they are skipped.
set -eu

is_debian_root() { [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; }
install() { apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq "$@" >/dev/null; }
# NAME PACKAGE MEGABYTES: tried once.
welcome() {
    is_debian_root && [ ! -e "node_modules/.no-$2" ] || return 0
    echo "no $1 here: trying Debian's (about $3 MB)"
    install --no-install-recommends "$2" 2>/dev/null || touch "node_modules/.no-$2"
}
has_chromium() {
    [ -n "${CHROMIUM:-}" ] && [ -x "$CHROMIUM" ] && return
    for name in chromium chromium-browser google-chrome google-chrome-stable; do
        command -v "$name" >/dev/null 2>&1 && return
    done
    return 1
}

if ! has_chromium; then
    if is_debian_root; then
        echo "no Chromium here: installing Debian's (about 100 MB)"
        install chromium # with what it recommends: its fonts
    else
        echo "The viewer's tests need Chromium. Install it (sudo apt-get install chromium)," >&2
        echo "or say where one is: CHROMIUM=/path/to/chromium make test" >&2
        exit 1
    fi
fi
if [ -z "${CHROMIUM:-}" ] && ! command -v chromium-headless-shell >/dev/null; then
    welcome "Chromium without windows" chromium-headless-shell 60
fi
if [ "${1:-}" = firefox ] && [ -z "${FIREFOX:-}" ] && ! command -v firefox-esr >/dev/null && ! command -v firefox >/dev/null; then
    welcome Firefox firefox-esr 80
fi
