#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`rakelight --completion`: what bash, zsh and fish make of the scripts. A shell that is not installed is skipped.

  completion_test.py PROGRAM [unittest arguments]"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program

BASH = r"""
source "$1"
shift
COMP_WORDS=("$@")
COMP_CWORD=$(($# - 1))
_rakelight
printf '%s\n' "${COMPREPLY[@]}"
"""

# The same for many options at once: a line "VERB OPTION WORD..." each, of those that take one of some words.
BASH_WORDS = r"""
source "$1"
while read -r verb option; do
    COMP_WORDS=(rakelight "$verb" "$option" "") COMP_CWORD=3
    _rakelight 2>/dev/null
    printf '%s %s %s\n' "$verb" "$option" "${COMPREPLY[*]}"
done
"""

# Types of values that are no words of a list: numbers, files, names in the model, ...
OPEN_TYPES = {"N", "S", "F", "R", "A", "D", "B", "E", "G", "P", "T", "V", "X", "M", "PX", "DB", "EV", "DEG", "SIZE", "SHARE", "VALUE", "MIN,MAX", "W,H", "X,Y", "X,Y,Z", "X,Y,W,H", "A-B",
              "FILE", "DIR", "PICTURE", "PLACE", "COLOR", "SPEC", "KEY=VALUE", "NAME=VALUE", "AXIS"}
OPEN_OPTIONS = {"--scalars", "--animation-name", "--format"}  # names in the model, and endings of files
REFUSALS = r"unknown word|unknown channel|is not one of|is not built in"

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

    def test_words_of_options_that_are_no_settings(self):
        def check(offers):
            for words, first, other in ((("smooth", "--normals", "fl"), "flat", "seams"), (("smooth", "--scope", "ob"), "object", "model"),
                                        (("smooth", "--tangents", "al"), "always", "never"), (("render", "--engine", "so"), "soft", "auto")):
                found = offers(*words)
                self.assertIn(first, found)
                self.assertNotIn(other, found)

        self.in_all_shells(check)

    def test_words_behind_commas(self):
        def check(offers):
            for words, found in ((("bake", "--maps", "normal,hei"), "height"), (("render", "--channels", "depth,uv,over"), "overdraw"),
                                 (("compare", "--engines", "soft,so"), "soft")):
                self.assertIn(found, ",".join(offers(*words)).split(","))

        self.in_all_shells(check)

    def test_words_of_a_positional(self):
        self.write("scene.obj", program.SQUARE.format(name="a"))
        def check(offers):
            self.assertEqual({"smooth", "render", "pose"} - set(offers("bench", "")), set())
            found = offers("bench", "s")
            self.assertIn("smooth", found)
            self.assertNotIn("scene.obj", found)
            self.assertIn("scene.obj", offers("bench", "render", "sc"))

        self.in_all_shells(check)
        self.assertIn("render", self.offers_bash("bench", "--threads", "2", "re"))

    def test_shells(self):
        def check(offers):
            self.assertIn("fish", offers("--completion", "f"))

        self.in_all_shells(check)
        self.assertEqual(self.offers_bash("--completion", ""), ["bash", "zsh", "fish"])
        for offers in (self.offers_bash, self.offers_fish):
            self.assertIn("--completion", offers("--comp"))

    def test_words_of_two(self):
        def check(offers):
            found = offers("render", "--normal-map-green", "d")
            self.assertIn("down", found)

        self.in_all_shells(check)

    def test_files(self):
        self.write("model.obj", program.SQUARE.format(name="a"))
        def check(offers):
            self.assertIn("model.obj", offers("smooth", "mod"))
            for words in (("smooth", "-o"), ("smooth", "--preview"), ("bake", "-o"), ("render", "--output")):
                self.assertIn("model.obj", offers(*words, "mod"))

        self.in_all_shells(check)

    def test_numbers_are_not_guessed(self):
        self.write("16.obj", program.SQUARE.format(name="a"))
        def check(offers):
            self.assertNotIn("16.obj", offers("render", "--anisotropy", "1"))

        self.in_all_shells(check)

    def test_every_option_is_offered(self):
        """The table is the source: what the manual says of a verb, bash offers."""
        listed = {}
        for verb, row in self.option_rows():
            listed.setdefault(verb, set()).update(re.findall(r"--[a-z][-a-z0-9]*", row))
        self.assertGreater(len(listed), 10)
        for name, options in listed.items():
            self.assertLessEqual(options, set(self.offers_bash(name, "--")), name)

    def option_rows(self):
        """(verb, "-o, --output FILE") of each option of each verb, as the man page has them."""
        verb = ""
        for line in self.fine("--man").out.replace("\\-", "-").splitlines():
            verb = line.removeprefix(".SH rakelight ") if line.startswith(".SH ") else verb
            if line.startswith(".B -"):
                yield verb, line[3:]

    def options_with_types(self):
        """(verb, "--option", type) of each option that takes a value, as the man page says."""
        for verb, text in self.option_rows():
            row = re.fullmatch(r"(?:-\w, )?(--[-a-z0-9]+)(?:, --[-a-z0-9]+)? ([^ \[]+)", text)
            if row:
                yield verb, row[1], row[2]

    def words_of_options(self):
        """{(verb, option): words that bash offers}"""
        options = [(verb, option) for verb, option, _ in self.options_with_types()]
        lines = "".join(f"{verb} {option}\n" for verb, option in options)
        done = subprocess.run(["bash", "-c", BASH_WORDS, "bash", self.script("bash")], cwd=self.folder, input=lines, capture_output=True, text=True, timeout=120,
                              check=True)
        offered = [line.split() for line in done.stdout.splitlines()]
        files = set(os.listdir(self.folder))
        return {(verb, option): [word for word in words if word not in files] for verb, option, *words in offered}

    def test_every_option_of_words_has_its_words(self):
        words = self.words_of_options()
        self.assertGreater(len(words), 300)
        for verb, option, kind in self.options_with_types():
            if kind not in OPEN_TYPES and option not in OPEN_OPTIONS:
                self.assertGreater(len(words[verb, option]), 1, f"{verb} {option} {kind} offers no words")
        for verb, option in (("smooth", "--normals"), ("smooth", "--scope"), ("smooth", "--tangents"), ("bake", "--maps"), ("render", "--engine"),
                             ("compare", "--engines"), ("bench", "--order"), ("render", "--ref-measure")):
            self.assertGreater(len(words[verb, option]), 1, (verb, option))

    def test_every_word_is_one_that_the_program_takes(self):
        """A word is refused before the missing model is; a word that nobody has is refused where the others are not."""
        small = ("smooth", "--triangles", "100")
        arguments = {"render": ("a.obj", "-o", "b.png"), "bench": {"--engine": ("render",), "--order": small, "--with": small}, "bake": ("a.obj", "b.obj", "-o", "{map}.png"),
                     "smooth": ("a.obj", "-o", "a.glb"), "convert": ("a.obj", "-o", "a.glb"), "compare": ("a.png", "b.png", "-o", "c.png"), "stages": ("a.obj", "-o", "pages"),
                     "radiosity": ("a.obj", "-o", "a.glb"), "explain": ("a.obj", "--pixel", "1,1")}
        seen = set()
        for (verb, option), words in self.words_of_options().items():
            if not words or verb == "view" or (option, *words) in seen:
                continue
            seen.add((option, *words))
            own = arguments.get(verb, ("a.obj",))
            own = own.get(option, ("render", "a.obj")) if isinstance(own, dict) else own
            own += ("--ref", "b.png") if option == "--ref-measure" else ()
            before = ""
            if option == "--engines":  # it takes two or more
                own, before = ("a.obj",), "soft,"
            for word in words:
                result = self.run_program(verb, *own, option, before + word)
                self.assertNotRegex(result.err, REFUSALS, (verb, option, word))
            refused = self.run_program(verb, *own, option, before + "nobody-has-this")
            self.assertEqual(refused.code, 2, (verb, option, refused.err))
            self.assertRegex(refused.err, REFUSALS, (verb, option))
        self.assertGreater(len(seen), 40)

    def test_no_description_is_cut_in_parentheses(self):
        for shell, start in (("zsh", "        '"), ("fish", "complete ")):
            lines = [line for line in self.fine("--completion", shell).out.splitlines() if line.startswith(start)]
            self.assertGreater(len(lines), 200, shell)
            for line in lines:
                self.assertEqual(line.count("("), line.count(")"), line)

    def test_a_shell_that_is_not_known(self):
        for words in (["tcsh"], [], ["bash", "zsh"]):
            result = self.run_program("--completion", *words)
            self.assertEqual((result.code, len(result.lines)), (2, 1))
            self.assertIn("bash, zsh", result.err)


if __name__ == "__main__":
    program.main()
