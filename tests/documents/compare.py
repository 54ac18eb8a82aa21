"""Compare what a page shows with what a command prints."""
import re

NUMBER = re.compile(r"(?<![\w.])[-+±]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?(?!\w*[/\\])")
REST = "..."  # a line of a page that stands for any number of lines


def digit_after(text):
    """Half of a unit in the last digit of a number as written: 0.05 of "12.3"."""
    mantissa, _, exponent = text.lower().partition("e")
    decimals = len(mantissa.partition(".")[2])
    return 0.5 * 10.0 ** (-decimals + int(exponent or 0))


def value_of(text):
    return float(text.lstrip("±"))


def same_number(shown, printed, tolerance):
    """Whether two numbers agree: to the relative tolerance and the digits shown, or exactly as written."""
    if tolerance is None:
        return shown == printed
    a, b = value_of(shown), value_of(printed)
    return abs(a - b) <= tolerance * max(abs(a), abs(b)) + digit_after(shown) + digit_after(printed)


def words_of(line):
    """The words of a line with # for each number: blanks between them do not count, nor those that fill up numbers in brackets."""
    return re.sub(r"([\[\]])", r" \1 ", NUMBER.sub("#", line)).split()


def same_line(shown, printed, tolerance=None, loose=None):
    if words_of(shown) != words_of(printed):
        return False
    if loose and re.search(loose, printed):
        return True
    return all(same_number(a, b, tolerance) for a, b in zip(NUMBER.findall(shown), NUMBER.findall(printed)))


def difference(shown, printed, tolerance=None, loose=None):
    """The first line in which two texts differ, as a message; empty where they agree."""
    shown = [line.rstrip() for line in shown]
    printed = [line.rstrip() for line in printed]
    while shown and not shown[-1]:
        shown.pop()
    while printed and not printed[-1]:
        printed.pop()
    at = 0
    for k, line in enumerate(shown):
        if line.strip() == REST:
            following = shown[k + 1] if k + 1 < len(shown) else None
            while at < len(printed) and (following is None or not same_line(following, printed[at], tolerance, loose)):
                at += 1
            continue
        if at >= len(printed):
            return f"shown:   {line}\nprinted: (nothing more)"
        if not same_line(line, printed[at], tolerance, loose):
            return f"shown:   {line}\nprinted: {printed[at]}"
        at += 1
    return f"shown:   (nothing more)\nprinted: {printed[at]}" if at < len(printed) else ""


def missing_numbers(text, printed, tolerance=None):
    """The numbers of a text that are not among those of what was printed."""
    there = NUMBER.findall(printed)
    return [n for n in NUMBER.findall(text) if not any(same_number(n, other, tolerance) for other in there)]
