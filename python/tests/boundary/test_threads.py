"""The loops run without the GIL."""

import threading

import numpy as np

import archerfish

SIZE = 1_000_000
ATTEMPTS = 300
UNTOUCHED = -7.0


def half_done(out):
    """Seen from here: the first element is written, the last is not."""
    return out[0] != UNTOUCHED and out[-1] == UNTOUCHED


def test_two_loops_run_at_once_while_python_looks_on():
    # With the GIL held, a call is one indivisible step to every other thread: no thread could ever
    # look at its output half written, let alone at two of them in the same moment.
    z = np.linspace(0.1, 10.0, SIZE)
    outs = [np.empty(SIZE), np.empty(SIZE)]
    for _ in range(ATTEMPTS):
        for out in outs:
            out[[0, -1]] = UNTOUCHED
        workers = [
            threading.Thread(target=archerfish.lambertw0, args=(z,), kwargs={"out": out})
            for out in outs
        ]
        for worker in workers:
            worker.start()
        seen = False
        while not seen and any(worker.is_alive() for worker in workers):
            seen = half_done(outs[0]) and half_done(outs[1])
        for worker in workers:
            worker.join()
        if seen:
            return
    raise AssertionError(f"in {ATTEMPTS} attempts two loops were never seen under way together")


def test_eight_threads_on_shared_inputs_give_the_same_numbers(ufunc, draw):
    """Every ufunc, of one, two and three numbers; half of the threads through strided memory."""
    inputs = draw(20_001)
    kept = [x.copy() for x in inputs]
    expected = ufunc(*inputs)
    room = np.full((8, 20_001, 2), UNTOUCHED)
    outs = [each[:, 0] if k % 2 else each.reshape(-1)[:20_001] for k, each in enumerate(room)]
    start = threading.Barrier(8)

    def work(out):
        start.wait()
        for _ in range(3):
            ufunc(*inputs, out=out)

    threads = [threading.Thread(target=work, args=(out,)) for out in outs]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(np.array_equal(expected, out) for out in outs)
    assert all(np.array_equal(before, after) for before, after in zip(kept, inputs, strict=True))
    assert np.all(room[1::2, :, 1] == UNTOUCHED)
    assert np.all(room[::2].reshape(4, -1)[:, 20_001:] == UNTOUCHED)
