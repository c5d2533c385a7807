"""What is pasted into the converter is read, whatever its notation, or said to be no rotation."""

from collections.abc import Callable
from pathlib import Path

import numpy as np

from .modules import ROTATION, called

Program = Callable[[str], str]

TEXTS = {
    "brackets": ("matrix", str(ROTATION)),
    "numpy": ("matrix", repr(np.array(ROTATION))),
    "matlab": ("matrix", "; ".join(" ".join(map(str, row)) for row in ROTATION)),
    "lines": ("matrix", "\n".join("\t".join(map(str, row)) for row in ROTATION)),
    "latex": ("matrix", r" \\ ".join(" & ".join(map(str, row)) for row in ROTATION)),
    "unicode minus": ("matrix", str(ROTATION).replace("-", "−")),
    "C": ("matrix", "const float R[3][3] = {{"
          + "}, {".join(", ".join(f"{v}f" for v in row) for row in ROTATION) + "}};"),
    "Fortran": ("matrix", "\n".join(f"{v:.8E}".replace("E", "D") for r in ROTATION for v in r)),
    "4 by 4": ("matrix", str([[*row, 7.5] for row in ROTATION] + [[0, 0, 0, 1]])),
    "decimal commas": (
        "matrix",
        "\n".join(" ".join(map(str, row)) for row in ROTATION).replace(".", ","),
    ),
}  # fmt: skip


def test_a_matrix_in_any_notation(program: Program, tmp_path: Path) -> None:
    program("node")
    own = {"scalarFirst": True}
    given = [[text, kind, own] for kind, text in TEXTS.values()]
    # Pasted into the field of another kind it is a matrix all the same.
    given += [[text, "quaternion", own, True] for _, text in TEXTS.values()]
    made = called(tmp_path, "converter_state.js", "understood", given)
    for name, found in zip([*TEXTS, *TEXTS], made, strict=True):
        assert found.get("kind") == "matrix", (name, found)
        np.testing.assert_allclose(found["value"], np.ravel(ROTATION), atol=1e-15, err_msg=name)


def test_what_is_being_typed_is_of_its_field(program: Program, tmp_path: Path) -> None:
    """Each beginning of it is of the field's kind, or not yet enough; never something else."""
    program("node")
    own = {"scalarFirst": False, "along": ["forward", "left", "up"], "sequence": "xyz",
           "order": [0, 1, 2]}  # fmt: skip
    typed = {
        "quaternion": "0.1, 0.2, 0.3, 0.9273618",
        "axis angle": "0.1 0.2 0.3 45",
        "angles": "0.1 0.2 0.3 0.9",
        "matrix": "0.36 0.48 -0.8 -0.8 0.6 0 0.48 0.64 0.6",
    }
    given = [
        [text[:end], kind, own] for kind, text in typed.items() for end in range(len(text) + 1)
    ]
    given += [["10 20 30", "quaternion", own], ["1 2 3 4 5 6 7 8 9", "angles", own]]
    made = called(tmp_path, "converter_state.js", "understood", given)
    for (text, kind, _), found in zip(given, made, strict=True):
        assert found.get("kind", kind) == kind, text
        full = [float(each) for each in text.replace(",", " ").split() if each not in ("-", ".")]
        assert found.get("value", full) == full, text
    whole = {text: each for (text, _, _), each in zip(given, made, strict=True)}
    assert whole[typed["quaternion"]]["value"] == [0.1, 0.2, 0.3, 0.9273618]
    assert whole["0.1 0.2 0.3 0.9"]["fault"]["words"] == "Expected 3 numbers, found 4."
    assert whole["10 20 30"]["fault"]["words"] == "Expected 4 numbers, found 3."
    assert len(whole[typed["matrix"]]["value"]) == 9


TABLE = {  # text: (kind, scalar first, values)
    "0.5 -0.5 0.5 -0.5": ("quaternion", True, [0.5, -0.5, 0.5, -0.5]),
    "Quaternion(w=0.5, x=-0.1, y=.2, z=3.)": ("quaternion", True, [0.5, -0.1, 0.2, 3]),
    "x: -0.1\ny: 0.2\nz: 3.0\nw: 0.5": ("quaternion", True, [0.5, -0.1, 0.2, 3]),
    '{"w": 0.5, "x": -0.1, "y": 0.2, "z": 3}': ("quaternion", False, [-0.1, 0.2, 3, 0.5]),
    "0.98 - 0.1i + 2e-1j - .3k": ("quaternion", False, [-0.1, 0.2, -0.3, 0.98]),
    "0.98-0.1i+0.2j-0.3k": ("quaternion", True, [0.98, -0.1, 0.2, -0.3]),
    "√2/2, 0, 1/sqrt(2), -√3/2": ("quaternion", True, [0.5**0.5, 0, 0.5**0.5, -(0.75**0.5)]),
    "pi/2, -π/4, 2pi": ("angles", True, [np.pi / 2, -np.pi / 4, 2 * np.pi]),
    "yaw = 30°, pitch = 20°, roll = 10°": ("angles", True, [10, 20, 30]),
    "1.5D+01; -2.0d0; 3": ("angles", True, [15, -2, 3]),
    "- 0.1\n- 0.2\n- -0.3": ("angles", True, [0.1, 0.2, -0.3]),
    "1,2,3": ("angles", True, [1, 2, 3]),
    "0,5 1,5 -2,5": ("angles", True, [0.5, 1.5, -2.5]),
    "0, -1, 0,\n1, 0, 0,\n0, 0, 1": ("matrix", True, [0, -1, 0, 1, 0, 0, 0, 0, 1]),
    "0,-1,0\n1,0,0\n0,0,1": ("matrix", True, [0, -1, 0, 1, 0, 0, 0, 0, 1]),
    "std::array<float64, 3>": None,
    "1 2": None,
    "1.0e-03 *\n1 2 3": ("quaternion", True, [0.001, 1, 2, 3]),
    "0 0 0 0": None,
    "1e999 0 0": None,
    "1 0 0 0 1 0 0 0 -1": None,
    "0.9 0 0 0 1 0 0 0 1": None,
    "nan 1 2": None,
    "": None,
}


def test_texts_are_read(program: Program, tmp_path: Path) -> None:
    program("node")
    names = {"along": ["forward", "right", "down"], "sequence": "xyz", "order": [0, 1, 2]}
    given = [
        [text, "angles" if e is None else e[0], {"scalarFirst": e is None or e[1], **names}]
        for text, e in TABLE.items()
    ]
    made = called(tmp_path, "converter_state.js", "understood", given)
    for (text, expected), found in zip(TABLE.items(), made, strict=True):
        if expected is None:
            assert found["fault"]["words"], text
        else:
            assert found.get("kind") == expected[0], (text, found)
            np.testing.assert_allclose(found["value"], expected[2], rtol=1e-15, err_msg=text)


def test_what_is_no_rotation_is_told_by_how_much(program: Program, tmp_path: Path) -> None:
    program("node")
    rough = np.round(ROTATION, 2)
    texts = [[str(rough.tolist()), "matrix", {}], [str(np.diag([1, 1, -1]).tolist()), "matrix", {}]]
    off, reflected = called(tmp_path, "converter_state.js", "understood", texts)
    defect = np.sqrt(((rough @ rough.T - np.eye(3)) ** 2).mean())
    assert f"off the unit matrix by {float(f'{defect:.3g}')}" in off["fault"]["words"]
    assert "reflection" in reflected["fault"]["words"]
    # A digit or a sign that is wrong is named; many that are rounded are not.
    assert "One number alone" not in off["fault"]["words"]
    wrong = np.array(ROTATION)
    random = np.random.default_rng(3)
    faults = []
    for place in range(9):
        one = wrong.copy()
        one.flat[place] = -one.flat[place] if place % 2 else one.flat[place] + 0.06
        faults.append([str(one.tolist()), "matrix", {}])
    for place, found in enumerate(called(tmp_path, "converter_state.js", "understood", faults)):
        said = f"row {place // 3 + 1}, column {place % 3 + 1}, "
        assert said in found["fault"]["words"], found
        fits = float(found["fault"]["words"].split("where ")[1].split()[0])
        assert abs(fits - wrong.flat[place]) < 1e-3
    matrices = random.normal(size=(40, 3, 3))
    nearest = called(
        tmp_path, "nearest.js", "nearestRotation", [[m.ravel().tolist()] for m in matrices]
    )
    for matrix, found in zip([*matrices], nearest, strict=True):
        left, _, right = np.linalg.svd(matrix)
        if np.linalg.det(matrix) < 0:
            assert found is None
        else:
            np.testing.assert_allclose(found, (left @ right).ravel(), atol=1e-12)
