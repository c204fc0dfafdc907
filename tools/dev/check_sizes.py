#!/usr/bin/env python3
"""Fails when a source file is longer than 600 lines or a function longer than 60.

A function counts from the first line of its signature to its closing brace, as ctags counts it.
C++ functions are found by their braces, without a compiler, so the verdict is the same everywhere.
Usage: check_sizes.py REPOSITORY
"""
import ast
import pathlib
import re
import sys

from source_tree import files_of, report

FILE_LIMIT = 600
FUNCTION_LIMIT = 60

# What may hold braces and parentheses that are no code, in the order in which they must be tried.
NO_CODE = re.compile(
    r'R"(?P<mark>[^()\\\s]{0,16})\(.*?\)(?P=mark)"'
    r"|//[^\n]*"
    r"|/\*.*?\*/"
    r'|"(?:\\.|[^"\\\n])*"'
    r"|(?<![0-9A-Fa-f])'(?:\\.|[^'\\\n])+'"
    r"|(?m:^)[ \t]*\#(?:\\\n|[^\n])*",
    re.DOTALL,
)
SCOPE = re.compile(r"(?:template\s*<.*>\s*)?(?:inline\s+)?(?:namespace|class|struct|union|enum|extern)\b", re.DOTALL)
TEMPLATE = re.compile(r"^template\s*<(?:[^<>]|<[^<>]*>)*>")
LAMBDA = re.compile(r"=\s*\[[^\]]*\]$")
LABEL = re.compile(r"\s*(?:public|private|protected)\s*:(?!:)")


def code_only(text):
    """The text with comments, literals and preprocessor lines blanked, every line kept."""
    return NO_CODE.sub(lambda m: re.sub(r"[^\n]", " ", m.group()), text)


def is_function(head):
    """Whether a brace behind this text opens the body of a function."""
    if LAMBDA.search(head):
        return True
    if "(" not in head or head.count("(") != head.count(")") or SCOPE.match(head):
        return False
    outside = TEMPLATE.sub("", head)
    while "(" in outside:
        outside = re.sub(r"\([^()]*\)", "", outside)
    # `= {` begins a value; `operator==` and `= [](...)` do not.
    return not re.search(r"(?<![=!<>+*/%&|^-])=\s*[^\[=]*$", outside.replace("operator=", ""))


def long_functions(text):
    """Pairs of first line and length of the C++ functions above the limit."""
    code = code_only(text)
    start = 0  # where the text in front of the next brace begins
    depth = 0  # of braces inside the outermost function or value
    body = None
    for mark in re.finditer(r"[{};]", code):
        sign, at = mark.group(), mark.start()
        if depth == 0:
            while label := LABEL.match(code, start, at):
                start = label.end()
            head = code[start:at].strip()
            if sign == "{" and not SCOPE.match(head):
                depth = 1
                body = code.index(head, start) if is_function(head) else None
            elif "(" not in head or head.count("(") == head.count(")"):
                start = at + 1
            continue
        depth += {"{": 1, "}": -1, ";": 0}[sign]
        if depth > 0:
            continue
        if re.match(r"\s*[,{)]", code[at + 1:at + 200]):
            continue  # of an initialiser list or a default argument: the body is still to come
        start = at + 1
        if body is not None:
            first, last = (code.count("\n", 0, where) + 1 for where in (body, at))
            if last - first + 1 > FUNCTION_LIMIT:
                yield first, last - first + 1


def long_python_functions(text):
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            length = node.end_lineno - node.lineno + 1
            if length > FUNCTION_LIMIT:
                yield node.lineno, length


def problems_of(here, text):
    lines = text.count("\n")
    if lines > FILE_LIMIT:
        yield here, 1, f"{lines} lines, the limit is {FILE_LIMIT}"
    functions = long_python_functions if here.endswith(".py") else long_functions
    for number, length in functions(text):
        yield here, number, f"a function of {length} lines, the limit is {FUNCTION_LIMIT}"


def main():
    root = pathlib.Path(sys.argv[1])
    problems = []
    files = files_of(root, ".h", ".cc", ".py")
    for file in files:
        problems += problems_of(file.relative_to(root).as_posix(), file.read_text(errors="replace"))
    return report(problems, f"sizes: {len(files)} files")


if __name__ == "__main__":
    sys.exit(main())
