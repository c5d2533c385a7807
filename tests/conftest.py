"""Where the material beside the project lies, and what may be missing."""

from pathlib import Path

import pytest

SHARED = Path(__file__).resolve().parents[2] / "shared"


@pytest.fixture(scope="session")
def shared() -> Path:
    """The folder with the documents and other people's data; a test that needs it skips."""
    if not SHARED.is_dir():
        pytest.skip("the material beside the project (../shared) is not there")
    return SHARED
