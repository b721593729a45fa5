"""What slides are written as, and of what: names that every writer and the command line share."""

from __future__ import annotations

COURSE = "course"  # the id of the deck of all scenes
PER_SHEET = (2, 3, 6)  # slides on a sheet of a handout
DECK_FORMATS = ("html", "pdf", "pptx")
SHEET_FORMATS = tuple(f"handout-{count}" for count in PER_SHEET)
LESSON_FORMATS = ("svg", "worksheet")
PUBLISHED = (*DECK_FORMATS, *SHEET_FORMATS, *LESSON_FORMATS)
# Answers are for teachers: they are in what `raywalk teacher` makes, and no page links to them.
FORMATS = (*PUBLISHED, "answers")
# What the command line may say for several.
GROUPS = {"decks": DECK_FORMATS, "handouts": SHEET_FORMATS}
TRANSLATED = (*DECK_FORMATS, *LESSON_FORMATS)  # any printer sets several slides on a sheet
COURSE_FORMATS = ("pdf", "pptx")  # as one page it would be heavy, and every lesson has its own

# Files that slides are made from, and what lies beside a deck and is not published.
ASKED = "asked.json"  # what the tracer is asked
SIGHTS = "sights.json"  # what it answers
LESSON = "lesson.json"  # the lesson as the viewer's modules know it
KEPT = "slides.pickle"  # a lesson's slides as plain data, for the course
REMARKS = "remarks.txt"  # what could not be written, and why
