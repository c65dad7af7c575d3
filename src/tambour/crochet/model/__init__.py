"""Model: from a closed surface to rounds that a person can follow, tried in the simulation before anyone takes up a hook."""
