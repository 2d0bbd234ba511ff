# SPDX-License-Identifier: MIT
"""An environment like gymnasium's: a box floats on the sea, and a thruster holds it in its place."""
import numpy
import bolan


class FloatingBox:
    """1 m2 of area, 500 kg. Observation: x, speed, height over the water, rising speed. Action: thrust -1..1."""

    def reset(self, seed):
        state = bolan.SeaState.from_wind(10.0, 270.0, 50e3)
        self.sea = bolan.Sea(state, seed=seed, resolution=64)
        self.x, self.u, self.z, self.w, self.time = 0.0, 0.0, 0.0, 0.0, 0.0
        return self._observe()

    def _observe(self):
        self.sea.step(self.time)
        self.water = self.sea.motion([[self.x, 0.0]], least_wavelength=4.0)[0]  # shorter waves do not move it
        return numpy.array([self.x, self.u, self.z - self.water["height"], self.w])

    def step(self, action, dt=0.1):
        draught = min(max(self.water["height"] - self.z + 0.5, 0.0), 1.0)  # the box is 1 m high
        drag = 400.0 * (self.water["velocity"][0] - self.u)
        heave = 1026.0 * 9.81 * draught - 500.0 * 9.81 + 2000.0 * (self.water["rise"] - self.w)
        self.u += dt * (drag + 300.0 * float(numpy.clip(action, -1, 1))) / 500.0
        self.w += dt * heave / 1000.0  # with as much added mass
        self.x, self.z, self.time = self.x + dt * self.u, self.z + dt * self.w, self.time + dt
        observed = self._observe()
        return observed, -abs(self.x), abs(self.x) > 50.0, self.time >= 20.0, {}


environment, total, ended = FloatingBox(), 0.0, False
observed = environment.reset(seed=1)
while not ended:
    observed, reward, fell, late, _ = environment.step(-0.5 * observed[0] - 1.0 * observed[1])
    total, ended = total + reward, fell or late
x, over = environment.x, observed[2]
print(f"after {environment.time:.0f} s: x {x:+.2f} m, {over:+.2f} m over the water, reward {total:.1f}")
