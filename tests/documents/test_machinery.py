"""The machinery itself: what it reads of a page, and that it sees what is wrong."""
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from blocks import MarkerError, blocks_of  # noqa: E402
from commands import commands_of, riffle_calls  # noqa: E402
from compare import difference, missing_numbers  # noqa: E402

PAGE = """# A page

Text with `code`.

    $ riffle check a.toml | tail -2
    valid

<!-- test: file=my.toml -->
```toml
[channel]
slope = 0.1
```

- a list
  over lines

  <!-- test: base=x.toml -->
  ```toml
  [numerics]
  ```

<!-- test: prints="make table" tolerance=2% -->
| a | b |
|---|---|
| 1 | 2 |

<!-- test: numbers="print it" -->
It takes 3 s.
"""


class Blocks(unittest.TestCase):
    def test_kinds_and_markers(self):
        code, case, part, table, text = blocks_of(PAGE, "page.md")
        self.assertEqual((code.kind, code.language, code.line), ("code", "", 5))
        self.assertEqual(code.lines, ["$ riffle check a.toml | tail -2", "valid"])
        self.assertEqual((case.language, case.marker), ("toml", {"file": "my.toml"}))
        self.assertEqual((part.lines, part.marker), (["[numerics]"], {"base": "x.toml"}))
        self.assertEqual((table.kind, table.marker["tolerance"]), ("table", "2%"))
        self.assertEqual((text.kind, text.marker["numbers"]), ("text", "print it"))

    def test_wrong_markers(self):
        with self.assertRaisesRegex(MarkerError, "page.md:1: unknown word `rum`"):
            blocks_of("<!-- test: rum -->\n\n    $ riffle\n", "page.md")
        with self.assertRaisesRegex(MarkerError, "page.md:3: a marker without a block"):
            blocks_of("\n\n<!-- test: run -->\n", "page.md")

    def test_commands(self):
        block, = blocks_of("    $ A=1 riffle run c.toml \\\n        --set a.b='\"1 s\"' | head   # why\n    out\n", "p")
        line, = commands_of(block)
        self.assertEqual(riffle_calls(line), [["run", "c.toml", "--set", 'a.b="1 s"']])
        self.assertEqual(riffle_calls("riffle new my.toml          a commented case"), [["new", "my.toml"]])


class Comparison(unittest.TestCase):
    def test_words_and_numbers(self):
        self.assertEqual(difference(["U   0.3351 +- 0.0002 m/s"], ["U 0.3351 +- 0.0002 m/s"]), "")
        self.assertIn("0.3352", difference(["U 0.3351 m/s"], ["U 0.3352 m/s"]))
        self.assertEqual(difference(["U 0.3351 m/s"], ["U 0.3352 m/s"], tolerance=0.01), "")
        self.assertNotEqual(difference(["U 0.3351 m/s"], ["U 0.36 m/s"], tolerance=0.01), "")
        self.assertNotEqual(difference(["U 0.3351 m/s"], ["V 0.3351 m/s"], tolerance=0.01), "")
        self.assertNotEqual(difference(["-4.2 %"], ["4.2 %"], tolerance=0.1), "")
        self.assertEqual(difference(["[[0.0008 0.07482]"], ["[[0.0008 0.0748 ]"], tolerance=0.01), "")

    def test_loose_lines_compare_words(self):
        self.assertEqual(difference(["about 30 s here"], ["about 90 s here"], loose="here"), "")
        self.assertNotEqual(difference(["about 30 s here"], ["about 90 min here"], loose="here"), "")

    def test_lines(self):
        self.assertNotEqual(difference(["a", "b"], ["a"]), "")
        self.assertNotEqual(difference(["a"], ["a", "b"]), "")
        self.assertEqual(difference(["a", "...", "d"], ["a", "b", "c", "d"]), "")
        self.assertEqual(difference(["a", "..."], ["a", "b", "c"]), "")
        self.assertNotEqual(difference(["a", "...", "e"], ["a", "b", "c"]), "")

    def test_numbers_of_a_paragraph(self):
        self.assertEqual(missing_numbers("from 1.5 to 20 mm", "20 and 1.5"), [])
        self.assertEqual(missing_numbers("from 1.5 to 20 mm", "20 and 1.6"), ["1.5"])
        self.assertEqual(missing_numbers("from 1.5 mm", "1.52", tolerance=0.02), [])


if __name__ == "__main__":
    unittest.main()
