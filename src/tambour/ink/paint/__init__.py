"""Paint: marks become a picture on paper, with its inscription and seal."""
