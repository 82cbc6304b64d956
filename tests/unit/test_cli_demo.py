"""``pointpred demo``: the folder it writes."""

from __future__ import annotations

from pathlib import Path

from pointpred_server.demo import MOVEMENTS


def test_the_page_is_written_with_relative_addresses_only(command, tmp_path: Path) -> None:
    folder = tmp_path / "public" / "pointing"
    done = command("demo", "--out", folder)
    assert done.code == 0, done.err
    assert done.out.split() == [str(folder / "index.html")]
    page = (folder / "index.html").read_text(encoding="utf-8")
    assert 'data-service="none"' in page
    assert "Content-Security-Policy" in page
    assert page.count("modulepreload") > 100
    assert 'href="/' not in page
    assert 'src="/' not in page
    assert len(list((folder / "samples").glob("p*.json"))) == MOVEMENTS
    assert (folder / "web" / "lib" / "laws" / "kinematic.js").is_file()


def test_files_that_are_there_are_replaced_only_when_told_to(command, tmp_path: Path) -> None:
    (tmp_path / "index.html").write_text("mine")
    refused = command("demo", "--out", tmp_path)
    assert refused.code == 2
    assert "--force" in refused.err
    assert (tmp_path / "index.html").read_text() == "mine"
    (tmp_path / "file").write_text("mine")
    assert command("demo", "--out", tmp_path / "file", "--force").code == 2
    assert command("demo", "--out", tmp_path, "--force").code == 0
    assert (tmp_path / "index.html").read_text(encoding="utf-8") != "mine"
