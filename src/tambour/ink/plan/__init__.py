"""Plan: where everything stands, and a window of it drawn."""
