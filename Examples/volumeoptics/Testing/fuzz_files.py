# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

"""fuzz_files.py PROGRAM BLOB: mutations of good files. Whatever a file has become, the program ends in 0 without
a complaint, or in one line of error, exit code 1 and no output file. A failing seed is printed; --seed SEED
--count 1 --keep FILE replays it and keeps the file.
"""

import argparse
import os
import random
import re
import sys
import time

import files
from broken_files import make_voxels
from run_files import Judge, commands_for

NUMBERS = [b"0", b"-1", b"1", b"7", b"255", b"65536", b"2147483647", b"-2147483648", b"4294967295",
           b"9223372036854775807", b"1e39", b"nan", b"inf", b"-0.0", b"1e-320", b"", b"x"]


def flip_bits(data, chance):
    for _ in range(chance.randint(1, 8)):
        at = chance.randrange(len(data))
        data[at] ^= 1 << chance.randrange(8)


def set_bytes(data, chance):
    at = chance.randrange(len(data))
    data[at:at + chance.choice([1, 2, 4, 8])] = chance.choice([b"\0", b"\xff", b"\x7f", b"\x80"]) * 4


def cut(data, chance):
    del data[chance.randrange(len(data)):]


def remove(data, chance):
    at = chance.randrange(len(data))
    del data[at:at + chance.randint(1, 64)]


def double(data, chance):
    at = chance.randrange(len(data))
    data[at:at] = data[at:at + chance.randint(1, 64)] * chance.randint(1, 50)


def replace_number(data, chance):
    """Of the text at the beginning, most often."""
    numbers = list(re.finditer(rb"-?[0-9][0-9.e+-]*", bytes(data[:chance.choice([512, 4096])])))
    if numbers:
        begin, end = chance.choice(numbers).span()
        data[begin:end] = chance.choice(NUMBERS)


MUTATIONS = [flip_bits, set_bytes, cut, remove, double, replace_number, replace_number, replace_number]


def mutated(content, chance):
    data = bytearray(content)
    for _ in range(chance.choice([1, 1, 2, 4])):
        if data:
            chance.choice(MUTATIONS)(data, chance)
    return bytes(data)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("blob")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=10**9, help="at most so many files")
    parser.add_argument("--seconds", type=float, default=1e9, help="begin none after so long")
    parser.add_argument("--keep", help="write the last file")
    options = parser.parse_args()
    options.blob = os.path.abspath(options.blob)
    judge = Judge(options.program)
    good = {**files.good_files(), "voxels.vti": make_voxels(judge, options.blob)}
    begin = time.monotonic()
    for seed in range(options.seed, options.seed + options.count):
        if time.monotonic() - begin > options.seconds:
            break
        chance = random.Random(seed)
        name = chance.choice(sorted(good))
        content = mutated(good[name], chance)
        if options.keep:
            with open(options.keep, "wb") as file:
                file.write(content)
        # that without a window is ten times as fast, and the reader is the same
        commands = commands_for(name, options.blob)
        which = 1 if chance.random() < 0.05 and len(commands) > 1 else 0
        judge.expect(None, f"seed {seed}", name, content, commands[which])
    print(f"{judge.runs} runs, {judge.failures} failures")
    return 1 if judge.failures else 0


if __name__ == "__main__":
    sys.exit(main())
