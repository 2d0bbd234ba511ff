# SPDX-License-Identifier: MIT
"""A buoy's record of 20 minutes, and its spectrum beside that of the sea: buoy.png."""
import matplotlib
import numpy
import bolan

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

sea = bolan.Sea(bolan.SeaState.from_wind(12.0, 225.0, 300e3).add_swell(1.5, 14.0, 300.0), resolution=64)
times = numpy.arange(0.0, 1200.0, 0.5)
heave = numpy.empty(len(times), "f4")
for i, time in enumerate(times):
    sea.step(time)
    heave[i] = sea.sample([[0.0, 0.0]])["height"][0]

bands = bolan.record.spectrum(heave, rate=2.0, segment=256)
grid = sea.desc.sea_state.sample()
pyplot.plot(bands["frequency"], bands["density"], label="the buoy")
pyplot.plot(grid.omega / (2 * numpy.pi), grid.density.mean(axis=1) * (2 * numpy.pi) ** 2, label="the sea")
pyplot.xlim(0.0, 0.4), pyplot.xlabel("frequency [Hz]"), pyplot.ylabel("density [m2/Hz]"), pyplot.legend()
pyplot.savefig("buoy.png")
measured = bolan.record.measure(heave, 2.0)
print(f"H1/3 {measured.h_third:.2f} m, Hm0 {measured.hm0:.2f} m, mean period {measured.tz:.2f} s")
