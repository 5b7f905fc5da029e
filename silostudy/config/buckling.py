"""A buckling study: the strength of shells by theories and design codes, of any cylinder or of Miller's test cylinders."""

from typing import Annotated, Any, ClassVar, Literal, Self, TypeAlias

from pydantic import Discriminator, Tag, field_validator, model_validator

from silostudy.buckling import BUCKLING, RIVALS
from silostudy.catalogue import Family
from silostudy.config.fields import described
from silostudy.config.own import OwnMethods, keys_of
from silostudy.config.steel import Cylinder, Making
from silostudy.config.study import BaseStudy, distinct
from silostudy.tables.miller1977 import TESTS
from silostudy.tables.outputs import OUTPUTS

RuleKeys: TypeAlias = keys_of(BUCKLING)  # type: ignore[valid-type]
RivalKeys: TypeAlias = keys_of(RIVALS)  # type: ignore[valid-type]
TestKey: TypeAlias = Literal[tuple(TESTS)]  # type: ignore[valid-type]


class TestCylinder(Making):
    """One of Miller's test cylinders: steel, sizes and rings come from the table."""

    test: TestKey = described("key of the test, as the source numbers it", "")
    safe_constants: bool = described("for fabricated tests Miller's safe constants in place of his formulas", default=False)


def _which(content: Any) -> str:
    return "a test" if "test" in (content if isinstance(content, dict) else vars(content)) else "a cylinder"


Shell = Annotated[Annotated[TestCylinder, Tag("a test")] | Annotated[Cylinder, Tag("a cylinder")], Discriminator(_which)]


class RuleChoice(OwnMethods, BaseStudy):
    """Base of studies with buckling rules."""

    joins: ClassVar[tuple[Family, ...]] = (BUCKLING, RIVALS)

    rules: RuleKeys = described("buckling rules (`silostudy list buckling`), or all", "")

    @field_validator("rules")
    @classmethod
    def _some_rule(cls, rules):
        if not rules:
            raise ValueError(f"a study needs a rule; known: {', '.join(BUCKLING)}")
        return distinct(rules)

    @model_validator(mode="after")
    def _rules_of_outputs(self) -> Self:
        for key in self.outputs:
            without = set(OUTPUTS[key].rules) - set(self.rule_keys)
            if without:
                raise ValueError(f"output {key} needs the rules {', '.join(sorted(without))}")
        return self

    @property
    def rule_keys(self) -> tuple[str, ...]:
        """The rules asked for, in order."""
        return tuple(self.family(BUCKLING)) if self.rules == "all" else self.rules


class BucklingStudy(RuleChoice):
    """Strength of cylindrical shells under axial compression."""

    kind: Literal["buckling"] = described("buckling: strength of shells by theories and design codes", "")
    scene: Shell = described("the base shell", "")
    rivals: RivalKeys = described(
        "readings of a source that its own data speak against, to be shown beside the rules", "", default=()
    )

    @field_validator("rivals")
    @classmethod
    def _no_twin_rival(cls, keys):
        return distinct(keys)

    @property
    def rival_keys(self) -> tuple[str, ...]:
        """The rival readings asked for, in order."""
        return tuple(self.family(RIVALS)) if self.rivals == "all" else self.rivals
