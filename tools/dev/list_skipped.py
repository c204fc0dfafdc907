#!/usr/bin/env python3
"""Prints which tests of a ctest run were skipped, and what each says about why.

Usage: list_skipped.py JUNIT.xml, as `ctest --output-junit` writes it
"""
import re
import sys
import xml.etree.ElementTree

REASON = re.compile(r"^.*(?:skipped: |: Skipped\n|Skipped\n)(.+)$", re.MULTILINE)


def main():
    suite = xml.etree.ElementTree.parse(sys.argv[1]).getroot()
    skipped = [case for case in suite.iter("testcase") if case.find("skipped") is not None]
    print(f"==== {len(skipped)} of {sum(1 for _ in suite.iter('testcase'))} tests were skipped ====")
    for case in skipped:
        reason = REASON.search(case.findtext("system-out", ""))
        print(f"SKIPPED {case.get('name')}: {reason.group(1) if reason else 'no reason given'}")


if __name__ == "__main__":
    main()
