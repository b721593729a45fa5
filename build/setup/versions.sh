#!/bin/sh
# Says in one sentence which Python, Node and npm are needed, where they are missing or of another version.
# Python: the locked packages come as wheels for these; Node: what the build runs of the viewer, and its tests, need.
set -eu
trouble=0
say() { echo "Raywalk needs $1; $2" >&2; trouble=1; }

python="Python 3.11 to 3.14 as python3"
if ! command -v python3 >/dev/null 2>&1; then
    say "$python" "there is none here. On Debian: sudo apt-get install python3 python3-venv"
else
    found=$(python3 -c 'import sys; print("%d.%d" % sys.version_info[:2])')
    case $found in
        3.11 | 3.12 | 3.13 | 3.14) ;;
        *) say "$python" "python3 here is $found" ;;
    esac
fi

node="Node 20 or newer with npm"
if ! command -v node >/dev/null 2>&1 || ! command -v npm >/dev/null 2>&1; then
    say "$node" "$(command -v node >/dev/null 2>&1 && echo npm || echo node) is missing here. On Debian: sudo apt-get install nodejs npm"
else
    found=$(node -p 'process.versions.node')
    [ "${found%%.*}" -ge 20 ] || say "$node" "node here is $found"
fi
exit $trouble
