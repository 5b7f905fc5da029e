"""A formula as one line of text gives its value and its MathML; the text and the numbers shown are the same formula."""

import math

import pytest

from silostudy.note import formula
from silostudy.note.mathml import number, rounded, symbol


def test_value_follows_the_usual_order():
    numbers = {"a": 2.0, "b": 3.0, "x": 0.5}
    assert formula.evaluate("a + b*x**2/(1 - x)", numbers) == 2 + 3 * 0.25 / 0.5
    assert formula.evaluate("-a**2", numbers) == -4
    assert formula.evaluate("between(a*b, 0, 1)", numbers) == 1
    assert formula.evaluate("max(a, b) - min(a, b)", numbers) == 1
    assert formula.evaluate("tan(x)*cot(x)", numbers) == pytest.approx(1)
    assert formula.evaluate("a >= 2 and b < 3", numbers) == 0


def test_names_come_in_order_without_functions_and_constants():
    assert formula.names("p*R/mu*(1 - exp(-z/z_o)) + pi*p") == ["p", "R", "mu", "z", "z_o"]


def test_brackets_stand_where_the_formula_needs_them():
    text = formula.mathml("(a + b)*c - (a - b)", symbol)
    plain = text.replace("<mrow>", "").replace("</mrow>", "")
    for name in "abc":
        plain = plain.replace(f"<mi>{name}</mi>", name)
    plain = plain.replace("<mo>", "").replace("</mo>", "")
    assert plain == "(a+b)·c−(a−b)"


def test_a_power_of_a_sum_is_bracketed_and_a_fraction_is_not():
    assert "<mo>(</mo>" in formula.mathml("(a + b)**2", symbol)
    assert "<mo>(</mo>" not in formula.mathml("(a + b)/c", symbol)


def test_numbers_carry_their_unit_and_negative_ones_brackets():
    assert number(2e3, "kPa") == "<mn>2</mn><mtext>\u202fkPa</mtext>"
    assert number(math.radians(30), "°").startswith("<mn>30</mn>")
    assert "<mo>(</mo>" in number(-1.0, "")


@pytest.mark.parametrize(("value", "told"), [(0.0, "0"), (0.0123456, "0.01235"), (123456.0, "123456"), (-7.5, "−7.5")])
def test_four_significant_digits(value, told):
    assert rounded(value) == told


def test_subscripts_and_greek_letters():
    assert symbol("sigma_x__Ed") == "<msub><mi>σ</mi><mtext>x,Ed</mtext></msub>"
