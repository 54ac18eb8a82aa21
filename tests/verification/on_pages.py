"""A check against what the pages of the documentation show of it (../shown_tables.py)."""

from check import budget_table
from shown_tables import NUMBER, plain


def printed_numbers(check):
    """(number as text, bar) of all that a check prints, in the units of its norms."""
    found = []
    for _, bar, value, text, _ in check.norms:
        factor = 100 if text.endswith("%") else 1
        found.append((f"{factor * value:.6g}", None if bar is None else factor * bar))
    for row in [cell for table in check.tables for line in table.rows for cell in line[1:]] + [value for _, _, value in check.budgets]:
        found += [(number, None) for number in NUMBER.findall(plain(row))]
    return found


def compare(check, comparison):
    """Hold what the pages show of a check that was run whole; each must stand on one."""
    rows = list(check.rows())
    shown = comparison.norms(rows)
    for row in budget_table([check]).rows:
        comparison.budgets(row)
    for table in check.tables:
        shown |= comparison.titled(table.title, table.header, table.rows)
    shown |= comparison.by_hand(check.name, printed_numbers(check))
    if not shown:
        comparison.faults.append(f"{check.name}: no page shows it")
