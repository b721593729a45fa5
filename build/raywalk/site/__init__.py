"""The site: pages, viewer bundle and scene data, published as plain files."""
