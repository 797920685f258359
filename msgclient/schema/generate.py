"""Generates the C header and the C++ descriptors of topic types from a schema (TOML).

    generate.py SCHEMA --c-header OUT.h --cpp-header OUT.hpp --c-include PATH_OF_OUT_H_IN_INCLUDES

The schema is validated first; an error names the file, the type, the field, what was found, the rule and the remedy.
Padding is made explicit: where C would leave a hole, a field `paddingN` is put, so that no byte of a type is undefined.
"""

import argparse
import keyword
import math
import pathlib
import re
import sys
import tomllib

# Schema type -> (C type, size = alignment in bytes).
SCALARS = {
    "int8": ("int8_t", 1), "uint8": ("uint8_t", 1), "int16": ("int16_t", 2), "uint16": ("uint16_t", 2),
    "int32": ("int32_t", 4), "uint32": ("uint32_t", 4), "int64": ("int64_t", 8), "uint64": ("uint64_t", 8),
    "float32": ("float", 4), "float64": ("double", 8),
}
FIELD_KEYS = {"name", "type", "shape", "unit", "frame", "doc", "limit", "values"}
MAX_RANK = 4
MAX_TYPE_BYTES = 1 << 20
RESERVED = set(keyword.kwlist) | {"double", "float", "int", "char", "struct", "default", "switch", "namespace", "template"}


class SchemaError(Exception):
    """The schema breaks a rule; the message says where and what to do."""


def require(condition, message):
    if not condition:
        raise SchemaError(message)


def snake(camel):
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", camel).lower()


def macro(constant):
    return "GAITWAY_" + snake(constant[1:]).upper()


def fnv1a_64(text):
    value = 0xCBF29CE484222325
    for byte in text.encode():
        value = ((value ^ byte) * 0x100000001B3) & 0xFFFFFFFFFFFFFFFF
    return value


class Field:
    def __init__(self, where, raw, constants):
        require(isinstance(raw, dict) and isinstance(raw.get("name"), str), f"{where}: a field without a name; give it name = \"...\"")
        self.name = raw["name"]
        where = f"{where}, field '{self.name}'"
        require(re.fullmatch(r"[a-z][a-z0-9_]*", self.name) and self.name not in RESERVED,
                f"{where}: not a valid name; use lower_case letters, digits and _ and no keyword")
        require(not re.fullmatch(r"padding\d+", self.name), f"{where}: this name is kept for generated padding; choose another")
        unknown = set(raw) - FIELD_KEYS
        require(not unknown, f"{where}: unknown key '{min(unknown, default='')}'; known are {', '.join(sorted(FIELD_KEYS))}")
        self.type = raw.get("type")
        require(self.type in SCALARS, f"{where}: unknown type '{self.type}'; known are {', '.join(SCALARS)}")
        for key in ("unit", "frame", "doc"):
            value = raw.get(key, "")
            require(isinstance(value, str) and "\n" not in value and "*/" not in value, f"{where}: {key} must be one line of text")
            setattr(self, key, value)
        self.limit = self.read_limit(where, raw.get("limit"))
        self.values = self.read_values(where, raw.get("values", []))
        shape = raw.get("shape", [])
        require(isinstance(shape, list) and len(shape) <= MAX_RANK, f"{where}: shape must be a list of at most {MAX_RANK} extents")
        self.extents, self.c_extents = [], []
        for extent in shape:
            require(not isinstance(extent, str) or extent in constants, f"{where}: unknown constant '{extent}' in shape; define it in [constants]")
            number = constants[extent] if isinstance(extent, str) else extent
            require(type(number) is int and number >= 1, f"{where}: extent {extent!r} must be a whole number of at least 1")
            require(number != constants.get("kMaxJoints") or extent == "kMaxJoints", f"{where}: extent {extent!r} is kMaxJoints' number, by which arrays of joints are known; choose another")
            self.extents.append(number)
            self.c_extents.append(macro(extent) if isinstance(extent, str) else str(number))
        self.alignment = SCALARS[self.type][1]
        self.size = self.alignment
        for number in self.extents:
            self.size *= number
        self.offset = 0

    # Lowest and highest number that a published value may have; None: whatever is finite.
    def read_limit(self, where, limit):
        if limit is None:
            return None
        require(self.type in ("float32", "float64"), f"{where}: limit belongs to float32 and float64; leave it out")
        numbers = isinstance(limit, list) and len(limit) == 2 and all(type(bound) in (int, float) and math.isfinite(bound) for bound in limit)
        require(numbers and limit[0] < limit[1], f"{where}: limit {limit!r} must be [lowest, highest], two finite numbers in rising order")
        return tuple(map(float, limit))

    # Names of the numbers 0, 1, ... that the field may have.
    def read_values(self, where, values):
        named = isinstance(values, list) and all(isinstance(value, str) and re.fullmatch(r"[a-z][a-z0-9_]*", value) and value not in RESERVED
                                                 for value in values)
        require(named and len(set(values)) == len(values),
                f"{where}: values {values!r} must be a list of different lower_case names that are no keywords; the first stands for 0")
        require(not values or self.type in ("uint8", "uint32"), f"{where}: values belong to uint8 and uint32; leave them out")
        return values

    def canonical(self):
        return f"{self.name}:{self.type}[{','.join(map(str, self.extents))}]|{self.unit}|{self.frame};"

    def comment(self):
        frame = f"in {self.frame}" if self.frame else ""
        unit = f"[{self.unit}]" if self.unit else ""
        limit = f"{self.limit[0]:g} to {self.limit[1]:g}" if self.limit else ""
        return ", ".join(part for part in (" ".join(p for p in (unit, frame) if p), self.full_doc(), limit) if part)

    def full_doc(self):
        values = ", ".join(f"{number} {value.replace('_', ' ')}" for number, value in enumerate(self.values))
        return "; ".join(part for part in (values, self.doc) if part)


class Type:
    def __init__(self, path, raw, constants):
        require(isinstance(raw.get("name"), str), f"{path}: a [[type]] without a name; give it name = \"...\"")
        self.name = raw["name"]
        where = f"{path}: type '{self.name}'"
        require(re.fullmatch(r"[A-Z][A-Za-z0-9]*", self.name), f"{where}: not a valid name; use CamelCase")
        self.doc = raw.get("doc", "")
        self.c_name = "gaitway_" + snake(self.name)
        require(raw.get("fields"), f"{where}: no fields; give it at least one")
        self.fields = [Field(where, field, constants) for field in raw["fields"]]
        names = set()
        for field in self.fields:
            require(field.name not in names, f"{where}, field '{field.name}': this name is used twice; rename one")
            names.add(field.name)
        self.members = []  # fields and explicit padding, in memory order
        self.size = 0
        for field in self.fields:
            self.pad_to(field.alignment)
            field.offset = self.size
            self.members.append(field)
            self.size += field.size
        # Values travel as whole 64-bit words; a multiple of eight also leaves no hole between elements of an array.
        self.pad_to(8)
        require(self.size <= MAX_TYPE_BYTES, f"{where}: {self.size} bytes; at most {MAX_TYPE_BYTES} are allowed, make the arrays smaller")
        self.alignment = max(field.alignment for field in self.fields)
        self.hash = fnv1a_64(self.name + "{" + "".join(field.canonical() for field in self.fields) + "}")

    def pad_to(self, alignment):
        hole = -self.size % alignment
        if hole:
            self.members.append((sum(isinstance(m, tuple) for m in self.members), hole))
            self.size += hole


class Schema:
    def __init__(self, path, raw):
        unknown = set(raw) - {"constants", "type", "topic"}
        require(not unknown, f"{path}: unknown table '{min(unknown, default='')}'; known are constants, type, topic")
        self.constants = raw.get("constants", {})
        for name, value in self.constants.items():
            require(re.fullmatch(r"k[A-Z][A-Za-z0-9]*", name), f"{path}: constant '{name}': not a valid name; use kCamelCase")
            require(type(value) is int and 0 < value < 2**31, f"{path}: constant '{name}': {value!r} must be a whole number from 1 to 2^31 - 1")
        self.types = [Type(path, entry, self.constants) for entry in raw.get("type", [])]
        by_name = {}
        for entry in self.types:
            require(entry.name not in by_name, f"{path}: type '{entry.name}': this name is used twice; rename one")
            by_name[entry.name] = entry
        self.topics = raw.get("topic", [])
        names = set()
        for topic in self.topics:
            name = topic.get("name")
            where = f"{path}: topic '{name}'"
            require(isinstance(name, str) and re.fullmatch(r"[a-z][a-z0-9_./]{0,62}", name), f"{where}: not a valid name; use lower_case, at most 63 characters")
            require(name not in names, f"{where}: this name is used twice; rename one")
            names.add(name)
            require(topic.get("type") in by_name, f"{where}: unknown type '{topic.get('type')}'; define it with [[type]]")
            require(isinstance(topic.get("writer"), str) and topic["writer"], f"{where}: no writer; name who writes it")
            require(type(topic.get("period_ms")) is int and topic["period_ms"] >= 0, f"{where}: period_ms must be a whole number; 0 means on change")


def load(path):
    """Reads and validates a schema file; raises SchemaError."""
    try:
        raw = tomllib.loads(pathlib.Path(path).read_text(encoding="utf-8"))
    except (OSError, tomllib.TOMLDecodeError) as error:
        raise SchemaError(f"{path}: {error}") from error
    return Schema(str(path), raw)


def c_header(schema, source):
    lines = [f"/* Topic types as plain C structs. Generated from {source}: change that file instead. */",
             "#pragma once", "#include <stdint.h>", ""]
    lines += [f"#define {macro(name)} {value}" for name, value in schema.constants.items()]
    for entry in schema.types:
        lines += ["", f"/* {entry.doc} {entry.size} bytes. */", f"typedef struct {entry.c_name} {{"]
        for member in entry.members:
            if isinstance(member, tuple):
                lines.append(f"  uint8_t padding{member[0]}[{member[1]}]; /* explicit padding, zero */")
                continue
            extents = "".join(f"[{extent}]" for extent in member.c_extents)
            comment = f" /* {member.comment()} */" if member.comment() else ""
            lines.append(f"  {SCALARS[member.type][0]} {member.name}{extents};{comment}")
        lines.append(f"}} {entry.c_name};")
        lines += [f"#define {entry.c_name.upper()}_{field.name.upper()}_{value.upper()} {number}u"
                  for field in entry.fields for number, value in enumerate(field.values)]
        lines.append(f"#define {entry.c_name.upper()}_TYPE_HASH UINT64_C(0x{entry.hash:016x})")
    return "\n".join(lines) + "\n"


def quoted(text):
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def cpp_type(entry):
    lines = [f"template <>", f"struct TopicType<{entry.name}> {{",
             f"  static constexpr std::string_view name = {quoted(entry.name)};",
             f"  static constexpr std::uint64_t hash = 0x{entry.hash:016x}u;",
             f"  static constexpr std::array<FieldDescriptor, {len(entry.fields)}> fields = {{{{"]
    for field in entry.fields:
        extents = ", ".join(map(str, field.extents))
        limit = f", {field.limit[0]!r}, {field.limit[1]!r}" if field.limit else ""
        lines.append(f"      {{{quoted(field.name)}, ScalarType::{field.type}_value, {len(field.extents)}, {{{extents}}}, "
                     f"{quoted(field.unit)}, {quoted(field.frame)}, {quoted(field.full_doc())}, {field.offset}{limit}}},")
    lines += ["  }};",
              f"  static constexpr TypeDescriptor descriptor{{name, hash, {entry.size}, fields, {quoted(entry.doc)}}};",
              "};",
              f"static_assert(std::is_trivially_copyable_v<{entry.name}> && std::is_standard_layout_v<{entry.name}>);",
              f"static_assert(sizeof({entry.name}) == {entry.size} && alignof({entry.name}) == {entry.alignment});"]
    lines += [f"static_assert(offsetof({entry.name}, {field.name}) == {field.offset});" for field in entry.fields]
    lines.append(f"static_assert(type_hash(TopicType<{entry.name}>::name, TopicType<{entry.name}>::fields) == TopicType<{entry.name}>::hash);")
    return lines


def cpp_header(schema, source, c_include, prefix):
    lines = [f"// Topic types in C++, with their descriptors. Generated from {source}: change that file instead.",
             "#pragma once", "#include <array>", "#include <cstddef>", "#include <cstdint>", "#include <string_view>",
             "#include <type_traits>", "", f"#include \"{c_include}\"", '#include "gaitway/msgclient/type_descriptor.hpp"',
             "", "namespace gaitway {", ""]
    lines += [f"inline constexpr int {name} = {value};" for name, value in schema.constants.items()]
    lines += [""] + [f"using {entry.name} = ::{entry.c_name};  // {entry.doc}" for entry in schema.types]
    lines += [f"namespace {snake(entry.name)}::{field.name} {{ inline constexpr {SCALARS[field.type][0]} "
              + ", ".join(f"{value} = {number}" for number, value in enumerate(field.values)) + "; }"
              for entry in schema.types for field in entry.fields if field.values]
    for entry in schema.types:
        lines += [""] + cpp_type(entry)
    lines += ["", f"inline constexpr std::array<const TypeDescriptor*, {len(schema.types)}> k{prefix}Types = {{{{"]
    lines += [f"    &TopicType<{entry.name}>::descriptor," for entry in schema.types]
    lines += ["}};", f"inline constexpr std::array<StandardTopic, {len(schema.topics)}> k{prefix}Topics = {{{{"]
    for topic in schema.topics:
        lines.append(f"    {{{quoted(topic['name'])}, &TopicType<{topic['type']}>::descriptor, {quoted(topic['writer'])}, "
                     f"{topic['period_ms'] * 1000000}}},")
    lines += ["}};", "", "}  // namespace gaitway"]
    return "\n".join(lines) + "\n"


def main(arguments):
    parser = argparse.ArgumentParser(description="Generates the headers of topic types from a schema.")
    parser.add_argument("schema", type=pathlib.Path)
    parser.add_argument("--c-header", type=pathlib.Path, required=True)
    parser.add_argument("--cpp-header", type=pathlib.Path, required=True)
    parser.add_argument("--c-include", required=True, help="how the C++ header includes the C header")
    parser.add_argument("--prefix", default="Standard", help="k<prefix>Topics and k<prefix>Types are the generated tables")
    options = parser.parse_args(arguments)
    try:
        schema = load(options.schema)
    except SchemaError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    source = options.schema.name
    for path, text in ((options.c_header, c_header(schema, source)),
                       (options.cpp_header, cpp_header(schema, source, options.c_include, options.prefix))):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
