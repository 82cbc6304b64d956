"""What a set of recordings is: where it comes from, under which licence, and how to get it."""

from __future__ import annotations

from pathlib import Path
from urllib.parse import quote

import msgspec

from pointpred.recording import Recording
from pointpred.recordings.reading import People, Reading


class RemoteFile(msgspec.Struct, frozen=True):
    """One file of a set. ``sha256`` is ``None`` where nobody has verified a digest of the original."""

    name: str
    url: str
    sha256: str | None = None


class DataSet(msgspec.Struct, frozen=True):
    """A public set of recordings of people.

    ``users`` and ``trials`` are ``None`` where unknown. ``files`` is empty where a program cannot fetch the
    set: a user then gets it from ``page``. ``importer`` names the format ``pointpred convert`` reads it as,
    ``None`` where none does. ``reading`` and ``people`` are how ``read`` makes trials of its files, ``None``
    where it cannot, or where they hold no movements of a cursor.
    """

    name: str
    title: str
    page: str
    licence: str
    citation: str
    users: int | None
    trials: int | None
    sampling: str
    targets: str
    importer: str | None = None
    files: tuple[RemoteFile, ...] = ()
    note: str = ""
    reading: Reading | None = None
    people: People = "column"

    @property
    def fetchable(self) -> bool:
        """Whether ``fetch`` knows where its files lie."""
        return bool(self.files)

    @property
    def verified(self) -> bool:
        """Whether every file has a digest to be checked against."""
        return self.fetchable and all(file.sha256 is not None for file in self.files)

    def read(self, folder: str | Path) -> Recording:
        """The trials of its files, which ``fetch`` has put into ``folder``; raises RecordingError.

        Without notes: how the files are read is known.
        """
        from pointpred.recordings import read_any

        assert self.reading is not None
        files = [Path(folder) / file.name for file in self.files]
        (found,) = read_any(files, self.reading, people=self.people)
        return msgspec.structs.replace(found, name=self.name, notes=())


def github_file(repository: str, path: str, commit: str = "HEAD", sha256: str | None = None) -> RemoteFile:
    """A file of a public repository; ``HEAD`` where no commit is pinned.

    >>> github_file("someone/moves", "data/a b.csv").url
    'https://raw.githubusercontent.com/someone/moves/HEAD/data/a%20b.csv'
    """
    url = f"https://raw.githubusercontent.com/{repository}/{commit}/{quote(path)}"
    return RemoteFile(path.rsplit("/", 1)[-1], url, sha256)
