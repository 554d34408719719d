"""The writer of tables of results."""
import pytest

from resultPage import between

PAGE = """before
<!-- a: written by writeTable.py -->

old
<!-- a: end -->
<!-- b: written by writeTable.py -->
other
<!-- b: end -->
after
"""


def test_only_what_is_between_the_marks_is_replaced():
    page = between(PAGE, "a", ["", "| x |", "| y |"])
    assert page == PAGE.replace("\nold\n", "\n| x |\n| y |\n\n")
    assert between(page, "a", ["| x |", "| y |"]) == page


def test_a_page_without_the_marks_is_an_error():
    with pytest.raises(ValueError):
        between(PAGE, "c", [])
