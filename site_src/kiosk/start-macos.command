#!/bin/sh
# Raywalk as a kiosk on macOS: full screen, the display stays awake. The browser comes back whenever it ends, whatever its
# code: to end it all, press Command+Q and, within three seconds, close the Terminal window that is left.
# Settings as in start-linux.sh: ./start-macos.command "idle=60&warn=20"; RAYWALK_LANGUAGE=de begins in German.
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd) || exit 1
course=course
[ -z "$RAYWALK_LANGUAGE" ] || [ "$RAYWALK_LANGUAGE" = en ] || course=course/$RAYWALK_LANGUAGE
page=$here/$course/@START@
if [ ! -f "$page" ]; then
  echo "start-macos.command: $page is not there: was the whole archive unpacked?" >&2
  exit 1
fi
address=file://$(printf %s "$page" | sed 's/%/%25/g; s/ /%20/g; s/#/%23/g; s/?/%3F/g')
address="$address#kiosk=1${1:+&$1}"

browser=$RAYWALK_BROWSER
for each in "Google Chrome.app/Contents/MacOS/Google Chrome" Chromium.app/Contents/MacOS/Chromium \
  "Microsoft Edge.app/Contents/MacOS/Microsoft Edge" Firefox.app/Contents/MacOS/firefox; do
  for place in /Applications "$HOME/Applications"; do
    [ -n "$browser" ] || [ ! -x "$place/$each" ] || browser=$place/$each
  done
done
if [ -z "$browser" ]; then
  echo "start-macos.command: no browser found: put Chrome, Chromium, Edge or Firefox into Applications" >&2
  exit 1
fi

profile=$(mktemp -d)
case $(basename -- "$browser") in
  *irefox*) set -- --kiosk --no-remote --profile "$profile" ;;
  *) set -- --kiosk --user-data-dir="$profile" \
    --no-first-run --no-default-browser-check --noerrdialogs --hide-crash-restore-bubble \
    --disable-pinch --overscroll-history-navigation=0 --disable-features=Translate \
    --disable-sync --disable-background-networking --disable-component-update --password-store=basic ;;
esac

trap 'rm -rf "$profile"' EXIT
trap 'exit 130' INT TERM HUP
while :; do
  caffeinate -d "$browser" "$@" "$address"
  sleep 3
done
