"""Which form of a plural a number takes, as browsers choose it (Intl.PluralRules): the rules of the
Unicode CLDR for whole numbers, "Language Plural Rules", by language. tests/words asks both."""

from __future__ import annotations

from collections.abc import Callable

Rule = Callable[[int], str]


def _one(n: int) -> str:
    return "one" if n == 1 else "other"


def _none_or_one(n: int) -> str:
    return "one" if n in (0, 1) else "other"


def _never(n: int) -> str:
    return "other"


def _czech(n: int) -> str:
    return "one" if n == 1 else "few" if 2 <= n <= 4 else "other"


def _few(n: int) -> bool:
    return 2 <= n % 10 <= 4 and not 12 <= n % 100 <= 14


def _polish(n: int) -> str:
    return "one" if n == 1 else "few" if _few(n) else "many"


def _russian(n: int) -> str:
    if n % 10 == 1 and n % 100 != 11:
        return "one"
    return "few" if _few(n) else "many"


def _arabic(n: int) -> str:
    if n < 3:
        return ("zero", "one", "two")[n]
    return "few" if 3 <= n % 100 <= 10 else "many" if n % 100 >= 11 else "other"


def _hebrew(n: int) -> str:
    return {1: "one", 2: "two"}.get(n, "other")


RULES: dict[str, Rule] = {
    **dict.fromkeys(("de", "el", "en", "et", "fi", "hu", "nb", "nl", "sv", "tr"), _one),
    **dict.fromkeys(("hi", "fa"), _none_or_one),
    **dict.fromkeys(("id", "ja", "ko", "th", "vi", "zh"), _never),
    **dict.fromkeys(("cs", "sk"), _czech),
    **dict.fromkeys(("ru", "uk"), _russian),
    "pl": _polish, "ar": _arabic, "he": _hebrew,
}  # fmt: skip
# A million is "many" to them, but for that.
RULES |= dict.fromkeys(("es", "it"), lambda n: _million(n) or _one(n))
RULES |= dict.fromkeys(("fr", "pt"), lambda n: _million(n) or _none_or_one(n))


def _million(n: int) -> str:
    return "many" if n and n % 1_000_000 == 0 else ""


def plural_form(language: str, count: object) -> str:
    """count: a whole number, or its digits; of anything else, such as a number that is written in
    groups, it is "other". Raises KeyError for a language without a rule."""
    code = language.partition("-")[0]
    if code not in RULES:
        raise KeyError(f'words/plurals.py has no rule for "{language}"; it has {", ".join(RULES)}')
    digits = str(count)
    return RULES[code](int(digits)) if digits.isascii() and digits.isdigit() else "other"
