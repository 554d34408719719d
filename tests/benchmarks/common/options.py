"""What the benchmarks' command lines have in common.

    -quick        a tiny mesh, only to see that everything works
    -repeat <n>   median of n runs
    -page <file>  another page than doc/performance.md
    -noPage       print only
"""
import argparse
from pathlib import Path

PAGE = Path(__file__).resolve().parents[3] / "doc" / "performance.md"


class Parser(argparse.ArgumentParser):
    """usage: the text for -h and errors. Options may have two dashes."""

    def __init__(self, usage):
        super().__init__(prog="run", usage=usage, allow_abbrev=False,
                         add_help=False)
        self.add_argument("-h", "-help", action="store_true")
        self.add_argument("-quick", action="store_true")
        self.add_argument("-repeat", type=int)
        self.add_argument("-page", type=Path)
        self.add_argument("-noPage", action="store_true")

    def parse(self, words, repeat):
        """repeat: the default. options.page is None where none is wanted."""
        options = self.parse_args(
            [w[1:] if w.startswith("--") else w for w in words])
        if options.h:
            print(self.usage)
            self.exit()
        options.repeat = options.repeat or (1 if options.quick else repeat)
        return options

    @staticmethod
    def choosePage(options, usual):
        """usual: does the page show what these options give?"""
        if options.noPage:
            options.page = None
        elif options.page is None and usual and not options.quick:
            options.page = PAGE
