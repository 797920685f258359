"""The schema generator: what it refuses, and that a change of unit changes the type hash."""

import pathlib
import sys
import tempfile
import unittest

SCHEMA_FOLDER = pathlib.Path(sys.argv.pop(1))
sys.path.insert(0, str(SCHEMA_FOLDER))
import generate  # noqa: E402


def schema_of(fields, rest=""):
    text = f'[constants]\nkCount = 3\n[[type]]\nname = "Sample"\ndoc = "d"\nfields = [{fields}]\n{rest}'
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "sample.toml"
        path.write_text(text, encoding="utf-8")
        return generate.load(path)


STAMP = '{name = "stamp_ns", type = "int64", unit = "ns"}'


class GenerateTest(unittest.TestCase):
    def refused(self, fields, *parts, rest=""):
        with self.assertRaises(generate.SchemaError) as caught:
            schema_of(fields, rest)
        for part in ("sample.toml", *parts):
            self.assertIn(part, str(caught.exception))

    def hash_of(self, fields):
        return schema_of(fields).types[0].hash

    def test_standard_schema_is_valid(self):
        self.assertGreater(len(generate.load(SCHEMA_FOLDER / "topics.toml").topics), 5)

    def test_unknown_type_is_refused(self):
        self.refused('{name = "a", type = "float63"}', "'Sample'", "'a'", "float63")

    def test_values_get_names(self):
        schema = schema_of('{name = "fall", type = "uint32", values = ["upright", "falls"]}')
        self.assertIn("namespace sample::fall { inline constexpr uint32_t upright = 0, falls = 1; }", generate.cpp_header(schema, "s", "s.h", "Test"))
        self.assertIn("#define GAITWAY_SAMPLE_FALL_FALLS 1u", generate.c_header(schema, "s"))
        self.assertEqual(self.hash_of('{name = "fall", type = "uint32", values = ["upright"]}'), self.hash_of('{name = "fall", type = "uint32"}'))

    def test_values_that_cannot_be_names_are_refused(self):
        self.refused('{name = "fall", type = "uint32", values = ["Upright"]}', "'fall'", "Upright", "lower_case")
        self.refused('{name = "fall", type = "uint32", values = ["lies", "lies"]}', "'fall'", "different")
        self.refused('{name = "fall", type = "float64", values = ["lies"]}', "'fall'", "uint32")

    def test_unknown_constant_is_refused(self):
        self.refused('{name = "a", type = "int8", shape = ["kMissing"]}', "'a'", "kMissing", "[constants]")

    def test_an_array_that_looks_like_one_of_joints_is_refused(self):
        joints = 'kMaxJoints = 64\nkOther = 64'
        text = lambda extent: f'[constants]\n{joints}\n[[type]]\nname = "Sample"\ndoc = "d"\nfields = [{{name = "a", type = "int8", shape = [{extent}]}}]\n'
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "sample.toml"
            path.write_text(text('"kMaxJoints"'), encoding="utf-8")
            generate.load(path)
            for extent in ('"kOther"', "64"):
                path.write_text(text(extent), encoding="utf-8")
                with self.assertRaisesRegex(generate.SchemaError, "kMaxJoints"):
                    generate.load(path)

    def test_duplicate_field_is_refused(self):
        self.refused(f"{STAMP}, {STAMP}", "'stamp_ns'", "twice")

    def test_unknown_key_is_refused(self):
        self.refused('{name = "a", type = "int8", units = "m"}', "'a'", "units")

    def test_bad_extent_is_refused(self):
        self.refused('{name = "a", type = "int8", shape = [0]}', "'a'", "at least 1")

    def test_bad_limit_is_refused(self):
        self.refused('{name = "a", type = "int8", limit = [0, 1]}', "'a'", "float32 and float64")
        self.refused('{name = "a", type = "float32", limit = [1.0]}', "'a'", "[lowest, highest]")
        self.refused('{name = "a", type = "float32", limit = [1.0, 1.0]}', "'a'", "rising order")
        self.refused('{name = "a", type = "float32", limit = [0.0, inf]}', "'a'", "finite")

    def test_bad_name_is_refused(self):
        self.refused('{name = "Upper", type = "int8"}', "'Upper'")

    def test_duplicate_topic_is_refused(self):
        topic = '[[topic]]\nname = "s"\ntype = "Sample"\nwriter = "w"\nperiod_ms = 1\n'
        self.refused(STAMP, "'s'", "twice", rest=topic + topic)

    def test_topic_of_unknown_type_is_refused(self):
        self.refused(STAMP, "'Other'", rest='[[topic]]\nname = "s"\ntype = "Other"\nwriter = "w"\nperiod_ms = 1\n')

    def test_unit_type_shape_frame_and_name_change_the_hash_but_doc_does_not(self):
        base = self.hash_of('{name = "a", type = "float32", shape = [3], unit = "m", frame = "base"}')
        for other in ('{name = "a", type = "float32", shape = [3], unit = "mm", frame = "base"}',
                      '{name = "a", type = "int32", shape = [3], unit = "m", frame = "base"}',
                      '{name = "a", type = "float32", shape = [4], unit = "m", frame = "base"}',
                      '{name = "a", type = "float32", shape = [3], unit = "m", frame = "plan"}',
                      '{name = "b", type = "float32", shape = [3], unit = "m", frame = "base"}'):
            self.assertNotEqual(base, self.hash_of(other), other)
        self.assertEqual(base, self.hash_of('{name = "a", type = "float32", shape = ["kCount"], unit = "m", frame = "base", doc = "x", limit = [-1, 2.5]}'))

    def test_holes_become_explicit_padding(self):
        entry = schema_of('{name = "a", type = "uint8"}, {name = "b", type = "float64"}, {name = "c", type = "uint16"}').types[0]
        self.assertEqual([field.offset for field in entry.fields], [0, 8, 16])
        self.assertEqual(entry.size, 24)
        self.assertEqual([member[1] for member in entry.members if isinstance(member, tuple)], [7, 6])


if __name__ == "__main__":
    unittest.main()
