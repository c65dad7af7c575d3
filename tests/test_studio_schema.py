"""The studio's routes as their own document tells them: whatever is sent there, no answer is a fault of ours."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

from studio import inside, studio
from tambour.studio import openapi
from tambour.studio.routes import ROUTES


def test_the_document_tells_every_route() -> None:
    told = openapi.document()
    assert {(m.upper(), p) for p, by in told["paths"].items() for m in by} == {(r.method, r.path) for r in ROUTES}
    assert all(op["summary"].endswith(".") for by in told["paths"].values() for op in by.values())
    names = [op["operationId"] for by in told["paths"].values() for op in by.values()]
    assert len(set(names)) == len(names)
    page = openapi.page()
    assert all(r.path.replace("{", "{") in page for r in ROUTES)


@pytest.mark.slow
def test_schemathesis_finds_no_5xx(tmp_path: Path) -> None:
    import schemathesis

    schema = schemathesis.openapi.from_dict(openapi.document())
    with studio(tmp_path, 2) as (client, tokens):
        ours = inside(client, tokens)
        piece = ours.post("/api/pieces", json={"seed": "1", "params": {"span": 20.0}}).json()["piece"]["id"]
        known = {"id": piece, "r": "1", "craft": "ink", "k": "0", "example": "heart.svg"}
        faults: list[Any] = []
        for found in schema.get_all_operations():
            operation = found.ok()

            @given(case=operation.as_strategy(), real=st.booleans())
            @settings(
                max_examples=12,
                deadline=None,
                derandomize=True,
                phases=[Phase.generate],
                suppress_health_check=list(HealthCheck),
            )
            def tried(case: Any, real: bool) -> None:
                path = case.path
                for name, value in (case.path_parameters or {}).items():
                    path = path.replace(f"{{{name}}}", known.get(name, str(value)) if real else str(value))
                body: dict[str, Any] = {}
                if isinstance(case.body, bytes):
                    body = {"content": case.body}
                elif case.method.upper() in ("POST", "PUT", "PATCH"):
                    body = {"json": case.body if not isinstance(case.body, schemathesis.core.NotSet) else None}
                query = {k: str(v) for k, v in (case.query or {}).items()}
                answer = ours.request(case.method.upper(), path, params=query, **body)
                if answer.status_code >= 500:
                    faults.append((case.method, path, body, answer.text[:200]))
                if answer.status_code >= 400:
                    assert answer.json()["problems"][0]["message"]

            tried()
        assert not faults, faults[0]
