#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`rakelight --completion`: what bash, zsh and fish make of the scripts. A shell that is not installed is skipped.

  completion_test.py PROGRAM [unittest arguments]"""
import os
import re
import shutil
import subprocess
import unittest

import program

BASH = r"""
source "$1"
shift
COMP_WORDS=("$@")
COMP_CWORD=$(($# - 1))
_rakelight
printf '%s\n' "${COMPREPLY[@]}"
"""

# A terminal in which a shell runs, as completion is a matter of its line editor.
ZSH = r"""
zmodload zsh/zpty
zpty shell zsh -f -i
zpty -w shell "PS1='READY '; autoload -Uz compinit; compinit -u -D; source $1; zstyle ':completion:*' list-grouped false; LISTMAX=10000; bindkey '^I' list-choices; stty columns 1000 rows 1000; COLUMNS=1000; LINES=1000; print begun"
zpty -r -m shell line '*begun*READY*'
zpty -w -n shell "$2"$'\t'
zpty -w -n shell $'\x01print end; \x05\x15print fin\x0a'
while zpty -r shell line; do print -r -- "$line"; [[ $line == *fin* ]] && ((++count >= 2)) && break; done
zpty -d shell
"""


class Completion(program.Case):
    def fine(self, *arguments):
        result = self.run_program(*arguments)
        self.assertEqual((result.code, result.err), (0, ""))
        return result

    def script(self, shell):
        if not shutil.which(shell):
            self.skipTest(shell + " is not installed")
        path = self.folder / ("rakelight." + shell)
        path.write_text(self.fine("--completion", shell).out)
        return path

    def run_shell(self, *command):
        done = subprocess.run(command, cwd=self.folder, capture_output=True, text=True, timeout=120, check=False,
                              env={**os.environ, "HOME": str(self.folder), "TERM": "dumb", "LC_ALL": "C.UTF-8"})
        self.assertEqual(done.stderr, "", command)
        return done.stdout

    def offers_bash(self, *words):
        script = self.script("bash")
        return self.run_shell("bash", "-c", BASH, "bash", script, "rakelight", *words).split()

    def offers_fish(self, *words):
        script = self.script("fish")
        text = self.run_shell("fish", "--no-config", "-c", f"source {script}; complete -C 'rakelight {' '.join(words)}'")
        return [line.split("\t")[0] for line in text.splitlines()]

    def offers_zsh(self, *words):
        script = self.script("zsh")
        text = self.run_shell("zsh", "-f", "-c", ZSH, "zsh", str(script), "rakelight " + " ".join(words))
        return re.findall(r"[-\w.=/]+", text.split("begun")[-1])

    def in_all_shells(self, check):
        """check(offers), where offers(words...) are what the shell offers for the last word."""
        for shell, offers in (("bash", self.offers_bash), ("zsh", self.offers_zsh), ("fish", self.offers_fish)):
            with self.subTest(shell=shell):
                check(offers)

    def test_verbs(self):
        def check(offers):
            found = offers("s")
            self.assertIn("smooth", found)
            self.assertIn("stages", found)
            self.assertNotIn("inspect", found)

        self.in_all_shells(check)

    def test_options_of_a_verb(self):
        def check(offers):
            found = offers("inspect", "--ch")
            self.assertIn("--check", found)
            self.assertNotIn("--channels", found)

        self.in_all_shells(check)

    def test_options_behind_a_model_are_those_of_render(self):
        self.write("a.obj", program.SQUARE.format(name="a"))
        def check(offers):
            found = offers("a.obj", "--chan")
            self.assertIn("--channels", found)
            self.assertIn("--channel-files", found)

        self.in_all_shells(check)

    def test_words_of_a_setting(self):
        def check(offers):
            found = offers("render", "--lighting", "oren")
            self.assertIn("oren-nayar", found)
            self.assertIn("oren-nayar-full", found)
            self.assertNotIn("ward", found)

        self.in_all_shells(check)

    def test_words_of_a_type(self):
        def check(offers):
            found = offers("render", "--normal-map-green", "d")
            self.assertIn("down", found)

        self.in_all_shells(check)

    def test_files(self):
        self.write("model.obj", program.SQUARE.format(name="a"))
        def check(offers):
            self.assertIn("model.obj", offers("smooth", "mod"))
            self.assertIn("model.obj", offers("smooth", "-o", "mod"))

        self.in_all_shells(check)

    def test_numbers_are_not_guessed(self):
        self.write("16.obj", program.SQUARE.format(name="a"))
        def check(offers):
            self.assertNotIn("16.obj", offers("render", "--anisotropy", "1"))

        self.in_all_shells(check)

    def test_every_option_is_offered(self):
        """The table is the source: what --markdown says of a verb, bash offers."""
        verb, listed = "", {}
        for line in self.fine("--markdown").out.splitlines():
            verb = line[3:] if line.startswith("## ") else verb
            if line.startswith("| `-"):
                listed.setdefault(verb, set()).update(re.findall(r"--[a-z][-a-z0-9]*", line.split("` |")[0]))
        self.assertGreater(len(listed), 10)
        for name, options in listed.items():
            self.assertLessEqual(options, set(self.offers_bash(name, "--")), name)

    def test_a_shell_that_is_not_known(self):
        for words in (["tcsh"], [], ["bash", "zsh"]):
            result = self.run_program("--completion", *words)
            self.assertEqual((result.code, len(result.lines)), (2, 1))
            self.assertIn("bash, zsh", result.err)


if __name__ == "__main__":
    program.main()
