"""NC programs for sinumerik_beside_fanuc.py: the same work for both dialects of g31.

Each workload writes its files into two folders, one a dialect, and names what `g31 run` is to be given
there.  Both do the same arithmetic in the same order and command the same moves.
"""
import dataclasses
import itertools
import pathlib
from typing import Callable

import workloads

START = "G71 G90 G17 G40 G94"
FEW = 5  # files of many


@dataclasses.dataclass(frozen=True)
class Workload:
    name: str
    size: int  # iterations, calls, blocks or files at scale 1
    fanuc: Callable[[pathlib.Path, int], list[str]]      # (folder, size) -> arguments of g31 run
    sinumerik: Callable[[pathlib.Path, int], list[str]]


def fanuc_file(lines):
    def write(folder, count):
        workloads.write(folder / "main.nc", workloads.fanuc_frame(1001, lines(count)))
        return ["main.nc"]
    return write


def sinumerik_file(lines):
    def write(folder, count):
        workloads.write(folder / "main.mpf", itertools.chain(lines(count), ["M30"]))
        return ["main.mpf"]
    return write


LOOP_BODY = ["{1}={1}+{0}*0.5-{2}/3", "{2}={2}*0.999+SIN({0})", "{3}={3}+SQRT(ABS({2}))"]


def loop_sinumerik(count, names, definitions=()):
    """The loop of workloads.py, spelt in this language."""
    i, a, b, c = names
    yield from definitions
    yield START
    yield from [f"{i}=0", f"{a}=0", f"{b}=1", f"{c}=0"]
    yield f"WHILE {i}<{count}"
    yield from (line.format(i, a, b, c) for line in LOOP_BODY)
    yield f"IF {a}<=1000000 GOTOF UNCHANGED"
    yield f"{a}={a}-1000000"
    yield f"UNCHANGED: {i}={i}+1"
    yield "ENDWHILE"
    yield f"G1 X={b} Y={c}/1000000 F1000"


def loop_of_r(count):
    return loop_sinumerik(count, ["R100", "R101", "R102", "R103"])


def loop_of_locals(count):
    return loop_sinumerik(count, ["COUNT", "SUM", "PART", "ROOTS"],
                          ["DEF REAL COUNT,SUM,PART,ROOTS"])


def calls_fanuc(folder, count):
    workloads.write(folder / "main.nc", workloads.calls_fanuc(count, workloads.looped_calls_fanuc))
    return ["main.nc"]


def calls_sinumerik(folder, count):
    workloads.write(folder / "main.mpf", [
        START, "R100=0", "R110=0", f"WHILE R100<{count}", "PART(R100,2.5,R110)", "R100=R100+1",
        "ENDWHILE", "G1 X=R110/10000/100000 F1000", "M30"])
    workloads.write(folder / "part.spf", [
        "PROC PART(REAL FIRST,REAL SECOND,REAL THIRD)", "DEF REAL SUM,SHARE", "SUM=FIRST*2+SECOND",
        "SHARE=SUM-THIRD/7", "R110=R110+SHARE", "RET"])
    return ["main.mpf", "part.spf"]


def lines_sinumerik(count):
    yield START
    yield from workloads.lines(count)


def subprogram(number, variable):
    """Some fifty blocks, as a small measuring program has."""
    yield from (f"G1 X{number % 100 + i * 0.5:.3f} Y{i * 0.25:.3f} F1000." for i in range(50))
    yield f"{variable}={variable}+{number}"


def few(count):
    return range(1, count + 1, max(1, count // FEW))


def every(count):
    return range(1, count + 1)


def folder_fanuc(folder, count, called):
    library = folder / "library"
    library.mkdir()
    for number in range(1, count + 1):
        workloads.write(library / f"O{number:04d}.nc",
                        ["%", f"O{number:04d}", *subprogram(number, "#100"), "M99", "%"])
    calls = [f"M98 P{number}" for number in called(count)]
    workloads.write(folder / "main.nc", workloads.fanuc_frame(9001, ["#100=0", *calls]))
    return ["main.nc", "--lib", "library"]


def folder_sinumerik(folder, count, called):
    library = folder / "library"
    library.mkdir()
    for number in range(1, count + 1):
        workloads.write(library / f"PART{number}.SPF", [*subprogram(number, "R100"), "M17"])
    calls = [f"PART{number}" for number in called(count)]
    workloads.write(folder / "main.mpf", [START, "R100=0", *calls, "M30"])
    return ["main.mpf", "--lib", "library"]


def archive_fanuc(folder, count):
    lines = ["%", "O9001", workloads.START, "#100=0"]
    lines += [*(f"M98 P{number}" for number in few(count)), "M30"]
    for number in range(1, count + 1):
        lines += [f"O{number:04d}", *subprogram(number, "#100"), "M99"]
    workloads.write(folder / "main.nc", [*lines, "%"])
    return ["main.nc"]


def archive_sinumerik(folder, count):
    lines = ["%_N_MAIN_MPF", START, "R100=0", *(f"PART{number}" for number in few(count)), "M30"]
    for number in range(1, count + 1):
        lines += [f"%_N_PART{number}_SPF", *subprogram(number, "R100"), "M17"]
    workloads.write(folder / "main.arc", lines)
    return ["main.arc"]


WORKLOADS = [
    Workload("loop-r", 1_000_000, fanuc_file(workloads.loop_fanuc), sinumerik_file(loop_of_r)),
    Workload("loop-locals", 1_000_000, fanuc_file(workloads.loop_fanuc),
             sinumerik_file(loop_of_locals)),
    Workload("calls", 200_000, calls_fanuc, calls_sinumerik),
    Workload("lines", 1_000_000, fanuc_file(workloads.lines), sinumerik_file(lines_sinumerik)),
    Workload("folder", 1_000, lambda at, n: folder_fanuc(at, n, few),
             lambda at, n: folder_sinumerik(at, n, few)),
    Workload("folder-all", 1_000, lambda at, n: folder_fanuc(at, n, every),
             lambda at, n: folder_sinumerik(at, n, every)),
    Workload("archive", 260, archive_fanuc, archive_sinumerik),
]
