#!/usr/bin/env python3
"""Check the machine code of the objects of one instruction set.

loops: the innermost loops of the sums over fluid neighbours work on whole registers. Each must hold a packed square
root, do all its arithmetic in packed single precision at the full width of the set, call nothing, and keep its sums in
registers.

symbols: the objects offer no function outside of their own namespace. The linker keeps one copy of each inline function
and template that several objects offer. If it kept that of an AVX-512 object, the program would die on processors
without.

Usage: check_objects.py loops|symbols avx2|avx512 OBJECT...
"""
import re
import subprocess
import sys

WIDEST = {"avx2": "ymm", "avx512": "zmm"}

# Stores of registers in a turn of the loop, by what it sums. The 32 registers of AVX-512 hold the sums and the
# cluster's own values. The 16 of AVX2 do not in all loops, and what GCC 12 moves to the stack and back there is
# allowed: no more, for then sums have left the registers that could stay.
STORES = {
    "avx512": {},
    # The leapfrog's gradients hold half a step of the way beside all sums.
    "avx2": {("gradient", 2, "default"): 1, ("gradient", 3, "default"): 10,
             ("gradient", 2, "midway"): 2, ("gradient", 3, "midway"): 13,
             ("force", 3, "plain"): 1, ("force", 3, "default"): 7, ("force", 3, "directional"): 8},
}
# Dimensions and schemes whose sums are looked at.
SUMS = [(loop, dimensions, scheme)
        for loop in ("gradient", "force") for dimensions in (2, 3) for scheme in ("plain", "default")]
SUMS.append(("force", 3, "directional"))

ARITHMETIC = r"v?(?:add|sub|mul|div|sqrt|rsqrt\d*|rcp\d*|max|min|fn?m(?:add|sub)\d+|cvt\w*2)"


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def functions(objects):
    """Demangled name -> instructions (address, name, operands)."""
    for path in objects:
        instructions, name = [], None
        for line in output_of("objdump", "-d", "-C", "--no-show-raw-insn", path).splitlines() + [""]:
            if match := re.match(r"[0-9a-f]+ <(.*)>:$", line):
                name, instructions = match[1], []
            elif match := re.match(r"\s*([0-9a-f]+):\s+(\S+)\s*([^#]*)", line):
                instructions.append((int(match[1], 16), match[2], match[3].strip()))
            elif name and not line:
                yield name, instructions
                name = None


def sum_of(name, instruction_set):
    """Which of SUMS a function computes in single precision with the default kernel and viscosity; None for others."""
    match = re.match(rf"void riffle::sph::{instruction_set}::(gradient|force)_loop<([23]), float, riffle::sph::WendlandC2<[23]>, "
                     r"(.*?)>\(riffle::sph::PairData", name)
    if not match or "PairForm" in match[3] or "[clone" in name:
        return None
    if "Directional" in match[3]:  # the viscosity of an anisotropic closure
        return match[1], int(match[2]), "directional"
    if match[1] == "gradient" and match[3].endswith("true"):  # the last argument: the leapfrog's
        return match[1], int(match[2]), "midway"
    scheme = "default" if re.search(r"\btrue\b|StressRecord", match[3]) else "plain"
    return match[1], int(match[2]), scheme


def fluid_loops(instructions):
    """The innermost loops with a packed square root and a prefetch; the loops over walls fetch nothing ahead."""
    at = {address: index for index, (address, _, _) in enumerate(instructions)}
    loops = []
    for index, (_, name, operands) in enumerate(instructions):
        target = re.match(r"([0-9a-f]+) ", operands)
        if name.startswith("j") and target and at.get(int(target[1], 16), index + 1) <= index:
            first = at[int(target[1], 16)]
            names = {name for _, name, _ in instructions[first:index + 1]}
            if any(re.match(r"v?r?sqrt\d*ps", n) for n in names) and any(n.startswith("prefetch") for n in names):
                loops.append((first, index))
    for loop in loops:
        if not any(other != loop and other[0] >= loop[0] and other[1] <= loop[1] for other in loops):
            yield instructions[loop[0]:loop[1] + 1]


def loop_faults(loop, instruction_set, stores_allowed):
    stores = 0
    for _, name, operands in loop:
        text = f"{name} {operands}"
        if name.startswith("call"):
            yield f"calls a function: {text}"
        if re.fullmatch(ARITHMETIC + "(?:ss|sd|pd)", name):
            yield f"arithmetic that is not packed single precision: {text}"
        widest = rf"%{WIDEST[instruction_set]}\d+(?:{{.*}})?$"
        if re.fullmatch(ARITHMETIC + "ps", name) and not re.search(widest, operands):
            yield f"does not use the whole width: {text}"
        if re.match(r"v?mov", name) and re.search(r"%[xyz]mm\d+(?:{.*})?,[^,]*\(", operands):
            stores += 1
    if stores > stores_allowed:
        yield f"stores registers {stores} times in a turn, {stores_allowed} allowed"


def check_loops(instruction_set, objects):
    """Faults, one line each."""
    seen = set()
    for name, instructions in functions(objects):
        what = sum_of(name, instruction_set)
        if what is None:
            continue
        seen.add(what)
        title = f"{instruction_set} {what[0]} {what[1]}D {what[2]}"
        loops = list(fluid_loops(instructions))
        if not loops:
            yield f"{title}: no loop with packed square root and prefetch"
        for loop in loops:
            print(f"{title}: loop of {len(loop)} instructions")
            allowed = STORES[instruction_set].get(what, 0)
            for fault in loop_faults(loop, instruction_set, allowed):
                yield f"{title}: {fault}"
    for what in SUMS:
        if what not in seen:
            yield f"{instruction_set}: no function found that computes {what}; have the names changed (sum_of)?"


def check_symbols(instruction_set, objects):
    """Faults, one line each."""
    own = rf"_ZZ?NK?6riffle3sph{len(instruction_set)}{instruction_set}"
    for path in objects:
        for line in output_of("nm", "--defined-only", path).splitlines():
            kind, symbol = line.split()[1:3]
            # W: a function that several objects may define. Data (V, u) are the same in each.
            if kind == "W" and not re.match(own, symbol):
                yield f"{path} offers {output_of('c++filt', symbol).strip()}, which is not in riffle::sph::{instruction_set}"


def main():
    check, instruction_set, objects = sys.argv[1], sys.argv[2], sys.argv[3:]
    faults = list({"loops": check_loops, "symbols": check_symbols}[check](instruction_set, objects))
    print("\n".join(faults) if faults else f"{check} of {instruction_set}: as they should be")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
