# SPDX-License-Identifier: MIT
"""Wrong arguments, closed objects, threads and leaks: exceptions with a sentence, never a crash."""
import gc
import subprocess
import sys
import threading
import time
import warnings

import numpy
import pytest

import bolan
from bolan import _library, record

WRONG = {
    "float32": numpy.zeros((3, 2), "f4"), "three columns": numpy.zeros((3, 3)), "one axis": numpy.zeros(2),
    "strided": numpy.zeros((3, 4))[:, ::2], "column-major": numpy.zeros((2, 3)).T,
    "big-endian": numpy.zeros((3, 2), ">f8"),
    "complex": numpy.zeros((3, 2), complex), "text": "somewhere", "none": None, "ragged": [[1.0, 2.0], [3.0]],
}


@pytest.mark.parametrize("name", WRONG)
def test_wrong_points(sea, name):
    for ask in (sea.heights, sea.surface, sea.motion, sea.sample):
        with pytest.raises(bolan.ArgumentError, match=r"expected a contiguous array of float64 of shape \(n, 2\)"):
            ask(WRONG[name])


def test_wrong_out(sea):
    xy = numpy.zeros((4, 2))
    fixed = numpy.zeros(4, "f4")
    fixed.flags.writeable = False
    for out in (numpy.zeros(3, "f4"), numpy.zeros(4), numpy.zeros(8, "f4")[::2], fixed, [0.0] * 4,
                numpy.zeros((4, 1), "f4")):
        with pytest.raises(bolan.ArgumentError, match=r"a contiguous, writeable array of float32 of shape \(4,\)"):
            sea.heights(xy, out=out)


def test_sentences_are_the_library_s(sea):
    with pytest.raises(bolan.ArgumentError, match="resolution is 100; expected a power of two from 32 to") as caught:
        bolan.Sea(resolution=100)
    assert caught.value.id == 103 and isinstance(caught.value, ValueError)
    with pytest.raises(bolan.ArgumentError, match=r"hs is 200; expected 0 to 40 m"):
        bolan.SeaState().add_swell(200.0, 10.0, 0.0)
    with pytest.raises(bolan.FormatError, match="mine.spec"):
        bolan.MeasuredSpectrum.parse(b"no spectrum", "mine.spec")
    with pytest.raises(bolan.FileError, match="none.spec") as caught:
        bolan.MeasuredSpectrum.load("/there/is/none.spec")
    assert isinstance(caught.value, OSError)


def test_warnings_are_warnings():
    with pytest.warns(bolan.BolanWarning, match="lower"):
        bolan.Sea(bolan.SeaState(depth=2.0).add_swell(5.0, 10.0, 0.0), resolution=32)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(bolan.BolanWarning):
            bolan.Sea(bolan.SeaState(depth=2.0).add_swell(5.0, 10.0, 0.0), resolution=32)
        bolan.Sea(resolution=32)  # silent


def test_wrong_fields():
    desc = bolan.SeaDesc()
    for name, value, said in (("seed", -1, "uint64_t"), ("seed", 1.5, "uint64_t"), ("resolution", 2**32, "uint32_t"),
                              ("choppiness", "much", "a number"), ("waves", "ripples", "expected one of fft, cosines"),
                              ("sea_state", 3, "a dict of its fields"), ("fft", {"cascade_count": "two"}, "uint32_t")):
        with pytest.raises(bolan.ArgumentError, match=said):
            setattr(desc, name, value)
    with pytest.raises(AttributeError, match="no field sharpness"):
        desc.sharpness = 1.0
    with pytest.raises(AttributeError, match="no field windy"):
        bolan.Sea(windy=True)
    scene = bolan.Scene()
    with pytest.raises(bolan.ArgumentError, match="at most 1023"):
        scene.spectrum_path = "x" * 1024
    with pytest.raises(bolan.ArgumentError, match="2 values; expected 3"):
        scene.camera.position = (1.0, 2.0)
    for flag in (1, 1.0, "yes"):
        with pytest.raises(bolan.ArgumentError, match="True or False"):
            scene.wind_sea = flag


def test_wrong_numbers(sea):
    for time in (float("nan"), float("inf"), "now", None):
        with pytest.raises(bolan.ArgumentError, match="time is not a finite number"):
            sea.step(time)
    for index in (4, -1, 0.0, None):
        with pytest.raises(bolan.ArgumentError, match=r"expected 0\.\.3"):
            sea.cascade(index)
    with pytest.raises(bolan.ArgumentError, match="stretching is 'long'; expected one of none, wheeler"):
        sea.below([[0.0, 0.0, -1.0]], stretching="long")
    with pytest.raises(bolan.ArgumentError, match="least_wavelength"):
        sea.below([[0.0, 0.0, -1.0]], least_wavelength=-1.0)
    with pytest.raises(bolan.ArgumentError, match="steps"):
        sea.crests((0.0, 0.0), (1e9, 0.0), 0.01)
    with pytest.raises(bolan.ArgumentError, match="points holds a number that is not finite"):
        sea.sample([[float("nan"), 0.0]])
    assert numpy.isfinite(sea.heights([[float("nan"), 0.0]])).all()  # a query answers with the level
    with pytest.raises(bolan.ArgumentError, match="at most 8"):
        bolan.Water(sea, layers=[bolan.WaveLayer()] * 9)
    with pytest.raises(bolan.ArgumentError, match="threads is 65"):
        bolan.set_threads(65)
    for path in (3, None, "a\0b"):
        with pytest.raises(bolan.ArgumentError, match="path is"):
            bolan.World(path)


def test_wrong_records():
    heave = numpy.zeros(64, "f4")
    for rate in (0.0, -1.0, float("nan")):
        with pytest.raises(bolan.ArgumentError, match="rate is"):
            record.measure(heave, rate)
    with pytest.raises(bolan.ArgumentError, match="samples"):
        record.measure(heave[:1], 2.0)
    with pytest.raises(bolan.ArgumentError, match="multiple of 4"):
        record.spectrum(heave, 2.0, 18)
    with pytest.raises(bolan.ArgumentError, match="both or neither"):
        record.spectrum(heave, 2.0, 16, east=heave)
    with pytest.raises(bolan.ArgumentError, match=r"north is float32 of shape \(3,\)"):
        record.spectrum(heave, 2.0, 16, east=heave, north=heave[:3])
    with pytest.raises(bolan.ArgumentError):
        record.spectrum(heave[:16], 2.0, 32)


def test_closed_objects_refuse_everything():
    sea, layer, world = bolan.Sea(resolution=32), bolan.WaveLayer(), bolan.World("open-sea")
    water, fork = bolan.Water(sea, layers=[layer]), sea.fork()
    for thing in (layer, world):
        thing.close()
        thing.close()
        assert thing.closed
    with pytest.raises(bolan.ClosedError, match="this WaveLayer is closed"):
        water.heights([[0.0, 0.0]])
    sea.close()
    xy = [[0.0, 0.0]]
    for use in (lambda: sea.heights(xy), lambda: sea.below([[0.0, 0.0, 0.0]]), lambda: sea.step(1.0), lambda: sea.time,
                sea.fork, sea.hash, sea.measure, lambda: sea.desc, lambda: sea.summary, lambda: sea.bounds,
                sea.components, lambda: sea.cascade(0), lambda: sea.sample(xy), lambda: water.heights(xy),
                lambda: sea.__enter__()):
        with pytest.raises(bolan.ClosedError, match="this Sea is closed"):
            use()
    for use in (lambda: world.heights(xy), lambda: world.step(1.0), lambda: world.scene, lambda: world.time,
                lambda: world.camera_at(0.0), world.fork_sea, lambda: world.object_pose(0)):
        with pytest.raises(bolan.ClosedError, match="this World is closed"):
            use()
    assert fork.heights(xy).shape == (1,)


def test_two_threads_at_once():
    xy = numpy.random.default_rng(7).uniform(-500, 500, (200, 2))
    sea = bolan.Sea(resolution=32)
    truth = {}
    for step in range(20):
        sea.step(step / 4)
        truth[step / 4] = sea.heights(xy).tobytes()
    wrong, sentences = [], {}

    def private(times):
        own = sea.fork()
        for time in times:
            own.step(time)
            if own.heights(xy).tobytes() != truth[time]:
                wrong.append(time)

    def shared():
        for step in range(60):
            sea.step(step % 20 / 4)
            if sea.heights(xy).tobytes() not in truth.values():  # of one time, never of two
                wrong.append("torn")

    def refused(value):
        for _ in range(30):
            with pytest.raises(bolan.ArgumentError) as caught:
                bolan.SeaState().add_swell(value, 10.0, 0.0)
            sentences.setdefault(value, set()).add(str(caught.value))
    jobs = [(private, list(truth)), (private, list(truth)[::-1]), (shared,), (shared,), (refused, 100.0),
            (refused, 200.0)]
    threads = [threading.Thread(target=job, args=arguments) for job, *arguments in jobs]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong
    assert {value: len(said) for value, said in sentences.items()} == {100.0: 1, 200.0: 1}
    assert all(f"is {int(value)};" in said.pop() for value, said in sentences.items())  # each thread hears its own


def test_a_thread_hears_its_own_sentences_alone():
    def refuse(depth):
        state = bolan.SeaState(depth=depth)
        return lambda: _library.lib.bolan_sea_state_validate(state._c)

    def both():
        thread = threading.Thread(target=_library._hear, args=(refuse(-2.0), ()))
        thread.start()
        thread.join()
        return refuse(-1.0)()
    _, said = _library._hear(both, ())
    assert [sentence.split(";")[0] for _, _, sentence in said] == ["bolan_sea_state: depth is -1"]


def test_another_version_of_the_library_is_an_import_error(monkeypatch):
    monkeypatch.setattr(_library, "VERSION", "0.1")
    with pytest.raises(ImportError, match="is version 0.2.0 of the library; expected 0.1"):
        _library._open()


def test_a_long_call_lets_other_threads_run(sea):
    xy = numpy.random.default_rng(8).uniform(-500, 500, (2400000, 2))
    stamps, done = [], threading.Event()

    def stamp():
        while not done.wait(0.001):
            stamps.append(time.perf_counter())
    thread = threading.Thread(target=stamp)
    thread.start()
    began = time.perf_counter()
    sea.heights(xy)
    ended = time.perf_counter()
    done.set()
    thread.join()
    # With the lock of Python held no stamp can lie inside the call; the margin is what Python needs to change threads.
    assert ended - began > 0.06
    assert any(began + 0.02 < at < ended - 0.02 for at in stamps)


def test_closing_while_another_thread_asks():
    xy = numpy.random.default_rng(9).uniform(-500, 500, (20000, 2))
    for _ in range(20):
        sea = bolan.Sea(resolution=32)
        said = []

        def ask():
            try:
                while True:
                    sea.heights(xy)
            except bolan.ClosedError as error:
                said.append(str(error))
        thread = threading.Thread(target=ask)
        thread.start()
        sea.close()
        thread.join()
        assert said == ["this Sea is closed"]


def test_nothing_leaks_over_1000_creations():
    def once():
        with bolan.Sea(bolan.SeaState(), resolution=32, fft={"cascade_count": 1}) as sea:
            sea.fork()
            sea.cascade(0).height
            sea.below([[0.0, 0.0, -1.0]])
        bolan.WaveLayer()
        with pytest.raises(bolan.ArgumentError):
            bolan.Sea(resolution=33)
    once()
    gc.collect()
    before = bolan.memory_in_use()
    for _ in range(1000):
        once()
    gc.collect()
    assert bolan.memory_in_use() == before


def test_worlds_and_renderers_do_not_leak(renderer):
    gc.collect()
    before = bolan.memory_in_use()
    for _ in range(2):
        with bolan.World("open-sea") as world, bolan.Renderer("low") as own:
            own.draw(world, (32, 32))
        del world, own
    gc.collect()
    assert bolan.memory_in_use() == before


@pytest.mark.parametrize("library, said", [("/there/is/no.so", "is not found"), ("libm.so.6", "bolan_version")])
def test_a_wrong_library_is_an_import_error(library, said, monkeypatch):
    monkeypatch.setenv("BOLAN_LIBRARY", library)
    ran = subprocess.run([sys.executable, "-c", "import bolan"], capture_output=True, text=True)
    assert ran.returncode == 1 and "ImportError" in ran.stderr and said in ran.stderr


def test_the_end_of_the_program_is_quiet(renderer):
    code = ("import bolan, numpy; s = bolan.Sea(resolution=32); a = s.cascade(0).height; w = bolan.World('pond');"
            "r = bolan.Renderer('low'); r.draw(w, (16, 16)); f = s.fork(); print('end')")
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert (ran.returncode, ran.stdout, ran.stderr) == (0, "end\n", "")
