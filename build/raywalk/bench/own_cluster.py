"""A Dask cluster of this machine's own: a scheduler and workers, a process each."""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

PATIENCE = 600.0  # seconds: the machine may be busy
OPTIONS = ("--host", "127.0.0.1", "--no-dashboard")


@contextmanager
def own_cluster(workers: int) -> Iterator[tuple[str, list[subprocess.Popen[bytes]]]]:
    """The scheduler's address, and the workers, of one thread each; all are ended at the end."""
    processes: list[subprocess.Popen[bytes]] = []

    def begin(*command: str) -> subprocess.Popen[bytes]:
        processes.append(
            subprocess.Popen(
                [sys.executable, "-m", *command, *OPTIONS], cwd=folder,
                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            )
        )  # fmt: skip
        return processes[-1]

    with tempfile.TemporaryDirectory() as folder:
        try:
            file = Path(folder) / "scheduler.json"
            start = ("distributed.cli.dask_scheduler", "--port", "0", "--scheduler-file")
            address = _address(begin(*start, str(file)), file)
            work = ("distributed.cli.dask_worker", address, "--nthreads", "1", "--no-nanny")
            alone = ("--death-timeout", "60")  # seconds, where we are killed and end nobody
            yield address, [begin(*work, *alone) for _ in range(workers)]
        finally:
            for process in reversed(processes):
                process.kill()
                process.wait()


def _address(scheduler: subprocess.Popen[bytes], file: Path) -> str:
    end = time.monotonic() + PATIENCE
    while not file.exists():
        if scheduler.poll() is not None or time.monotonic() > end:
            raise RuntimeError("the scheduler did not start")
        time.sleep(0.05)
    return str(json.loads(file.read_text(encoding="utf-8"))["address"])
