#!/usr/bin/env python3
"""Says how many tests ran, which of them were skipped, and what each says about why.

Usage: list_skipped.py FOLDER of the result files of the test programs, as GTEST_OUTPUT=xml:FILE makes them
"""
import pathlib
import sys
import xml.etree.ElementTree


def reason_of(case):
    skipped = case.find("skipped")
    return None if skipped is None else skipped.get("message", "").strip().splitlines()


def main():
    files = sorted(pathlib.Path(sys.argv[1]).glob("*.xml"))
    if not files:
        sys.exit(f"{sys.argv[1]}: no results of tests")
    cases = [case for file in files for case in xml.etree.ElementTree.parse(file).getroot().iter("testcase")
             if case.get("status") == "run"]
    skipped = [case for case in cases if reason_of(case) is not None]
    print(f"==== {len(cases)} tests, {len(skipped)} of them skipped ====")
    for case in skipped:
        reason = reason_of(case)
        print(f"SKIPPED {case.get('classname')}.{case.get('name')}: {reason[-1] if reason else 'no reason given'}")


if __name__ == "__main__":
    main()
