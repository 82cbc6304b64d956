"""The load generator, in a process of its own: frames made beforehand, plain sockets.

``python -m benchmarks.service_load PLAN``, where PLAN is JSON, prints what it measured as JSON. Without a
``rate`` each client sends its next frame when the last one is answered; with one it keeps to the clock, the
clients evenly staggered, whatever comes back. With ``beside`` the clients of two paths take turns of
``TURN_S``, too short for the machine to have changed meanwhile: the ratio of each turn and the one after it
says what one path costs beside the other, and the machine's moods cancel.
"""

from __future__ import annotations

import json
import select
import sys
import time
from pathlib import Path

import msgspec
import numpy as np

from benchmarks.service_client import Client, Plan, period
from benchmarks.service_frames import events

WARM_S = 0.3
TURN_S = 0.05
FRAMES = 4000
QUIET = 10
"""The percentile of turns whose cost is told: what else the machine does can only add."""


def cpu_s(pid: int) -> float:
    """Processor time of all threads of a process so far, in steps of nanoseconds."""
    tasks = Path(f"/proc/{pid}/task").glob("*/schedstat")
    return sum(int(task.read_text().split()[0]) for task in tasks) / 1e9


def closed_loop(plan: Plan, clients: list[Client], frames: list[bytes], until: float) -> None:
    """Every client has one frame under way."""
    waiting = select.epoll()
    by_number = {client.socket.fileno(): client for client in clients}
    for number in by_number:
        waiting.register(number, select.EPOLLIN)
    for client in clients:
        if client.sent == client.answered:
            client.send(frames)
    while time.perf_counter() < until:
        for number, _ in waiting.poll(0.1):
            client = by_number[number]
            if client.read(plan):
                client.send(frames)
    waiting.close()


def open_loop(plan: Plan, clients: list[Client], frames: list[bytes], until: float) -> None:
    """Every client keeps to the clock."""
    gap = 1.0 / (plan.rate or 1.0)
    start = time.perf_counter()
    due = [start + gap * number / len(clients) for number in range(len(clients))]
    by_socket = {client.socket: client for client in clients}
    turn = 0
    while (now := time.perf_counter()) < until:
        while due[turn] <= now:
            clients[turn].send(frames)
            due[turn] += gap
            turn = (turn + 1) % len(clients)
        pause = max(0.0, due[turn] - time.perf_counter())
        for ready in select.select(by_socket, [], [], pause)[0]:
            by_socket[ready].read(plan)


def drain(plan: Plan, clients: list[Client]) -> None:
    """Read what is still under way."""
    for client in clients:
        while client.answered < client.sent:
            client.read(plan)


def in_turns(
    plan: Plan, clients: list[Client], others: list[Client], frames: list[bytes]
) -> dict[str, float]:
    """The server's processor time a message on two paths, and the quartiles of the ratio of neighbours."""
    groups = (clients, others)
    for group in groups:
        closed_loop(plan, group, frames, time.perf_counter() + WARM_S)
        drain(plan, group)
    cost: tuple[list[float], list[float]] = ([], [])
    own, start = time.process_time(), time.perf_counter()
    while time.perf_counter() < start + plan.seconds:
        for group, costs in zip(groups, cost, strict=True):
            before, server = sum(client.answered for client in group), cpu_s(plan.pid)
            closed_loop(plan, group, frames, time.perf_counter() + TURN_S)
            drain(plan, group)
            answers = sum(client.answered for client in group) - before
            costs.append((cpu_s(plan.pid) - server) / answers * 1e6)
    own, took = time.process_time() - own, time.perf_counter() - start
    low, middle, high = np.percentile(np.divide(*cost), [25, 50, 75])
    quiet = (float(np.percentile(costs, QUIET)) for costs in cost)
    names = ("server_us", "beside_us", "ratio", "ratio_low", "ratio_high", "own_share")
    return dict(zip(names, (*quiet, middle, low, high, own / took), strict=True))


def main() -> None:
    """Carry out a plan."""
    plan = msgspec.json.decode(sys.argv[1], type=Plan)
    count = int((plan.rate or 0) * (plan.seconds + 1.0)) or FRAMES
    frames = events(plan.encoding, count, plan.size, period(plan))
    clients = [Client(plan, plan.path) for _ in range(plan.clients)]
    if plan.beside:
        others = [Client(plan, plan.beside) for _ in range(plan.clients)]
        print(json.dumps(in_turns(plan, clients, others, frames)))
        return
    go = open_loop if plan.rate else closed_loop
    go(plan, clients, frames, time.perf_counter() + WARM_S)
    before = [(client.sent, len(client.trips)) for client in clients]
    server, own, start = cpu_s(plan.pid), time.process_time(), time.perf_counter()
    go(plan, clients, frames, start + plan.seconds)
    took = time.perf_counter() - start
    server, own = cpu_s(plan.pid) - server, time.process_time() - own
    trips = np.concatenate([c.trips[first:] for c, (_, first) in zip(clients, before, strict=True)])
    answers = len(trips)
    sent = sum(c.sent - first for c, (first, _) in zip(clients, before, strict=True))
    p50, p99 = np.percentile(trips, [50, 99]) * 1e3
    result = {
        "messages_per_s": answers / took,
        "sent_per_s": sent / took,
        "server_us": server / max(answers, 1) * 1e6,
        "server_share": server / took,
        "own_share": own / took,
        "p50_ms": p50,
        "p99_ms": p99,
        "given_way": sum(client.given_way for client in clients),
    }
    print(json.dumps(result))


if __name__ == "__main__":
    main()
