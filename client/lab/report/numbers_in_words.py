"""Numbers as people read them: three digits and a unit of the right size."""

import math

PREFIXES = ((1, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n"), (1e-12, "p"), (1e-15, "f"))
NOTHING = "–"
SUPERSCRIPT = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def _digits(value, digits):
    """Plain, with that many significant digits: 0.0123, 1.23, 1230."""
    if value == 0:
        return "0"
    # Rounded first, so that 9.996 becomes 10.0 and not 10.00.
    rounded = float(f"{value:.{digits - 1}e}")
    decimals = max(0, digits - 1 - math.floor(math.log10(abs(rounded))))
    return f"{rounded:.{decimals}f}"


def power_of_ten(value, digits=2):
    mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
    power = f"10{str(int(exponent)).translate(SUPERSCRIPT)}"
    return power if float(mantissa) == 1 else f"{mantissa} × {power}"


def quantity(value, unit, digits=3):
    """`1.23 mm`; from femto down to powers of ten; `–` where there is none."""
    if value is None:
        return NOTHING
    size = abs(float(f"{value:.{digits - 1}e}"))
    if size == 0:
        return f"0 {unit}"
    if size >= 1e4:
        return f"{power_of_ten(value)} {unit}"
    for factor, prefix in PREFIXES:
        if size >= factor:
            return f"{_digits(value / factor, digits)} {prefix}{unit}"
    return f"{power_of_ten(value)} {unit}"


def metres(value, digits=3):
    """As quantity, with centimetres where they are what people say."""
    if value is not None and 0.009995 <= value < 0.995:
        return f"{_digits(value * 100, digits)} cm"
    return quantity(value, "m", digits)


def time_of_ns(ns, digits=3):
    return quantity(None if ns is None else ns * 1e-9, "s", digits)


def percent(share):
    if share is None:
        return NOTHING
    if 0.9995 <= share < 1:
        return "99.9… %"  # not all of them
    return "0 %" if share == 0 else f"{_digits(share * 100, 2 if share < 0.1 else 3)} %"


def plain(value, digits=3):
    """A number without a unit; powers of ten where there would be many zeros."""
    if value is None:
        return NOTHING
    return power_of_ten(value) if 0 < abs(value) < 1e-3 else _digits(value, digits)


def duration(seconds):
    """`48 s`, `15 min 12 s`."""
    whole = round(seconds)
    return f"{whole} s" if whole < 60 else f"{whole // 60} min {whole % 60} s"


def times(factor, digits=2):
    """A ratio: `0.85`, `12`, `1.2 million`."""
    for size, name in ((1e9, "billion"), (1e6, "million")):
        if size <= factor < size * 1000:
            return f"{_digits(factor / size, digits)} {name}"
    if factor >= 1e12 or factor < 1e-3:
        return power_of_ten(factor)
    return _digits(factor, digits)


def listed(words):
    """`a`, `a and b`, `a, b and c`."""
    words = list(words)
    return " and ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)
