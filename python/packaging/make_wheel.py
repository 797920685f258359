"""Makes a wheel of what was installed into FOLDER/gaitway, with the metadata of pyproject.toml.

    make_wheel.py SOURCE_TREE FOLDER OUT_FOLDER

What `pip install .` leaves out of the wheel is left out here, too. The licences of what it bundles go where wheels have such.
"""

import base64
import fnmatch
import hashlib
import json
import pathlib
import re
import sys
import sysconfig
import tomllib
import zipfile

import licences

EPOCH = (1980, 1, 1, 0, 0, 0)  # the same files make the same wheel


def version_of(tree):
    return re.search(r"project\(gaitway VERSION ([0-9.]+)", (tree / "CMakeLists.txt").read_text())[1]


def expression(project, third_party):
    """Of the whole wheel, in SPDX's language."""
    parts = {part for one in third_party for part in one["licence"].split(" AND ")} - {project["license"]}
    return " AND ".join([project["license"], *sorted(parts)])


def metadata(project, version, readme, third_party, texts):
    lines = ["Metadata-Version: 2.4", f"Name: {project['name']}", f"Version: {version}", f"Summary: {project['description']}",
             f"License-Expression: {expression(project, third_party)}", f"Requires-Python: {project['requires-python']}"]
    lines += [f"License-File: {file}" for file in [*project["license-files"], *texts]]
    lines += [f"Classifier: {entry}" for entry in project["classifiers"]]
    lines += [f"Requires-Dist: {entry}" for entry in project["dependencies"]]
    for extra, entries in project["optional-dependencies"].items():
        lines += [f"Provides-Extra: {extra}", *(f'Requires-Dist: {entry}; extra == "{extra}"' for entry in entries)]
    return "\n".join([*lines, "Description-Content-Type: text/markdown", "", readme])


def tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def main(tree, folder, out):
    settings = tomllib.loads((tree / "pyproject.toml").read_text())
    project, version = settings["project"], version_of(tree)
    left_out = [pattern.replace("**", "*") for pattern in settings["tool"]["scikit-build"]["wheel"]["exclude"]]
    info = f"gaitway-{version}.dist-info"
    out.mkdir(parents=True, exist_ok=True)
    for old in out.glob("gaitway-*.whl"):
        old.unlink()
    wheel = out / f"gaitway-{version}-{tag()}.whl"
    packaged = folder / "gaitway" / licences.WHEREABOUTS
    if not (packaged / "third_party.json").exists():
        sys.exit(f"{packaged} has no licences of what is bundled: install the component `python`, which writes them")
    of_others = {f"third_party/{file.name}" if file.name != "NOTICE" else file.name: file.read_text() for file in sorted(packaged.iterdir())}
    third_party = json.loads(of_others["third_party/third_party.json"])
    texts = {
        f"{info}/METADATA": metadata(project, version, (tree / project["readme"]).read_text(), third_party, of_others),
        f"{info}/WHEEL": f"Wheel-Version: 1.0\nGenerator: gaitway\nRoot-Is-Purelib: false\nTag: {tag()}\n",
        f"{info}/entry_points.txt": "[console_scripts]\n" + "".join(f"{name} = {call}\n" for name, call in project["scripts"].items()),
        f"{info}/licenses/LICENSE": (tree / "LICENSE").read_text(),
        **{f"{info}/licenses/{name}": text for name, text in of_others.items()},
    }
    record = []
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        def add(name, content, mode):
            entry = zipfile.ZipInfo(name, EPOCH)
            entry.external_attr = (0o100000 | mode) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, content)
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            record.append(f"{name},sha256={digest},{len(content)}\n")

        for file in sorted(folder.rglob("*")):
            name = file.relative_to(folder).as_posix()
            if file.is_file() and file.parent != packaged and not any(fnmatch.fnmatch(name, pattern) for pattern in left_out):
                add(name, file.read_bytes(), 0o755 if file.stat().st_mode & 0o100 else 0o644)
        for name, text in texts.items():
            add(name, text.encode(), 0o644)
        add(f"{info}/RECORD", ("".join(record) + f"{info}/RECORD,,\n").encode(), 0o644)
    print(f"{wheel} ({wheel.stat().st_size / 1e6:.1f} MB)")


if __name__ == "__main__":
    main(*(pathlib.Path(argument).resolve() for argument in sys.argv[1:4]))
