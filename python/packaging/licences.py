"""Under which licences the wheel carries what others wrote, and their texts: of Debian's packages, of MuJoCo and nanobind as their
wheels have them, and of the page's parts. What is not in these tables, or not permitted, is not packaged."""

import importlib.metadata
import json
import pathlib
import subprocess
import sys

# By Debian's source packages and their copyright files: that of the library itself, not of its build files, tests or tools.
OF_SOURCE = {
    "apriltag": "BSD-2-Clause",
    "assimp": "BSD-3-Clause",
    "atlas": "BSD-3-Clause",
    "boost1.74": "BSL-1.0",
    "ceres-solver": "BSD-3-Clause",
    "cli11": "BSD-3-Clause",
    "console-bridge": "BSD-3-Clause",
    "draco": "Apache-2.0",
    "eigen3": "MPL-2.0",
    "fmtlib": "MIT",
    "gcc-12": "GPL-3.0-or-later WITH GCC-exception-3.1 AND LGPL-2.1-or-later",
    "gflags": "BSD-3-Clause",
    "google-glog": "BSD-3-Clause",
    "lapack": "BSD-3-Clause",
    "libbsd": "BSD-3-Clause",
    "libglvnd": "MIT",
    "libmd": "BSD-3-Clause",
    "libmnl": "LGPL-2.1-or-later",
    "libpng1.6": "libpng-2.0",
    "libseccomp": "LGPL-2.1-only",
    "libunwind": "MIT",
    "libx11": "MIT",
    "libxau": "MIT",
    "libxcb": "MIT",
    "libxdmcp": "MIT",
    "minizip": "Zlib",
    "nlohmann-json3": "MIT",
    "onetbb": "Apache-2.0",
    "openblas": "BSD-3-Clause",
    "opencv": "Apache-2.0",
    "orocos-kdl": "LGPL-2.1-or-later",
    "qhull": "Qhull",
    "suitesparse": "GPL-2.0-or-later",
    "tinyxml": "Zlib",
    "tinyxml2": "Zlib",
    "urdfdom": "BSD-3-Clause",
    "yaml-cpp": "MIT",
}
# {SPDX identifier: the file of Debian's common licences to which copyright files refer instead of repeating it}
PERMITTED = {
    "Apache-2.0": "Apache-2.0",
    "BSD-2-Clause": None,
    "BSD-3-Clause": None,
    "BSL-1.0": None,
    "GPL-3.0-or-later WITH GCC-exception-3.1": "GPL-3",
    "LGPL-2.1-only": "LGPL-2.1",
    "LGPL-2.1-or-later": "LGPL-2.1",
    "MIT": None,
    "MPL-2.0": "MPL-2.0",
    "Qhull": None,
    "Zlib": None,
    "libpng-2.0": None,
}
# Headers and static libraries whose code is part of the programs.
COMPILED_IN = ("libboost1.74-dev", "libceres-dev", "libcli11-dev", "libeigen3-dev", "nlohmann-json3-dev")
PAGE = pathlib.Path(__file__).parent / "page_licences"
WHEREABOUTS = "share/gaitway/licenses"  # in a package; make_wheel.py moves it to where wheels have such


def packages_of(files):
    """{file: Debian package} for those that a package has."""
    spelled = {}
    for file in files:
        spelled[str(file)] = file
        spelled[str(file).removeprefix("/usr")] = file  # as a package may have it from before /lib and /usr/lib became one
    listing = subprocess.run(["dpkg-query", "-S", *spelled], check=False, capture_output=True, text=True).stdout
    found = {}
    for line in listing.splitlines():
        package, _, name = line.rpartition(": ")
        if name in spelled and not package.startswith("diversion"):
            found[spelled[name]] = package.split(",")[0]
    return found


def of_package(name, package):
    """What is known of a Debian package that `name` comes from. Ends the packaging where that is too little."""
    asked = subprocess.run(["dpkg-query", "-W", "-f=${source:Package}\t${source:Version}", package], check=False, capture_output=True, text=True)
    if asked.returncode != 0:
        sys.exit(f"{name}: the Debian package {package} is not installed, so its licence cannot be read")
    source, version = asked.stdout.split("\t")
    licence = OF_SOURCE.get(source)
    if licence is None:
        sys.exit(f"{name} comes from Debian's {source}, whose licence is not in {pathlib.Path(__file__).name}. "
                 f"Read /usr/share/doc/{package.split(':')[0]}/copyright and name it there, or leave the library out")
    require_permitted(name, licence)
    copyright_file = pathlib.Path("/usr/share/doc") / package.split(":")[0] / "copyright"
    if not copyright_file.is_file():
        sys.exit(f"{name}: {copyright_file} is missing. Some images of Debian leave out what is in /usr/share/doc: "
                 f"apt-get install --reinstall {package}")
    return {"name": name, "from": f"Debian's {source} {version}", "licence": licence,
            "texts": {f"{source}.txt": copyright_file.read_text(errors="replace"), **full_texts(licence)}}


def require_permitted(name, licence):
    for part in licence.split(" AND "):
        if part not in PERMITTED:
            sys.exit(f"{name} is under {part}, which this package does not carry. Permitted: {', '.join(sorted(PERMITTED))}")


def full_texts(licence):
    files = {PERMITTED[part] for part in licence.split(" AND ")} - {None}
    return {f"{file}.txt": (pathlib.Path("/usr/share/common-licenses") / file).read_text() for file in files}


def of_mujoco(name, folder):
    """`folder`: the unpacked wheel's folder mujoco, beside whose library or folder its licences lie."""
    for texts in (folder / "licenses", *sorted(folder.parent.glob("mujoco_core-*.dist-info/licenses"))):
        if (texts / "LICENSE").is_file():
            return {"name": name, "from": "MuJoCo's wheel mujoco-core", "licence": "Apache-2.0",
                    "texts": {f"mujoco-{file.stem.lower()}.txt": file.read_text() for file in sorted(texts.iterdir())}}
    sys.exit(f"{name}: its licences are not in {folder / 'licenses'}. ./dev setup brings them")


def of_nanobind():
    package = importlib.metadata.distribution("nanobind")
    texts = {file.name: package.locate_file(file).read_text() for file in package.files or ()
             if file.name == "LICENSE" or file.name == "robin_map.h"}  # this one's stands in the file
    if len(texts) != 2:
        sys.exit("nanobind: the installed package lacks its licence, or that of robin_map")
    return {"name": "nanobind (compiled in)", "from": f"the Python package nanobind {package.version}", "licence": "BSD-3-Clause AND MIT",
            "texts": {"nanobind.txt": texts["LICENSE"], "robin_map.txt": texts["robin_map.h"].partition("*/")[0]}}


def of_page():
    return [{"name": f"{file.stem} (in the robot's page)", "from": "the package of that name", "licence": "MIT",
             "texts": {f"{file.stem}.txt": file.read_text()}} for file in sorted(PAGE.glob("*.txt"))]


def write(folder, libraries, mujoco):
    """`libraries`: {name: the file it was copied from}. Writes texts, table and notice into the package `folder`."""
    packages = packages_of(libraries.values())
    known = []
    for name, file in sorted(libraries.items()):
        if name.startswith("libmujoco.so"):
            known.append(of_mujoco(name, mujoco))
        elif file in packages:
            known.append(of_package(name, packages[file]))
        else:
            sys.exit(f"{name}: no Debian package has {file}, so its licence is not known")
    known += [of_package(f"{package} (compiled in)", package) for package in COMPILED_IN]
    known += [of_nanobind(), *of_page()]
    place = folder / WHEREABOUTS
    place.mkdir(parents=True, exist_ok=True)
    for one in known:
        for file, text in one["texts"].items():
            (place / file).write_text(text)
        one["texts"] = sorted(one["texts"])
    (place / "NOTICE").write_text(notice(known))
    (place / "third_party.json").write_text(json.dumps(known, indent=1) + "\n")


def notice(known):
    width = max(len(one["name"]) for one in known)
    lines = [f"{one['name']:{width}}  {one['licence']}; {one['from']}; {', '.join(one['texts'])}" for one in known]
    return ("Gaitway is under the Apache License 2.0 (LICENSE). This package also carries what others wrote, each under its own licence,\n"
            "whose text lies beside this file or in third_party. The libraries are Debian's own builds, of the versions named here, and\n"
            "Debian has their sources; they are as they were but for the path by which they find each other, and any of them can be replaced by a\n"
            "version of your own in lib/gaitway.\n\n"
            "Nothing here binds what uses it to the GPL: of gcc's libraries its exception says so, and SuiteSparse, by which Debian's Ceres\n"
            "could solve sparse problems, is left out, with the references to it. Gaitway's problems are dense.\n\n"
            + "\n".join(lines) + "\n")
