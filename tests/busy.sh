#!/bin/sh
# Runs a command beside eight busy processes, as on a machine that does other things: sh tests/busy.sh make test
busy=
for _ in 1 2 3 4 5 6 7 8; do
  (while :; do :; done) &
  busy="$busy $!"
done
trap 'kill $busy' EXIT
trap 'exit 130' INT TERM
"$@"
