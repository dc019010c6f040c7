#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes an environment of a Python in which the packages of a folder are found, unless it is there, and prints the path of
# its interpreter:  Utilities/python-environment.sh PYTHON ENVIRONMENT FOLDER
# What the Python itself has is found after them.
set -euo pipefail

python="$1"
environment="$2"
folder="$3"

if [ "$("$environment/bin/python3" -c 'import sys; print(sys.base_prefix)' 2>/dev/null)" != \
  "$("$python" -c 'import sys; print(sys.base_prefix)')" ]; then
  rm -rf "$environment"
  "$python" -m venv --without-pip --system-site-packages "$environment"
fi
"$environment/bin/python3" - "$folder" <<'END'
import os
import sys
import sysconfig

path = os.path.join(sysconfig.get_paths()["purelib"], "vtk-headless.pth")
if not os.path.exists(path) or open(path, encoding="utf-8").read() != sys.argv[1] + "\n":
    # Whole at once: another shell may be starting Python here.
    with open(f"{path}.{os.getpid()}", "w", encoding="utf-8") as file:
        file.write(sys.argv[1] + "\n")
    os.replace(f"{path}.{os.getpid()}", path)
END
echo "$environment/bin/python3"
