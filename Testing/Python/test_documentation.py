# SPDX-License-Identifier: BSD-3-Clause
"""Links in the documentation lead to files."""

import pathlib
import re

import pytest

pytestmark = pytest.mark.one_build

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = sorted(page for folder in (ROOT, ROOT / "Documentation", ROOT / "Data") for page in folder.glob("*.md"))


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links(page):
    links = re.findall(r"\]\(([^)#]+)", page.read_text(encoding="utf-8"))
    missing = [link for link in links if "://" not in link and not (page.parent / link).exists()]
    assert not missing, f"{page.name} links to {missing}"


@pytest.mark.parametrize("page", [page for page in PAGES if page.name != "CHANGELOG.md"], ids=lambda page: page.name)
def test_spelling_is_american(page):
    """As in VTK, and in the names of vtkInk's own classes and options."""
    british = r"\w*(?:colour|neighbour|normalis[ei]|behaviour|synchronis|recognis|quantis|rasteris|favour)\w*|\bgrey\w*|\bcentre[sd]?\b"
    assert not re.findall(british, page.read_text(encoding="utf-8"), re.IGNORECASE)
