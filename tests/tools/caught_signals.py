"""Signals that a process catches."""
import pathlib
import time


def wait_until_it_catches(process, caught):
    """Before, the signal ends it as any program."""
    for _ in range(600):
        status = pathlib.Path(f"/proc/{process.pid}/status").read_text(encoding="ascii")
        mask = next(int(line.split()[1], 16) for line in status.splitlines() if line.startswith("SigCgt"))
        if mask >> (caught - 1) & 1:
            return
        time.sleep(0.1)
    raise AssertionError("it does not catch the signal")
