#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The program from outside, over whole sets of files. Standard library only.

  acceptance.py models  PROGRAM DIR   every model renders: exit 0, a picture that is not blank, nothing not finite, nothing left behind
  acceptance.py hostile PROGRAM DIR   every broken file of DIR/cases.json keeps its rule
  acceptance.py floods  PROGRAM       models of 50,000 names whose std::hash is equal keep the rule of broken files, and take about as long as
                                      models of plain names; the test makes them itself
  acceptance.py smooth  PROGRAM DIR   every file of DIR, broken or not, goes through `smooth` to its own kind, to GLB and to PLY: it is refused in
                                      one line, or the output stands alone and a second run over it succeeds and changes nothing
  acceptance.py seams   PROGRAM DIR   `inspect --check` fails for each model of which `smooth` would join normals that differ by more than the limit,
                                      and for no other; it finds no seam in what `smooth` wrote, and a second `smooth` changes nothing
  acceptance.py parts   PROGRAM DIR   models cut into parts render like the whole when smoothed over the model, and unlike it per object
  acceptance.py growth  PROGRAM       what a file may have many of costs time in proportion
  acceptance.py bits    PROGRAM FILE... the same picture for each number of threads and instruction set, and under qemu as a Nehalem

Exit code 0 when all holds, 1 with a line for each thing that does not, 77 when DIR is not there (the test is skipped)."""
import base64
import concurrent.futures
import itertools
import json
import os
import pathlib
import resource
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import zlib

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent.parent / "tools/pictures")]
import name_floods  # noqa: E402
import posing_files  # noqa: E402
from png8 import read_rgb  # noqa: E402

FORMATS = {".glb", ".gltf", ".obj", ".fbx", ".stl", ".ply", ".dae", ".3ds", ".ase", ".blend", ".off", ".x"}
SECONDS, GIB = 10, 2
POSING = ("render", "inspect", "smooth")
SANITIZED = os.environ.get("RAKELIGHT_SANITIZED") == "1"  # slower and hungrier: only the limits are lifted


def run(command, seconds=60, folder=None, **environment):
    """(exit code, -999 when out of time; standard error; peak memory of all children so far in MiB)"""
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=seconds * (6 if SANITIZED else 1),
                              stdin=subprocess.DEVNULL, cwd=folder, env={**os.environ, **environment})
    except subprocess.TimeoutExpired:
        return -999, "", 0
    return done.returncode, done.stderr, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024


def run_alone(command, seconds, folder):
    """(exit code, -999 when out of time; standard error; peak memory of this process in MiB)"""
    with tempfile.TemporaryFile() as errors:
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=errors, cwd=folder)
        timer = threading.Timer(seconds, process.kill)
        timer.start()
        _, status, usage = os.wait4(process.pid, 0)
        timer.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)  # it has been waited for
        errors.seek(0)
        text = errors.read().decode(errors="replace")
    return -999 if process.returncode == -signal.SIGKILL else process.returncode, text, usage.ru_maxrss / 1024


def last_line(text):
    return (text.strip().splitlines() or ["(no message)"])[-1][:200]


def sanitizer_spoke(text):
    return "Sanitizer" in text or "runtime error:" in text


def in_parallel(work, items):
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return [line for line in pool.map(work, items) if line]


def models_under(folder):
    return sorted(p for p in folder.rglob("*") if p.suffix.lower() in FORMATS)


def check_models(program, folder):
    known = json.loads((HERE / "refused_models.json").read_text())
    models = models_under(folder)

    def one(model):
        name = str(model.relative_to(folder))
        with tempfile.TemporaryDirectory() as temporary:
            picture = pathlib.Path(temporary) / "picture.png"
            code, errors, _ = run([program, "render", str(model), "-o", str(picture), "--resolution", "192,144"], folder=temporary)
            left = [p.name for p in pathlib.Path(temporary).iterdir() if p != picture]
            if sanitizer_spoke(errors):
                return f"{name}: sanitizer: {last_line(errors)}"
            if name in known:
                return None if code == 4 and known[name] in errors else f"{name}: expected a refusal with '{known[name]}', got exit {code}: {last_line(errors)}"
            if code != 0 or not picture.exists():
                return f"{name}: exit {code}: {last_line(errors)}"
            if "not finite and" in errors and "color values" in errors:
                return f"{name}: {last_line(errors)}"
            _, _, pixels = read_rgb(picture)
            shown = sum(pixels[i:i + 3] != pixels[:3] for i in range(0, len(pixels), 3)) / (192 * 144)
            return f"{name}: leaves {left} behind" if left else f"{name}: a blank picture" if shown < 0.002 else None

    wrong = in_parallel(one, models)
    print(f"{len(models) - len(wrong)} of {len(models)} models as expected, {len(known)} of them refused by name")
    return wrong if models else ["no models found"]


def keeps_rule(verdict, code, errors, has_picture, names):
    """None, or what is wrong: the rule of the hostile set's index."""
    if code < 0:
        return f"signal or out of time ({code})"
    if sanitizer_spoke(errors):
        return "sanitizer: " + last_line(errors)
    if (code == 0) != has_picture:
        return f"exit {code} and {'a' if has_picture else 'no'} picture"
    if code not in (0, 1, 3, 4):
        return f"exit {code}: {last_line(errors)}"
    if code and not any(n in errors for n in names):
        return "the message does not name the file: " + last_line(errors)
    if code and len([x for x in errors.splitlines() if ": error: " in x]) != 1:
        return "not exactly one error line"
    if verdict == "refuse" and code == 0:
        return "accepted"
    if verdict == "render" and code:
        return "refused though valid: " + last_line(errors)
    if verdict == "load" and code and not (code == 4 and "nothing to draw" in errors):
        return "refused though valid: " + last_line(errors)
    if verdict == "warn+render" and (code or not errors.strip()):
        return f"want a warning and a picture, got exit {code}: {last_line(errors)}"
    return None


def quad_with_material(source, folder):
    """An OBJ of one square that uses the material file."""
    if source.parent != folder:
        shutil.copy(source, folder)
    names = [line.split()[1] for line in source.read_text(errors="replace").splitlines() if line.startswith("newmtl") and len(line.split()) > 1]
    model = folder / "quad.obj"
    model.write_text(f"mtllib {source.name}\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                     f"usemtl {names[0] if names else 'm'}\nf 1/1 2/2 3/3 4/4\n")
    return model


def check_hostile(program, folder):
    cases = [(folder / name, verdict) for name, _, verdict in json.loads((folder / "cases.json").read_text())
             if verdict != "-" and (folder / name).exists()]
    peak = [0.0]

    def one(case):
        source, verdict = case
        with tempfile.TemporaryDirectory() as temporary, tempfile.TemporaryDirectory() as beside:
            model = quad_with_material(source, pathlib.Path(beside)) if verdict == "via-obj" else source
            picture = pathlib.Path(temporary) / "picture.png"
            code, errors, memory = run([program, "render", str(model), "-o", str(picture), "--resolution", "64,64"], SECONDS, temporary)
            peak[0] = max(peak[0], memory)
            left = [p.name for p in pathlib.Path(temporary).iterdir() if p != picture]
            wrong = keeps_rule(verdict, code, errors, picture.exists(), (source.name, model.name)) or (f"leaves {left} behind" if left else None)
            return f"{source.relative_to(folder)} ({verdict}): {wrong}" if wrong else None

    wrong = in_parallel(one, cases)
    if peak[0] > GIB * 1024 and not SANITIZED:
        wrong.append(f"a run took {peak[0]:.0f} MiB")
    print(f"{len(cases) - len(wrong)} of {len(cases)} hostile files keep the rule, most memory {peak[0]:.0f} MiB")
    return wrong + check_memory(program) if cases else ["no cases found"]


def gray_png(path, side, gray):
    """A picture of one gray, a few hundred kilobytes whatever its size."""
    packer, rows = zlib.compressobj(9), 100
    data = b"".join(packer.compress((b"\0" + bytes([gray]) * side) * rows) for _ in range(side // rows)) + packer.flush()

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, 0, 0, 0, 0)) + chunk(b"IDAT", data) + chunk(b"IEND", b""))


def gltf_of(nodes, images=0):
    """One triangle that `nodes` nodes show; with images, each in a mesh and a material of its own, all from one file."""
    triangle = base64.b64encode(struct.pack("<9f6f", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1)).decode()
    tree = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(nodes))}], "nodes": [{"mesh": i if images else 0} for i in range(nodes)],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}} | ({"material": i} if images else {})]} for i in range(images or 1)],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                          {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}],
            "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24}],
            "buffers": [{"byteLength": 60, "uri": "data:application/octet-stream;base64," + triangle}]}
    if images:
        tree |= {"images": [{"uri": "bomb.png"}] * images, "textures": [{"source": i} for i in range(images)],
                 "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": i}}} for i in range(images)]}
    return json.dumps(tree, separators=(",", ":"))


def grid_gltf(path, nodes, side, skins=0):
    """A height field of side * side vertices, without normals and texture coordinates, that `nodes` nodes show: beside one another, or with skins,
    as many as nodes, all at one place."""
    vertices = side * side
    positions = b"".join(struct.pack("<3f", x, y, (x * x + y) % 7 * 0.3) for y in range(side) for x in range(side))
    indices = b"".join(struct.pack("<6I", i, i + 1, i + side, i + 1, i + side + 1, i + side)
                       for y in range(side - 1) for i in range(y * side, y * side + side - 1))
    arrays = [(positions, "VEC3", 5126, vertices), (indices, "SCALAR", 5125, len(indices) // 4)]
    if skins:
        arrays += [(b"\0\0\0\0" * vertices, "VEC4", 5121, vertices), (struct.pack("<4f", 1, 0, 0, 0) * vertices, "VEC4", 5126, vertices)]
    starts = list(itertools.accumulate((len(data) for data, *_ in arrays), initial=0))
    placed = [{"mesh": 0, "skin": i} if skins else {"mesh": 0, "translation": [i * side, 0, 0]} for i in range(nodes)]
    tree = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(nodes + bool(skins)))}], "nodes": placed + [{}] * bool(skins),
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0} | ({"JOINTS_0": 2, "WEIGHTS_0": 3} if skins else {}), "indices": 1}]}],
            "accessors": [{"bufferView": i, "componentType": kind, "count": count, "type": shape} for i, (_, shape, kind, count) in enumerate(arrays)],
            "bufferViews": [{"buffer": 0, "byteOffset": start, "byteLength": len(data)} for start, (data, *_) in zip(starts, arrays)],
            "buffers": [{"byteLength": starts[-1], "uri": path.stem + ".bin"}]}
    tree["accessors"][0] |= {"min": [0, 0, 0], "max": [side - 1, side - 1, 1.8]}
    if skins:
        tree["skins"] = [{"joints": [nodes]}] * skins
    path.write_text(json.dumps(tree, separators=(",", ":")))
    path.with_suffix(".bin").write_bytes(b"".join(data for data, *_ in arrays))


def check_memory(program):
    """Small files that ask for much: at their peak they take what files may ask for and 200 MiB for the program at most."""
    # 200: a million meshes of one triangle also cost what malloc adds to each of their arrays, which nobody charges.
    seconds, most, million = 300, GIB * 1024 + 200, 1000000
    if SANITIZED:
        return []
    wrong = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        gray_png(folder / "gray.png", 16000, 128)
        gray_png(folder / "bomb.png", 2000, 200)
        (folder / "quad.mtl").write_text("newmtl m\nmap_Kd gray.png\n")
        quad_with_material(folder / "quad.mtl", folder)
        (folder / "images.gltf").write_text(gltf_of(120, 120))
        (folder / "nodes.gltf").write_text(gltf_of(million))
        (folder / "objects.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\n" + "o a\nf 1 2 3\n" * million)
        (folder / "few.gltf").write_text(gltf_of(20000))
        (folder / "models.scene.toml").write_text("[[model]]\nfile = 'few.gltf'\n" * 1000)
        (folder / "fewer_models.scene.toml").write_text("[[model]]\nfile = 'few.gltf'\n" * 270)
        (folder / "shapes.scene.toml").write_text("[[primitive]]\ntype = 'sphere'\nobjects = 1024\ntolerance = 0.001\n" * 4000)
        grid_gltf(folder / "grids.gltf", 1000, 300)
        grid_gltf(folder / "skins.gltf", 1000, 300, skins=1000)
        posing_files.targets(folder / "targets.glb", 10000, 2000)
        posing_files.targets(folder / "more_targets.glb", 3000, 20000)
        posing_files.targets(folder / "stacked_targets.glb", 4000, 1000, step=0)
        posing_files.targets(folder / "own_weights.glb", 2000, 1000, own_weights=True)
        posing_files.targets(folder / "moving_weights.glb", 8000, 2000, is_animated=True, has_normals=True)
        posing_files.skins(folder / "joints.glb", 200, 60000)
        posing_files.skins(folder / "other_joints.glb", 400, 30000, are_different=True)
        posing_files.instances(folder / "instances.glb", 1700000)
        posing_files.instances(folder / "fewer_instances.glb", 1300000)
        posing_files.instances(folder / "more_instances.glb", 2100000)
        for model, verbs in (("quad.obj", ("render",)), ("images.gltf", ("render",)), ("objects.obj", ("render", "inspect", "smooth")),
                             ("nodes.gltf", ("render", "inspect", "smooth")), ("models.scene.toml", ("check", "render")),
                             ("fewer_models.scene.toml", ("check", "inspect", "render --roughness 0.5")), ("shapes.scene.toml", ("check", "render")),
                             ("grids.gltf", ("render --uv box", "render --subdivide 1", "render --normals model", "inspect")),
                             ("skins.gltf", ("render", "smooth")), ("targets.glb", POSING), ("more_targets.glb", POSING), ("stacked_targets.glb", POSING), ("own_weights.glb", POSING),
                             ("moving_weights.glb", (*POSING, "render --animation-index 0 --animation-time 0.5", "render --engine gl --animation-index 0 --animation-time 0.5")),
                             ("joints.glb", POSING), ("other_joints.glb", POSING), ("fewer_instances.glb", ("explain --pixel 3,3", "stages")), ("instances.glb", (*POSING, "explain --pixel 3,3", "stages")),
                             ("more_instances.glb", (*POSING, "explain --pixel 3,3", "stages"))):
            for verb, *options in map(str.split, verbs):
                out = folder / ("out.png" if verb == "render" else "out" + pathlib.Path(model).suffix)
                options += {"render": ["-o", str(out), "--resolution", "64,64"], "smooth": ["-o", str(out)], "stages": ["-o", str(folder / "stages")]}.get(verb, [])
                code, errors, peak = run_alone([program, verb, str(folder / model), *options], seconds, folder)
                case = f"{verb} {model} {' '.join(o for o in options if o != str(out) and o != '-o')}"
                print(f"{case}: exit {code}, {peak:.0f} MiB")
                if code not in (0, 4):
                    wrong.append(f"{case}: exit {code}: {last_line(errors)}")
                if peak > most:
                    wrong.append(f"{case}: {peak:.0f} MiB are more than {most}")
    return wrong


def check_floods(program):
    wrong, peak = [], 0.0

    def spent_seconds():
        return sum(resource.getrusage(resource.RUSAGE_CHILDREN)[:2])  # of the processor: other work on the machine does not count

    def seconds_of(model, rule):
        nonlocal peak
        picture, before = model.with_suffix(".png"), spent_seconds()
        code, errors, memory = run([program, "render", str(model), "-o", str(picture), "--resolution", "64,64"], 120, model.parent)
        peak = max(peak, memory)
        broken = keeps_rule(rule, code, errors, picture.exists(), (model.name,))
        if broken:
            wrong.append(f"{model.name}: {broken}")
        return spent_seconds() - before

    with tempfile.TemporaryDirectory() as temporary:
        for kind, rule, plain, flood in name_floods.write(pathlib.Path(temporary)):
            usual, seconds = seconds_of(plain, rule), seconds_of(flood, rule)
            print(f"{name_floods.COUNT} names of {kind}: {usual:.2f} s, with one std::hash {seconds:.2f} s")
            if seconds > min(SECONDS, 2 * usual + 0.5) and not SANITIZED:
                wrong.append(f"{kind}: names of one hash take {seconds:.2f} s, plain names {usual:.2f} s")
    if peak > GIB * 1024 and not SANITIZED:
        wrong.append(f"a run took {peak:.0f} MiB")
    return wrong


def has_smoothing_groups(source):
    """They rule the first run and are gone in GLB and PLY; 3DS and ASE may always have them."""
    lines = source.read_bytes().splitlines() if source.suffix.lower() == ".obj" else []
    return source.suffix.lower() in (".3ds", ".ase") or any(line.split()[:1] == [b"s"] for line in lines)


def check_smooth(program, folder):
    def smooth(source, target, folder):
        code, errors, _ = run([program, "smooth", str(source), "-o", str(target)], SECONDS, folder)
        return (code, errors, keeps_rule(None, code, errors, target.exists(), (source.name,)))

    def one(task):
        source, ending = task
        name = f"{source.relative_to(folder)} to {ending}"
        with tempfile.TemporaryDirectory() as temporary:
            first, second = (pathlib.Path(temporary) / (n + ending) for n in ("first", "second"))
            code, errors, wrong = smooth(source, first, temporary)
            left = [p.name for p in pathlib.Path(temporary).rglob(".*")]
            if wrong or left or code:
                return f"{name}: {wrong}" if wrong else f"{name}: leaves {left} behind" if left else None
            again, errors, wrong = smooth(first, second, temporary)
            if wrong or again:
                return f"{name}: a second run: {wrong or last_line(errors)}"
            # Vertices at NaN become one when a PLY file is read: what is no place has no normal of its own.
            is_lost = ending != source.suffix.lower() and (has_smoothing_groups(source) or "vertices are not finite numbers" in errors)
            return None if is_lost or first.read_bytes() == second.read_bytes() else f"{name}: a second run changes it"

    def endings(source):
        own = source.suffix.lower()
        return {own if own in (".glb", ".gltf", ".obj") else ".glb", ".glb", ".ply"}

    tasks = [(p, e) for p in models_under(folder) for e in sorted(endings(p))]
    wrong = in_parallel(one, tasks)
    print(f"{len(tasks) - len(wrong)} of {len(tasks)} ways as expected")
    return wrong if tasks else ["no models found"]


def check_seams(program, folder):
    """A seam of s degrees turns the normals of one of its sides by s / 2 or more, and none by more than s. Normals that are zero or not finite are a
    fault at every limit; smooth makes them."""
    limits = (1, 5, 20)

    def rows(*command):
        done = subprocess.run([program, *map(str, command), "--json", "--quiet"], capture_output=True, text=True, stdin=subprocess.DEVNULL)
        return json.loads(done.stdout)["rows"] if done.returncode in (0, 5) else None

    def faults(model, temporary):
        first, second = (pathlib.Path(temporary) / (n + (model.suffix.lower() if model.suffix.lower() in (".gltf", ".obj") else ".glb"))
                         for n in ("first", "second"))
        before, smoothed = rows("inspect", model), rows("smooth", model, "-o", first)
        if before is None or smoothed is None:
            return  # refused
        seam, turned = before[0]["seams"]["seam_deg"], smoothed[0].get("seams", {"turned": None, "max_deg": None})
        gaps = before[0]["seams"]["missing_normals"]
        if turned["turned"] is not None and gaps > 0 and smoothed[0]["missing_made"] == 0:
            yield f"{gaps} normals are zero or not finite, but smooth makes none"
        for limit in limits:
            fails = bool(rows("inspect", model, "--check", "--max-seam", limit)[0]["check"]["failures"])
            if fails != (seam > limit or gaps > 0):
                yield f"--max-seam {limit} {'fails' if fails else 'passes'} at a seam of {seam}"
            if turned["turned"] is not None and seam > limit and not turned["max_deg"] > limit / 2.001:
                yield f"--max-seam {limit} fails ({seam}), but smooth turns {turned['turned']} normals by at most {turned['max_deg']}"
            if turned["turned"] and not fails and turned["max_deg"] > limit:
                yield f"--max-seam {limit} passes ({seam}), but smooth turns {turned['turned']} normals by up to {turned['max_deg']}"
        if rows("inspect", first, "--check", "--max-seam", 180)[0]["check"]["failures"]:
            yield "normals that are zero or not finite are left after smooth"
        left = rows("inspect", first)[0]["seams"]["seam_deg"]
        if left > 0.02:
            yield f"{left} degrees are left after smooth"
        rows("smooth", first, "-o", second)
        if turned["turned"] is not None and first.read_bytes() != second.read_bytes():
            yield "a second smooth changes it"

    def one(model):
        with tempfile.TemporaryDirectory() as temporary:
            return "; ".join(f"{model.relative_to(folder)}: {fault}" for fault in faults(model, temporary))

    models = models_under(folder)
    wrong = in_parallel(one, models)
    print(f"{len(models) - len(wrong)} of {len(models)} models agree")
    return wrong if models else ["no models found"]


def check_parts(program, folder):
    wrong, pairs = [], 0
    with tempfile.TemporaryDirectory() as temporary:
        def picture(model, scope):
            out = pathlib.Path(temporary) / "picture.png"
            code, errors, _ = run([program, "render", str(model), "-o", str(out), "--resolution", "480,480", "--normals", scope, "--crease-angle", "180"])
            if code:
                raise SystemExit(f"{model.name} {scope}: exit {code}: {last_line(errors)}")
            return read_rgb(out)[2]
        for whole in (p for p in models_under(folder) if "_whole." in p.name):
            reference = picture(whole, "model")
            for cut in sorted(whole.parent.glob(whole.name.split("_whole")[0] + "_*" + whole.suffix)):
                if cut == whole:
                    continue
                pairs += 1
                off = {s: sum(abs(a - b) > 1 for a, b in zip(reference, picture(cut, s))) / len(reference) for s in ("model", "object")}
                print(f"{cut.name}: values off by more than 1/255: model {off['model']:.4%}, object {off['object']:.4%}")
                if off["model"] > 5e-4:
                    wrong.append(f"{cut.name}: a seam shows though smoothed over the model")
                if off["object"] < 1e-3:
                    wrong.append(f"{cut.name}: no seam though smoothed per object: the comparison proves nothing")
    return wrong if pairs else ["no cut models found"]


def two_triangles(attributes):
    """A glTF of a bent sheet, so that smoothing splits vertices, whose primitive has many attributes of its own."""
    corners = struct.pack("<12f", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1) + struct.pack("<6H", 0, 1, 2, 0, 2, 3)
    return json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "buffers": [{"byteLength": len(corners), "uri": "data:application/octet-stream;base64," + base64.b64encode(corners).decode()}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 4, "min": [0, 0, 0], "max": [1, 1, 1]},
                      {"bufferView": 1, "componentType": 5123, "type": "SCALAR", "count": 6}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, **{f"_A{i}": 0 for i in range(attributes)}}, "indices": 1}]}]})


def check_growth(program):
    """Processor time at four times the size: 4 times as much when it is linear, 16 times when it is quadratic."""
    wrong = []
    with tempfile.TemporaryDirectory() as temporary:
        def seconds(count, *options):
            source = pathlib.Path(temporary) / "many.gltf"
            source.write_text(two_triangles(count))
            before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
            code, errors, _ = run([program, "smooth", str(source), "-o", str(source.with_name("smooth.glb")), *options], 100, temporary)
            if code:
                raise SystemExit(f"{count} attributes: exit {code}: {last_line(errors)}")
            return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        for what, options in (("kept vertices", ("--crease-angle", "180")), ("split vertices", ("--crease-angle", "30"))):
            few, many = seconds(20_000, *options), seconds(80_000, *options)
            print(f"smooth with 20,000 and 80,000 attributes, {what}: {few:.2f} and {many:.2f} s")
            if many > 8 * few + 0.5:
                wrong.append(f"smooth, {what}: {many / few:.1f} times the time for 4 times the attributes")
    return wrong


# The picture as displayed with all channels, then its linear floats with each way of lighting.
BITS_OPTIONS = (("--channels", "depth,normal,object,material"), ("--shading", "unlit"), ("--shading", "flat", "--normals", "model"),
                ("--shading", "gouraud", "--normals", "model"), ("--lighting", "phong", "--specular", "normalized", "--bump", "none"),
                ("--visibility", "painter", "--window", "33,21,200,180"))


def check_bits(program, *models):
    flags = set(pathlib.Path("/proc/cpuinfo").read_text().split())
    sets = ["scalar", "sse2"] + ["avx2"] * ("avx2" in flags) + ["avx512"] * ({"avx512f", "avx512bw", "avx512dq", "avx512vl", "avx512cd"} <= flags)
    qemu = shutil.which("qemu-x86_64")
    wrong = [] if qemu else ["qemu-x86_64 is not installed (Debian: qemu-user)"]
    with tempfile.TemporaryDirectory() as temporary:
        def picture(model, options, before, threads, **environment):
            """All files that render writes, or what went wrong."""
            folder = pathlib.Path(temporary) / "pictures"
            shutil.rmtree(folder, ignore_errors=True)
            folder.mkdir()
            code, errors, _ = run(before + [program, "render", str(model), "-o", str(folder / ("picture.png" if options == BITS_OPTIONS[0] else "picture.exr")), "--resolution", "320,240", "--threads", str(threads),
                                            *options], 300, **environment)
            return {p.name: p.read_bytes() for p in folder.iterdir()} if code == 0 else f"exit {code}: {last_line(errors)}"
        for model, options in itertools.product(map(pathlib.Path, models), BITS_OPTIONS):
            what = " ".join([model.name, *options])
            reference = picture(model, options, [], 1, RAKELIGHT_ISA="scalar")
            if isinstance(reference, str):
                wrong.append(f"{what}: {reference}")
                continue
            for isa, threads in itertools.product(sets, (1, 2, 4)):
                if picture(model, options, [], threads, RAKELIGHT_ISA=isa) != reference:
                    wrong.append(f"{what}: {isa} with {threads} threads differs from scalar with one")
            if qemu and picture(model, options, [qemu, "-cpu", "Nehalem"], 2) != reference:
                wrong.append(f"{what}: differs under qemu -cpu Nehalem")
    print(f"{len(models)} models x {len(BITS_OPTIONS)} ways to draw, {', '.join(sets)}, 1 / 2 / 4 threads, qemu -cpu Nehalem")
    return wrong


def main():
    checks = {"models": check_models, "hostile": check_hostile, "floods": check_floods, "smooth": check_smooth, "seams": check_seams, "parts": check_parts,
              "growth": check_growth, "bits": check_bits}
    if len(sys.argv) < (3 if sys.argv[1:2] in (["floods"], ["growth"]) else 4) or sys.argv[1] not in checks:
        sys.exit(__doc__)
    program, paths = str(pathlib.Path(sys.argv[2]).resolve()), [pathlib.Path(p) for p in sys.argv[3:]]
    if not all(p.exists() for p in paths):
        print(f"{paths[0]} is not there: skipped")
        sys.exit(77)
    wrong = checks[sys.argv[1]](program, *paths)
    print("\n".join(wrong))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
