"""Names of locals: what a value is, said by its name."""

from sympy import Add, Expr, Mul, Pow, Rational, Symbol

_LONGEST = 40
_POWERS = {2: "{}_squared", -1: "inverse_{}", Rational(1, 2): "root_of_{}"}


def name_of(value: Expr) -> str | None:
    """Say what a product, power or sum of named things is; None where too long.

    Parameters
    ----------
    value
        Such as `cos_roll * yaw`.

    Returns
    -------
    str or None
        Such as `cos_roll_yaw`.
    """
    name = _name(value)
    return name if name is not None and len(name) <= _LONGEST else None


def _name(value: Expr) -> str | None:
    if isinstance(value, Symbol):
        return str(value.name)
    if isinstance(value, Pow) and value.exp in _POWERS:
        base = _name(value.base)
        return _POWERS[value.exp].format(base) if base else None
    if isinstance(value, Mul):
        return _of_product(value)
    if isinstance(value, Add) and len(value.args) == 2:  # noqa: PLR2004 (a sum of two has a name)
        first, second = value.as_ordered_terms()
        parts = _name(first), _name(-second if second.could_extract_minus_sign() else second)
        joined = "minus" if second.could_extract_minus_sign() else "plus"
        return f"{parts[0]}_{joined}_{parts[1]}" if all(parts) else None
    return None


def _of_product(value: Mul) -> str | None:
    coefficient, factors = value.as_coeff_mul()
    if coefficient == Rational(1, 2) and len(factors) == 1:
        inner = _name(factors[0])
        return inner and f"half_{inner}"
    if coefficient not in (1, 2):
        return None
    names = [_name(factor) for factor in factors]
    if not all(names):
        return None
    return "_".join([*(["twice"] if coefficient == 2 else []), *map(str, names)])  # noqa: PLR2004
