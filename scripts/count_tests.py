#!/usr/bin/python3
"""Reads the test results of a catkin build, names failed and skipped tests, and prints the counts."""

import pathlib
import sys
import xml.etree.ElementTree as ElementTree


def outcome(case):
    """Returns 'failed', 'skipped' or 'passed', and its message."""
    for tag in ("failure", "error"):
        element = case.find(tag)
        if element is not None:
            return "failed", (element.get("message") or element.text or "").strip()
    skipped = case.find("skipped")
    if skipped is not None or case.get("result") == "skipped":
        text = "" if skipped is None else (skipped.get("message") or skipped.text or "")
        return "skipped", " ".join(text.split())
    return "passed", ""


def main():
    counts = {"passed": 0, "failed": 0, "skipped": 0}
    for path in sorted(pathlib.Path(sys.argv[1]).rglob("*.xml")):
        try:
            cases = ElementTree.parse(path).getroot().iter("testcase")
            for case in cases:
                kind, message = outcome(case)
                counts[kind] += 1
                if kind != "passed":
                    print(f"{kind}: {case.get('classname')}.{case.get('name')}: {message}")
        except ElementTree.ParseError as error:
            counts["failed"] += 1
            print(f"failed: {path} cannot be read: {error}")
    line = f"{counts['passed']} passed, {counts['failed']} failed"
    print(line + (f", {counts['skipped']} skipped" if counts["skipped"] else ""))
    return 1 if counts["failed"] or not counts["passed"] else 0


if __name__ == "__main__":
    sys.exit(main())
