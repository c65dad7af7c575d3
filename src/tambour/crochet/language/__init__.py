"""Language: tambour's own words for stitches, and the tree that every reader gives."""
