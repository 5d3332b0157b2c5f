# SPDX-License-Identifier: Apache-2.0
"""The GIL, Ctrl+C, progress, memory."""
import os
import signal
import subprocess
import sys
import threading
import time

import pytest

import rakelight

LONG = "builtin:sphere:tolerance=0.000004"  # 2.5 million triangles; 4 million are refused


def resident():
    """[bytes]"""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGESIZE")


def test_memory_does_not_grow_over_10000_pictures(teapot):
    session = rakelight.Session(teapot, resolution=(8, 6), samples=1)
    channels = ["image", "depth", "normal", "object"]

    def draw(count):
        for number in range(count):
            session.render(rakelight.Camera.orbit(number * 7 % 360, 20, 4), channels=channels)

    draw(1000)
    before = resident()
    draw(10000)
    assert resident() - before < 2 << 20


def test_memory_does_not_grow_over_scenes(quad):
    def work(count):
        for _ in range(count):
            scene = rakelight.Scene.from_meshes([quad, quad])
            scene.smooth().meshes
            rakelight.render(scene, resolution=(4, 4), samples=1)
            with pytest.raises(rakelight.Error):
                rakelight.attributes((quad.vertices, [[0, 1, 9]]))

    work(100)
    before = resident()
    work(500)
    assert resident() - before < 4 << 20


def test_other_threads_run_meanwhile(teapot):
    counted, done = [0], threading.Event()

    def count():
        while not done.is_set():
            counted[0] += 1
            time.sleep(0)

    thread = threading.Thread(target=count)
    thread.start()
    try:
        session = rakelight.Session(teapot, resolution=(640, 480))
        before = counted[0]
        for _ in range(5):
            session.render()
        assert counted[0] - before > 100
    finally:
        done.set()
        thread.join()


def test_sessions_of_several_threads_draw_the_same(teapot):
    pictures = {}

    def draw(number):
        session = rakelight.Session(teapot, resolution=(64, 48))
        pictures[number] = [session.render("front")["image"].tobytes() for _ in range(5)]

    threads = [threading.Thread(target=draw, args=(n,)) for n in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len({picture for several in pictures.values() for picture in several}) == 1 and len(pictures) == 4


def test_a_session_is_for_one_thread_at_a_time(teapot):
    session = rakelight.Session(teapot, resolution=(64, 48))
    errors = []

    def progress(stage, fraction):
        if not errors:
            try:
                session.render()
            except rakelight.UsageError as error:
                errors.append(error)

    for _ in range(200):  # until a picture takes long enough to be told of
        session.render(resolution=(2000, 1500), progress=progress)
        if errors:
            break
    assert "in use" in str(errors[0])
    assert session.render()["image"].shape == (48, 64, 3)


INTERRUPTED = """
import sys, rakelight
def tell(stage, fraction):
    print("busy", flush=True)
try:
    scene = rakelight.load("builtin:teapot")
    session = rakelight.Session(scene, resolution=(4000, 3000), samples=8)
    while True:
        session.render(progress=tell)
except KeyboardInterrupt:
    print("interrupted", flush=True)
session.render("front", resolution=(8, 8))
print("usable", flush=True)
"""


def test_ctrl_c_ends_work_and_leaves_the_session_usable():
    process = subprocess.Popen([sys.executable, "-c", INTERRUPTED], stdout=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "busy\n"
    process.send_signal(signal.SIGINT)
    rest = process.communicate(timeout=120)[0].splitlines()
    assert [line for line in rest if line != "busy"] == ["interrupted", "usable"]
    assert process.returncode == 0


def test_what_progress_raises_ends_the_work(teapot):
    class Enough(Exception):
        pass

    def stop(stage, fraction):
        assert isinstance(stage, str) and 0 <= fraction <= 1
        raise Enough

    session = rakelight.Session(teapot, resolution=(3000, 2000), samples=8)
    with pytest.raises(Enough):
        for _ in range(100):
            session.render(progress=stop)
    assert session.render(resolution=(8, 8))["image"].shape == (8, 8, 3)


def test_progress_is_a_bar_where_tqdm_is_installed(teapot, capsys):
    pytest.importorskip("tqdm")
    rakelight.render(teapot, resolution=(1500, 1000), samples=8, progress=True)
    assert "%" in capsys.readouterr().err


def test_warnings_point_to_the_caller(teapot, tmp_path):
    with pytest.warns(rakelight.RakelightWarning) as caught:
        teapot.save(tmp_path / "a.glb")
    assert caught[0].filename == __file__


DAEMON = """
import sys, threading, time
import numpy as np
import rakelight
inside = threading.Event()
def tell(stage, fraction):
    inside.set()
    while {stays}:
        pass
class Late:  # keeps the interpreter busy at its end, so that the thread comes back while it finishes
    def __del__(self, sleep=time.sleep):
        sleep(0.3)
late = Late()
scene = rakelight.load("builtin:sphere:tolerance=0.00001")
def work():
    while True:
        {call}
threading.Thread(target=work, daemon=True).start()
assert inside.wait(60)
sys.exit(3)
"""


@pytest.mark.parametrize("call, stays", [
    ("rakelight.render(scene, resolution=(3000, 2000), samples=8, progress=tell)", False),
    ("rakelight.render(scene, resolution=(3000, 2000), samples=8, progress=tell)", True),  # Python code of the thread, called by ours
    ("inside.set(); scene.smooth(progress=tell)", False),
    ("inside.set(); rakelight.attributes(scene.placed_meshes())", False),
    (f"inside.set(); rakelight.load('{LONG}', progress=tell)", False),
])  # fmt: skip
def test_a_daemon_thread_inside_a_call_does_not_keep_the_process_from_its_end(call, stays):
    done = subprocess.run([sys.executable, "-c", DAEMON.format(call=call, stays=stays)], capture_output=True, text=True, timeout=120)
    assert (done.returncode, done.stderr) == (3, "")


AT_EXIT = """
import atexit
def last():
    print(rakelight.render("builtin:teapot", "front", resolution=(8, 8))["image"].shape)
atexit.register(last)
import rakelight
"""


def test_calls_at_exit_are_calls():
    done = subprocess.run([sys.executable, "-c", AT_EXIT], capture_output=True, text=True, timeout=120)
    assert (done.returncode, done.stdout, done.stderr) == (0, "(8, 8, 3)\n", "")


FORK = """
import os, sys, threading
import rakelight
inside = threading.Event()
def work():
    rakelight.render("builtin:teapot", resolution=(3000, 2000), samples=8, progress=lambda stage, fraction: inside.set())
thread = threading.Thread(target=work)
thread.start()
assert inside.wait(60)
child = os.fork()
if child == 0:
    sys.exit(5)
print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
"""


def test_a_fork_does_not_wait_for_work_of_its_parent():
    done = subprocess.run([sys.executable, "-c", FORK], capture_output=True, text=True, timeout=120)
    assert (done.returncode, done.stdout, done.stderr) == (0, "5\n", "")
