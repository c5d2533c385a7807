"""How much a test tries: little by default, more with `--full`."""

from hypothesis import settings


def few(count: int) -> settings:
    """So many examples, for a test whose examples are dear; in proportion more with `--full`."""
    usual = settings.get_profile("project").max_examples
    return settings(max_examples=count * settings.default.max_examples // usual)
