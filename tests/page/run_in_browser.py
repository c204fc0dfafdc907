#!/usr/bin/env python3
"""Runs a test of report pages: NAME_test.mjs beside this file, or the type check of the page's script.

Usage: run_in_browser.py NAME BUNDLE PACKAGES NODE CHROMIUM G31

Ends with 77, and says why, where something that it needs is not there.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parents[1] / "tools" / "page" / "web" / "src"


def missing(bundle, packages, node, chromium):
    """What is not there, in words; None where all is."""
    if not node or node.endswith("NOTFOUND"):
        return "no node (Debian: nodejs npm)"
    if not (pathlib.Path(packages) / "node_modules" / "playwright-core").is_dir():
        return "the packages of the page are not installed: npm was not there when g31 was configured"
    if not (pathlib.Path(bundle) / "page.js").is_file():
        return "the page's script was not built (target g31_page_bundle)"
    if not chromium or chromium.endswith("NOTFOUND"):
        return "no chromium (Debian: chromium)"
    return None


def check_types(packages):
    """The exit code of tsc over the script, whose JSDoc comments are its types."""
    modules = pathlib.Path(packages).resolve() / "node_modules"
    options = {
        "strict": True, "checkJs": True, "allowJs": True, "noEmit": True, "target": "es2022", "module": "esnext",
        "moduleResolution": "bundler", "lib": ["es2022", "dom", "dom.iterable"], "skipLibCheck": True, "types": [],
        "paths": {"three": [f"{modules}/@types/three"], "three/*": [f"{modules}/@types/three/*"], "fflate": [f"{modules}/fflate"]},
    }
    with tempfile.TemporaryDirectory() as folder:
        project = pathlib.Path(folder) / "tsconfig.json"
        project.write_text(json.dumps({"compilerOptions": options, "files": [f"{SOURCE}/page.js", f"{SOURCE}/types.d.ts"]}))
        return subprocess.run([modules / ".bin" / "tsc", "-p", project], check=False).returncode


def main():
    name, bundle, packages, node, chromium, g31 = sys.argv[1:7]
    reason = missing(bundle, packages, node, chromium)
    if reason:
        print(f"skipped: {reason}")
        return 77
    if name == "page_types":
        return check_types(packages)
    places = {"G31_PAGE_BUNDLE": bundle, "G31_PAGE_PACKAGES": packages, "G31_CHROMIUM": chromium, "G31_PROGRAM": g31}
    return subprocess.run([node, "--test", "--test-reporter=spec", HERE / f"{name}_test.mjs"],
                          env={**os.environ, **places}, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
