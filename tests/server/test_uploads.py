"""``POST /v1/score`` with bodies that are large, slow, many, or much larger than they look."""

from __future__ import annotations

import gzip
import io
import signal
import socket as socket_module
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from httpx2 import Response, get, post

from pointpred.errors import RecordingError
from pointpred.recordings import Reading
from pointpred_server.uploads import limits, process, receiving, recordings
from pointpred_server.uploads.limits import MOST_ROWS, MOST_UNPACKED, check_unpacked
from pointpred_server.uploads.process import UploadProcess
from pointpred_server.uploads.receiving import UploadError
from pointpred_server.uploads.recordings import score_body
from tests.server.listener import soon
from tests.server.running import PATIENCE_S, Running, running

CSV = b"user,trial,t_s,x_px,y_px\n" + b"".join(
    b"ann,%d,%.2f,%d,0\n" % (trial, i / 100, 7 * i) for trial in range(3) for i in range(60)
)


def parquet(**columns: Any) -> bytes:
    """A recording as Parquet, packed as small as it gets."""
    file = io.BytesIO()
    pq.write_table(pa.table(columns), file, compression="zstd")
    return file.getvalue()


def same(word: str, count: int) -> Any:
    """A column of one word."""
    return pa.DictionaryArray.from_arrays(pa.array(np.zeros(count, np.int32)), [word]).cast(pa.string())


def columns(count: int, user: str = "ann") -> dict[str, Any]:
    t = np.zeros(count)
    return {"user": same(user, count), "trial": same("1", count), "t_s": t, "x_px": t, "y_px": t}


def refused(answer: Response, status: int, code: str) -> str:
    told = answer.json()
    assert (answer.status_code, told["type"], told["code"]) == (status, "error", code), told
    return str(told["message"])


def test_a_small_file_of_many_rows_is_refused_before_it_is_unpacked(service: Running) -> None:
    body = parquet(**columns(MOST_ROWS + 1))
    assert len(body) < 100_000
    message = refused(post(f"{service.url}/v1/score", content=body, timeout=PATIENCE_S), 413, "too_large")
    assert f"{MOST_ROWS} rows" in message
    assert f"{MOST_ROWS + 1}" in message


def test_a_small_file_of_long_words_is_refused_before_it_is_unpacked(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    body = parquet(**columns(300_000, "x" * 1000))
    assert len(body) < 100_000
    monkeypatch.setattr(recordings, "read_any", lambda path, reading: pytest.fail("it was unpacked"))
    with pytest.raises(UploadError, match=f"{MOST_UNPACKED} bytes"):
        score_body(body, ("hold",))


def declaring(rows: int, body: bytes) -> bytes:
    """The same Parquet file, whose footer says that it holds so many rows; its group of rows has them all."""
    metadata = pq.read_metadata(io.BytesIO(body))
    true = packed_number(metadata.num_rows)
    false = packed_number(rows, len(true))
    size = int.from_bytes(body[-8:-4], "little")
    footer = body[-8 - size : -8]
    return body[: -8 - size] + footer.replace(true, false, 1) + body[-8:]


def packed_number(number: int, size: int = 0) -> bytes:
    """A whole number as the footer of a Parquet file has it, in at least so many bytes."""
    number, parts = 2 * number, []
    while number > 127 or len(parts) < size - 1:
        parts.append(number & 127 | 128)
        number >>= 7
    return bytes([*parts, number])


def test_rows_are_counted_as_they_are_whatever_the_footer_says() -> None:
    file = io.BytesIO()
    pq.write_table(pa.table(columns(600_000)), file, compression="zstd", row_group_size=10**6)
    body = declaring(100, file.getvalue())
    assert pq.read_metadata(io.BytesIO(body)).num_rows == 100
    with pytest.raises(UploadError, match=f"at most {MOST_ROWS} rows"):
        check_unpacked(body)


@pytest.mark.parametrize(
    ("column", "words"),
    [
        (pa.array([[0.0] * 1000] * 10), "expected text or numbers"),
        (pa.array([b"x" * 1000] * 10, pa.binary(1000)), "expected text or numbers"),
        (pa.array([{"a": 1}] * 10), "expected text or numbers"),
    ],
)
def test_what_is_neither_words_nor_numbers_is_not_unpacked(column: Any, words: str) -> None:
    with pytest.raises(RecordingError, match=words):
        check_unpacked(parquet(**columns(10), more=column))


def test_many_columns_are_refused() -> None:
    with pytest.raises(UploadError, match="columns"):
        check_unpacked(parquet(**{f"c{i}": np.zeros(1) for i in range(100)}))


def test_rows_of_text_are_counted_before_they_are_read() -> None:
    for end in (b"\n", b"\r"):
        check_unpacked(b"a,b" + end * MOST_ROWS)
        with pytest.raises(UploadError, match="rows"):
            check_unpacked(b"a,b" + end * (MOST_ROWS + 2))


def test_an_honest_file_is_no_larger_than_allowed() -> None:
    count = 200_000
    trial = pa.array([f"trial {i // 80}" for i in range(count)])
    t = np.random.default_rng(1).normal(size=count)
    file = io.BytesIO()
    whole = pa.table({**columns(count), "trial": trial, "t_s": t, "x_px": t, "y_px": t})
    pq.write_table(whole, file, compression="zstd")
    assert len(file.getvalue()) < receiving.MOST_BYTES
    check_unpacked(file.getvalue())
    file = io.BytesIO()
    pq.write_table(pa.table({**columns(5), "trial": pa.array(["a", "b", None, "a", "c"])}), file)
    check_unpacked(file.getvalue())


def test_a_torn_parquet_file_is_no_recording() -> None:
    with pytest.raises(RecordingError, match="the recording"):
        check_unpacked(parquet(**columns(10))[:-20])


def test_many_trials_are_for_the_command_line(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(recordings, "MOST_TRIALS", 2)
    with pytest.raises(UploadError, match="at most 2 trials"):
        score_body(CSV, ("hold",))


def test_the_length_is_refused_before_the_body_comes(service: Running) -> None:
    with socket_module.create_connection(("127.0.0.1", service.port)) as plain:
        said = receiving.MOST_BYTES + 1
        plain.sendall(
            f"POST /v1/score HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: {said}\r\n\r\n".encode()
        )
        plain.settimeout(PATIENCE_S)
        assert b" 413 " in plain.recv(4096).split(b"\r\n")[0]


def begun(here: Running, sent: bytes = CSV[:50]) -> socket_module.socket:
    """An upload that does not go on."""
    plain = socket_module.create_connection(("127.0.0.1", here.port))
    head = f"POST /v1/score HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: {len(CSV)}\r\n\r\n"
    plain.sendall(head.encode() + sent)
    return plain


def stop_process(here: Running) -> subprocess.Popen[bytes]:
    """The process that opens recordings, which stands still until it gets SIGCONT or is killed."""
    assert post(f"{here.url}/v1/recording", content=CSV, timeout=PATIENCE_S).status_code == 200
    process = here.service.upload_process._process
    assert process is not None
    process.send_signal(signal.SIGSTOP)
    return process


def test_a_slow_upload_holds_up_nobody(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(receiving, "READ_S", PATIENCE_S)
    with running() as here, begun(here):
        soon(lambda: here.service.uploads == 1, "the upload has begun")
        answer = post(f"{here.url}/v1/score?predictors=hold", content=CSV, timeout=PATIENCE_S)
        assert answer.status_code == 200
        assert here.service.uploads >= 1, "scored while the other one was still waited for"


def test_a_slow_upload_ends_with_408(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(receiving, "READ_S", 1.0)
    with running() as here, begun(here) as slow:
        slow.settimeout(PATIENCE_S)
        said = b""
        while more := slow.recv(4096):  # until the connection is closed
            said += more
        assert b" 408 " in said.split(b"\r\n")[0]
        assert b'"code":"slow"' in said
        assert b"within 1 s" in said


def test_an_upload_that_was_given_up_leaves_its_place(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(receiving, "MOST_AT_ONCE", 1)
    with running() as here:
        with begun(here):
            soon(lambda: here.service.uploads == 1, "the upload has begun")
            message = refused(post(f"{here.url}/v1/score", content=CSV, timeout=PATIENCE_S), 503, "too_many")
            assert "1 " in message
        soon(lambda: here.service.uploads == 0, "its place is free")
        answer = post(f"{here.url}/v1/score?predictors=hold", content=CSV, timeout=PATIENCE_S)
        assert answer.status_code == 200


def test_sessions_go_on_while_a_recording_is_scored(monkeypatch: pytest.MonkeyPatch) -> None:
    with ThreadPoolExecutor(1) as other, running() as here, here.greeted() as socket:
        options = {"content": CSV, "timeout": PATIENCE_S}
        process = stop_process(here)  # it is at work for as long as we like
        answer = other.submit(post, f"{here.url}/v1/recording", **options)
        soon(lambda: here.service.uploads == 1, "it has come")
        socket.send('{"type":"events","events":[[1,5,6,null,null,0]]}')
        assert '"prediction"' in str(socket.recv(PATIENCE_S))
        assert get(f"{here.url}/healthz", timeout=PATIENCE_S).status_code == 200
        process.send_signal(signal.SIGCONT)
        assert answer.result(PATIENCE_S).status_code == 200


def test_a_client_that_leaves_before_its_turn_leaves_its_place() -> None:
    """A page that is loaded again and again has its recording scored each time."""
    with ThreadPoolExecutor(1) as other, running() as here:
        options = {"content": CSV, "timeout": PATIENCE_S}
        process = stop_process(here)
        answer = other.submit(post, f"{here.url}/v1/recording", **options)
        soon(lambda: here.service.uploads == 1, "the first has come")
        with begun(here, CSV):
            soon(lambda: here.service.uploads == 2, "the second waits")
        soon(lambda: here.service.uploads == 1, "the second has left")
        process.send_signal(signal.SIGCONT)
        assert answer.result(PATIENCE_S).status_code == 200
        assert post(f"{here.url}/v1/recording", **options).status_code == 200


def test_a_recording_that_takes_too_long_is_refused_and_the_next_one_is_taken(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    with running() as here:
        options = {"content": CSV, "timeout": PATIENCE_S}
        stop_process(here)
        monkeypatch.setattr("pointpred_server.uploads.process.SCORE_S", 0.2)
        message = refused(post(f"{here.url}/v1/recording", **options), 413, "too_large")
        assert "pointpred score" in message
        monkeypatch.setattr("pointpred_server.uploads.process.SCORE_S", PATIENCE_S)
        assert post(f"{here.url}/v1/recording", **options).status_code == 200


def test_a_process_that_somebody_killed_is_not_the_fault_of_the_recording() -> None:
    with ThreadPoolExecutor(1) as other, running() as here:
        options = {"content": CSV, "timeout": PATIENCE_S}
        process = stop_process(here)
        answer = other.submit(post, f"{here.url}/v1/recording", **options)
        soon(lambda: here.service.upload_process._busy.locked(), "it is being opened")
        process.kill()
        assert "send the recording again" in refused(answer.result(PATIENCE_S), 500, "internal")
        assert post(f"{here.url}/v1/recording", **options).status_code == 200


def test_what_takes_more_memory_than_allowed_is_refused() -> None:
    lines = (
        "import sys; from pointpred_server.uploads import process\n"
        "process.MEMORY_BYTES = 2**26; process._bound_memory(); bytearray(2**27)"
    )
    done = subprocess.run([sys.executable, "-c", lines], capture_output=True, text=True, check=False)
    assert "MemoryError" in done.stderr


OUT_OF_MEMORY = """
from pointpred_server.uploads import answers, process

def run_out(*arguments):
    raise MemoryError

answers.open_body = run_out
process.main()
"""


def test_after_a_recording_for_which_memory_ran_out_another_process_takes_the_next(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    with running() as here:
        options = {"content": CSV, "timeout": PATIENCE_S}
        with monkeypatch.context() as patch:
            command = [sys.executable, "-c", OUT_OF_MEMORY]
            patch.setattr("pointpred_server.uploads.process.command", lambda module: command)
            refused(post(f"{here.url}/v1/recording", **options), 413, "too_large")
        assert post(f"{here.url}/v1/recording", **options).status_code == 200


@pytest.mark.parametrize("when", ["before", "while its process is started"])
def test_a_recording_that_comes_when_the_service_has_stopped_is_refused(
    when: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    uploads = UploadProcess()

    def command(module: str) -> list[str]:
        uploads.end(0.0)
        return [sys.executable, "-m", module]

    if when == "before":
        uploads.end()
    else:
        monkeypatch.setattr(process, "command", command)
    with pytest.raises(UploadError) as refusal:
        uploads.run("open", CSV, (), {})
    assert (refusal.value.status, refusal.value.code) == (503, "stopping")
    assert uploads._process is None


def test_the_service_stops_beside_a_recording_that_is_being_scored() -> None:
    with running() as here:
        options = {"content": CSV, "timeout": PATIENCE_S}
        process = stop_process(here)
        asking = threading.Thread(target=lambda: post(f"{here.url}/v1/recording", **options))
        asking.daemon = True
        asking.start()
        soon(lambda: here.service.uploads == 1, "it has come")
        here.service.upload_process.end()
        asking.join(PATIENCE_S)
        assert process.wait(PATIENCE_S) != 0


def test_a_gzip_file_is_measured_as_it_is_unpacked() -> None:
    bomb = gzip.compress(b"1,2,3\n" * (limits.MOST_ROWS + 2))
    assert len(bomb) < 100_000
    with pytest.raises(UploadError) as refusal:
        check_unpacked(bomb)
    assert refusal.value.code == "too_large"


def test_text_of_few_lines_is_bounded_as_it_is_unpacked() -> None:
    check_unpacked(gzip.compress(b"1" * limits.MOST_TEXT, 1))
    with pytest.raises(UploadError) as refusal:
        check_unpacked(gzip.compress(b"1" * (limits.MOST_TEXT + 1), 1))
    assert refusal.value.code == "too_large"


def test_a_binary_file_that_begins_like_text_is_refused() -> None:
    body = b"MATLAB 5.0 MAT-file" + b" " * limits.HEAD_BYTES + b"\0" * 64
    check_unpacked(body)
    with pytest.raises(RecordingError, match="neither text nor Parquet"):
        recordings.recordings_of(body, Reading())


def test_limits_fit_together() -> None:
    assert MOST_ROWS * 8 * limits.MOST_COLUMNS <= MOST_UNPACKED
