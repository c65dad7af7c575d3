"""Embroidery: a drawing becomes thread, for a machine and on cloth that moves."""

from __future__ import annotations
