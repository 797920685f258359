"""A value of a YAML file that knows where it stands, so that whatever is wrong with it is told with its place."""

from __future__ import annotations

import difflib
import math
import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any, NoReturn

from .complaint import InputError

try:
    import yaml
except ImportError as error:
    raise ImportError("sweep files need PyYAML. Install the wheel with it: pip install 'gaitway-….whl[sweep]'") from error

TAG = "tag:yaml.org,2002:"
MOST_BYTES = 4_000_000
MOST_VALUES = 200_000  # an alias counts as what it stands for
DEEPEST = 20
LONGEST_NUMBER = 1000  # characters
LOWEST_WHOLE, HIGHEST_WHOLE = -(2**63), 2**64 - 1
SHOWN = 80  # characters of a value or a name that is complained about


class _Loader(yaml.SafeLoader):
    """Takes 1e-3 and 2.5e6 for numbers, too, as everybody means them; to YAML 1.1 they are words."""


_Loader.add_implicit_resolver(
    f"{TAG}float", re.compile(r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)[eE][-+]?[0-9]+\Z"), list("-+.0123456789")
)


class Source:
    """`field`: how one gets to it, for people: parameters.trajectory.lift[2]."""

    def __init__(self, file: Path, node: yaml.Node, field: str = "") -> None:
        self._file, self._node, self.field = file, node, field

    @staticmethod
    def read(file: Path) -> Source:
        """Its one document, of words, finite numbers, flags, lists and mappings only. InputError where it is none."""
        try:
            with file.open("rb") as opened:
                content = opened.read(MOST_BYTES + 1)
            if len(content) > MOST_BYTES:
                raise InputError(f"{file}: is larger than {MOST_BYTES // 1_000_000} MB. Give ranges in the place of values")
            node = yaml.compose(content.decode("utf-8"), Loader=_Loader)
        except OSError as error:
            raise InputError(f"{file}: {error.strerror}") from error
        except RecursionError:
            raise InputError(f"{file}: is nested too deep, {DEEPEST} lists and mappings at most") from None
        except yaml.MarkedYAMLError as error:
            line = f":{error.problem_mark.line + 1}" if error.problem_mark else ""
            what = ", ".join(part for part in (error.context, error.problem) if part)
            raise InputError(f"{file}{line}: is no YAML: {what}") from error
        except (yaml.YAMLError, UnicodeDecodeError) as error:
            raise InputError(f"{file}: is no YAML: {error}") from error
        if node is None:
            raise InputError(f"{file}: is empty. 'gaitway sweep --help' shows an example")
        root = Source(file, node)
        root._require_plain()
        return root

    def refuse(self, rule: str, remedy: str = "") -> NoReturn:
        where = f"{self._file}:{self._node.start_mark.line + 1}: {_shown(self.field) + ': ' if self.field else ''}"
        value = f"'{_shown(self._node.value)}' " if isinstance(self._node, yaml.ScalarNode) else ""
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
            here = Source(self._file, key, self.field)
            if not isinstance(key, yaml.ScalarNode) or key.tag == f"{TAG}merge":
                here.refuse("must be a name", "Lists, mappings and << are no names here")
            name = str(key.value)
            one = Source(self._file, value, f"{self.field}.{name}" if self.field else name)
            here.field = one.field
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
        if not self.is_list:
            return [self]
        if not self._node.value:
            self.refuse("is an empty list", "Name at least one, or leave it out")
        return self._children()

    def scalars(self) -> Iterator[Source]:
        """All that is neither a list nor a mapping, in it or it itself."""
        if isinstance(self._node, yaml.ScalarNode):
            yield self
        for child in self._children():
            yield from child.scalars()

    def text(self) -> str:
        if not isinstance(self._node, yaml.ScalarNode):
            self.refuse("must be a word")
        return str(self._node.value)

    def number(self, lowest: float = -math.inf, highest: float = math.inf) -> float:
        """Finite."""
        value = self.plain()
        if isinstance(value, bool) or not isinstance(value, int | float):
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
        """As YAML means it."""
        loader = _Loader("")
        try:
            return loader.construct_object(self._node, deep=True)
        except (yaml.YAMLError, ValueError, KeyError, TypeError) as error:
            self.refuse(f"cannot be read as {self._node.tag.removeprefix(TAG)}: {_shown(str(error))}")
        finally:
            loader.dispose()

    def _children(self) -> list[Source]:
        if isinstance(self._node, yaml.SequenceNode):
            return [Source(self._file, node, f"{self.field}[{place}]") for place, node in enumerate(self._node.value)]
        return list(self.fields().values()) if self.is_map else []

    def _require_plain(self) -> None:
        """Of all that is in it."""
        waiting, count = [(self, 0)], 0
        while waiting:
            one, depth = waiting.pop()
            count += 1
            if depth > DEEPEST:
                one.refuse(f"is nested too deep, {DEEPEST} lists and mappings at most")
            if count > MOST_VALUES:
                self.refuse(f"has more than {MOST_VALUES} values", "Give ranges in the place of values")
            if isinstance(one._node, yaml.ScalarNode):
                one._require_plain_scalar()
            elif one._node.tag != (f"{TAG}seq" if one.is_list else f"{TAG}map"):
                one.refuse(f"is a {one._node.tag.removeprefix(TAG)}", "Take words, numbers, true, false, lists and mappings only")
            waiting += [(child, depth + 1) for child in reversed(one._children())]

    def _require_plain_scalar(self) -> None:
        what, text = self._node.tag.removeprefix(TAG), str(self._node.value)
        if what == "timestamp":
            self.refuse("is a date to YAML", "Put it between quotes where it is a word")
        if what not in ("str", "int", "float", "bool", "null"):
            self.refuse(f"is a {what}", "Take words, numbers, true, false, lists and mappings only")
        if what in ("int", "float") and len(text) > LONGEST_NUMBER:
            self.refuse(f"has {len(text)} characters, a number has {LONGEST_NUMBER} at most")
        value = self.plain()
        if isinstance(value, float) and not math.isfinite(value):
            self.refuse("is not a finite number", "Give one, or leave it out")
        if isinstance(value, int) and not LOWEST_WHOLE <= value <= HIGHEST_WHOLE:
            self.refuse("is a whole number of more than 64 bits", "Write it with a decimal point, or as 1e30")
        if any(letter == "\0" or "\ud800" <= letter <= "\udfff" for letter in text):
            self.refuse("holds what is no character", "Leave out NUL, and halves of characters (\\ud800 to \\udfff)")


def _shown(text: str) -> str:
    """As a terminal may show it, and nobody has to read it all."""
    plain = "".join(letter if letter.isprintable() else "?" for letter in text[:SHOWN])
    return plain if len(text) <= SHOWN else f"{plain}… ({len(text)} characters)"
