"""The kiosk's archive: whole, small, the same bytes each time, and started by flags that exist."""

from __future__ import annotations

import hashlib
import mmap
import os
import posixpath
import re
import shutil
import subprocess
import zipfile
from pathlib import Path

import pytest

from raywalk.errors import UserError
from raywalk.scene.read import read_scenes
from raywalk.site import kiosk
from raywalk.site.kiosk import SITE, TOP, write_archive

ROOT = Path(__file__).parent.parent.parent
DIST = ROOT / "dist"
SOURCE = ROOT / "site_src"
BROWSERS = ("/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome")
FIRST = read_scenes(ROOT / "scenes")[0].id  # of the course
# Firefox's own; --edge-kiosk-type and --kiosk-idle-timeout-minutes are Edge's, as Microsoft
# documents them (learn.microsoft.com, "Configure Microsoft Edge kiosk mode").
NOT_CHROMIUMS = {"no-remote", "profile", "edge-kiosk-type", "kiosk-idle-timeout-minutes"}


@pytest.fixture(scope="module")
def archive(tmp_path_factory):
    """The archive of the built site, once for all these tests."""
    path = tmp_path_factory.mktemp("kiosk") / "raywalk-kiosk.zip"
    write_archive(DIST, SOURCE, path)
    return path


def text(archive: Path, name: str) -> str:
    return zipfile.ZipFile(archive).read(f"{TOP}/{name}").decode("utf-8-sig")


def test_it_takes_less_than_64_mb_with_all_scenes_and_slides(archive):
    """An old stick takes that."""
    names = set(zipfile.ZipFile(archive).namelist())
    print(f"{archive.stat().st_size / 1e6:.1f} MB, {len(names)} files")
    assert archive.stat().st_size < 64_000_000
    for folder in (DIST / "scenes").iterdir():
        for needed in (f"scenes/{folder.name}/15.js", f"slides/{folder.name}.pdf"):
            assert not (DIST / needed).exists() or f"{TOP}/{SITE}/{needed}" in names
    assert f"{TOP}/START-HERE.txt" in names and f"{TOP}/{SITE}/LICENSES.txt" in names


def test_nothing_that_a_page_links_to_is_left_out(archive):
    """What is left out is for hosts and other programs."""
    packed = zipfile.ZipFile(archive)
    held = {name.removeprefix(f"{TOP}/{SITE}/") for name in packed.namelist()}
    left_out = {
        path.relative_to(DIST).as_posix() for path in DIST.rglob("*") if path.is_file()
    } - held
    linked = re.compile(r'(?:href|src)="([^"#?]+)')
    pages = sorted(name for name in held if name.endswith(".html"))
    assert "index.html" in pages and "check/index.html" in left_out
    for page in pages:
        for address in linked.findall(packed.read(f"{TOP}/{SITE}/{page}").decode("utf-8")):
            if ":" in address:
                continue
            to = posixpath.normpath(posixpath.join(posixpath.dirname(page), address))
            assert to not in left_out, f"{page}: {address}"


def small_site(folder: Path) -> Path:
    """One scene of the built site: what is not about size takes no time."""
    shutil.copytree(DIST / "scenes" / "01-shading", folder / "scenes" / "01-shading")
    shutil.copyfile(DIST / "index.html", folder / "index.html")
    return folder


def test_the_same_site_makes_the_same_bytes(tmp_path):
    """So that two archives can be compared, and copied by what changed; wherever the site lies and
    whenever it was built."""
    one, other = small_site(tmp_path / "one"), small_site(tmp_path / "other")
    for path in other.rglob("*"):
        os.utime(path, (0, 0))
    digests = []
    for site in (one, other):
        write_archive(site, SOURCE, tmp_path / f"{site.name}.zip")
        digests.append(hashlib.sha256((tmp_path / f"{site.name}.zip").read_bytes()).digest())
    assert digests[0] == digests[1]


def test_scripts_are_as_their_systems_want_them(archive):
    """Unix: executable, bare line feeds; Windows: both, in scripts and in text."""
    packed = zipfile.ZipFile(archive)
    for info in packed.infolist():
        mode = info.external_attr >> 16
        if info.filename.endswith((".sh", ".command")):
            content = packed.read(info)
            assert (
                mode & 0o111 == 0o111
                and b"\r" not in content
                and content.startswith(b"#!/bin/sh\n")
            )
        elif info.filename.endswith((".bat", ".txt")) and f"/{SITE}/" not in info.filename:
            assert b"\n" not in packed.read(info).replace(b"\r\n", b"")
        else:
            assert mode == 0o100644
    for script in ("start-linux.sh", "start-macos.command"):
        subprocess.run(["sh", "-n"], input=text(archive, script).encode(), check=True)


def test_every_script_opens_the_first_scene_as_a_kiosk_and_needs_no_relaxed_rules(archive):
    """The rules are those of any profile."""
    for script in ("start-linux.sh", "start-macos.command", "start-windows.bat"):
        said = text(archive, script)
        assert "@" not in said.replace("$@", "").replace("@echo off", ""), "every place is filled"
        assert "kiosk=1" in said and "file://" in said
        assert re.search(rf"scenes[\\/]{FIRST}[\\/]index\.html", said)
        assert not re.search("allow-file-access|disable-web-security|no-sandbox", said)


@pytest.mark.parametrize("code", [0, 1, 137])
def test_however_the_browser_ends_the_script_starts_it_again(archive, tmp_path, code):
    """A stand-in for the browser ends at once, three times; the pause between takes no time."""
    place = tmp_path / "unpacked"
    with zipfile.ZipFile(archive) as packed:
        needed = ("start-linux.sh", f"{SITE}/scenes/{FIRST}/index.html")
        packed.extractall(place, [f"{TOP}/{name}" for name in needed])
    starts = tmp_path / "starts"
    tools = tmp_path / "tools"
    tools.mkdir()
    for name, does in {
        "browser": f'echo started >>"{starts}"; exit {code}',
        "sleep": f'[ "$(wc -l <"{starts}")" -lt 3 ] || kill -TERM $PPID',
    }.items():
        (tools / name).write_text(f"#!/bin/sh\n{does}\n")
        (tools / name).chmod(0o755)
    own = {"RAYWALK_BROWSER": str(tools / "browser"), "PATH": f"{tools}:{os.environ['PATH']}"}
    done = subprocess.run(
        ["sh", str(place / "raywalk-kiosk" / "start-linux.sh")], env=os.environ | own, check=False,
    )  # fmt: skip
    assert done.returncode == 130 and len(starts.read_text().splitlines()) == 3


def test_no_script_asks_how_the_browser_ended(archive):
    """A browser that was closed in good order is gone as well."""
    for script in ("start-linux.sh", "start-macos.command", "start-windows.bat"):
        loop = text(archive, script).replace("\r\n", "\n")
        loop = loop[max(loop.find("while :"), loop.find(":again")) :]
        assert not re.search(r"until|errorlevel|\$\?|&&", loop)
        assert "sleep 3" in loop or "ping -n 4" in loop


def flags_for(said: str, browser: str) -> set[str]:
    """What a script hands to that browser."""
    lines = re.findall(r"set (?:-- |flags=)(.*)", said.replace("\\\n", ""))
    [line] = [line for line in lines if ("--no-remote" in line) == (browser == "firefox")]
    return set(re.findall(r"(?:(?<=\s)|^)(--[a-z][a-z-]*(?:=\w+)?)", line))


def test_all_three_scripts_give_a_browser_the_same_flags(archive):
    """But for Edge's own, which only Windows has as the browser that is always there."""
    linux, mac, windows = (
        text(archive, script).replace("\r\n", "\n")
        for script in ("start-linux.sh", "start-macos.command", "start-windows.bat")
    )
    for browser in ("chromium", "firefox"):
        flags = flags_for(linux, browser)
        assert len(flags) >= 3, flags
        assert flags_for(mac, browser) == flags
        edge = {flag for flag in flags_for(windows, browser) if "kiosk-" in flag}
        assert flags_for(windows, browser) - edge == flags


def run_set_lines(script: str, known: dict[str, str]) -> dict[str, str]:
    """The variables after a batch file's lines `[if ... ]set "name=value"`, as cmd.exe has them.

    Two passes, of which the second does not look at what the first put in: %name%, where a name
    reaches to the next percent sign, %% is one, and %0 to %9 are arguments; then !name!, from
    the line with EnableDelayedExpansion on. name:a=b puts b for each a, name:~0,2 takes letters.
    """

    def look_up(name: str) -> str:
        name, _, change = name.partition(":")
        value = known.get(name.lower(), "")
        if change.startswith("~"):
            start, length = (int(part) for part in change[1:].split(","))
            return value[start : start + length]
        old, _, new = change.partition("=")
        return value.replace(old, new) if change else value

    def percents(found: re.Match[str]) -> str:
        said = found[0]
        return "%" if said == "%%" else "" if said[-1].isdigit() else look_up(said[1:-1])

    delayed = False
    for line in script.splitlines():
        delayed = delayed or "EnableDelayedExpansion" in line
        line = re.sub(r"%%|%\d|%[^%\d][^%]*%", percents, line.replace("%~1", known["1"]))
        if delayed:
            line = re.sub(r"!([^!]+)!", lambda found: look_up(found[1]), line)
        setting = re.fullmatch(r'(?:if (not )?"(.*)"=="(.*)" )?set "(\w+)=(.*)"', line)
        if setting and (setting[3] is None or (setting[2] == setting[3]) != bool(setting[1])):
            known[setting[4]] = setting[5]
    return known


@pytest.mark.parametrize(
    ("folder", "address"),
    [
        ("E:\\raywalk-kiosk\\", "file:///E:/raywalk-kiosk/"),
        ("C:\\A & B\\kiosk #1 50% ä\\", "file:///C:/A%20&%20B/kiosk%20%231%2050%25%20ä/"),
        ("\\\\server\\our course\\", "file://server/our%20course/"),
    ],
)
def test_windows_script_writes_any_folder_as_an_address(archive, folder, address):
    """Spaces, &, #, percent signs, a folder on a server."""
    script = text(archive, "start-windows.bat").replace("%~dp0", "%here%")
    script, _, _ = script.partition('set "browser=')
    known = run_set_lines(script, {"here": folder, "1": "idle=60&warn=20"})
    assert known["address"] == (
        f"{address}course/scenes/{FIRST}/index.html#kiosk=1&idle=60&warn=20"
    )


def test_every_flag_is_one_that_chromium_knows(archive):
    """Chromium says nothing of a flag that it does not know: it is looked for in the program."""
    browser = next((path for path in BROWSERS if Path(path).exists()), None)
    if browser is None:
        pytest.skip("no Chromium here to ask")
    program = _program(Path(browser))
    flags = set()
    for script in ("start-linux.sh", "start-macos.command", "start-windows.bat"):
        flags |= set(re.findall(r"(?<=\s)--([a-z-]+)", text(archive, script)))
    assert {"kiosk", "user-data-dir", "disable-pinch", "noerrdialogs"} <= flags
    with program.open("rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as code:
        unknown = [
            flag
            for flag in sorted(flags - NOT_CHROMIUMS)
            if code.find(b"\0" + flag.encode() + b"\0") < 0
        ]
    assert not unknown


def _program(browser: Path) -> Path:
    """The program behind a start script: the largest file of that name."""
    places = [
        browser.resolve(),
        *Path("/usr/lib").glob("chromium*/chromium*"),
        *Path("/opt/google").glob("chrome*/chrome"),
    ]
    return max(
        (place for place in places if place.is_file()), key=lambda place: place.stat().st_size
    )


def test_an_archive_that_outgrows_its_limit_is_not_written(tmp_path, monkeypatch):
    """And one that was there stays."""
    site = small_site(tmp_path / "site")
    out = tmp_path / "out.zip"
    out.write_bytes(b"before")
    monkeypatch.setattr(kiosk, "LIMIT", 1000)
    with pytest.raises(UserError, match=r"bytes; a kiosk's archive takes 1,000 at most"):
        write_archive(site, SOURCE, out)
    assert out.read_bytes() == b"before"
    assert not list(tmp_path.glob("*.partial"))


def test_without_a_built_site_the_next_step_is_named(tmp_path):
    """make."""
    with pytest.raises(UserError, match="no built site is there\n  hint: run `raywalk build`"):
        write_archive(tmp_path, SOURCE, tmp_path / "out.zip")


def test_the_instructions_name_the_settings_that_the_page_has(archive):
    """Range and default of each, in both languages, as the viewer clamps them."""
    fields = (SOURCE / "viewer" / "state" / "kiosk-fields.ts").read_text(encoding="utf-8")
    found = re.findall(r'^  "?([a-z-]+)"?: \[([\d.]+), ([\d.]+), ([\d.]+)\]', fields, re.M)
    numbers = {key: tuple(map(float, rest)) for key, *rest in found if key != "strikes"}
    assert set(numbers) == {"idle", "warn", "attract-pace"}
    for language in text(archive, "START-HERE.txt").split("RAYWALK ALS KIOSK"):
        settings = " ".join(language.replace(",", ".").split())
        for key, range_and_usual in numbers.items():
            [said] = re.findall(rf"{key} (?!=)[^(=]*\(([^()]*)\)", settings)
            assert tuple(map(float, re.findall(r"[\d.]+", said))) == range_and_usual, (key, said)
        assert f"{numbers['idle'][2]:g} " in settings and f"{numbers['warn'][2]:g} " in settings
