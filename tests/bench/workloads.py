"""NC programs for beside_rs274.py: the same work in the dialects of g31 and of LinuxCNC's rs274.

Each workload is a pair of generators of lines.  Both do the same arithmetic in the same order and
command the same moves; only the spelling of loops, calls and program frames differs.
"""
import dataclasses
import math
from typing import Callable, Iterable

START = "G21 G90 G17 G40 G49 G80 G94"
LIMIT = 200.0  # mm: arcs that would leave this square go back to the origin


class Noise:
    """Knuth's 64-bit congruential generator: the same programs everywhere, in [0, 1)."""

    def __init__(self, seed):
        self.state = seed

    def next(self):
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % 2**64
        return (self.state >> 11) / 2**53


@dataclasses.dataclass(frozen=True)
class Workload:
    name: str
    size: int           # blocks, iterations or calls at scale 1
    target: float       # how many times faster than rs274 g31 wants to be
    fanuc: Callable[[int], Iterable[str]]
    rs274: Callable[[int], Iterable[str]]


def fanuc_frame(number, body):
    yield "%"
    yield f"O{number:04d}"
    yield START
    yield from body
    yield "M30"
    yield "%"


def rs274_frame(body):
    yield START
    yield from body
    yield "M2"


def lines(count):
    """Straight feed moves around a circle, four words and a sequence number each."""
    noise = Noise(1)
    for i in range(count):
        x = 50 * math.cos(i * 0.01) + noise.next()
        y = 50 * math.sin(i * 0.01) + noise.next()
        z = -0.0001 * (i % 10000)
        yield f"N{i % 99999 + 1} G1 X{x:.4f} Y{y:.4f} Z{z:.4f} F{800 + i % 7 * 100}."


def arcs(count):
    """Arcs by centre and by radius, clockwise and not, every tenth a helix; each begins where the
    one before ended."""
    noise = Noise(2)
    x = y = 0.0
    yield "G0 X0. Y0. Z0."
    for i in range(count):
        turn = 2 + i % 2
        sweep = 0.2 + 2.5 * noise.next()
        angle, size = noise.next() * 2 * math.pi, 1 + 9 * noise.next()
        centre_x, centre_y = round(x + size * math.cos(angle), 4), round(y + size * math.sin(angle), 4)
        radius = math.hypot(x - centre_x, y - centre_y)
        end = math.atan2(y - centre_y, x - centre_x) + (sweep if turn == 3 else -sweep)
        new_x = round(centre_x + radius * math.cos(end), 4)
        new_y = round(centre_y + radius * math.sin(end), 4)
        if max(abs(new_x), abs(new_y)) > LIMIT:
            yield "G1 X0. Y0. F1000."
            x = y = 0.0
            continue
        z = f" Z{i % 50 * -0.1:.4f}" if i % 10 == 0 else ""
        way = f"R{radius:.6f}" if i % 3 == 2 else f"I{centre_x - x:.4f} J{centre_y - y:.4f}"
        yield f"G{turn} X{new_x:.4f} Y{new_y:.4f}{z} {way} F1000."
        x, y = new_x, new_y


LOOP_HEAD = ["#100=0", "#101=0", "#102=1", "#103=0"]
LOOP_BODY = ["#101=[#101+#100*0.5-#102/3]", "#102=[#102*0.999+SIN[#100]]",
             "#103=[#103+SQRT[ABS[#102]]]"]
LOOP_WRAP = "#101=[#101-1000000]"
LOOP_TAIL = "G1 X[#102] Y[#103/1000000] F1000."


def loop_fanuc(count):
    yield from LOOP_HEAD
    yield f"WHILE [#100 LT {count}] DO1"
    yield from LOOP_BODY
    yield "IF [#101 LE 1000000] GOTO 10"
    yield LOOP_WRAP
    yield "N10 #100=#100+1"
    yield "END1"
    yield LOOP_TAIL


def loop_rs274(count):
    yield from LOOP_HEAD
    yield f"o100 while [#100 LT {count}]"
    yield from LOOP_BODY
    yield "o101 if [#101 GT 1000000]"
    yield LOOP_WRAP
    yield "o101 endif"
    yield "#100=[#100+1]"
    yield "o100 endwhile"
    yield LOOP_TAIL


SUBPROGRAM = ["#4=[#1*2+#2]", "#5=[#4-#3/7]", "#110=[#110+#5]"]
CALLS_TAIL = "G1 X[#110/10000/100000] F1000."


def calls_fanuc(count, calls):
    """Program O1003 and its macro O9100 in one file."""
    yield "%"
    yield "O1003"
    yield START
    yield from ["#100=0", "#110=0"]
    yield from calls(count)
    yield CALLS_TAIL
    yield "M30"
    yield "O9100"
    yield from SUBPROGRAM
    yield "M99"
    yield "%"


def calls_rs274(count, calls):
    yield "o9100 sub"
    yield from SUBPROGRAM
    yield "o9100 endsub"
    yield START
    yield from ["#100=0", "#110=0"]
    yield from calls(count)
    yield CALLS_TAIL
    yield "M2"


def looped_calls_fanuc(count):
    yield f"WHILE [#100 LT {count}] DO1"
    yield "G65 P9100 A#100 B2.5 C#110"
    yield "#100=#100+1"
    yield "END1"


def looped_calls_rs274(count):
    yield f"o100 while [#100 LT {count}]"
    yield "o9100 call [#100] [2.5] [#110]"
    yield "#100=[#100+1]"
    yield "o100 endwhile"


def written_calls_fanuc(count):
    return (f"G65 P9100 A{i}. B2.5 C#110" for i in range(count))


def written_calls_rs274(count):
    return (f"o9100 call [{i}] [2.5] [#110]" for i in range(count))


WORKLOADS = [
    Workload("lines", 1_000_000, 15,
             lambda n: fanuc_frame(1001, lines(n)), lambda n: rs274_frame(lines(n))),
    Workload("arcs", 200_000, 15,
             lambda n: fanuc_frame(1005, arcs(n)), lambda n: rs274_frame(arcs(n))),
    Workload("loop", 2_000_000, 120,
             lambda n: fanuc_frame(1002, loop_fanuc(n)), lambda n: rs274_frame(loop_rs274(n))),
    Workload("calls-in-loop", 200_000, 50,
             lambda n: calls_fanuc(n, looped_calls_fanuc),
             lambda n: calls_rs274(n, looped_calls_rs274)),
    Workload("calls-written", 200_000, 50,
             lambda n: calls_fanuc(n, written_calls_fanuc),
             lambda n: calls_rs274(n, written_calls_rs274)),
]


def write(path, text_lines):
    """Writes the lines and returns the bytes."""
    with open(path, "w", newline="\n") as file:
        for line in text_lines:
            file.write(line + "\n")
    return path.stat().st_size


def write_large(path, size):
    """A program of straight moves of at least `size` bytes: a stretch of them, again and again."""
    stretch = "".join(line + "\n" for line in lines(100_000)).encode()
    with open(path, "wb") as file:
        file.write(f"%\nO1001\n{START}\n".encode())
        while file.tell() < size:
            file.write(stretch)
        file.write(b"M30\n%\n")
    return path.stat().st_size
