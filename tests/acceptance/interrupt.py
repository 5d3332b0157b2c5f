#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How soon the program ends when it is interrupted, whatever it does. Standard library only.

  interrupt.py PROGRAM [--only WORDS] [--moments S,S,...] [--limit S] [--inputs DIR] [--where]

Makes heavy inputs, runs every verb over them with several sets of options, sends SIGINT at each of the moments [s after the
start] and measures the time until the process is gone. It must work no longer than the limit (default 0.5 s of each processor,
and six times that by the clock, since the machine may be loaded), end by the signal, with its line on standard
error, and leave neither an output nor a temporary file or folder nor another process. What the program's own alarm ends is
seen by --where, which shows by gdb what it does 0.2 s after the signal; that every loop looks whether it is cancelled is
held by the unit tests (Cancel*).

Exit code 0 when all holds, 1 with a line for each thing that does not."""
import argparse
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import zlib

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
MOMENTS = (0.3, 1.2)
MOST_OUTSIDE_OF_WORK = 8


def png(path, width, height, channels):
    """8-bit gray or RGB: rows of waves that differ a little."""
    def chunk(kind, data):
        return len(data).to_bytes(4, "big") + kind + data + zlib.crc32(kind + data).to_bytes(4, "big")
    wave = bytes(96 + (x * x // 64 + x) % 64 for x in range(width * channels + 256))
    packer = zlib.compressobj(1)
    data = b"".join(packer.compress(b"\0" + wave[y % 256:y % 256 + width * channels]) for y in range(height)) + packer.flush()
    head = width.to_bytes(4, "big") + height.to_bytes(4, "big") + bytes([8, {1: 0, 3: 2}[channels], 0, 0, 0])
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", data) + chunk(b"IEND", b""))


def hdr(path, width, height):
    """A panorama without run lengths."""
    row = b"".join(bytes([96 + x % 64, 128, 64, 129]) for x in range(width))
    path.write_bytes(f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n".encode() + row * height)


def grid_obj(path, size):
    """A height field of 2 (size - 1)^2 triangles with normals and texture coordinates."""
    with path.open("w") as out:
        for y in range(size):
            out.write("".join(f"v {x} {y} {(x * x + 3 * y * x) % 17 / 8}\nvt {x / size:.5f} {y / size:.5f}\n" for x in range(size)))
        out.write("vn 0 0 1\n")
        for y in range(size - 1):
            first = y * size + 1
            out.write("".join(f"f {i}/{i}/1 {i + 1}/{i + 1}/1 {i + size + 1}/{i + size + 1}/1 {i + size}/{i + size}/1\n"
                              for i in range(first, first + size - 1)))


def make_inputs(program, folder):
    def run(*arguments):
        subprocess.run([program, *arguments], cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    run("bench", "render", "--triangles", "3M", "--frames", "1", "--resolution", "16,16", "--export", "mesh.glb")
    run("smooth", "mesh.glb", "-o", "mesh.ply", "--scope", "object")
    grid_obj(folder / "grid.obj", 800)
    png(folder / "gray.png", 12000, 12000, 1)
    png(folder / "normal.png", 4096, 4096, 3)
    hdr(folder / "around.hdr", 6144, 3072)


def cases():
    """What is run, in words; OUT is replaced by the output's name."""
    glass = ROOT / "data/rays/glass.scene.toml"
    head, brick = ROOT / "data/head/head.obj", ROOT / "data/maps/brick_height.png"
    subdivided = f"{head} --subdivide 4 --max-memory 16G"
    displaced = f"builtin:sphere --bump displacement --height-map {brick} --displacement-edge 0.0005 --displacement-triangles 10000000 --max-memory 16G"
    return [line.strip() for line in f"""
        render mesh.glb -o OUT.png --normals model
        render mesh.glb -o OUT.png --normals model --crease-angle 40 --tangents mikktspace
        render grid.obj -o OUT.png --normals object
        render mesh.ply -o OUT.png
        render {subdivided} -o OUT.png
        render {head} --subdivide 3 --subdivide-crease 30 --subdivide-scheme catmull-clark --max-memory 16G -o OUT.png
        render {displaced} -o OUT.png
        render builtin:plane --texture-normal normal.png --bump occlusion -o OUT.png --max-memory 16G
        render builtin:sphere --hdri-file around.hdr --hdri-skybox -o OUT.png --max-memory 16G
        render builtin:plane --texture-base-color gray.png -o OUT.png --max-memory 16G
        render builtin:teapot -o OUT.png --resolution 16000,12000 --channels all --max-memory 16G
        render builtin:teapot -o OUT.exr --resolution 12000,8000 --channels all --channel-files layers --max-memory 16G
        render builtin:teapot -o OUT.jpg --resolution 16000,12000
        render builtin:teapot -o OUT.webp --resolution 12000,9000
        render builtin:teapot -o OUT.png --resolution 8000,6000 --samples 8 --shadows
        render mesh.glb -o OUT.png --engine trace
        render {glass} -o OUT.png --resolution 4000,3000 --max-depth 64
        render {glass} -o OUT.exr --resolution 4000,3000 --channels all
        render mesh.ply -o OUT.png --engine trace --method cast --naive --naive-limit 1e18
        smooth mesh.glb -o OUT.glb
        smooth mesh.glb -o OUT.ply --weld-distance 0.0001
        smooth mesh.ply -o OUT.glb
        smooth grid.obj -o OUT.obj --crease-angle 30
        inspect mesh.glb --heatmap OUT.png
        inspect grid.obj --normals object --json
        explain mesh.glb --pixel 640,360
        explain {subdivided} --pixel 640,360
        stages mesh.glb -o OUT
        stages {displaced} -o OUT
        check mesh.glb
        check grid.obj
        bench smooth --triangles 5M --with all
        bench smooth --triangles 50k --brute-force
        bench render --triangles 5M""".strip().splitlines()]


def processor_seconds(pid):
    fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def others_of(session):
    """Processes that still run in it."""
    found = []
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            name, _, rest = stat.read_text().rpartition(")")
        except OSError:
            continue
        if rest.split()[3] == str(session) and rest.split()[0] != "Z":
            found.append(name.partition("(")[2])
    return found


def show_where(pid):
    time.sleep(0.2)
    text = subprocess.run(["gdb", "-p", str(pid), "-batch", "-ex", "thread apply all bt 12"], capture_output=True, text=True).stdout
    print("\n".join(line[:160] for line in text.splitlines() if line.startswith(("#", "Thread"))), flush=True)


def interrupt(command, folder, moment, where):
    """(None where it ended before, else seconds until it was gone, of them on a processor, exit code, standard error, processes left)"""
    with tempfile.TemporaryFile() as errors:
        process = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=errors, start_new_session=True)
        try:
            process.wait(moment)
            return None
        except subprocess.TimeoutExpired:
            pass
        before = processor_seconds(process.pid)
        begin = time.monotonic()
        process.send_signal(signal.SIGINT)
        if where:
            show_where(process.pid)
        _, status, usage = os.wait4(process.pid, 0)
        took = time.monotonic() - begin
        process.returncode = os.waitstatus_to_exitcode(status)
        left, patience = others_of(process.pid), time.monotonic() + 1
        while left and time.monotonic() < patience:  # the kernel is ending it
            time.sleep(0.01)
            left = others_of(process.pid)
        errors.seek(0)
        worked = usage.ru_utime + usage.ru_stime - before  # some kernels bring the file in /proc up to date late: never more than all processors do
        return took, min(max(0.0, worked), took * os.cpu_count()), process.returncode, errors.read().decode(errors="replace"), left


def is_outside_of_work(code, errors):
    """Before the work or after it there is nothing to cancel, and nothing to say; what was said before may be warnings."""
    is_said = "cancelled" in errors or any(": error: " in line for line in errors.splitlines())
    return code == 0 or (code == -signal.SIGINT and not is_said)


def faults(answer, outputs, limit):
    took, worked, code, errors, left = answer
    if worked > limit * os.cpu_count() or took > 6 * limit:
        yield f"gone after {took:.2f} s, {worked:.2f} of them at work"
    if is_outside_of_work(code, errors):
        return
    if code != -signal.SIGINT:
        yield f"exit code {code}"
    if [line for line in errors.splitlines() if ": error: " in line and not line.endswith(": cancelled")] or "cancelled" not in errors:
        yield f"says: {errors.strip()[-200:]}"
    if outputs:
        yield f"leaves {outputs} behind"
    if left:
        yield f"leaves {left} running"


def check_case(program, words, folder, options):
    """Lines of what is wrong, and how many signals met no work; prints the slowest answer."""
    wrong, slowest, answered, outside = [], (0.0, 0.0, 0.0), 0, 0
    for moment in options.moments:
        with tempfile.TemporaryDirectory(dir=folder) as out:
            command = [program] + [w.replace("OUT", f"{out}/out") for w in words.split()]
            answer = interrupt(command, folder, moment, options.where)
            if answer is None:
                break
            answered += 1
            outside += is_outside_of_work(answer[2], answer[3])
            slowest = max(slowest, (answer[0], answer[1], moment))
            whole = words.startswith("stages")  # writes many files, each of them whole
            outputs = [p.name for p in pathlib.Path(out).rglob("*") if not whole or any(part.startswith(".") for part in p.relative_to(out).parts)]
            wrong += [f"{words} at {moment:g} s: {fault}" for fault in faults(answer, outputs, options.limit)]
    print(f"{slowest[0]:6.2f} s, {slowest[1]:5.2f} at work, at {slowest[2]:4.2f} s, of {answered} signals: {words.replace(str(ROOT) + '/', '')}", flush=True)
    return wrong, outside


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=lambda p: str(pathlib.Path(p).resolve()))
    parser.add_argument("--only", default="", help="cases that hold these words")
    parser.add_argument("--moments", type=lambda t: [float(s) for s in t.split(",")], default=MOMENTS)
    parser.add_argument("--limit", type=float, default=0.5)
    parser.add_argument("--inputs", type=pathlib.Path, help="a folder to keep the inputs in")
    parser.add_argument("--where", action="store_true")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.inputs or pathlib.Path(temporary)
        if not (folder / "around.hdr").exists():
            make_inputs(options.program, folder)
        found = [check_case(options.program, words, folder, options) for words in cases() if options.only in words]
    wrong = [line for lines, _ in found for line in lines]
    outside = sum(count for _, count in found)
    if outside > MOST_OUTSIDE_OF_WORK:
        wrong.append(f"{outside} signals were answered by no word: more than can have met no work")
    print("\n".join(wrong))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
