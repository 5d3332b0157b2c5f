#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the files of a wheel run on any Linux of the same machine with the glibc of its tag: shared libraries that such a system need not
have are copied beside them, under names of their own, and found from where they are. setup.py calls it. As a program: repair_wheel.py
--check WHEEL says what a wheel needs and fails where that is more than its tag promises. The policy is that of auditwheel's
manylinux_2_36, the oldest that there is, with a later glibc where the files ask for one. Needs patchelf, readelf, ldd."""
import argparse
import hashlib
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile

# What every system of the policy has.
ALLOWED = {"libc.so.6", "libm.so.6", "libdl.so.2", "librt.so.1", "libpthread.so.0", "libgcc_s.so.1", "libstdc++.so.6", "libresolv.so.2",
           "libutil.so.1", "libnsl.so.1", "ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1", "ld-linux-riscv64-lp64d.so.1"}
OLDEST = (2, 36)  # glibc of Debian 12
# The highest versions of symbols of the other libraries.
HIGHEST = {"GLIBCXX": (3, 4, 30), "CXXABI": (1, 3, 13), "GCC": (12, 0, 0)}


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def is_elf(path):
    with open(path, "rb") as file:
        return file.read(4) == b"\x7fELF"


def needed(path):
    """Names of libraries that a file asks for by itself."""
    return re.findall(r"\(NEEDED\).*\[(.+)\]", output("readelf", "-dW", str(path)))


def resolved(path):
    """{name: file} of all that the loader would load."""
    return dict(re.findall(r"^\s*(\S+) => (/\S+)", output("ldd", str(path)), re.MULTILINE))


def own_name(path):
    """A name that no other copy of the library in the same process has."""
    digest = hashlib.sha256(path.read_bytes()).hexdigest()[:8]
    stem, _, rest = path.name.partition(".so")
    return f"{stem}-{digest}.so{rest}"


def repair(package, libraries):
    """Copies what the ELF files of `package` need into `libraries`, a folder beside it, and lets all find it there."""
    files = [path for path in sorted(package.iterdir()) if path.is_file() and is_elf(path)]
    found = {}
    for path in files:
        found.update({name: file for name, file in resolved(path).items() if name not in ALLOWED})
    names = {name: own_name(pathlib.Path(file).resolve()) for name, file in found.items()}
    shutil.rmtree(libraries, ignore_errors=True)
    (libraries / "licenses").mkdir(parents=True)
    for name, file in found.items():
        copy = libraries / names[name]
        shutil.copy(file, copy)
        copy.chmod(0o755)
        copy_license(pathlib.Path(file), libraries / "licenses")
        patch(copy, "--set-soname", names[name])
        rename(copy, names, "$ORIGIN")
    for path in files:
        subprocess.run(["strip", "--strip-unneeded", str(path)], check=True)  # before: what patchelf moved it would break
        rename(path, names, f"$ORIGIN/../{libraries.name}")


def copy_license(library, folder):
    """What Debian says of a library's copyright."""
    for file in (library, library.resolve(), pathlib.Path("/usr") / library.relative_to("/")):
        owner = subprocess.run(["dpkg-query", "-S", str(file)], capture_output=True, text=True)
        if owner.returncode == 0:
            package = owner.stdout.split(":")[0]
            shutil.copy(f"/usr/share/doc/{package}/copyright", folder / package)
            return
    raise SystemExit(f"repair_wheel: no Debian package has {library}: its license is not known")


def patch(path, *arguments):
    subprocess.run(["patchelf", *arguments, str(path)], check=True)


def rename(path, names, place):
    """One change a run: patchelf 0.14 mixes up the strings of several."""
    for name in needed(path):
        if name in names:
            patch(path, "--replace-needed", name, names[name])
    patch(path, "--force-rpath", "--set-rpath", place)


def asked(path):
    """{(library's word, version)} of the symbols that a file wants: ("GLIBC", (2, 34))."""
    found = re.findall(r"Name: ([A-Z]+)_([0-9.]+)", output("readelf", "-VW", str(path)))
    return {(kind, tuple(map(int, number.split(".")))) for kind, number in found}


def platform_tag(folder):
    """The tag of a wheel with the files below a folder: "manylinux_2_36_x86_64"."""
    files = [path for path in pathlib.Path(folder).rglob("*") if path.is_file() and is_elf(path)]
    glibc = max([OLDEST, *(version[:2] for path in files for kind, version in asked(path) if kind == "GLIBC")])
    return f"manylinux_{glibc[0]}_{glibc[1]}_{platform.machine()}"


def glibc_of(wheel):
    """What a wheel's name promises; None: nothing."""
    tag = re.search(r"-manylinux_(\d+)_(\d+)_\w+\.whl$", pathlib.Path(wheel).name)
    return tag and (int(tag.group(1)), int(tag.group(2)))


def too_new(path, glibc):
    """Versions of symbols beyond the policy."""
    highest = {"GLIBC": glibc, **HIGHEST}
    return [f"{kind}_{'.'.join(map(str, version))}" for kind, version in sorted(asked(path))
            if kind in highest and version > highest[kind]]


def check(wheel):
    """What is wrong with a wheel, one line each."""
    faults = []
    glibc = glibc_of(wheel)
    if glibc is None:
        return ["its name has no tag manylinux_..."]
    with tempfile.TemporaryDirectory() as folder, zipfile.ZipFile(wheel) as archive:
        archive.extractall(folder)
        files = [path for path in sorted(pathlib.Path(folder).rglob("*")) if path.is_file() and is_elf(path)]
        held = {path.name for path in files}
        if not any(path.name.startswith("_core.") for path in files):
            faults.append("there is no extension")
        for path in files:
            name = path.relative_to(folder)
            faults += [f"{name}: {version} is too new" for version in too_new(path, glibc)]
            faults += [f"{name}: {library} is neither in the wheel nor on every system" for library in needed(path)
                       if library not in ALLOWED and library not in held]
            place = re.findall(r"\((?:RPATH|RUNPATH)\).*\[(.*)\]", output("readelf", "-dW", str(path)))
            faults += [f"{name}: looks for libraries in {p}" for p in place if not p.startswith("$ORIGIN")]
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", metavar="WHEEL", required=True)
    wheel = parser.parse_args().check
    faults = check(wheel)
    for fault in faults:
        print(f"{wheel}: {fault}", file=sys.stderr)
    return bool(faults)


if __name__ == "__main__":
    sys.exit(main())
