"""Page: charts, written patterns and the booklet."""
