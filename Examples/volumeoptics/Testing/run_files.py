# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

"""Gives volumeoptics files and judges how it ends."""

import os
import pathlib
import subprocess
import tempfile

SECONDS = 30  # no file may keep the program longer
# By the address sanitizer, which ends a program where the C++ library throws: nothing can be told of what comes then.
REFUSED = "AddressSanitizer: requested allocation size"
PICTURE = ["--headless", "--size", "16x16"]


class Judge:
    """Runs the program in an empty folder, to which a file may neither add nor write beside it."""

    def __init__(self, program):
        self.program = str(pathlib.Path(program).resolve())
        self.root = tempfile.TemporaryDirectory(prefix="volumeoptics-files-")
        self.failures = 0
        self.runs = 0

    def run(self, name, content, arguments):
        """arguments: FILE and OUT stand for the file and for the folder that must stay empty after an error.
        Returns the exit code and what is wrong, or None."""
        with tempfile.TemporaryDirectory(dir=self.root.name) as folder:
            file = pathlib.Path(folder, name)
            file.write_bytes(content)
            out = pathlib.Path(folder, "out")
            out.mkdir()
            words = [word.replace("FILE", str(file)).replace("OUT", str(out)) for word in arguments]
            before = self.listing()
            environment = {key: value for key, value in os.environ.items() if key != "DISPLAY"}
            # VTK's readers leave behind what they hold when an exception comes through them
            environment["ASAN_OPTIONS"] = environment.get("ASAN_OPTIONS", "") + ":detect_leaks=0"
            try:
                done = subprocess.run([self.program, "-q", *words], capture_output=True, cwd=out,
                                      timeout=SECONDS, env=environment, check=False)
            except subprocess.TimeoutExpired:
                return None, f"runs for more than {SECONDS} s"
            self.runs += 1
            return done.returncode, self.fault(done, before)

    def listing(self):
        return sorted(str(path) for path in pathlib.Path(self.root.name).rglob("*") if not path.is_dir())

    def fault(self, done, before):
        lines = done.stderr.decode(errors="replace").splitlines()
        if any(REFUSED in line for line in lines):
            return None
        if done.returncode == 0:
            return f"complains: {lines[0]}" if lines else None
        if done.returncode != 1:
            return f"exit code {done.returncode}, {lines[:3]}"
        if len(lines) != 1 or not lines[0].startswith("volumeoptics: "):
            return f"{len(lines)} lines of error: {lines[:4]}"
        left = [path for path in self.listing() if path not in before]
        return f"leaves {left}" if left else None

    def expect(self, code, title, name, content, arguments):
        result, fault = self.run(name, content, arguments)
        if fault is None and code is not None and result != code:
            fault = f"exit code {result} instead of {code}"
        if fault is not None:
            self.failures += 1
            print(f"FAILED {title} [{' '.join(arguments)}]: {fault}", flush=True)
        return fault is None


def commands_for(name, blob):
    """Every subcommand that reads files of this kind."""
    if name.endswith(".json"):
        option = "--lighting" if "lighting" in name else "--transfer-function"
        return [["render", blob, *PICTURE, option, "FILE", "-o", "OUT/a.png"],
                ["editor", blob, *PICTURE, option, "FILE", "-o", "OUT/a.png", "--write-lighting", "OUT/a.json"]]
    if name.endswith(".vtp") or name.startswith("voxels"):
        return [["lines", "FILE", *PICTURE, "--grid", "8", "-o", "OUT/a.png", "--voxels", "OUT/a.vti"]]
    commands = [["info", "FILE"], ["render", "FILE", *PICTURE, "-o", "OUT/a.png"],
                ["editor", "FILE", *PICTURE, "-o", "OUT/a.png"],
                ["trade", "covariance", "FILE", "-o", "OUT/trade"]]
    if name.endswith(".inv3"):
        commands += [["gallery", "--headless", "--only", "ranium", "--without-scores", "--cranium", "FILE", "-o",
                      "OUT/gallery"],
                     ["trade", "table", "--headless", "--cranium", "FILE", "-o", "OUT/trade"],
                     ["trade", "visibility", "--headless", "--field", "cranium", "--cranium", "FILE", "-o",
                      "OUT/trade"]]
    return commands
