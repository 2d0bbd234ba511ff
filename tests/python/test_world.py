# SPDX-License-Identifier: MIT
"""Scenes, worlds and pictures."""
import math
import threading

import numpy
import pytest

import bolan

YAML = """
camera: {position: [0, 0, 12], heading: 90, pitch: -10}
sea: {wind: {speed: 6, from: 200}}
"""


def test_scene_of_text():
    scene = bolan.Scene.parse(YAML)
    assert scene.camera.position == (0.0, 0.0, 12.0) and scene.camera.heading_deg == 90.0
    assert scene.sea.sea_state.wind_speed == 6.0
    scene.set_wind(10.0, 100.0).set_technique("exp-cosine")
    assert scene.sea.sea_state.wind_speed == 10.0 and scene.sea.waves == "exp-cosine"
    assert scene.technique.name == "exp-cosine" and scene.technique.optics == "phong"
    with pytest.raises(bolan.ArgumentError, match="expected one of ocean, two-triangle"):
        scene.set_technique("magic")


def test_bad_scenes_name_line_and_key(tmp_path):
    with pytest.raises(bolan.FormatError, match=r"mine:2: unknown key camera.hight") as caught:
        bolan.Scene.parse("# a scene\ncamera: {hight: 3}\n", name="mine")
    assert caught.value.id == 311  # SCENE_UNKNOWN_KEY
    path = tmp_path / "bad.yaml"
    path.write_text("sea:\n  wind: {speed: 1000}\n")
    with pytest.raises(bolan.FormatError, match=r"bad.yaml:2: .*wind"):
        bolan.Scene.load(path)
    with pytest.raises(bolan.FileError, match="none.yaml"):
        bolan.World(tmp_path / "none.yaml")
    scene = bolan.Scene()
    scene.camera.fov_deg = 500.0
    with pytest.raises(bolan.ArgumentError, match="fov_deg"):
        scene.validate()


def test_cameras_begin_with_the_defaults():
    assert (bolan.Camera().position, bolan.Camera().fov_deg) == ((0.0, 0.0, 3.0), 50.0)


def test_world_steps_and_answers():
    assert {"island", "open-sea", "storm"} <= set(bolan.scene_names())
    with bolan.World("open-sea") as world:
        xy, under = [[0.0, 0.0], [25.0, 0.0]], [[0.0, 0.0, -3.0]]
        world.step(3.0)
        world.below(under)
        assert world.time == 3.0 and world.scene.time == 3.0
        fork = world.fork_sea()
        fork.step(3.0)
        assert world.heights(xy).tobytes() == fork.heights(xy).tobytes()
        scene = world.scene.set_wind(16.0, 30.0)
        world.set_scene(scene)
        assert world.time == 3.0 and world.heights(xy).tobytes() != fork.heights(xy).tobytes()
        fork = world.fork_sea()
        fork.step(3.0)
        assert world.below(under).tobytes() == fork.below(under).tobytes()  # the flow follows the other sea
        world.set_camera(bolan.Camera(position=(1.0, 2.0, 30.0)))
        assert world.scene.camera.position == (1.0, 2.0, 30.0)
        world.settle(5.0)
        assert world.time == 5.0
        scene.tiles_path = "/there/are/none"
        with pytest.raises(bolan.ArgumentError, match="tiles"):
            world.set_scene(scene)
    with pytest.raises(bolan.ClosedError):
        world.heights(xy)


def test_a_world_has_land_and_objects():
    with bolan.World("island") as world:
        assert world.heights([[0.0, 0.0]])[0] == pytest.approx(world.scene.water.level, abs=1e-6)  # dry land
    with bolan.World("pond") as world:
        assert len(world.scene.objects) == world.scene.object_count > 0
        pose = world.object_pose(0)
        assert sum(v * v for v in pose.z) == pytest.approx(1.0, abs=1e-5)
        with pytest.raises(bolan.ArgumentError, match="the scene has"):
            world.object_pose(1000)


def test_picture_radiance_and_distance(renderer):
    scene = bolan.Scene.parse(YAML)
    scene.sky.cloud_cover = 0.0
    with bolan.World(scene) as world:
        rgb, linear, distance = renderer.draw(world, (160, 90)), renderer.linear(), renderer.distance()
        assert rgb.shape == (90, 160, 3) and rgb.dtype == numpy.uint8
        assert linear.shape == (90, 160, 3) and distance.shape == (90, 160)
        assert numpy.isinf(distance[0]).all() and numpy.isfinite(distance[60:]).all()  # sky above, water below
        # Row r looks down by pitch + atan(...): along the view axis flat water 12 m below is at 12 / sin, times cos.
        row = 75
        down = math.atan(math.tan(math.radians(25.0)) * (2 * (row + 0.5) / 90 - 1)) + math.radians(10.0)
        expected = 12.0 / math.sin(down) * math.cos(down - math.radians(10.0))
        assert numpy.median(distance[row, 70:90]) == pytest.approx(expected, rel=0.1)
        hit = world.rays([[0.0, 0.0, 12.0]], [[math.cos(down), 0.0, -math.sin(down)]], 1e4)
        along = hit["distance"][0] * math.cos(down - math.radians(10.0))
        assert distance[row, 79:81].mean() == pytest.approx(along, rel=0.02)
        assert linear[0, :, 2].mean() > linear[0, :, 0].mean() > 0  # a clear sky is blue
        out = numpy.zeros((90, 160, 3), "u1")
        assert renderer.draw(world, (160, 90), out=out) is out and (out == rgb).all()
        smooth = renderer.draw(world, (160, 90), samples=4)
        assert (smooth != rgb).any() and abs(smooth.astype("f4") - rgb).mean() < 8
        other = renderer.draw(world, (64, 64), camera=bolan.Camera(position=(0.0, 0.0, 40.0), pitch_deg=-90.0))
        assert renderer.distance().shape == (64, 64) and renderer.distance().mean() == pytest.approx(40.0, abs=1.0)
        assert other.shape == (64, 64, 3)


def test_files_of_pictures(renderer, tmp_path):
    with bolan.World("open-sea") as world:
        rgb = renderer.draw(world, (64, 32))
        bolan.write_png(tmp_path / "sea.png", rgb)
        assert (tmp_path / "sea.png").read_bytes()[:4] == b"\x89PNG"
        bolan.write_exr(tmp_path / "sea.exr", Z=renderer.distance())
        assert (tmp_path / "sea.exr").read_bytes()[:4] == b"\x76\x2f\x31\x01"
        with pytest.raises(bolan.FileError, match="sea.png"):
            bolan.write_png(tmp_path / "no" / "sea.png", rgb)
        assert sorted(path.name for path in tmp_path.iterdir()) == ["sea.exr", "sea.png"]


def test_renderer_stays_on_its_thread(renderer):
    caught = []

    def elsewhere():
        try:
            renderer.info
        except bolan.GLError as error:
            caught.append(str(error))
    thread = threading.Thread(target=elsewhere)
    thread.start()
    thread.join()
    assert caught and "belongs to the thread" in caught[0]
    assert renderer.info["max_picture"] >= 4096


def test_renderer_refuses(renderer):
    with pytest.raises(bolan.ArgumentError, match="quality is 'best'; expected one of low, medium, high, ultra"):
        bolan.Renderer("best")
    with bolan.World("open-sea") as world:
        for size in ((0, 10), (10, 20000), (10.0, 10), 5):
            with pytest.raises(bolan.ArgumentError, match="size is"):
                renderer.draw(world, size)
        with pytest.raises(bolan.ArgumentError, match="samples"):
            renderer.draw(world, (16, 16), samples=0)
        for _ in range(2):  # every time, not once
            with pytest.raises(bolan.ArgumentError, match="fov"):
                renderer.draw(world, (16, 16), camera=bolan.Camera(fov_deg=0.0))
        second = bolan.Renderer("low")
        with pytest.raises(bolan.GLError, match="no picture yet"):
            second.linear()
        second.draw(world, (16, 16))
        second.close()
        second.close()
        with pytest.raises(bolan.ClosedError):
            second.draw(world, (16, 16))
        renderer.draw(world, (16, 16))
        with pytest.raises(bolan.ArgumentError, match="float32 of shape"):
            renderer.linear(out=numpy.empty((16, 17, 3), "f4"))


def test_a_renderer_dropped_on_another_thread_goes_with_the_next_one_of_its_own(renderer):
    made, dropped, after = [], threading.Event(), []

    def own():
        made.append(bolan.Renderer("low"))
        ready.set()
        dropped.wait()
        before = bolan.memory_in_use()
        last = bolan.Renderer("low")
        last.close()
        after.append((before, bolan.memory_in_use()))
    ready = threading.Event()
    thread = threading.Thread(target=own)
    thread.start()
    ready.wait()
    made.clear()
    dropped.set()
    thread.join()
    (before, now), = after
    assert now < before
