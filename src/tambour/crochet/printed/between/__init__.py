"""Printed patterns, between the rounds: headings, lists of materials, sentences that put, stuff and sew, and what is told since it was not understood."""
