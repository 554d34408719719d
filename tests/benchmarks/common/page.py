"""Writes tables between marks of a Markdown page.

    <!-- speedError sod: begin -->
    ...
    <!-- speedError sod: end -->
"""


class NoMarks(ValueError):
    """The page has no such pair of marks."""


def marks(name):
    return f"<!-- {name}: begin -->", f"<!-- {name}: end -->"


def parts(page, name):
    """The page's text before and after the marks of this name."""
    begin, end = marks(name)
    try:
        old = page.read_text()
    except OSError as problem:
        raise NoMarks(problem) from None
    if old.count(begin) != 1 or old.count(end) != 1:
        raise NoMarks(f"{page}: not one '{begin}' and one '{end}'")
    before, rest = old.split(begin)
    return before, rest.split(end)[1]


def expectMarks(page, *names):
    """Stop before the runs rather than after them; page may be None."""
    for name in names:
        if page:
            parts(page, name)


def replaceBetween(page, name, text):
    """Replace what page (a path) has between the marks of this name."""
    before, after = parts(page, name)
    begin, end = marks(name)
    page.write_text(f"{before}{begin}\n{text.strip()}\n{end}{after}")


def table(head, rows):
    """A Markdown table; numbers with three digits."""
    def words(row):
        return "| " + " | ".join(written(v) for v in row) + " |"

    return "\n".join([words(head), "|---" * len(head) + "|"]
                     + [words(row) for row in rows])


def written(value):
    if isinstance(value, str):
        return value
    if isinstance(value, float):
        text = f"{value:.3g}"
        return f"{value:.0f}" if "e+" in text else text
    return f"{value:,}"
