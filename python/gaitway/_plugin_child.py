"""The process of a plug-in in Python: `gaitway_python_child` runs this file, with its own path and the manager's words."""

from __future__ import annotations

import io
import os
import sys
import traceback
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NoReturn

if TYPE_CHECKING:
    from gaitway import _native, plugin

KIND = "gaitway_plugin_"  # before a module's name, so that no other one's is taken
own_folder = ""  # of the plug-in's file


class Instance:
    """A plug-in as the C side calls it."""

    def __init__(self, kind: type[plugin.Plugin], host: _native.PluginHost) -> None:
        from gaitway.plugin import Setup

        setup = Setup(host)
        self._plugin = kind(setup)
        self.live = setup._live
        self.state_version = self._plugin.state_version
        self.step = self._plugin.step
        self.deactivate = self._plugin.deactivate
        self.save_state = self._plugin.save_state
        self.restore_state = self._plugin.restore_state

    def activate(self) -> None:
        import faulthandler
        import gc

        faulthandler.enable()  # a crash in somebody's C shows where it was called
        self._plugin.activate()
        gc.collect()
        gc.freeze()  # from now on a collection looks at what the steps leave behind alone


def load(file: str) -> tuple[str, str, str, Callable[[_native.PluginHost], Instance]]:
    """Name, version, description and maker of the one plug-in in a file."""
    import importlib.util
    import inspect

    from gaitway.plugin import Plugin, SetupError

    global own_folder
    own_folder, name = os.path.split(file)
    stem = name.removesuffix(".py")
    sys.path.insert(0, own_folder)
    spec = importlib.util.spec_from_file_location(KIND + stem, file)
    if spec is None or spec.loader is None:
        raise SetupError(f"{file}: is no Python file")
    module = importlib.util.module_from_spec(spec)
    sys.modules[module.__name__] = module
    spec.loader.exec_module(module)
    kinds = {value for value in vars(module).values()
             if isinstance(value, type) and issubclass(value, Plugin) and value.__module__ == module.__name__}
    if len(kinds) != 1:
        found = ", ".join(sorted(kind.__name__ for kind in kinds)) or "none"
        raise SetupError(f"{file}: must hold one class that derives from gaitway.plugin.Plugin; holds {found}")
    kind = kinds.pop()
    for what in ("name", "version"):
        if not isinstance(getattr(kind, what), str):
            raise SetupError(f"{file}: {kind.__name__}.{what} = {getattr(kind, what)!r}: must be a text, such as \"1.0.0\"")
    about = inspect.cleandoc(kind.__doc__ or "").partition("\n")[0]
    return kind.name or stem, kind.version, about, lambda host: Instance(kind, host)


def describe(error: BaseException) -> str:
    """One line for people: where it was raised, as near to the plug-in's own code as can be, and what it is."""
    from gaitway.plugin import SetupError

    if isinstance(error, SystemExit):
        leave(error.code)
    if isinstance(error, SetupError):
        return str(error)  # what the manager said, which it knows again
    frames = traceback.extract_tb(error.__traceback__)
    own = [frame for frame in frames if os.path.dirname(frame.filename) == own_folder]
    where = [f"{os.path.basename(frame.filename)}:{frame.lineno} in {frame.name}: " for frame in (own or frames)[-1:]]
    if isinstance(error, SyntaxError) and error.filename:
        where = [f"{os.path.basename(error.filename)}:{error.lineno}: "]
    return "".join(where) + " ".join(f"{type(error).__name__}: {error}".split())


def leave(code: Any) -> NoReturn:
    """The end of this process, as the plug-in asked for it; what other modules left for the end is not run."""
    if isinstance(code, str):
        print(code, file=sys.stderr)
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(code if isinstance(code, int) else 0 if code is None else 1)


def main(launcher: str, *words: str) -> NoReturn:
    sys.dont_write_bytecode = True
    folder = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    sys.path[0] = folder  # this package, and no other one's
    try:
        from gaitway import _native, plugin  # noqa: F401  # all that is no plug-in's own, before the bounds
    except Exception as error:  # whatever a module of this interpreter raises
        os.execv(launcher, [launcher, "--refuse", f"{sys.executable} (Python {sys.version.split()[0]}) cannot load Gaitway's "
                            f"package in {folder}: {type(error).__name__}: {error}. Name an interpreter that can in GAITWAY_PYTHON"])
    del sys.path[0]
    sys.path.append(folder)
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(line_buffering=True)
    leave(_native.run_plugin(list(words), load, describe))


if __name__ == "__main__":
    main(*sys.argv[1:])
