# SPDX-License-Identifier: Apache-2.0
"""OBJ and MTL files of many names whose std::hash<std::string> in libstdc++ is one number, each beside a file of as many plain names.
A table keyed by std::hash takes time by the square of their number.

libstdc++ hashes a text by MurmurHash64A (Austin Appleby) with a fixed seed. The state goes through one reversible step for each
8 bytes, so for any first half of a name there is one second half that leads to a state chosen before."""
import random

COUNT = 50_000
WORD = (1 << 64) - 1
FACTOR, SEED = 0xC6A4A7935BD1E995, 0xC70F6907  # of libstdc++'s _Hash_bytes and std::hash
INVERSE = pow(FACTOR, -1, 1 << 64)
LENGTH = 16
GOAL = 0x0123456789ABCDEF  # the state after both halves, any number
FORBIDDEN = set(b'\0\t\n\v\f\r #"\\/:')  # would end the name, or be parts of a path


def folded(v):
    """v ^ v >> 47, which undoes itself."""
    return v ^ v >> 47


def spread(half):
    """What 8 bytes of text add to the state."""
    return folded(half * FACTOR & WORD) * FACTOR & WORD


def gathered(v):
    """The 8 bytes of text that add v: the inverse of spread()."""
    return folded(v * INVERSE & WORD) * INVERSE & WORD


def names_of_one_hash(count, letters=b"abcdefghijklmnopqrstuvwxyz0123456789"):
    choose, names, begin = random.Random(21), {}, SEED ^ (LENGTH * FACTOR & WORD)
    while len(names) < count:
        first = bytes(choose.choice(letters) for _ in range(8))
        state = (begin ^ spread(int.from_bytes(first, "little"))) * FACTOR & WORD
        second = gathered(state ^ GOAL).to_bytes(8, "little")
        if not FORBIDDEN & set(second):
            names[first + second] = None
    return list(names)


VERTICES, FACE = b"v 0 0 0\nv 1 0 0\nv 0 1 0\n", b"f 1 2 3\n"
KINDS = {  # what is named: the rule that a render keeps, and how the model is written; names in an MTL stand in models.mtl
    "groups": ("render", lambda names, mtl: VERTICES + b"".join(b"g " + n + b"\n" + FACE for n in names)),
    "usemtl": ("warn+render", lambda names, mtl: VERTICES + b"".join(b"usemtl " + n + b"\n" + FACE for n in names)),
    "newmtl": ("render", lambda names, mtl: b"mtllib " + mtl + b"\n" + VERTICES + FACE),
    "mtllib": ("warn+render", lambda names, mtl: b"".join(b"mtllib " + n + b"\n" for n in names) + VERTICES + FACE),
}


def write(folder, count=COUNT):
    """Writes all files. Yields what is named, the rule, the model of plain names and the one of hostile names."""
    sets = {"plain": [b"%016d" % i for i in range(count)], "flood": names_of_one_hash(count)}
    for how, names in sets.items():
        (folder / f"{how}.mtl").write_bytes(b"".join(b"newmtl " + n + b"\nKd 1 0 0\n" for n in names))
    for kind, (rule, text) in KINDS.items():
        models = []
        for how, names in sets.items():
            models.append(folder / f"{how}_{kind}.obj")
            models[-1].write_bytes(text(names, f"{how}.mtl".encode()))
        yield kind, rule, *models
