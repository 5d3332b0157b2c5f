# SPDX-License-Identifier: Apache-2.0
"""What the entries share: the program run from outside, its pictures, and the numbers of its JSON. Only the standard library is needed."""
import dataclasses
import json
import math
import pathlib
import subprocess
import typing

from png8 import read_rgb
from sheet import ROOT, write_sheet

PLAIN = ("--look", "plain")


@dataclasses.dataclass(frozen=True)
class Entry:
    """One figure, claim or table."""
    name: str
    source: str  # where it stands: S1 Mileff, S2 Ban, S3 Jez
    claim: str
    measure: typing.Callable  # (kit) -> {what: number}
    draw: typing.Callable | None = None  # (kit, path): writes the picture
    timed: typing.Callable | None = None  # (kit) -> {what: number} that no range holds


@dataclasses.dataclass
class Picture:
    width: int
    height: int
    pixels: bytes

    def at(self, x, y):
        """RGB codes at a place from 0 to 1, y down."""
        i = 3 * (min(self.height - 1, int(y * self.height)) * self.width + min(self.width - 1, int(x * self.width)))
        return tuple(self.pixels[i:i + 3])

    def part(self, x0, y0, x1, y1):
        """RGB codes of a part, its borders from 0 to 1."""
        left, right = round(x0 * self.width), round(x1 * self.width)
        rows = range(round(y0 * self.height), round(y1 * self.height))
        return [self.pixels[i:i + 3] for y in rows for i in range(3 * (y * self.width + left), 3 * (y * self.width + right), 3)]

    def mean(self, *borders):
        """Mean code of a part."""
        pixels = self.part(*borders)
        return sum(map(sum, pixels)) / 3 / len(pixels)


class Failure(Exception):
    """A run of the program ended as it should not."""


class Kit:
    """Runs of the program for one entry. `scale` makes its pictures smaller: 1 for the page, less in the tests."""

    def __init__(self, program, folder, scale=1.0):
        self.program, self.folder, self.scale = pathlib.Path(program).resolve(), pathlib.Path(folder).resolve(), scale
        self.is_small = scale < 1
        self.made = {}

    def size(self, width, height):
        return max(24, round(width * self.scale)), max(24, round(height * self.scale))

    def run(self, *words, codes=(0,)):
        done = subprocess.run([str(self.program), *map(str, words)], cwd=ROOT, capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=900)
        if done.returncode not in codes:
            raise Failure(f"rakelight {' '.join(map(str, words))}: exit code {done.returncode}: {done.stderr.strip()}")
        return done

    def row(self, *words):
        """First row of what the program says in JSON."""
        return json.loads(self.run(*words, "--json").stdout)["rows"][0]

    def render(self, arguments, width=320, height=240):
        """(path of the picture, row of its JSON, what was said on standard error); drawn once."""
        key = (tuple(map(str, arguments)), width, height)
        if key not in self.made:
            path = self.folder / f"{len(self.made)}.png"
            size = ",".join(map(str, self.size(width, height)))
            done = self.run("render", *arguments, *(() if "--look" in arguments else PLAIN), "--resolution", size, "-o", path, "--json")
            self.made[key] = path, json.loads(done.stdout)["rows"][0], done.stderr
        return self.made[key]

    def picture(self, arguments, width=320, height=240):
        return Picture(*read_rgb(self.render(arguments, width, height)[0]))

    def stats(self, arguments, width=320, height=240):
        return self.render(arguments, width, height)[1]["stats"]

    def channel(self, arguments, name, width=320, height=240):
        """Path of a data channel as a picture for the eye."""
        path = self.render((*arguments, "--channels", name, "--channel-files", "png"), width, height)[0]
        return path.with_name(f"{path.stem}.{name}.png")

    def compare(self, one, other, width=320, height=240, tolerance="0"):
        """Row of `compare`; one and other are arguments of render, or paths."""
        paths = [p if isinstance(p, pathlib.Path) else self.render(p, width, height)[0] for p in (one, other)]
        return self.row("compare", *paths, "--tolerance", tolerance)

    def rmse(self, one, other, width=320, height=240):
        """[1/255] root of the mean square difference."""
        return 255 * self.compare(one, other, width, height)["rmse"]

    def differing(self, one, other, width=320, height=240, codes=2):
        """[%] of the pixels that differ by more than so many codes."""
        return 100 * self.compare(one, other, width, height, f"{codes}/255")["differing_share"]

    def explain(self, arguments, places, width=320, height=240):
        """Rows of `explain` for places from 0 to 1, y down."""
        w, h = self.size(width, height)
        words = [word for x, y in places for word in ("--pixel", f"{int(x * w)},{int(y * h)}")]
        return json.loads(self.run("explain", *arguments, *PLAIN, "--resolution", f"{w},{h}", *words, "--json").stdout)["rows"]

    def stages(self, arguments, width=320, height=240):
        """Folder of `stages`, and a reader of a stage's table."""
        key = ("stages", tuple(map(str, arguments)), width, height)
        if key not in self.made:
            self.made[key] = self.folder / f"stages{len(self.made)}"
            self.run("stages", *arguments, *PLAIN, "--resolution", ",".join(map(str, self.size(width, height))), "-o", self.made[key])
        folder = self.made[key]
        return folder, lambda stage: json.loads((folder / f"{stage}.json").read_text())

    def sheet(self, path, rows, width, height, colors=128, **words):
        """write_sheet() with the plain look for what is rendered; colors: of the palette, so that sheets are small."""
        def plain(part):
            if isinstance(part, (str, pathlib.Path)):
                return str(part)
            if isinstance(part[0], tuple):
                return (plain(part[0]), plain(part[1]), part[2])
            return (*map(str, part), *(() if "--look" in part else PLAIN))
        write_sheet(path, [[plain(part) for part in row] for row in rows], width, height, self.program, 4, colors=colors, **words)


def detail(picture, width):
    """What a picture has beyond its mean over 5 pixels of a row: bumps, not the shape below them."""
    return [picture[i] - sum(picture[i - 2:i + 3]) / 5 for i in range(2, len(picture) - 2) if 2 <= i % width < width - 2]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def unit(a):
    length = math.sqrt(dot(a, a))
    return [x / length for x in a]


def angle(a, b):
    """[degrees] between two directions."""
    return math.degrees(math.atan2(math.sqrt(dot(cross(a, b), cross(a, b))), dot(a, b)))


def linear(code):
    """Light of a code from 0 to 255 (IEC 61966-2-1)."""
    value = code / 255
    return value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4


def brightness(color):
    """Relative luminance of linear RGB (ITU-R BT.709)."""
    return dot((0.2126, 0.7152, 0.0722), color[:3])
