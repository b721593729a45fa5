"""Makes a newer build of a built site: all titles of scenes say so, in pages and in their data."""

import base64
import gzip
import json
import re
import sys
from pathlib import Path

from raywalk.site.offline import write_worker
from raywalk.trace_file.container import write_script

NEWER = "Newer: "

site = Path(sys.argv[1])
for path in site.glob("scenes/*/scene.js"):
    packed = re.search(r'"([A-Za-z0-9+/=]{100,})"', path.read_text())[1]
    scene = json.loads(gzip.decompress(base64.b64decode(packed)))
    scene["title"] = NEWER + scene["title"]
    write_script(path, f"{path.parent.name}/scene", json.dumps(scene).encode())
for path in [site / "index.html", *site.glob("scenes/*/index.html")]:
    path.write_text(path.read_text().replace("<title>", f"<title>{NEWER}"))
write_worker(site, Path("site_src"))
