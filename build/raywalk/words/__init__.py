"""Sentences and numbers for people, out of site_src/words/<language>.json."""

from raywalk.words.catalogue import (
    Phrase,
    Words,
    languages,
    missing_sentences,
    plain,
    read_words,
)

__all__ = ["Phrase", "Words", "languages", "missing_sentences", "plain", "read_words"]
