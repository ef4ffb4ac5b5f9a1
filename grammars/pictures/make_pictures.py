#!/usr/bin/env python3
"""Makes the pictures of grammars/cga.md and grammars/rules/README.md with citykiln itself.

make_pictures.py BUILD [NAME …]: all, or those whose names begin so. BUILD holds citykiln and tests/rule_glb; oiiotool makes .jpg of .png.
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
MOST_BYTES = 12_000  # of each picture

# style: (what stands there, eye, look, field of view)
STYLES = {
    "old_town_house": (["w=9 d=11 h=12.5 levels=4 roof=gabled shop=true id=3 party=13", "x=9 w=8 d=11 h=10.5 levels=3 roof=gabled pitch=48 id=12 party=13",
                        "x=17 w=11 d=11 h=13 levels=4 roof=mansard id=6 party=3"], "9,-19,3", "14,0,7.2", 52),
    "courtyard_block": (["w=22 d=20 h=19 levels=5 plan=court shop=true id=3", "x=22 w=19 d=16 h=18.4 levels=5 roof=gabled id=5 party=3"], "16,-25,6", "21,0,10", 55),
    "row_house": (["w=6 d=9 h=5.8 levels=2 roof=saltbox id=1 party=13 pitch=40", "x=6 w=6 d=9 h=5.8 levels=2 roof=saltbox id=2 party=13 pitch=40",
                   "x=12 w=6 d=9 h=5.8 levels=2 roof=saltbox id=5 party=13 pitch=40"], "3,-16,3", "9.5,0,4.2", 50),
    "villa": (["y=6 w=11 d=9 h=5.6 levels=2 roof=gabled over=0.6 id=9", "x=17 y=8 w=13 d=10 h=3 levels=1 roof=hipped over=0.6 id=4"], "7,-12,4", "13.5,6,3", 56),
    "panel_block": (["w=45 d=12 h=16.8 levels=6 id=4"], "52,-22,3", "26,0,8", 52),
    "office_slab": (["w=32 d=14 h=22 levels=6 id=5", "x=40 w=24 d=16 h=26 levels=7 id=9"], "26,-32,5", "35,0,12", 58),
    "glass_tower": (["y=4 w=26 d=24 h=92 levels=25 id=4", "x=44 y=6 w=24 d=20 h=70 levels=19 id=7"], "10,-60,4", "30,4,42", 72),
    "shop": (["y=2 w=22 d=16 h=4.5 levels=1 id=3", "x=27 y=2 w=9 d=8 h=3.6 levels=1 id=9"], "11,-13,3", "17,2,2.4", 52),
    "warehouse": (["y=4 w=36 d=24 h=8 levels=1 roof=gabled pitch=10 id=4"], "2,-22,5", "17,6,4.4", 55),
    "church": (["y=4 w=12 d=26 h=10 levels=1 roof=gabled pitch=52 id=8"], "-12,-18,4", "5,8,8", 55),
    "barn": (["y=5 w=18 d=10 h=4.5 levels=1 roof=gabled id=4"], "0,-12,3", "9,5,4", 52),
    "garage": (["y=2 w=12 d=6 h=2.6 levels=1 id=5", "x=15 y=2 w=6 d=6 h=2.6 levels=1 id=6"], "5,-11,2.4", "10,2,1.4", 46),
    "castle": (["y=5 w=14 d=14 h=17 levels=4 id=2", "x=14 y=9 w=18 d=3 h=8 levels=2 id=2"], "0,-20,4", "13,5,8", 55),
}
EXAMPLE_EYE = ("-8,-15,15", "6,4,3", 36)


def run(*words):
    subprocess.run([str(w) for w in words], check=True, stdout=subprocess.DEVNULL)


def picture(build, folder, name, orders, eye, look, fov):
    glb, png, jpg = folder / f"{name}.glb", folder / f"{name}.png", HERE / f"{name}.jpg"
    run(build / "tests/rule_glb", glb, 0, *orders)
    run(build / "citykiln", "preview", glb, "--eye", eye, "--look", look, "--fov", fov, "--size", "320x240", "--spp", 96,
        "--time", "2024-06-10T13:30:00Z", "--quiet", "-o", png)
    for quality in range(80, 20, -5):
        run("oiiotool", png, "--ch", "R,G,B", "--compression", f"jpeg:{quality}", "-o", jpg)
        if jpg.stat().st_size <= MOST_BYTES:
            return


def main():
    build, wanted = Path(sys.argv[1]), sys.argv[2:]
    is_wanted = lambda name: not wanted or any(name.startswith(w) for w in wanted)
    examples = re.findall(r"```cga\n(.*?)```", (HERE.parent / "cga.md").read_text(), re.S)
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        for i, text in enumerate(examples, 1):
            if is_wanted(name := f"example_{i:02}"):
                (folder / f"{name}.cga").write_text(text)
                picture(build, folder, name, [f"{folder}/{name}.cga lot=1 names=1 w=12 d=9"], *EXAMPLE_EYE)
        for style, (orders, *view) in STYLES.items():
            if is_wanted(style):
                picture(build, folder, style, [f"{style} {order}" for order in orders], *view)


if __name__ == "__main__":
    main()
