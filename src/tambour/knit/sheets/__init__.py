"""Sheets: the chart and the cloth, drawn for eyes and for printers."""
