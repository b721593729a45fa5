"""Names of files that slides are made from, and of what lies beside a deck and is not published."""

ASKED = "asked.json"  # what the tracer is asked
SIGHTS = "sights.json"  # what it answers
LESSON = "lesson.json"  # the lesson as the viewer's modules know it
KEPT = "slides.pickle"  # a lesson's slides as plain data, for the course
REMARKS = "remarks.txt"  # what could not be written, and why
