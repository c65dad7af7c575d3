"""Words: the languages that patterns are printed in, and the templates that fill and read them."""
