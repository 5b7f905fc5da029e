"""MathML of symbols, numbers and their units: `sigma_x__Ed` is sigma with the subscript x,Ed."""

import re
from html import escape
from math import floor, isfinite, isinf, log10, pi
from xml.etree import ElementTree

GREEK = {
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "eta": "η", "theta": "θ", "lambda": "λ", "mu": "μ",
    "nu": "ν", "phi": "φ", "psi": "ψ", "rho": "ρ", "sigma": "σ", "tau": "τ", "chi": "χ", "omega": "ω", "lam": "λ",
}  # fmt: skip
# unit shown -> (unit in the cube, factor of the shown one)
UNITS = {
    "": ("1", 1.0),
    "m": ("m", 1.0),
    "mm": ("m", 1e-3),
    "cm²": ("m2", 1e-4),
    "cm³": ("m3", 1e-6),
    "cm⁴": ("m4", 1e-8),
    "m³": ("m3", 1.0),
    "°": ("rad", pi / 180),
    "kPa": ("Pa", 1e3),
    "MPa": ("Pa", 1e6),
    "GPa": ("Pa", 1e9),
    "kN": ("N", 1e3),
    "kNm": ("N m", 1e3),
    "kN/m": ("N m-1", 1e3),
    "kN/m³": ("N m-3", 1e3),
    "t": ("kg", 1e3),
}
DIGITS = 4  # that a number in a formula shows
SCRIPTS = ("msub", "msup", "msubsup")
SCRIPT = 0.7  # size of an index or exponent


def tag(name: str, content: str, **attributes: str) -> str:
    """An element."""
    told = "".join(f' {key}="{escape(value)}"' for key, value in attributes.items())
    return f"<{name}{told}>{content}</{name}>"


def mi(text: str) -> str:
    """An identifier; one of several letters stands upright."""
    return tag("mi", escape(text))


def mo(text: str) -> str:
    """An operator."""
    return tag("mo", escape(text))


def row(*parts: str) -> str:
    """Parts side by side, as one argument of a fraction or a power."""
    return tag("mrow", "".join(parts))


def fenced(text: str) -> str:
    """A part in parentheses."""
    return row(mo("("), text, mo(")"))


def math(content: str) -> str:
    """A whole formula within a line of text."""
    return f'<math xmlns="http://www.w3.org/1998/Math/MathML" displaystyle="true">{content}</math>'


def width(content: str) -> float:
    """About how many letters wide MathML is set: a fraction is as wide as its wider part."""

    def wide(node: ElementTree.Element) -> float:
        parts, kind = [wide(part) for part in node], node.tag.rpartition("}")[2]
        if kind == "mfrac":
            return max(parts)
        if kind in SCRIPTS:
            return parts[0] + SCRIPT * sum(parts[1:])
        return len(node.text or "") + sum(parts)

    return wide(ElementTree.fromstring(row(content)))


def symbol(name: str) -> str:
    """MathML of a quantity's name: base and subscript apart by `_`, parts of the subscript by `__`, Greek letters by name."""
    base, _, below = name.partition("_")
    letter = mi(GREEK.get(base, base))
    parts = below.split("__") if below else []
    if parts[:1] == ["bar"]:
        letter, parts = tag("mover", letter + mo("¯")), parts[1:]
    return tag("msub", letter + tag("mtext", ",".join(GREEK.get(part, part) for part in parts))) if parts else letter


def prose(text: str) -> str:
    """HTML of words that name quantities: gamma_Q times z_o in letters with subscripts; what stands in backticks is code."""
    return re.sub(r"`([^`]*)`|\b([A-Za-z]+)(?:_(\w+))?\b", _letter, escape(text, quote=False))


def _letter(match: re.Match) -> str:
    code, base, below = match.groups()
    if code is not None:
        return tag("code", code)
    if base not in GREEK and not (below and len(base) == 1):
        return match[0]
    letter = GREEK.get(base, base)
    return f"{letter}<sub>{GREEK.get(below, below)}</sub>" if below else letter


def shown(value: float, unit: str) -> str:
    """A number in the unit shown, to four significant digits."""
    return rounded(value / UNITS[unit][1])


def rounded(value: float) -> str:
    """A number to four significant digits, never in a power of ten."""
    if isinf(value):
        return "∞"
    if not isfinite(value):
        return "–"
    if abs(value) < 1e-12:
        return "0"
    places = max(0, DIGITS - 1 - floor(log10(abs(value))))
    text = f"{value:.{min(places, 8)}f}"
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return text.replace("-", "−")


def number(value: float, unit: str, bracketed: bool = True) -> str:
    """MathML of a number with its unit; a negative one in brackets, unless it stands alone."""
    text = tag("mn", shown(value, unit)) + (tag("mtext", ("" if unit == "°" else "\u202f") + unit) if unit else "")
    return fenced(text) if value < 0 and bracketed else text
