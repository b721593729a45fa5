"""Runs a command and appends what it took to a file, a line of JSON: python3 timed.py FILE NAME COMMAND...

For `make TIMES=1`, before there is anything but Python itself; `raywalk site --times FILE` shows it.
"""

import json
import os
import resource
import subprocess
import sys
import time

place, name, *command = sys.argv[1:]
begun = time.monotonic()
done = subprocess.run(command)
used = resource.getrusage(resource.RUSAGE_CHILDREN)
os.makedirs(os.path.dirname(place), exist_ok=True)
with open(place, "a", encoding="utf-8") as file:
    row = {
        "name": name,
        "seconds": time.monotonic() - begun,
        "processor": used.ru_utime + used.ru_stime,
    }
    file.write(json.dumps(row) + "\n")
sys.exit(done.returncode)
