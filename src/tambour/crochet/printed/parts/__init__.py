"""Printed patterns, parts: rounds → parts: where they begin, go on, are worked again, change their yarn, join and end."""
