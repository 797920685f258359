"""Makes an installed tree stand alone: copies the shared libraries that a bare Debian 12 with Python 3.11 has not into
lib/gaitway, and lets programs, module and libraries look there first.

    bundle_libraries.py FOLDER MUJOCO_FOLDER

FOLDER holds bin/, lib/gaitway/ and, of a Python package, _native*.so. MUJOCO_FOLDER: where MuJoCo's library is from. Writes the
licences of all that is bundled, too. Needs ldd, readelf, nm and patchelf.
"""

import pathlib
import re
import shutil
import subprocess
import sys

import licences

# Of glibc, gcc and what Debian's Python itself needs: these are there, and have their security updates from there.
ON_EVERY_MACHINE = re.compile(
    r"^(ld-linux.*|lib(c|m|dl|rt|pthread|resolv|util|gcc_s|stdc\+\+|z|crypto|ssl|lzma|expat)\.so.*|linux-vdso.*)$")

# Sparse solvers, which Debian's Ceres is built with: under the GPL. Ours are dense, so nothing of them is ever called, and the loader
# looks for a function when it is first called (unless LD_BIND_NOW is set).
NEVER_CALLED = re.compile(r"^lib(cholmod|cxsparse|spqr)\.so\.")


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


def tool(*arguments):
    return subprocess.run(arguments, check=True, capture_output=True, text=True).stdout


def take_out_what_is_never_called(file, found):
    """So that the file no longer needs such libraries. `found`: as of needed(). What it needs after that."""
    wanted = set(re.findall(r"\(NEEDED\).*\[(.+)\]", tool("readelf", "-dW", file)))
    for name in sorted(filter(NEVER_CALLED.match, wanted)):
        offered = {line.split()[-1].partition("@")[0] for line in tool("nm", "-D", "--defined-only", found[name]).splitlines()}
        for line in tool("readelf", "-rW", file).splitlines():
            parts = line.split()
            if len(parts) > 4 and parts[4].partition("@")[0] in offered and "JUMP_SL" not in parts[2]:
                sys.exit(f"{file} needs {parts[4]} of {name} as soon as it is loaded: {name} cannot be left out")
        subprocess.run(["patchelf", "--remove-needed", name, file], check=True)


def bundle(folder, mujoco):
    libraries = folder / "lib" / "gaitway"
    search = str(libraries)
    own = [file for place in ("bin", "lib/gaitway", "lib/gaitway/plugins", ".") for file in sorted((folder / place).glob("*"))
           if file.is_file() and not file.is_symlink() and is_elf(file)]
    copied = {file.name: file for file in own if file.name.startswith("libmujoco.so")}
    for file in own:
        take_out_what_is_never_called(file, needed(file, search))
        for name, place in needed(file, search).items():
            if not (libraries / name).exists():
                copied[name] = place.resolve()
                shutil.copy(copied[name], libraries / name)
    licences.write(folder, copied, mujoco)
    # The old kind of path, which counts for what a library loads in its turn, too: plug-ins are loaded from private copies.
    for file in [*own, *(libraries / name for name in copied if not name.startswith("libmujoco.so"))]:
        if file.parent.name == "plugins":
            continue
        to = {"bin": "$ORIGIN/../lib/gaitway", "gaitway": "$ORIGIN"}[file.parent.name] if file.parent != folder else "$ORIGIN/lib/gaitway"
        subprocess.run(["patchelf", "--force-rpath", "--set-rpath", to, file], check=True)


if __name__ == "__main__":
    bundle(*(pathlib.Path(argument).resolve() for argument in sys.argv[1:3]))
