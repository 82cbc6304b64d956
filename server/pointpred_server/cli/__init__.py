"""Commands of the service: what ``pointpred`` finds by the entry points of this distribution."""
