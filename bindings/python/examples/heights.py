# SPDX-License-Identifier: MIT
"""A million heights in one call."""
import time
import numpy
import bolan

bolan.set_threads(0)  # one for each processor
sea = bolan.Sea(bolan.SeaState.from_beaufort(6, 225.0))
sea.step(10.0)
xy = numpy.random.default_rng(1).uniform(-5000.0, 5000.0, (1_000_000, 2))
heights = sea.heights(xy)  # the first question makes the fields
began = time.perf_counter()
sea.heights(xy, out=heights)
print(f"{len(xy)} heights in {1e3 * (time.perf_counter() - began):.0f} ms; Hs {4 * heights.std():.2f} m")
