"""Plan: the order of sewing, what lies over what, and what is measured on the result."""
