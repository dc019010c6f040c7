# SPDX-License-Identifier: BSD-3-Clause
"""What VTK's objects report."""


class Messages:
    """Collects the errors and warnings of an object."""

    def __init__(self, *observed):
        self.texts = []
        for one in observed:
            for event in ("ErrorEvent", "WarningEvent"):
                one.AddObserver(event, self)
        self.CallDataType = "string0"

    def __call__(self, caller, event, text):
        self.texts.append(text)
