"""What the pages show of the suites' tables, held against what the suites print.

Three kinds of tables stand on the pages, and each row of them is compared when its check is run whole:

- copies: of the norms and budgets of verify.py, and of a table whose title is a heading of the page;
- tables written by hand, behind a marker that names the checks whose norms their rows show, one for each first cell in its order
  (or one for all, - for none):  <!-- test: checks="tank wedge -" -->

Two numbers agree where they differ by no more than the digits that are shown, a tenth of the larger one, or a quarter of the bar:
room for flows that never repeat, which come out a little otherwise with another compiler. It was chosen, not measured. Times of a
processor and the words of costs are not compared."""

import pathlib
import re
import sys
from dataclasses import dataclass

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "documents"))

from blocks import blocks_of  # noqa: E402
from compare import NUMBER, digit_after, value_of  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[1]
PAGES = ["verification.md", "validation.md", "open-ends.md", "bodies.md", "porous.md", "vegetation.md", "resolved-eddies.md"]

RELATIVE, OF_THE_BAR = 0.1, 0.25

# Of the norms and budgets of verify.py as they are printed; the last two columns of the first are words.
NORMS = ["case", "error norm", "bar", "measured", "best option set", "cost"]
BUDGETS = ["case", "mass lost", "momentum along x", "along z", "energy", "work of viscosity", "left"]
# Budgets are shares of what went in: a hundredth of it is the smallest departure that says something.
BUDGET_BAR = 0.04
NOT_COMPARED = re.compile(r"s of a core|\+- 95 %|^cost$|^best option set$")
MARKS = re.compile(r"\s*(!|\(fails\)|\(known miss\)|\*\*|\[known miss\]\([^)]*\))")


def plain(cell):
    """A cell without its verdict and emphasis, as the pages and the tables write it."""
    return MARKS.sub("", str(cell)).replace("−", "-").strip()


def agree(shown, printed, bar=None):
    """Whether two numbers, as text, are the same within what a table promises."""
    a, b = value_of(shown), value_of(printed)
    if a == b or (a != a and b != b):
        return True
    return abs(a - b) <= max(RELATIVE * max(abs(a), abs(b)), OF_THE_BAR * (bar or 0.0)) + digit_after(shown) + digit_after(printed)


def same_cell(shown, printed, bar=None):
    shown, printed = plain(shown), plain(printed)
    if NUMBER.sub("#", shown).split() != NUMBER.sub("#", printed).split():
        return False
    return all(agree(a, b, bar) for a, b in zip(NUMBER.findall(shown), NUMBER.findall(printed)))


def bar_of(text):
    """The number of a cell or a heading that states a bar, in the units of the table; None without one."""
    found = re.search(r"<= (" + NUMBER.pattern + ")", text) or re.match(r"(" + NUMBER.pattern + r")(?: [^\d]*)?$", text)
    return abs(value_of(found.group(1))) if found else None


@dataclass
class Shown:
    """A table of a page; rows are (number of the line, cells)."""
    page: str
    title: str
    header: list
    rows: list
    checks: list


def cells_of(line):
    return [cell.strip() for cell in re.split(r"(?<!\\)\|", line.strip().strip("|"))]


def tables_of(text, page):
    headings = [(number, line.lstrip("#").strip()) for number, line in enumerate(text.split("\n"), 1) if line.startswith("#")]
    found = []
    for block in blocks_of(text, page):
        if block.kind != "table" or len(block.lines) < 3:
            continue
        title = next((heading for number, heading in reversed(headings) if number < block.line), "")
        rows = [(block.line + at, cells_of(line)) for at, line in enumerate(block.lines) if at > 1]
        found.append(Shown(page, title, cells_of(block.lines[0]), rows, block.marker.get("checks", "").split()))
    return found


def read(folder=ROOT / "docs", pages=None):
    return [table for page in pages or PAGES for table in tables_of((folder / page).read_text(), f"docs/{page}")]


class Comparison:
    """Departures of the pages from what was printed: `faults` in words, `lines` by (page, line): the row as it should stand."""

    def __init__(self, tables):
        self.tables, self.faults, self.lines, self.rows = tables, [], {}, 0

    def _row(self, table, line, key, shown, printed, bars):
        """A row of a page against the one that is printed now; key: what it is called; bars: of each column, or None."""
        self.rows += 1
        for column, (head, a, b) in enumerate(zip(table.header, shown, printed)):
            if NOT_COMPARED.search(head):
                continue
            if not same_cell(a, b, bars[column]) or "!" in a.replace("!=", ""):
                self.faults.append(f"{table.page}:{line}: {' / '.join(key)}: {head} is {a or 'empty'}, printed {b}")
                self.lines[table.page, line] = printed

    def _copy(self, tables, what, printed, bars_of, keys=1):
        """Rows of a copy; tables: the shown ones that may hold them, the first with a row's key does."""
        there = {}
        for table in tables:
            case = ""
            for line, cells in table.rows:
                case = cells[0] or case
                there.setdefault((case, *cells[1:keys]), (table, line, cells))
        case, seen = "", set()
        for row in printed:
            row = [str(cell) for cell in row]
            case = row[0] or case
            key = (case, *row[1:keys])
            seen.add(key)
            if key not in there:
                self.faults.append(f"{what}: no page shows {' / '.join(key)}: | {' | '.join(row)} |")
                continue
            table, line, cells = there[key]
            self._row(table, line, key, cells, row, bars_of(table.header, row))
        cases = {key[0] for key in seen}
        for key, (table, line, cells) in there.items():
            if key not in seen and (keys == 1 or key[0] in cases):
                self.faults.append(f"{table.page}:{line}: {' / '.join(key)} is shown, and not printed any more")

    def titled(self, title, header, rows):
        """A table whose title is a heading of a page, an observed order in it aside, or whose columns only one table has; False where no page has it."""
        name = lambda text: re.sub(r" \(observed order [^)]*\)", "", plain(text))
        heads = lambda cells: [NUMBER.sub("#", plain(cell)) for cell in cells]
        tables = [table for table in self.tables if name(table.title) == name(title) and heads(table.header) == heads(header)]
        if not tables:
            tables = [table for table in self.tables if heads(table.header) == heads(header)]
            if len(tables) != 1:
                return False
        self._copy(tables, title, rows, lambda head, _: [bar_of(text) if "<=" in text else None for text in head])
        return True

    def norms(self, rows):
        """Rows of the table of all checks of verify.py, where it shows this case; False where it does not."""
        tables = [table for table in self.tables if table.header == NORMS]
        if not any(cells[0] == rows[0][0] for table in tables for _, cells in table.rows):
            return False
        self._copy([_only(table, rows[0][0]) for table in tables], "docs/verification.md", rows, lambda _, row: [None, None, None, bar_of(row[2]), None, None], keys=2)
        return True

    def budgets(self, row):
        tables = [_only(table, row[0]) for table in self.tables if table.header == BUDGETS]
        if any(table.rows for table in tables):
            self._copy(tables, "docs/verification.md", [row], lambda *_: 7 * [BUDGET_BAR])

    def by_hand(self, check, printed):
        """Rows that a marker gives to a check: each number of what was measured must be among `printed`, [(text, bar)]; False where none has one."""
        found = False
        for table in self.tables:
            first = max((column for column, head in enumerate(table.header) if head == "bar"), default=0) + 1
            for line, cells, name in groups(table):
                if name != check:
                    continue
                found = True
                self.rows += 1
                for cell in cells[first:]:
                    missing = [number for number in NUMBER.findall(plain(_measured(cell))) if not any(_is_value(number, text, bar) for text, bar in printed)]
                    if missing:
                        self.faults.append(f"{table.page}:{line}: {' / '.join(filter(None, cells[:2]))[:90]}: {check} does not print {', '.join(missing)}")
        return found

    def end(self, write):
        """Say what departs; the exit status."""
        for fault in self.faults:
            print("PAGE:", fault)
        if self.rows or self.faults:
            print(f"{self.rows} rows of the pages compared, {len(self.faults)} departures")
        if write:
            self.write()
            print(f"{len(self.lines)} rows written")
        return 1 if self.faults else 0

    def write(self, folder=ROOT):
        """Write the rows that are printed now over those of the pages."""
        for page in {page for page, _ in self.lines}:
            lines = (folder / page).read_text().split("\n")
            for (where, line), cells in self.lines.items():
                if where == page:
                    lines[line - 1] = "| " + " | ".join(cells) + " |"
            (folder / page).write_text("\n".join(lines))


def _only(table, case):
    """The rows of one case of a table."""
    kept, inside = [], False
    for line, cells in table.rows:
        inside = cells[0] == case if cells[0] else inside
        if inside:
            kept.append((line, cells))
    return Shown(table.page, table.title, table.header, kept, table.checks)


def _measured(cell):
    """A cell without what it says of other places: brackets, links, code."""
    return re.sub(r"`[^`]*`|\([^)]*\)|\]\([^)]*\)", "", cell)


def _is_value(shown, printed, bar):
    if not re.match(r"[-+]", shown):
        printed = printed.lstrip("-")
    return agree(shown, printed, bar)


def groups(table):
    """(line, cells, check) of each row of a table written by hand; a first cell that is not empty begins the next check."""
    number = -1
    for line, cells in table.rows:
        number += bool(cells[0]) or number < 0
        if len(table.checks) == 1:
            yield line, cells, table.checks[0]
        elif number < len(table.checks):
            yield line, cells, table.checks[number]
