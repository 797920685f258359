"""A value of a YAML file that knows where it stands, so that whatever is wrong with it is told with its place."""

from __future__ import annotations

import difflib
import math
from collections.abc import Iterable
from pathlib import Path
from typing import Any, NoReturn

from .complaint import InputError

try:
    import yaml
except ImportError as error:
    raise ImportError("sweep files need PyYAML. Install the wheel with it: pip install 'gaitway-….whl[sweep]'") from error


class Source:
    """`field`: how one gets to it, for people: parameters.trajectory.lift[2]."""

    def __init__(self, file: Path, node: yaml.Node, field: str = "") -> None:
        self._file, self._node, self.field = file, node, field

    @staticmethod
    def read(file: Path) -> Source:
        """Its one document. InputError when it cannot be read or is no YAML."""
        try:
            node = yaml.compose(file.read_text(encoding="utf-8"), Loader=yaml.SafeLoader)
        except OSError as error:
            raise InputError(f"{file}: {error.strerror}") from error
        except (yaml.YAMLError, UnicodeDecodeError) as error:
            raise InputError(f"{file}: is no YAML: {error}") from error
        if node is None:
            raise InputError(f"{file}: is empty. 'gaitway sweep --help' shows an example")
        return Source(file, node)

    def refuse(self, rule: str, remedy: str = "") -> NoReturn:
        where = f"{self._file}:{self._node.start_mark.line + 1}: {self.field + ': ' if self.field else ''}"
        value = f"'{self._node.value}' " if isinstance(self._node, yaml.ScalarNode) else ""
        raise InputError(f"{where}{value}{rule}{'. ' + remedy if remedy else ''}")

    @property
    def is_map(self) -> bool:
        return isinstance(self._node, yaml.MappingNode)

    @property
    def is_list(self) -> bool:
        return isinstance(self._node, yaml.SequenceNode)

    def fields(self, known: Iterable[str] | None = None) -> dict[str, Source]:
        """Of a mapping, in the file's order; `known`: there are no others."""
        if not isinstance(self._node, yaml.MappingNode):
            self.refuse("must be a mapping (name: value)")
        found: dict[str, Source] = {}
        for key, value in self._node.value:
            name = str(key.value)
            one = Source(self._file, value, f"{self.field}.{name}" if self.field else name)
            here = Source(self._file, key, one.field)
            if name in found:
                here.refuse("stands here twice", "Leave one out")
            if known is not None and name not in known:
                nearest = difflib.get_close_matches(name, list(known), 1)
                here.refuse(
                    "is unknown", f"Did you mean '{nearest[0]}'?" if nearest else f"There are: {', '.join(known)}"
                )
            found[name] = one
        return found

    def items(self) -> list[Source]:
        """Of a list; anything else is a list of one."""
        if not isinstance(self._node, yaml.SequenceNode):
            return [self]
        if not self._node.value:
            self.refuse("is an empty list", "Name at least one, or leave it out")
        return [Source(self._file, node, f"{self.field}[{place}]") for place, node in enumerate(self._node.value)]

    def text(self) -> str:
        if not isinstance(self._node, yaml.ScalarNode):
            self.refuse("must be a word")
        return str(self._node.value)

    def number(self, lowest: float = -math.inf, highest: float = math.inf) -> float:
        """Finite."""
        value = self.plain()
        if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
            self.refuse("must be a finite number")
        if not lowest <= value <= highest:
            self.refuse(f"must be {lowest:g} to {highest:g}" if highest < math.inf else f"must be at least {lowest:g}")
        return float(value)

    def whole(self, lowest: int, highest: int) -> int:
        value = self.plain()
        if isinstance(value, bool) or not isinstance(value, int) or not lowest <= value <= highest:
            self.refuse(f"must be a whole number, {lowest} to {highest}")
        return value

    def plain(self) -> Any:
        """As YAML means it; numbers in it are finite."""
        loader = yaml.SafeLoader("")
        try:
            value = loader.construct_object(self._node, deep=True)
        except yaml.YAMLError as error:
            self.refuse(f"cannot be read: {error}")
        finally:
            loader.dispose()
        self._require_finite()
        return value

    def _require_finite(self) -> None:
        if isinstance(self._node, yaml.SequenceNode):
            for item in self.items() if self._node.value else []:
                item._require_finite()
        elif isinstance(self._node, yaml.MappingNode):
            for value in self.fields().values():
                value._require_finite()
        elif self._node.tag == "tag:yaml.org,2002:float" and not _is_finite(str(self._node.value)):
            self.refuse("is not a finite number", "Give one, or leave it out")


def _is_finite(text: str) -> bool:
    return not any(word in text.lower() for word in (".nan", ".inf"))
