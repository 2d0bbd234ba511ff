# SPDX-License-Identifier: MIT
"""A data set of pictures, radiance, distance and where the water is: sea_000.npz ..."""
import numpy
import bolan

world, renderer = bolan.World("open-sea"), bolan.Renderer("low")
random = numpy.random.default_rng(1)
for i in range(3):
    world.set_scene(world.scene.set_wind(random.uniform(4.0, 16.0), random.uniform(0.0, 360.0)))
    world.step(random.uniform(0.0, 1000.0))
    camera = bolan.Camera(position=(0.0, 0.0, random.uniform(5.0, 40.0)), pitch_deg=-10.0)
    rgb, distance = renderer.draw(world, (320, 180), camera), renderer.distance()
    numpy.savez_compressed(f"sea_{i:03}.npz", rgb=rgb, linear=renderer.linear(), distance=distance,
                           water=numpy.isfinite(distance), wind=world.scene.sea.sea_state.wind_speed)
    print(f"sea_{i:03}.npz: nearest water {distance.min():.1f} m, {numpy.isfinite(distance).mean():.0%} of the picture")
