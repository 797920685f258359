"""One text for one value: the JSON that is hashed, stored, and compared to the byte."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

Json = dict[str, Any]


def canonical(value: Any) -> str:
    """Keys in order, no spaces, numbers as short as they can be read back. ValueError for NaN and infinities."""
    return json.dumps(value, sort_keys=True, separators=(",", ":"), ensure_ascii=True, allow_nan=False)


def text_hash(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()


def files_hash(files: Mapping[str, Path]) -> str:
    """Of names and contents; where the files lie does not count. OSError for one that cannot be read."""
    whole = hashlib.sha256()
    for name in sorted(files):
        with files[name].open("rb") as file:
            whole.update(f"{name}\0{hashlib.file_digest(file, 'sha256').hexdigest()}\0".encode())
    return whole.hexdigest()
