"""The threads that do what takes sessions long: frames of many events in slices, trials one at a time."""

from __future__ import annotations

from concurrent.futures import Future, ThreadPoolExecutor

from pointpred_server.sessions.work import Completion, Work


class WorkThreads:
    """One thread for divided work, of which each session has one slice in turn, and one for the rest."""

    def __init__(self) -> None:
        self._frames = ThreadPoolExecutor(1, "frames")
        self._trials = ThreadPoolExecutor(1, "trials")

    def submit(self, work: Work) -> Future[Completion]:
        """Do some work, however many others have some, too; it is cancelled when the threads end."""
        done: Future[Completion] = Future()
        self._enqueue(work, done)
        return done

    def shut_down(self) -> None:
        """Do nothing more; what is being done is not waited for."""
        for thread in (self._frames, self._trials):
            thread.shutdown(wait=False, cancel_futures=True)

    def _enqueue(self, work: Work, done: Future[Completion]) -> None:
        """Put the next slice behind those of all other sessions."""
        thread = self._frames if work.divided else self._trials
        try:
            turn = thread.submit(self._advance, work, done)
        except RuntimeError:  # the threads have ended
            done.cancel()
        else:
            turn.add_done_callback(lambda ended: done.cancel() if ended.cancelled() else None)

    def _advance(self, work: Work, done: Future[Completion]) -> None:
        if done.cancelled():
            return
        try:
            completion = work.advance()
        except BaseException as error:
            done.set_exception(error)
            return
        if completion is None:
            self._enqueue(work, done)
        elif done.set_running_or_notify_cancel():
            done.set_result(completion)
