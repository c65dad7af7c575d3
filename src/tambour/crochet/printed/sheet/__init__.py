"""Printed patterns, the sheet: a text as it lies on its page, put as plain lines: columns, tables, headings, broken lines, lists without numbers."""
