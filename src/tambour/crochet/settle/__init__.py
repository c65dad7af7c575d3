"""Settle: from a StitchGraph to the shape at which its fabric rests."""
