"""Sentences and numbers for people, out of site_src/words/<language>.json."""

from raywalk.words.catalogue import Words, languages, missing_sentences, read_words

__all__ = ["Words", "languages", "missing_sentences", "read_words"]
