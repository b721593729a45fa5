"""Sentences and numbers for people, out of site_src/words/<language>.json."""

from raywalk.words.catalogue import Phrase, Words, languages, plain, read_words

__all__ = ["Phrase", "Words", "languages", "plain", "read_words"]
