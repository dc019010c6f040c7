#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes an environment of a Python in which the packages of some folders are found, unless it is there, and prints the path
# of its interpreter:  Utilities/python-environment.sh PYTHON ENVIRONMENT FOLDER...
# What the Python itself has is found after them.
set -euo pipefail

python="$1"
environment="$2"
shift 2

if [ "$("$environment/bin/python3" -c 'import sys; print(sys.base_prefix)' 2>/dev/null)" != \
  "$("$python" -c 'import sys; print(sys.base_prefix)')" ]; then
  rm -rf "$environment"
  "$python" -m venv --without-pip --system-site-packages "$environment"
fi
"$environment/bin/python3" - "$@" <<'END'
import os
import sys
import sysconfig

path = os.path.join(sysconfig.get_paths()["purelib"], "vtk-headless.pth")
lines = "".join(folder + "\n" for folder in sys.argv[1:])
if not os.path.exists(path) or open(path, encoding="utf-8").read() != lines:
    # Whole at once: another shell may be starting Python here.
    with open(f"{path}.{os.getpid()}", "w", encoding="utf-8") as file:
        file.write(lines)
    os.replace(f"{path}.{os.getpid()}", path)
END
echo "$environment/bin/python3"
