#!/bin/sh
# Makes .venv. Debian's python3 comes without the part of venv that brings pip along.
set -eu
[ -x .venv/bin/python ] && .venv/bin/python -m pip --version >/dev/null 2>&1 && exit 0

rm -rf .venv
if ! python3 -m venv .venv >/dev/null 2>&1; then
    rm -rf .venv
    if [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
        echo "python3 has no venv: installing Debian's python3-venv"
        apt-get update -qq && apt-get install -y -qq python3-venv >/dev/null
        python3 -m venv .venv
    else
        echo "python3 has no venv. Install it first:  sudo apt-get install python3-venv" >&2
        exit 1
    fi
fi
