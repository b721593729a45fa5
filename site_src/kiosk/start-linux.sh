#!/bin/sh
# Raywalk as a kiosk on Linux: full screen, nothing else to get at. The browser comes back
# whenever it ends, whatever its code: to end it all, press Alt+F4 and, within three seconds, Ctrl+C where this was started.
#   ./start-linux.sh                       as it is
#   ./start-linux.sh "idle=60&warn=20"     starts again after 60 seconds without a touch, warns 20 seconds before
# RAYWALK_LANGUAGE=de: begins in German. RAYWALK_BROWSER: the browser to take. RAYWALK_FLAGS: more flags for it.
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd) || exit 1
course=course
[ -z "$RAYWALK_LANGUAGE" ] || [ "$RAYWALK_LANGUAGE" = en ] || course=course/$RAYWALK_LANGUAGE
page=$here/$course/@START@
if [ ! -f "$page" ]; then
  echo "start-linux.sh: $page is not there: was the whole archive unpacked?" >&2
  exit 1
fi
# What has a meaning of its own in an address.
address=file://$(printf %s "$page" | sed 's/%/%25/g; s/ /%20/g; s/#/%23/g; s/?/%3F/g')
address="$address#kiosk=1${1:+&$1}"

browser=$RAYWALK_BROWSER
for each in chromium chromium-browser google-chrome google-chrome-stable microsoft-edge brave-browser firefox firefox-esr; do
  [ -n "$browser" ] || browser=$(command -v "$each")
done
if [ -z "$browser" ]; then
  echo "start-linux.sh: no browser found: install Chromium, Chrome, Edge or Firefox" >&2
  exit 1
fi

# A profile of its own, empty at each start: no session to restore, no bubble to close.
profile=${RAYWALK_PROFILE:-$(mktemp -d)}
case $(basename -- "$browser") in
  *firefox*) set -- --kiosk --no-remote --profile "$profile" ;;
  *) set -- --kiosk --user-data-dir="$profile" \
    --no-first-run --no-default-browser-check --noerrdialogs --hide-crash-restore-bubble \
    --disable-pinch --overscroll-history-navigation=0 --disable-features=Translate \
    --disable-sync --disable-background-networking --disable-component-update --password-store=basic ;;
esac

trap '[ -n "$RAYWALK_PROFILE" ] || rm -rf "$profile"' EXIT
trap 'exit 130' INT TERM HUP
while :; do
  # shellcheck disable=SC2086 # several flags
  "$browser" "$@" $RAYWALK_FLAGS "$address"
  [ -z "$RAYWALK_ONCE" ] || break
  sleep 3
done
