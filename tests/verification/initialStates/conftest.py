"""The boxes of gas that these tests start from are those of gasSchemes."""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent / "gasSchemes"))
