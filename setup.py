#!/usr/bin/python3
"""Called by catkin, not by users."""
from distutils.core import setup

from catkin_pkg.python_setup import generate_distutils_setup

setup(**generate_distutils_setup(packages=["contact_shapelets"], package_dir={"": "python"}))
