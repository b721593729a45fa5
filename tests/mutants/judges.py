"""Which tests judge a mutant of which file: all that concern it, and no others, for time's sake."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple


class Judges(NamedTuple):
    """What pytest is given (files, folders, options), first without compiled kernels, then with.

    To compile the kernels that a mutant is part of costs ten seconds and more, to interpret a few
    quick tests two or three: most mutants die there.
    """

    interpreted: tuple[str, ...]
    compiled: tuple[str, ...]


SCENE = Judges(
    (),
    (
        "tests/scene",
        "tests/commands/test_answers.py",
        "tests/geometry/test_overlap.py",
        "tests/trace/test_scenes_one_to_five.py",
        "tests/trace/test_lights_and_looks.py",
        "--ignore=tests/scene/test_fine_scenes.py",  # traces for half a minute, reads nothing new
    ),
)
OPTICS = Judges(
    # Where a kernel divides by 0 and has its infinity, Python raises.
    (
        "tests/optics",
        "tests/properties/test_optics_laws.py",
        "-k=not almost_at_the_point",
        "--ignore=tests/optics/test_compiling.py",  # compiles
    ),
    (
        "tests/optics",
        "tests/properties/test_optics_laws.py",
        "tests/trace/test_lights_and_looks.py",
        "tests/trace/test_glass.py",
    ),
)
# Kernels here read tables of records, which only numba can.
SHAPES = Judges(
    (),
    (
        "tests/geometry",
        "tests/properties/test_geometry_laws.py",
        "tests/trace/test_touching_glass.py",
        "--ignore=tests/geometry/test_meshes.py",
        "--ignore=tests/geometry/test_mesh_files.py",
    ),
)
MESHES = Judges(
    (),
    (
        "tests/geometry/test_meshes.py",
        "tests/geometry/test_mesh_files.py",
        "tests/geometry/test_leaving.py",
        "tests/trace/test_boxes.py",
    ),
)
MODELS = Judges(
    (),
    (
        "tests/models",
        "tests/bench/test_model_memory.py",
        "tests/commands/test_model.py",
        "tests/geometry/test_mesh_shells.py",
        "tests/scene/test_mesh_parts.py",
    ),
)
WARNINGS = Judges((), ("tests/trace/test_scene_warnings.py", "tests/geometry/test_overlap.py"))
NEIGHBOURS = Judges((), ("tests/trace/test_touching_glass.py", *WARNINGS.compiled))
FOLDERS = {"scene": SCENE, "optics": OPTICS, "geometry": SHAPES, "models": MODELS}
# Files of geometry/ that other tests know better.
FILES = {
    **{
        f"geometry/{name}.py": WARNINGS
        for name in ("coincide", "mesh_points", "overlap", "samples")
    },
    **{f"geometry/{name}.py": NEIGHBOURS for name in ("boxes", "neighbours", "sides")},
    **{
        f"geometry/{name}.py": MESHES
        for name in (
            *(
                "bvh",
                "float32_copy",
                "mesh_file",
                "mesh_rays",
                "mesh_sides",
                "mesh_surface",
                "mesh_target",
                "mesh_world",
            ),
            *("shallow_boxes", "triangle"),
        )
    },
    **{
        f"geometry/{name}.py": Judges((), tests)
        for name, tests in {
            "cross_section": (
                "tests/geometry/test_cross_section.py",
                "tests/geometry/test_cones.py",
                "tests/trace/test_sections.py",
            ),
            "mesh_section": ("tests/trace/test_sections.py",),
            "savings": ("tests/trace/test_plan.py",),
            "mesh_savings": ("tests/trace/test_plan.py",),
            "base_colour": ("tests/scene/test_mesh_parts.py",),
            "texture_lookup": ("tests/scene/test_textures.py", "tests/scene/test_mesh_textures.py"),
            "texture_places": ("tests/scene/test_textures.py", "tests/scene/test_mesh_textures.py"),
            "mesh_corners": ("tests/scene/test_mesh_parts.py",),
            "mesh_normals": ("tests/geometry/test_mesh_normals.py",),
            "mesh_report": ("tests/commands/test_model.py", "tests/scene/test_mesh_parts.py"),
            "mesh_display": ("tests/site/test_mesh_data.py",),
        }.items()
    },
}
# Where kernels are kept is what the copy of the checkout itself decides.
UNJUDGED = {"optics/compiled.py"}


def is_judged(file: Path) -> bool:
    """Whether tests can say anything about the file."""
    return "/".join(file.parts[-2:]) not in UNJUDGED


def judges_of(file: Path) -> Judges:
    """The tests for a source file."""
    return FILES.get("/".join(file.parts[-2:]), FOLDERS[file.parts[-2]])
