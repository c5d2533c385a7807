"""Changes that look like misprints and are none, each with the reason; the test proves each."""

EQUIVALENT: dict[tuple[str, str], str] = {}
