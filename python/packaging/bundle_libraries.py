"""Makes an installed tree stand alone: copies the shared libraries that a bare Debian 12 with Python 3.11 has not into
lib/gaitway, and lets programs, module and libraries look there first.

    bundle_libraries.py FOLDER [MORE_FOLDERS_TO_LOOK_IN…]

FOLDER holds bin/, lib/gaitway/ and, of a Python package, _native*.so. Needs ldd and patchelf.
"""

import pathlib
import re
import shutil
import subprocess
import sys

# Of glibc, gcc and what Debian's Python itself needs: these are there, and have their security updates from there.
ON_EVERY_MACHINE = re.compile(
    r"^(ld-linux.*|lib(c|m|dl|rt|pthread|resolv|util|gcc_s|stdc\+\+|z|crypto|ssl|lzma|expat)\.so.*|linux-vdso.*)$")


def is_elf(file):
    with open(file, "rb") as opened:
        return opened.read(4) == b"\x7fELF"


def needed(file, search):
    """{name: where it is now} of all that the loader finds for a file."""
    found = {}
    listing = subprocess.run(["ldd", file], check=True, capture_output=True, text=True, env={"LD_LIBRARY_PATH": search, "PATH": "/usr/bin:/bin"})
    for line in listing.stdout.splitlines():
        name, arrow, place = line.strip().partition(" => ")
        if not arrow or ON_EVERY_MACHINE.match(name):
            continue
        if place.startswith("not found"):
            sys.exit(f"{file} needs {name}, which is not installed here")
        found[name] = pathlib.Path(place.split(" (")[0])
    return found


def bundle(folder, more):
    libraries = folder / "lib" / "gaitway"
    search = ":".join([str(libraries), *more])
    loaded = [file for place in ("bin", "lib/gaitway", "lib/gaitway/plugins", ".") for file in sorted((folder / place).glob("*"))
              if file.is_file() and not file.is_symlink() and is_elf(file)]
    for file in loaded:
        for name, place in needed(file, search).items():
            if not (libraries / name).exists():
                shutil.copy(place.resolve(), libraries / name)
    # The old kind of path, which counts for what a library loads in its turn, too: plug-ins are loaded from private copies.
    for file in [*loaded, *(file for file in libraries.glob("*.so*") if file not in loaded)]:
        if file.parent.name == "plugins":
            continue
        to = {"bin": "$ORIGIN/../lib/gaitway", "gaitway": "$ORIGIN"}[file.parent.name] if file.parent != folder else "$ORIGIN/lib/gaitway"
        subprocess.run(["patchelf", "--force-rpath", "--set-rpath", to, file], check=True)


if __name__ == "__main__":
    bundle(pathlib.Path(sys.argv[1]).resolve(), sys.argv[2:])
