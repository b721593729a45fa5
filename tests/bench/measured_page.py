"""Writes the page of benchmarks from made-up figures: `measured_page.py OUT STYLE_SHEET`.

So that what is asked of every page can be asked of it where nothing has been measured.
"""

from __future__ import annotations

import sys
from pathlib import Path

from test_page import TEMPLATES, named, report

from raywalk.bench.cases import Case
from raywalk.bench.report import keep_bench, keep_stress
from raywalk.site.reports import publish_reports

out = Path(sys.argv[1])
keep_bench(out / "work", report())
named(out / "work")
keep_stress(out / "work", [Case("s", "c", "m", 0.0, float("inf"), 5, 9)], 5, 9)
publish_reports(out, TEMPLATES, {"style_css": sys.argv[2]}, (), out / "work")
