"""Files that the package writes are whole, or none is there."""

import errno
from pathlib import Path

import pytest

from chr_notes.__main__ import main
from chr_notes._texts import write


def test_all_are_written(tmp_path: Path) -> None:
    write({tmp_path / "a": "one\n", tmp_path / "b": "é"})
    assert (tmp_path / "a").read_bytes() == b"one\n"
    assert (tmp_path / "b").read_bytes() == "é".encode()


@pytest.mark.parametrize(
    ("command", "second"),
    [
        (["export", "c"], "attitude.c"),
        (["notebooks"], "estimation.ipynb"),
        (["notebooks", "--without-solutions"], "estimation.ipynb"),
    ],
)
def test_of_a_full_disk_it_is_said_where_and_nothing_stays(
    command: list[str],
    second: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    folder = tmp_path / "mine"
    written = Path.write_bytes

    def full(path: Path, content: bytes) -> int:
        if second not in path.name:
            return written(path, content)
        written(path, content[:100])
        raise OSError(errno.ENOSPC, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(Path, "write_bytes", full)
        assert main([*command, str(folder)]) == 1
    said = capsys.readouterr().err
    assert said == f"{command[0]}: No space left on device: {folder / second}\n"
    assert list(folder.iterdir()) == []
    assert main([*command, str(folder)]) == 0


def test_what_cannot_be_written_anew_stays(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    first, second = tmp_path / "first", tmp_path / "second"
    write({first: "one", second: "two"})
    written = Path.write_bytes

    def full(path: Path, content: bytes) -> int:
        if first.name in path.name:
            return written(path, content)
        raise OSError(errno.ENOSPC, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(Path, "write_bytes", full)
        with pytest.raises(OSError, match="No space left"):
            write({first: "three", second: "four"})
    assert {path: path.read_text() for path in tmp_path.iterdir()} == {first: "one", second: "two"}
    write({first: "three", second: "four"})
    assert second.read_text() == "four"
