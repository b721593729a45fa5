"""The stress matrix: every subject in turn, every bound judged."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from raywalk.bench import (
    stress_acne,
    stress_fuzz,
    stress_hits,
    stress_kills,
    stress_media,
    stress_mesh,
    stress_mirrors,
    stress_model_memory,
    stress_models,
    stress_optics,
    stress_order,
    stress_page,
    stress_place,
    stress_runs,
    stress_seams,
    stress_shadows,
    stress_shells,
    stress_silhouette,
)
from raywalk.bench.cases import Case

Subject = Callable[[int, int], Iterator[Case]]

# In the order of the table. Each gets the rays a case asks for, and a seed.
SUBJECTS: dict[str, Subject] = {
    "hits": stress_hits.cases,
    "place": stress_place.cases,
    "silhouette": stress_silhouette.cases,
    "mesh": stress_mesh.cases,
    "seams": stress_seams.cases,
    "optics": stress_optics.cases,
    "mirrors": stress_mirrors.cases,
    "order": stress_order.cases,
    "media": stress_media.cases,
    "shells": stress_shells.cases,
    "shadows": stress_shadows.cases,
    "acne": stress_acne.cases,
    "models": stress_models.cases,
    "fuzz": stress_fuzz.cases,
    "runs": stress_runs.cases,
    "kills": stress_kills.cases,
    "monkey": stress_page.monkey_cases,
    "soak": stress_page.soak_cases,
    "memory": stress_model_memory.cases,
}
RAYS = 1_000_000
SEED = 20_260


def stress(rays: int = RAYS, seed: int = SEED, only: list[str] | None = None) -> Iterator[Case]:
    """All cases of the chosen subjects, as they are measured."""
    for place, (name, cases) in enumerate(SUBJECTS.items()):
        if not only or name in only:
            yield from cases(rays, seed + 100 * place)
