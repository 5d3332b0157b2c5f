#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Random keys, mouse, sizes and drops against a running rakelight-view that steps through hostile and sound files.

  random_events.py VIEWER SECONDS [--seed N] [--files FOLDER ...]

Fails when the viewer ends by itself, writes an error of a sanitizer, does not end when told to, or when its memory after the first
third has more than doubled (and grown by 300 MB) at the end. Runs itself under xvfb-run; exit code 77 where that, xdotool or python3-xlib is missing."""
import argparse
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import xdnd

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
KEYS = ("1 2 3 4 5 6 7 8 9 f h s y b c shift+c a t q e w o i j l shift+l g x d shift+n shift+t shift+b v backslash shift+backslash p k u n z m Tab "
        "Escape Home Return period Page_Down F2 F3 F4 F5 F6 F7 F8 F10 F11 F12 ctrl+c ctrl+1 ctrl+3 ctrl+7 grave Right Right Right Left Up r "
        "space shift+space shift+w alt+w BackSpace shift+Right shift+Left bracketleft bracketright ctrl+l Insert Delete shift+m").split()
ENDINGS = {".glb", ".gltf", ".obj", ".ply", ".stl", ".toml", ".3ds", ".fbx", ".dae", ".x", ".off", ".ase", ".blend"}


PICTURES = {".png", ".jpg", ".jpeg", ".webp", ".tga", ".bmp", ".hdr", ".exr"}


def files_of(folders, endings, rng):
    found = [str(path) for folder in folders for path in sorted(folder.rglob("*")) if path.suffix.lower() in endings and path.stat().st_size < 5_000_000]
    rng.shuffle(found)
    return found[:300]


def memory_mb(pid):
    for line in pathlib.Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith("VmRSS"):
            return int(line.split()[1]) / 1024
    return 0


def settled_mb(tool, window, pid):
    """Memory in a small window: pictures of the largest ones take half a gigabyte, and go with them."""
    tool("windowsize", window, 640, 480)
    time.sleep(1.5)
    return memory_mb(pid)


def step(rng, window):
    """One event as words of xdotool."""
    kind = rng.random()
    x, y = rng.randrange(1280), rng.randrange(900)
    if kind < 0.45:
        return ["key", rng.choice(KEYS)]
    if kind < 0.65:
        moves = [word for _ in range(6) for word in ("mousemove_relative", "--", str(rng.randrange(-60, 60)), str(rng.randrange(-60, 60)))]
        return ["mousemove", x, y, "mousedown", rng.choice("123"), *moves, "mouseup", "1", "mouseup", "2", "mouseup", "3"]
    if kind < 0.8:
        return ["mousemove", x, y, "click", rng.choice("12345")]
    if kind < 0.86:
        key = rng.choice("wasdqe")
        return ["keydown", key, "sleep", "0.05", "keyup", key]
    if kind < 0.9:
        return ["windowsize", window, rng.choice((1, 2, 17, 200, 640, 1280, 2500, 3840)), rng.choice((1, 3, 31, 200, 480, 900, 1700, 2160))]
    if kind < 0.95:
        return ["type", "--delay", "2", rng.choice(("0.5", "-1e30", "nan", "abc", "99999999999", "1,2,3"))]
    return ["sleep", "0.3"]


def drop(rng, desktop, window, files, pictures):
    """Whether the window took it: it may be minute, or busy with the drop before."""
    kind = rng.random()
    some = [rng.choice(files)] if kind < 0.3 else [rng.choice(pictures)] if kind < 0.8 else rng.sample(files + pictures, 3)
    if kind > 0.97:
        some = [str(pathlib.Path(rng.choice(files)).parent)]
    # Without Control the list is what was dropped alone, and there is little to step through.
    held = ["Control_L"] if rng.random() < 0.8 else ["Shift_L"] if rng.random() < 0.5 else []
    try:
        desktop.drop(window, some, rng.randrange(640), rng.randrange(480), held)
        return True
    except xdnd.Refused:
        return False


def run(options):
    rng = random.Random(options.seed)
    folder = pathlib.Path(tempfile.mkdtemp(prefix="rakelight_random_"))
    files = files_of(options.files, ENDINGS, rng)
    pictures = files_of([*options.files, ROOT / "data"], PICTURES, rng)
    print(f"seed {options.seed}, {len(files)} files, {len(pictures)} pictures", flush=True)
    environment = dict(os.environ, XDG_CONFIG_HOME=str(folder))
    with open(folder / "log", "w+") as log:
        viewer = subprocess.Popen([options.viewer, "--stats", "builtin:teapot", ROOT / "data" / "motion" / "door.gltf", *files], cwd=folder, env=environment, stdout=log, stderr=log)
        try:
            faults = play(options, rng, viewer, files, pictures)
        finally:
            if viewer.poll() is None:
                viewer.kill()
                viewer.wait()
        log.seek(0)
        text = log.read()
    if "Sanitizer" in text or "runtime error" in text:
        faults.append("a sanitizer found something")
    print(text[-6000:])
    shutil.rmtree(folder, ignore_errors=True)
    for fault in faults:
        print(f"FAILED: {fault}", file=sys.stderr)
    return 1 if faults else 0


def play(options, rng, viewer, files, pictures):
    tool = lambda *words: subprocess.run(["xdotool", *map(str, words)], capture_output=True, text=True).stdout
    end, window = time.monotonic() + options.seconds, ""
    while not window and time.monotonic() < end:
        window = tool("search", "--onlyvisible", "--pid", viewer.pid).split("\n")[0]
    early_mb, count, drops = 0, 0, 0
    desktop = xdnd.Desktop()
    while time.monotonic() < end:
        if rng.random() < 0.06:
            drops += drop(rng, desktop, window, files, pictures)
        else:
            tool(*step(rng, window))
        count += 1
        if viewer.poll() is not None:
            return [f"the viewer ended with {viewer.returncode} after {count} events"]
        if early_mb == 0 and time.monotonic() > end - 2 * options.seconds / 3:
            early_mb = settled_mb(tool, window, viewer.pid)
    late_mb = settled_mb(tool, window, viewer.pid)
    print(f"{count} events, {drops} drops taken, {early_mb:.0f} MB after a third, {late_mb:.0f} MB at the end")
    faults = [f"memory grew from {early_mb:.0f} to {late_mb:.0f} MB"] if late_mb > max(2 * early_mb, early_mb + 300) else []
    tool("windowsize", window, 640, 480, "mousemove", 600, 440, "key", "Escape", "key", "Escape", "key", "Escape", "key", "ctrl+q")
    try:
        if viewer.wait(60) not in (0, 1):  # 1: a picture that was asked for could not be made, as of 8 samples by llvmpipe
            faults.append(f"the viewer ended with {viewer.returncode}")
    except subprocess.TimeoutExpired:
        viewer.send_signal(signal.SIGABRT)
        faults.append("the viewer does not end")
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("viewer", type=os.path.abspath)
    parser.add_argument("seconds", type=float)
    parser.add_argument("--seed", type=int, default=1)
    shared = pathlib.Path(os.environ.get("RAKELIGHT_SHARED", ROOT.parent / "shared"))
    parser.add_argument("--files", type=pathlib.Path, nargs="*", default=[f for f in (shared / "hostile", ROOT / "data") if f.is_dir()])
    options = parser.parse_args()
    missing = [tool for tool in ("xvfb-run", "xdotool") if not shutil.which(tool)] + ([] if xdnd.is_there() else ["python3-xlib"])
    if missing:
        print(f"SKIPPED: no random events: {', '.join(missing)} not installed", file=sys.stderr)
        return 77
    if os.environ.get("RAKELIGHT_VIEWER_TEST_DISPLAY") != "1":
        environment = dict(os.environ, RAKELIGHT_VIEWER_TEST_DISPLAY="1")
        return subprocess.run(["xvfb-run", "-a", "-s", "-screen 0 1280x900x24 -noreset", sys.executable, *sys.argv], env=environment).returncode
    return run(options)


if __name__ == "__main__":
    sys.exit(main())
