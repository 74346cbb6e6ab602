"""maturin, after a look at what the build of GMP needs: its own complaint stands far up in the log."""

import os
import shutil
import sys
from pathlib import Path

import maturin
from maturin import *  # noqa: F403  the hooks that are not replaced below


def _missing(config_settings):
    """The tools that the build needs and that are not there."""
    needed = ["cargo"]
    if "--no-default-features" not in str(config_settings):
        home = os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache")
        cache = os.environ.get("GMP_MPFR_SYS_CACHE") or Path(home, "gmp-mpfr-sys")
        if not any(Path(cache).glob("**/libmpfr.a")):
            needed += ["m4", "make", "cc", "diff"]
    return [tool for tool in needed if shutil.which(tool) is None]


def _check(config_settings):
    missing = _missing(config_settings)
    if "cargo" in missing:
        sys.exit("mdr-contact is built from Rust: install it from https://rustup.rs, and put cargo into the PATH")
    if missing:
        sys.exit(
            f"certified digits need GMP, and its build needs {', '.join(missing)}: apt-get install {' '.join(missing)},\n"
            "or without certified digits: pip install --config-settings build-args=--no-default-features …"
        )


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    _check(config_settings)
    return maturin.build_wheel(wheel_directory, config_settings, metadata_directory)


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    _check(config_settings)
    return maturin.build_editable(wheel_directory, config_settings, metadata_directory)
