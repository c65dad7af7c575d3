"""OpenAPI: the table of routes as a document for programs, and as a page for people."""

from __future__ import annotations

import re
from html import escape
from typing import Any

from tambour import __version__
from tambour.studio.routes import PARAMETERS, ROUTES, Route

_PROBLEM = {
    "type": "object",
    "properties": {
        "message": {"type": "string"},
        "hint": {"type": "string"},
        "line": {"type": ["integer", "null"]},
        "column": {"type": ["integer", "null"]},
        "length": {"type": ["integer", "null"]},
        "span": {"type": ["array", "null"], "items": {"type": "integer"}},
        "where": {"type": "string"},
        "fields": {"type": "array", "items": {"type": "string"}},
        "warning": {"type": "boolean"},
    },
}
_PROBLEMS = {"type": "object", "properties": {"problems": {"type": "array", "items": _PROBLEM}}}
REFUSALS = {
    "400": "what was sent is no JSON",
    "401": "no token",
    "403": "sent by another page",
    "404": "not there",
    "408": "the rest did not come",
    "409": "changed elsewhere",
    "413": "too large",
    "415": "of another type than JSON",
    "422": "cannot be made of this",
    "429": "too much at once",
    "499": "the page left",
    "503": "the making was stopped",
    "507": "the disk is full",
}


def document() -> dict[str, Any]:
    """The OpenAPI document."""
    paths: dict[str, Any] = {}
    schemas: dict[str, Any] = {"Problems": _PROBLEMS}
    for route in ROUTES:
        paths.setdefault(route.path, {})[route.method.lower()] = _operation(route, schemas)
    return {
        "openapi": "3.1.0",
        "info": {"title": "Tambour's studio", "version": __version__, "description": __doc__},
        "paths": paths,
        "components": {
            "schemas": schemas,
            "securitySchemes": {"cookie": {"type": "apiKey", "in": "cookie", "name": "tambour-PORT"}},
        },
        "security": [{"cookie": []}],
    }


def _operation(route: Route, schemas: dict[str, Any]) -> dict[str, Any]:
    found = [
        {
            "name": name,
            "in": "path",
            "required": True,
            "schema": {"type": "string", "pattern": f"^{PARAMETERS[name]}$"},
        }
        for name in re.findall(r"\{(\w+)\}", route.path)
    ]
    found += [
        {"name": name, "in": "query", "required": False, "description": text, "schema": {"type": "string"}}
        for name, text in route.query
    ]
    good: dict[str, Any] = {
        "description": "made" if route.method == "POST" else "found",
        "content": {route.gives: {"schema": {}}},
    }
    bad = {
        status: {
            "description": text,
            "content": {"application/json": {"schema": {"$ref": "#/components/schemas/Problems"}}},
        }
        for status, text in REFUSALS.items()
    }
    told: dict[str, Any] = {
        "summary": route.help,
        "operationId": route.do.__name__,
        "parameters": found,
        "responses": {"200": good, "201": good, "304": {"description": "as before"}, **bad},
    }
    if route.takes is not None:
        schema = route.takes.model_json_schema(ref_template="#/components/schemas/{model}")
        schemas.update(schema.pop("$defs", {}))
        schemas[route.takes.__name__] = schema
        ref = {"$ref": f"#/components/schemas/{route.takes.__name__}"}
        told["requestBody"] = {"required": True, "content": {"application/json": {"schema": ref}}}
    elif route.path == "/api/files":
        told["requestBody"] = {"required": True, "content": {"application/octet-stream": {"schema": {}}}}
    return told


def page() -> str:
    """The table for people: plain HTML."""
    rows = "".join(
        f"<tr><td><code>{r.method}</code><td><code>{escape(r.path)}</code><td>{escape(r.help)}" for r in ROUTES
    )
    head = "<!doctype html><html lang=en><meta charset=utf-8><title>The studio's routes</title>"
    return (
        f"{head}<h1>The studio's routes</h1><p>As data: <a href=/api/openapi.json>openapi.json</a>. States of a piece "
        f"come over the socket <code>/api/live</code>.<table>{rows}</table></html>"
    )
