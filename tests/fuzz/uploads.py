"""Any body and any query as an uploaded recording."""

from __future__ import annotations

import gzip
import warnings
from urllib.parse import parse_qsl

from pointpred.errors import PointpredError
from pointpred_server.uploads.receiving import UploadError
from pointpred_server.uploads.recordings import reading_of, recordings_of
from tests.fuzz.files import DATA
from tests.fuzz.inputs import check as check_recording
from tests.fuzz.refusals import refused


def check(data: bytes) -> str:
    """An input is a line with the query, and the body."""
    query, _, body = data.partition(b"\n")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            recordings = recordings_of(body, reading_of(dict(parse_qsl(query.decode("latin-1")))))
    except (PointpredError, UploadError) as error:
        sentence, came = str(error), refused(error)
    else:
        sentence, came = "", "read"
        for recording in recordings:
            check_recording(recording)
    assert "/proc/" not in sentence, "the place of the upload is in its error"
    return came


def seeds() -> list[bytes]:
    queries = (
        b"",
        b"columns=t=0,x=1,y=2&time_unit=ms",
        b"y_up=true&px_per_unit=2&cut=clicks",
        b"records=data.samples",
    )
    bodies = [
        (DATA / name).read_bytes()
        for name in ("table.csv", "table.json", "table.parquet", "pair_samples.csv")
    ]
    bodies.append(gzip.compress(bodies[0], mtime=0))
    return [query + b"\n" + body for query in queries for body in bodies]
