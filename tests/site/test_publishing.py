"""The workflow that publishes runs what the README tells, with no more rights than it needs."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import yaml  # of Dask, which the tests need anyway

ROOT = Path(__file__).parent.parent.parent
WORKFLOW = yaml.safe_load((ROOT / ".github" / "workflows" / "publish.yml").read_text("utf-8"))
JOBS = WORKFLOW["jobs"]


def steps():
    return [step for job in JOBS.values() for step in job["steps"]]


def test_it_builds_and_tests_by_the_two_commands_and_runs_nothing_else():
    """make, make test: what a stranger would type."""
    assert [step["run"] for step in steps() if "run" in step] == ["make", "make test"]


def test_every_action_is_pinned_to_a_commit_of_githubs_own():
    """A tag can be moved; a commit cannot."""
    used = [step["uses"] for step in steps() if "uses" in step]
    assert len(used) == 5
    for action in used:
        assert re.fullmatch(r"actions/[a-z-]+@[0-9a-f]{40}", action)


def test_no_job_has_a_right_that_it_does_not_need():
    """Nothing by default; the tests may read; only what publishes may publish, and it runs no
    code of the repository."""
    assert WORKFLOW["permissions"] == {}
    assert JOBS["site"]["permissions"] == {"contents": "read"}
    assert JOBS["publish"]["permissions"] == {"pages": "write", "id-token": "write"}
    assert not any("run" in step or "checkout" in step["uses"] for step in JOBS["publish"]["steps"])
    checkout = next(step for step in steps() if "checkout" in step.get("uses", ""))
    assert checkout["with"]["persist-credentials"] is False


@pytest.mark.parametrize("job", JOBS)
def test_only_main_is_published_and_no_job_runs_for_ever(job):
    """A pull request is built and tested, no more."""
    assert JOBS[job]["timeout-minutes"] <= 60
    guarded = [JOBS["publish"], *(step for step in steps() if "upload" in step.get("uses", ""))]
    for each in guarded:
        assert each["if"].startswith("github.ref == 'refs/heads/main'")
    assert JOBS["publish"]["needs"] == "site"
    upload = next(step for step in steps() if "upload" in step.get("uses", ""))
    assert upload["with"] == {"path": "dist"}
