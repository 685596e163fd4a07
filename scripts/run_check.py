#!/usr/bin/python3
"""Runs a check of the package and writes its result beside those of the tests, for count_tests.py to count.

    run_check.py RESULTS NAME COMMAND...

The check passed if the command exits with 0, and was skipped if it exits with 77."""

import pathlib
import subprocess
import sys
import time
import xml.etree.ElementTree as ElementTree

SKIPPED = 77


def main():
    folder, name, *command = sys.argv[1:]
    begin = time.monotonic()
    run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", check=False)
    suite = ElementTree.Element("testsuite", name="package")
    case = ElementTree.SubElement(suite, "testcase", classname="package", name=name, time=f"{time.monotonic() - begin:.1f}")
    if run.returncode == SKIPPED:
        ElementTree.SubElement(case, "skipped", message=run.stdout.strip())
    elif run.returncode != 0:
        ElementTree.SubElement(case, "failure", message=f"exit status {run.returncode}\n{run.stdout.strip()}")
    pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
    ElementTree.ElementTree(suite).write(pathlib.Path(folder) / f"package-{name}.xml", encoding="utf-8", xml_declaration=True)


if __name__ == "__main__":
    main()
