#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""The model of src/parallel/README.md: time of a sweep by part, for so many grains on so many ranks, as rows of a Markdown table.

scalingModel.py [reductions per sweep]"""

import math
import sys

# Measured (src/parallel/README.md says how).
SECONDS_PER_GRAIN = 77e-9       # a sweep with its share of mixing, one core
PASSES = 1.31                   # exchanges with the neighbors in a sweep: its own, and its share of a mixing
MESSAGES = 13.0*PASSES          # that a rank sends in a sweep: neighbors
BYTES = 225.0*PASSES            # that a rank sends in a sweep, over n^(2/3)
REDUCTIONS = PASSES             # in a sweep and its share of a mixing

# Assumed of the machine.
LATENCY = 1.5e-6                # s, a message between nodes
OVERHEAD = 0.5e-6               # s of the processor for sending, or for receiving, a message
BANDWIDTH_OF_RANK = 10e9        # B/s, between ranks of a node
BANDWIDTH_OF_NODE = 25e9        # B/s, out of a node
RANKS_PER_NODE = 64
IMBALANCE = 1.1                 # largest over mean load
NOISE, NOISE_RATE = 10e-6, 10.0  # s that an interruption takes, interruptions of a core in a second


def partsOfSweep(n, ranks, reductions=REDUCTIONS):
    """Seconds: work, waiting for the most loaded rank, messages, leaving the node, reductions, interruptions."""
    work = n*SECONDS_PER_GRAIN
    surface = BYTES*n**(2/3)
    messages = 2*PASSES*LATENCY + 2*MESSAGES*OVERHEAD + surface/BANDWIDTH_OF_RANK
    node = BYTES*(RANKS_PER_NODE*n)**(2/3)/BANDWIDTH_OF_NODE if ranks > RANKS_PER_NODE else 0.0
    reducing = reductions*LATENCY*math.log2(ranks)
    quiet = IMBALANCE*work + messages + node + reducing
    return work, (IMBALANCE - 1)*work, messages, node, reducing, NOISE*min(1.0, ranks*NOISE_RATE*quiet)


def smallest(ranks, efficiency, reductions):
    """Fewest grains of a rank with that efficiency."""
    n = 10.0
    while partsOfSweep(n, ranks, reductions)[0] < efficiency*sum(partsOfSweep(n, ranks, reductions)):
        n *= 1.02
    return n


def main():
    reductions = float(sys.argv[1]) if len(sys.argv) > 1 else REDUCTIONS
    print("| grains | ranks | n | work | load | messages | node | reductions | noise | sweep [us] | efficiency |")
    print("|" + "---|"*11)
    for grains in (1e7, 1e8, 1e9):
        for ranks in (1e3, 1e4, 1e5):
            parts = partsOfSweep(grains/ranks, ranks, reductions)
            print("| %.0e | %.0e | %.0f | %s | %.0f | %.2f |" % (
                grains, ranks, grains/ranks, " | ".join("%.0f" % (1e6*part) for part in parts), 1e6*sum(parts), parts[0]/sum(parts)))
    for ranks in (1e3, 1e4, 1e5):
        print("%.0e ranks: half the efficiency at %.0f grains a rank, 0.7 at %.0f" % (
            ranks, smallest(ranks, 0.5, reductions), smallest(ranks, 0.7, reductions)))


main()
