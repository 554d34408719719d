"""The readers of OpenFOAM files, on texts written by hand."""
import numpy as np
import pytest

from foamFile import readHistory, readInternalField, readList

HEADER = """/* comment 1 2 3 */
FoamFile
{
    version 2.0;
    format  ascii;
    class   x;
}
// another 4 5
"""


@pytest.fixture
def file(tmp_path):
    def write(text):
        path = tmp_path / "file"
        path.write_text(text)
        return path

    return write


def test_scalar_list(file):
    path = file(
        HEADER + "internalField nonuniform List<scalar>\n3\n(\n1\n-2.5e-3\n"
        "1e+05\n)\n;\nboundaryField { a { type x; value uniform 7; } }\n"
    )
    assert readInternalField(path, 3).tolist() == [1, -2.5e-3, 1e5]


def test_vector_list(file):
    path = file(
        HEADER + "internalField nonuniform List<vector> 2((1 2 3)(4 5 .6));"
    )
    assert readInternalField(path, 2).tolist() == [[1, 2, 3], [4, 5, 0.6]]


def test_uniform(file):
    scalar = file(HEADER + "internalField uniform 1e5;")
    assert readInternalField(scalar, 2).tolist() == [1e5, 1e5]
    vector = file(HEADER + "internalField uniform (1 0 -1);")
    assert readInternalField(vector, 2).tolist() == [[1, 0, -1]] * 2


def test_repeated_value(file):
    path = file(HEADER + "internalField nonuniform List<scalar> 3{0.25};")
    assert readInternalField(path, 3).tolist() == [0.25] * 3


def test_nan_is_read_as_such(file):
    path = file(HEADER + "internalField nonuniform List<scalar> 2(nan 1);")
    values = readInternalField(path, 2)
    assert np.isnan(values[0]) and values[1] == 1


def test_wrong_size(file):
    path = file(HEADER + "internalField nonuniform List<scalar> 2(1 2);")
    with pytest.raises(ValueError, match="expected 3"):
        readInternalField(path, 3)
    path = file(HEADER + "internalField nonuniform List<scalar> 3(1 2);")
    with pytest.raises(ValueError, match="2 entries, expected 3"):
        readInternalField(path, 3)


def test_no_internal_field(file):
    with pytest.raises(ValueError, match="no internalField"):
        readInternalField(file(HEADER + "dimensions [0 0 0];"), 1)


def test_binary_is_refused(file):
    with pytest.raises(ValueError, match="writeFormat ascii"):
        readList(file(HEADER.replace("ascii", "binary")), 3)


def test_points(file):
    path = file(HEADER + "2\n(\n(0 0 0)\n(1 2 3)\n)\n")
    assert readList(path, 3).tolist() == [[0, 0, 0], [1, 2, 3]]


def test_history(file):
    path = file("# Panel tip\n# time ux uy\n0 (0 0)\n1e-3 (1 -2)\n")
    names, table = readHistory(path)
    assert names == ["time", "ux", "uy"]
    assert table.tolist() == [[0, 0, 0], [1e-3, 1, -2]]


def test_empty_history(file):
    with pytest.raises(ValueError, match="no data"):
        readHistory(file("# time p\n"))
