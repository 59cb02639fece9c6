"""Small mutations of a source file, each a fault that people make."""

import re
from dataclasses import dataclass


@dataclass(frozen=True)
class Mutation:
    """Replaces text[begin:end]."""

    begin: int
    end: int
    replacement: str

    def apply(self, text):
        return text[: self.begin] + self.replacement + text[self.end :]

    def line(self, text):
        return text.count("\n", 0, self.begin) + 1


# Parts that are not code: comments, texts, characters, directives.
NO_CODE = re.compile(
    r"""//[^\n]*|/\*.*?\*/|R"\((?:.*?)\)"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])'|^[ ]*\#[^\n]*""",
    re.DOTALL | re.MULTILINE,
)
# Statements that check the program itself, and declarations of templates.
NOT_MUTATED = re.compile(
    r"^[ ]*(?:assert|static_assert|template|requires|using)\b[^;{]*[;{]?|\b(?:reserve|shrink_to_fit)\([^;\n]*", re.MULTILINE
)

SWAPS = {
    "==": "!=", "!=": "==", "<": ">=", ">=": "<", ">": "<=", "<=": ">",
    "+": "-", "-": "+", "*": "/", "/": "*", "+=": "-=", "-=": "+=", "*=": "/=", "/=": "*=",
    "&&": "||", "||": "&&",
}  # fmt: skip
# Between blanks: so the formatter writes binary operators, and nothing else.
OPERATOR = re.compile(r"(?<= )(?:[=!<>]=|[-+*/]=?|<|>|&&|\|\|)(?=[ \n])")
NOT = re.compile(r"(?<=[\s(])!(?=[\w(:*])")
MINUS = re.compile(r"(?:(?<=[(,={?:] )|(?<=return )|(?<=[({]))-(?=[\w(])")
TRUTH = re.compile(r"\b(?:true|false)\b")
# Not those with an exponent, which are tolerances; not a first value, which is often overwritten,
# nor the 0 of an order, for which the order is turned.
INTEGER = re.compile(r"(?<![\w.'\"])(?<!e-)(?<!\w = )(?<![<>] )(?<![<>]= )\d+(?![\w.'>])|(?<=[<>] )[1-9]\d*(?![\w.'>])")
REAL = re.compile(r"(?<![\w.'])\d+\.\d+(?![\w.'])")
CONDITION = re.compile(r"\bif \((?!const |auto )")
CALL = re.compile(r"(?<=[;{})]) *\n?( *)((?!return|throw|delete|assert|static_assert)[A-Za-z_][\w:.\->\[\]]*\([^;\n]*\);)(?=\n)")
# Calls whose only effect is on time or memory.
HINT = re.compile(r"\breserve\(|\bshrink_to_fit\(|\byield\(|\bcpu_relax\(")
# A value that the author chose: another one is no fault.
CHOICE = re.compile(r"(?:^[ ]*//[^\n]*\[choice\][^\n]*\n(?:[ ]*//[^\n]*\n)*[^\n]*)|(?:^[^\n]*\[choice\][^\n]*)", re.MULTILINE)


def blanked(text, pattern):
    """The text with blanks for what matches; line ends stay."""
    return pattern.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)


def end_of_condition(code, begin):
    """The position of the bracket that closes the one before `begin`; None if a ; comes first."""
    depth = 1
    for at in range(begin, len(code)):
        depth += {"(": 1, ")": -1}.get(code[at], 0)
        if depth == 0:
            return at
        if code[at] == ";":
            return None
    return None


def other_number(digits):
    """Off by one where that is a step of a count, twice as much otherwise."""
    number = int(digits)
    return str(number + 1 if number <= 2 else 2 * number)


def mutations_of(text):
    """All mutations of a source file, in the order of their positions."""
    code = blanked(blanked(text, NO_CODE), NOT_MUTATED)
    found = []

    def add(begin, end, replacement):
        found.append(Mutation(begin, end, replacement))

    for match in OPERATOR.finditer(code):
        beside_text = '"' in (text[match.start() - 2], text[match.end() + 1 : match.end() + 2])
        if not beside_text:  # texts are joined there
            add(match.start(), match.end(), SWAPS[match[0]])
    for pattern in (NOT, MINUS):
        for match in pattern.finditer(code):
            add(match.start(), match.end(), "")
    for match in TRUTH.finditer(code):
        add(match.start(), match.end(), "false" if match[0] == "true" else "true")
    chosen = code
    for match in CHOICE.finditer(text):
        chosen = chosen[: match.start()] + re.sub(r"[^\n]", " ", match[0]) + chosen[match.end() :]
    for match in INTEGER.finditer(chosen):
        add(match.start(), match.end(), other_number(match[0]))
    for match in REAL.finditer(chosen):
        add(match.start(), match.end(), repr(2 * float(match[0]) or 1.0))
    for match in CONDITION.finditer(code):
        end = end_of_condition(code, match.end())
        if end is not None:
            add(match.end(), end, "!(" + text[match.end() : end] + ")")
    for match in CALL.finditer(code):
        if not HINT.search(match[2]):
            add(match.start(2), match.end(2), "{}")
    return sorted(found, key=lambda mutation: (mutation.begin, mutation.end))
