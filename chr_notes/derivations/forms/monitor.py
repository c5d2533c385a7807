"""Forms of the watch over the factor E: which gain it asks for, sample by sample."""

from functools import cache

from sympy import And, S, symbols

from chr_notes.derivations.computation import Choice, Computation, otherwise

ABOVE, THRESHOLD, PATIENCE = symbols("above threshold patience", real=True)
USUAL, LOWEST, HIGHEST = symbols("usual lowest highest", real=True)
FACTOR = symbols("watched_factor", real=True)
CHOSEN, COUNTED = symbols("chosen_gain counted", real=True)


@cache
def gain() -> Computation:
    """Gain to use once E has been above its threshold for so many samples in a row.

    First the accelerometer is heard more, then less; if neither helps, as always.
    """
    more = And(ABOVE > 0, ABOVE <= PATIENCE)
    less = And(ABOVE > PATIENCE, ABOVE <= 2 * PATIENCE)
    branches = ((more, (HIGHEST,)), (less, (LOWEST,)), otherwise(USUAL))
    return Computation((Choice((CHOSEN,), branches),), CHOSEN)


@cache
def samples_above() -> Computation:
    """For how many samples in a row E has been above its threshold; NaN tells nothing."""
    branches = (
        (FACTOR > THRESHOLD, (ABOVE + 1,)),
        (FACTOR <= THRESHOLD, (S.Zero,)),
        otherwise(ABOVE),
    )
    return Computation((Choice((COUNTED,), branches),), COUNTED)
