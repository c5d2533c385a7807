"""Table 1 is shown as it was judged."""

from chr_notes.ledger.cases import CASES
from chr_notes.ledger.table import PREFIX, show_table


def test_every_cell_stands_in_the_table_once() -> None:
    text = show_table().markdown
    cells = [name for name in CASES if name.startswith(PREFIX)]
    assert len(cells) == 42
    for name in cells:
        assert text.count(f'id="entry-{name}"') == 1


def test_corrected_numbers_are_struck_out_beside_the_right_ones() -> None:
    rows = show_table().markdown.splitlines()
    one_degree = next(row for row in rows if row.startswith("| 1.0°"))
    cells = one_degree.split(" | ")
    assert "<s>" not in cells[1]
    assert "<s>$612$</s>" in cells[4]
    assert cells[4].endswith("$308$")
