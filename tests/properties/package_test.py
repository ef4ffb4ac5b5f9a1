#!/usr/bin/env python3
"""The Debian package has all that it should, and installs, works and is removed on a Debian that has nothing else.

The long test needs root, debootstrap and Debian's mirror. CITYKILN_ROOT names a folder made by debootstrap to copy instead.
"""
import json
import os
import re
import shutil
import subprocess
import unittest
from pathlib import Path

from citykiln_program import PROGRAM, ROOT, ProgramTest, long_test, run

BUILD = Path(PROGRAM).parent
# the verbs of the help
VERBS = re.findall(r"^  ([a-z]+) {2,}", run("--help").stdout.partition("Subcommands:")[2], re.MULTILINE)


def call(*words, **options):
    return subprocess.run([str(word) for word in words], check=True, capture_output=True, text=True, **options).stdout


def flags_in_help(verb):
    names = ",".join(re.findall(r"^  (-\S+)", run(verb, "--help").stdout, re.MULTILINE)).split(",")
    return {name for name in names if name.startswith("--")}


class Package(ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        if not all(map(shutil.which, ("cpack", "dpkg-deb", "dpkg-shlibdeps", "file"))):
            raise unittest.SkipTest("dpkg-dev or file is missing")
        folder = Path(cls.shared_scratch.name)
        call("cpack", "-G", "DEB", "--config", BUILD / "CPackConfig.cmake", "-B", folder)
        (cls.package,) = folder.glob("citykiln_*.deb")
        cls.content = folder / "content"
        call("dpkg-deb", "-x", cls.package, cls.content)

    def field(self, name):
        return call("dpkg-deb", "-f", self.package, name)

    def test_has_program_modules_pages_and_examples(self):
        share = self.content / "usr/share"
        for path in ["usr/bin/citykiln", "usr/libexec/citykiln/citykiln_gdal.so", "usr/libexec/citykiln/citykiln_image.so",
                     "usr/share/man/man1/citykiln.1.gz", "usr/share/bash-completion/completions/citykiln",
                     "usr/share/doc/citykiln/copyright", "usr/share/doc/citykiln/changelog.gz",
                     "usr/share/citykiln/examples/town/town.osm", "usr/share/citykiln/godot3/addons/citykiln/plugin.cfg",
                     "usr/share/citykiln/godot4/addons/citykiln/plugin.cfg"]:
            self.assertTrue((self.content / path).is_file(), path)
        self.assertEqual([path for path in share.rglob("*") if path.is_dir() and not any(path.iterdir())], [], "no empty folders")

    def test_has_the_add_on_if_the_source_has_it(self):
        source = ROOT / "exporters/blender/citykiln/__init__.py"
        self.assertEqual(source.exists(), (self.content / "usr/share/citykiln/blender/citykiln.zip").exists())

    def test_the_town_names_its_installed_files(self):
        spec = json.loads((self.content / "usr/share/citykiln/examples/town/spec.json").read_text())
        self.assertEqual(spec["map"], "/usr/share/citykiln/examples/town/town.osm")
        for path in (spec["map"], spec["dem"].split(",")[0]):
            self.assertTrue((self.content / path[1:]).is_file(), path)

    def test_depends_on_the_libraries_of_program_and_modules(self):
        depends = self.field("Depends")
        for library in ("libc6", "libgdal32", "libopenimageio2.4", "libembree3-3"):
            self.assertIn(library, depends)
        self.assertNotIn("-dev", depends)

    def test_the_manual_page_has_every_option_of_every_verb(self):
        page = call("gzip", "-dc", self.content / "usr/share/man/man1/citykiln.1.gz").replace("\\-", "-")
        for verb in VERBS:
            section = page[page.index(f".SS citykiln {verb}\n"):]
            section = section[:section.index("\n.S", 4)]
            flags = flags_in_help(verb) - {"--help", "--json", "--quiet"}
            self.assertEqual([flag for flag in flags if f"\\fB{flag}\\fR" not in section], [], verb)
        for shared in ("--help", "--json", "--quiet"):
            self.assertIn(f"\\fB{shared}\\fR", page)

    def test_every_verb_has_a_manual_page_of_its_own(self):
        folder = self.content / "usr/share/man/man1"
        self.assertEqual({path.name for path in folder.iterdir()},
                         {"citykiln.1.gz"} | {f"citykiln-{verb}.1.gz" for verb in VERBS})
        for verb in VERBS:
            page = call("gzip", "-dc", folder / f"citykiln-{verb}.1.gz").replace("\\-", "-")
            self.assertIn(f".SH NAME\ncitykiln-{verb} - ", page)
            self.assertEqual([flag for flag in flags_in_help(verb) if f"\\fB{flag}\\fR" not in page], [], verb)

    def completed(self, *words):
        """The words that bash offers for the last one."""
        script = self.content / "usr/share/bash-completion/completions/citykiln"
        given = " ".join(f"'{word}'" for word in words)
        return call("bash", "-c", f". {script}; COMP_WORDS=({given}); COMP_CWORD={len(words) - 1}; _citykiln; "
                                  'printf "%s\\n" "${COMPREPLY[@]}"').split()

    def test_bash_completes_verbs_flags_and_values(self):
        self.assertEqual(self.completed("citykiln", "com"), ["compile"])
        self.assertEqual(self.completed("citykiln", "compile", "--targ"), ["--target"])
        self.assertEqual(self.completed("citykiln", "compile", "--compress", "d"), ["draco"])
        self.assertGreater(len(VERBS), 9)
        for verb in VERBS:
            self.assertEqual(set(self.completed("citykiln", verb, "--")), flags_in_help(verb))

    def test_bash_completes_lists_names_of_views_and_words_by_place(self):
        self.assertEqual(self.completed("citykiln", "compile", "--emit", "3"), ["3dtiles", "3tz"])
        self.assertEqual(self.completed("citykiln", "compile", "--emit", "kiln,gl"), ["kiln,glb"])
        self.assertEqual(self.completed("citykiln", "preview", "--view", "s"), ["street", "south", "square", "skyline"])
        self.assertEqual(self.completed("citykiln", "addon", ""), ["blender"])
        self.assertEqual(self.completed("citykiln", "compile", "--compress", "none,d"), [], "one value, no list")
        self.assertEqual(self.completed("citykiln", "compile", "--bbox", "W"), [], "names of numbers are no values")

    def test_hidden_verbs_are_in_no_list(self):
        self.assertNotRegex(run("--help").stdout, r"\n\s+(man|completion)\b")
        self.assertNotIn("completion", run("compil").stderr)

    @unittest.skipUnless(shutil.which("lintian"), "lintian is missing")
    def test_lintian_finds_no_error(self):
        found = subprocess.run(["lintian", "--allow-root", str(self.package)], capture_output=True, text=True, check=False).stdout
        allowed = {"initial-upload-closes-no-bugs"}  # no upload to Debian is meant
        tags = re.findall(r"^[EW]: citykiln: (\S+)", found, re.MULTILINE)
        self.assertEqual([tag for tag in tags if tag not in allowed], [], found)

    @long_test
    @unittest.skipUnless(os.geteuid() == 0 and shutil.which("debootstrap"), "needs root and debootstrap")
    def test_installs_works_and_is_removed_on_a_bare_debian(self):
        bare = Path(self.folder) / "bare"
        made = os.environ.get("CITYKILN_ROOT")
        if made:
            call("cp", "-a", made, bare)
        else:
            call("debootstrap", "--variant=minbase", "bookworm", bare, "http://deb.debian.org/debian")
        shutil.copy(self.package, bare / "tmp/citykiln.deb")

        def inside(command):
            # a PID namespace of its own has a /proc of its own, which ends with it
            return call("unshare", "--mount", "--pid", "--fork", "chroot", bare, "sh", "-ec",
                        f"mount -t proc proc /proc; export DEBIAN_FRONTEND=noninteractive; {command}")

        packages = "dpkg-query -W -f '${Package} ${db:Status-Abbrev}\\n'"
        before = inside(packages)
        inside("apt-get update -qq; apt-get install -y -qq --no-install-recommends /tmp/citykiln.deb; rm /tmp/citykiln.deb")
        inside("cd /root; citykiln compile --spec /usr/share/citykiln/examples/town/spec.json --lods 2.5 -o town")
        inside("cd /root; citykiln preview town --size 64x48 --spp 1 -o town.png; test -s town.png; rm -r town town.png")
        inside("cd /root; citykiln demo --no-view; test -s citykiln-demo/scene.kiln; rm -r citykiln-demo")
        inside("apt-get purge -y -qq --auto-remove citykiln")
        self.assertEqual(inside(packages), before)
        self.assertEqual([path for path in bare.rglob("*citykiln*")], [])


if __name__ == "__main__":
    unittest.main()
