"""The generated sample the first command runs on, and the catalogue of public sets a user may fetch."""

from pointpred.datasets.catalogue import DataSet, RemoteFile
from pointpred.datasets.embedded import sample
from pointpred.datasets.fetch import Fetched, fetch, terms
from pointpred.datasets.public import find, listing

__all__ = ["DataSet", "Fetched", "RemoteFile", "fetch", "find", "listing", "sample", "terms"]
