@echo off
rem Raywalk as a kiosk on Windows: full screen, nothing else to get at. The browser comes back whenever it
rem ends, whatever its code: to end it all, press Alt+F4 and, within three seconds, close the black window that is left.
rem   start-windows.bat                       as it is
rem   start-windows.bat "idle=60&warn=20"     starts again after 60 seconds without a touch, warns 20 seconds before
rem   set RAYWALK_LANGUAGE=de                 begins in German
setlocal DisableDelayedExpansion
set "here=%~dp0"
set "course=course"
if defined RAYWALK_LANGUAGE if not "%RAYWALK_LANGUAGE%"=="en" set "course=course\%RAYWALK_LANGUAGE%"
set "page=%here%%course%\@START_WINDOWS@"
if not exist "%page%" (
  echo start-windows.bat: "%page%" is not there: was the whole archive unpacked?
  pause
  exit /b 1
)
set "settings=kiosk=1"
if not "%~1"=="" set "settings=kiosk=1&%~1"
rem What has a meaning of its own in an address. With exclamation marks: between percent signs none could be put in.
setlocal EnableDelayedExpansion
set "path_=!page:\=/!"
set "path_=!path_:%%=%%25!"
set "path_=!path_:#=%%23!"
set "path_=!path_: =%%20!"
set "address=file:///!path_!#!settings!"
if "!path_:~0,2!"=="//" set "address=file:!path_!#!settings!"

set "browser=!RAYWALK_BROWSER!"
for %%b in (
  "%ProgramFiles%\Google\Chrome\Application\chrome.exe"
  "%ProgramFiles(x86)%\Google\Chrome\Application\chrome.exe"
  "%LocalAppData%\Google\Chrome\Application\chrome.exe"
  "%LocalAppData%\Chromium\Application\chrome.exe"
  "%ProgramFiles(x86)%\Microsoft\Edge\Application\msedge.exe"
  "%ProgramFiles%\Microsoft\Edge\Application\msedge.exe"
  "%ProgramFiles%\Mozilla Firefox\firefox.exe"
) do if not defined browser if exist "%%~b" set "browser=%%~b"
if not defined browser (
  echo start-windows.bat: no browser found: install Edge, Chrome or Firefox
  pause
  exit /b 1
)

rem A profile of its own, empty at each start: no session to restore, no bubble to close.
set "profile=!TEMP!\raywalk-kiosk"
if exist "!profile!" rmdir /s /q "!profile!"
mkdir "!profile!"
set flags=--kiosk --user-data-dir="!profile!" --edge-kiosk-type=fullscreen --kiosk-idle-timeout-minutes=0 --no-first-run --no-default-browser-check --noerrdialogs --hide-crash-restore-bubble --disable-pinch --overscroll-history-navigation=0 --disable-features=Translate --disable-sync --disable-background-networking --disable-component-update --password-store=basic
if /i "!browser:~-11!"=="firefox.exe" set flags=--kiosk --no-remote --profile "!profile!"

:again
start "" /wait "!browser!" !flags! "!address!"
ping -n 4 127.0.0.1 >nul
goto again
