"""The files of a source tree, for the checkers."""


def files_of(root, *endings):
    """Files under root whose names end so, sorted; build folders and dot folders are left out.

    A wrong root must not pass for a clean tree: no file at all ends the program.
    """
    found = [
        path
        for path in sorted(root.rglob("*"))
        if path.name.endswith(endings) and path.is_file() and not _is_foreign(path.relative_to(root))
    ]
    if not found:
        raise SystemExit(f"{root}: error: no {' '.join(endings)} files here, so nothing was checked")
    return found


def _is_foreign(path):
    top = path.parts[0]
    return top == "build" or top.startswith("build-") or top in (".git", ".cache")


def report(problems, summary):
    """Prints file:line: error: text for each problem, then the summary; the exit code."""
    for here, line, text in problems:
        print(f"{here}:{line}: error: {text}")
    print(f"{summary}, {len(problems)} problems")
    return 1 if problems else 0
