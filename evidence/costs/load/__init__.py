"""Load on the service: a compiled generator of clients, the servers that it measures, and what it sends.

Linux only: the generator waits by epoll and reads processor times from ``/proc``.
"""
