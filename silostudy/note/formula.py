"""A formula as one line of text, `gamma*R/mu*(1 - exp(-z/z_o))`: its value, and its MathML in symbols or in numbers."""

import ast
import operator
from collections.abc import Callable, Mapping
from functools import cache

import numpy as np

from silostudy.note.mathml import fenced, mi, mo, row, tag

FUNCTIONS: dict[str, Callable] = {
    **{name: getattr(np, name) for name in ("sqrt", "exp", "sin", "cos", "tan")},
    "cot": lambda angle: 1 / np.tan(angle),
    "asin": np.arcsin,
    "acos": np.arccos,
    "atan": np.arctan,
    "max": lambda *values: np.max(values),
    "min": lambda *values: np.min(values),
    "between": lambda value, least, most: np.clip(value, least, most),
}
COMPARED: dict[type, tuple[str, Callable]] = {
    ast.Lt: ("<", operator.lt),
    ast.LtE: ("≤", operator.le),
    ast.Gt: (">", operator.gt),
    ast.GtE: ("≥", operator.ge),
    ast.Eq: ("=", operator.eq),
}
OPERATORS: dict[type, Callable] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: operator.pow,
}
CONSTANTS = {"pi": np.pi}
SUM, PRODUCT, SIGN, POWER, WHOLE = range(1, 6)  # how tightly a part of a formula holds together
HOLDS: dict[type, int] = {ast.Add: SUM, ast.Sub: SUM, ast.Mult: PRODUCT, ast.Div: WHOLE, ast.Pow: POWER}
Written = Callable[[str], str]  # MathML of a name: its symbol, or its number


@cache
def parsed(text: str) -> ast.expr:
    """The tree of a formula."""
    return ast.parse(text, mode="eval").body


def names(text: str) -> list[str]:
    """The quantities that a formula asks for, in the order in which they stand in it."""
    calls = {node.func.id for node in ast.walk(parsed(text)) if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)}
    nodes = [node for node in ast.walk(parsed(text)) if isinstance(node, ast.Name)]
    nodes.sort(key=lambda node: node.col_offset)
    return list(dict.fromkeys(node.id for node in nodes if node.id not in calls and node.id not in CONSTANTS))


def evaluate(text: str, numbers: Mapping[str, float]) -> float:
    """The value of a formula with numbers in SI."""
    return float(_value(parsed(text), {**CONSTANTS, **numbers}))


def _value(node: ast.expr, numbers: Mapping[str, float]):
    match node:
        case ast.Constant(value=value):
            return value
        case ast.Name(id=name):
            return numbers[name]
        case ast.UnaryOp(op=ast.USub(), operand=inner):
            return -_value(inner, numbers)
        case ast.BinOp(left=left, op=op, right=right):
            return OPERATORS[type(op)](_value(left, numbers), _value(right, numbers))
        case ast.Compare(left=left, ops=[op], comparators=[right]):
            return float(COMPARED[type(op)][1](_value(left, numbers), _value(right, numbers)))
        case ast.BoolOp(op=joint, values=values):
            holding = [_value(part, numbers) for part in values]
            return float(all(holding) if isinstance(joint, ast.And) else any(holding))
        case ast.Call(func=ast.Name(id=name), args=arguments):
            return FUNCTIONS[name](*(_value(argument, numbers) for argument in arguments))
    raise ValueError(f"a formula cannot hold {ast.dump(node)}")


def mathml(text: str, written: Written) -> str:
    """The formula in MathML, every name as `written` has it."""
    return _written(parsed(text), written)[0]


def _written(node: ast.expr, name_of: Written, linear: bool = False) -> tuple[str, int]:
    """MathML of a formula, and how tightly it holds together; linear: fractions with a stroke, as in an exponent."""
    match node:
        case ast.Constant(value=int() | float() as value):
            return tag("mn", f"{float(value):g}"), WHOLE
        case ast.Name(id=name):
            return (mi("π") if name == "pi" else name_of(name)), WHOLE
        case ast.UnaryOp(operand=inner):
            return row(mo("−"), _tight(inner, PRODUCT, name_of, linear)), SUM
        case ast.BinOp(left=left, op=op, right=right):
            return _joined(left, op, right, name_of, linear), _holds(left, op, linear)
        case ast.Compare(left=left, ops=[op], comparators=[right]):
            return row(_written(left, name_of)[0], mo(COMPARED[type(op)][0]), _written(right, name_of)[0]), SUM
        case ast.Call(func=ast.Name(id=function), args=arguments):
            return _called(function, [_written(argument, name_of, function == "exp")[0] for argument in arguments]), WHOLE
    raise ValueError(f"a formula cannot hold {ast.dump(node)}")


def _holds(left: ast.expr, op: ast.operator, linear: bool) -> int:
    if isinstance(left, ast.UnaryOp) and isinstance(op, (ast.Mult, ast.Div)):
        return SUM
    return PRODUCT if linear and isinstance(op, ast.Div) else HOLDS[type(op)]


def _tight(node: ast.expr, least: int, name_of: Written, linear: bool = False) -> str:
    text, holds = _written(node, name_of, linear)
    return text if holds >= least else fenced(text)


def _joined(left: ast.expr, op: ast.operator, right: ast.expr, name_of: Written, linear: bool) -> str:
    def factor(node: ast.expr) -> str:
        return _tight(node, SUM if isinstance(node, ast.UnaryOp) else PRODUCT, name_of, linear)

    match op:
        case ast.Div() if linear:
            return row(factor(left), mo("/"), _tight(right, POWER, name_of, linear))
        case ast.Div():
            return tag("mfrac", row(_written(left, name_of)[0]) + row(_written(right, name_of)[0]))
        case ast.Pow():
            whole = isinstance(left, (ast.Name, ast.Constant))
            base = _written(left, name_of, linear)[0] if whole else fenced(_written(left, name_of, linear)[0])
            return tag("msup", row(base) + row(_written(right, name_of, True)[0]))
        case ast.Mult():
            return row(factor(left), mo("·"), _tight(right, PRODUCT, name_of, linear))
        case ast.Add():
            return row(_written(left, name_of, linear)[0], mo("+"), _tight(right, SUM, name_of, linear))
        case ast.Sub():
            return row(_written(left, name_of, linear)[0], mo("−"), _tight(right, PRODUCT, name_of, linear))
    raise ValueError(f"a formula cannot hold {op}")


def _called(function: str, arguments: list[str]) -> str:
    match function:
        case "sqrt":
            return tag("msqrt", arguments[0])
        case "exp":
            return tag("msup", mi("e") + row(arguments[0]))
        case "between":
            value, least, most = arguments
            return row(mi("min"), fenced(row(mi("max"), fenced(value + mo(";") + least), mo(";"), most)))
    inner = mo(";").join(arguments)
    return row(mi(function if function not in ("asin", "acos", "atan") else f"arc{function[1:]}"), fenced(inner))
