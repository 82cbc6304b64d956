"""The laws in C, by their keys; see ``pointpred.compiled``."""
