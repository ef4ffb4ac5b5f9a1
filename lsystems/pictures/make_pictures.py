#!/usr/bin/env python3
"""Makes the pictures of lsystems/notation.md.

make_pictures.py BUILD [NAME …]: all, or those whose names begin so. BUILD holds tests/lsystem_png; oiiotool makes .jpg of .png.
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
MOST_BYTES = 12_000  # of each example; three times as many of a sheet

# sheet: (figures, how many stand in a row, size of each)
SHEETS = {
    "book_1": (["1_24a", "1_24b", "1_24c", "1_24d", "1_24e", "1_24f", "1_25", "1_26", "1_27", "1_28"], 5, 190),
    "book_2": ([f"2_{figure}{letter}" for figure in "678" for letter in "abcd"], 4, 190),
    "book_5": ([f"5_11{letter}" for letter in "abcde"] + [f"5_12{letter}" for letter in "abc"], 4, 230),
}

# the same of meshes: (figure, tolerance, zoom, height of what is zoomed to) each
MESHES = {
    "tubes_book": ([(f"2_{name}", 1 if name[0] == "8" else 0.002, 1, 0.5) for name in ("6a", "6b", "6c", "6d", "7b", "7d", "8a", "8b")], 4, 230),
    "tubes_joints": ([("2_6a", 0.002, 5, 0.33), ("2_7b", 0.002, 6, 0.3), ("2_8b", 0.5, 6, 0.45)], 3, 300),
}

SPECIES = "oak beech plane maple lime birch poplar willow apple bush spruce fir pine cypress palm".split()  # broad leaves first


def run(*words):
    subprocess.run([str(w) for w in words], check=True, stdout=subprocess.DEVNULL)


def draw(build, png, file, size):
    run(build / "tests/lsystem_png", png, file, f"size={size}", "line=0.8")


def compress(png, name, most):
    for quality in range(85, 20, -5):
        jpg = HERE / f"{name}.jpg"
        run("oiiotool", png, "--ch", "R,G,B", "--compression", f"jpeg:{quality}", "-o", jpg)
        if jpg.stat().st_size <= most:
            return


def main():
    build, wanted = Path(sys.argv[1]), sys.argv[2:]
    is_wanted = lambda name: not wanted or any(name.startswith(w) for w in wanted)
    examples = re.findall(r"```lsys\n(.*?)```", (HERE.parent / "notation.md").read_text(), re.S)
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        for i, text in enumerate(examples, 1):
            if is_wanted(name := f"example_{i:02}"):
                (folder / "example.lsys").write_text(text)
                draw(build, folder / "example.png", folder / "example.lsys", 240)
                compress(folder / "example.png", name, MOST_BYTES)
        for name, (figures, columns, size) in SHEETS.items():
            if is_wanted(name):
                for figure in figures:
                    draw(build, folder / f"{figure}.png", HERE.parent / f"book/fig_{figure}.lsys", size)
                rows = -(-len(figures) // columns)
                run("oiiotool", *[folder / f"{figure}.png" for figure in figures], f"--mosaic:pad=0", f"{columns}x{rows}", "-o", folder / "sheet.png")
                compress(folder / "sheet.png", name, 3 * MOST_BYTES)
        for name, (figures, columns, size) in MESHES.items():
            if is_wanted(name):
                pictures = []
                for i, (figure, tolerance, zoom, up) in enumerate(figures):
                    pictures.append(folder / f"mesh_{i}.png")
                    run(build / "tests/lsystem_png", pictures[-1], HERE.parent / f"book/fig_{figure}.lsys", f"size={size}",
                        f"tolerance={tolerance}", f"zoom={zoom}", f"up={up}", f"pitch={10 if zoom == 1 else 0}")
                run("oiiotool", *pictures, f"--mosaic:pad=0", f"{columns}x{-(-len(figures) // columns)}", "-o", folder / "sheet.png")
                compress(folder / "sheet.png", name, 3 * MOST_BYTES)
        if is_wanted("species"):
            for species in SPECIES:
                run(build / "tests/lsystem_png", folder / f"{species}.png", HERE.parent / f"species/{species}.lsys", "size=230",
                    "tolerance=0.02", "pitch=4", "seed=6")
            run("oiiotool", *[folder / f"{species}.png" for species in SPECIES], "--mosaic:pad=0", "5x3", "-o", folder / "sheet.png")
            compress(folder / "sheet.png", "species", 5 * MOST_BYTES)


if __name__ == "__main__":
    main()
