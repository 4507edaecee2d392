"""Builds the two compiled parts (scenes.cpp: random scenes, raycast.cu: ray caster) and makes batches of noise-free images.

With a GPU the ray caster is built by nvcc, else by g++; the pictures are the same.
"""
import ctypes
import hashlib
import os
import queue
import shutil
import subprocess
import tempfile
import threading

import numpy as np
import torch

SOURCES = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "scenes")
CAPACITY = 1600          # primitives a scene can hold
PRIMITIVE_FLOATS, CAMERA_FLOATS = 28, 16
HEIGHT, WIDTH = 240, 320


def _build(name, sources, command):
    """Compiles once per content of the sources; returns the loaded library."""
    content = b"".join(open(os.path.join(SOURCES, s), "rb").read() for s in sources) + " ".join(command).encode()
    path = os.path.join(tempfile.gettempdir(), f"depthnet_{name}_{hashlib.sha256(content).hexdigest()[:16]}.so")
    if not os.path.exists(path):
        partial = f"{path}.{os.getpid()}"
        subprocess.run(command + ["-o", partial], cwd=SOURCES, check=True)
        os.replace(partial, path)
    return ctypes.CDLL(path)


def _pointer(array):
    return ctypes.c_void_p(array.data_ptr() if isinstance(array, torch.Tensor) else array.ctypes.data)


class Generator:
    """Endless batches of (depth [m], class, instance, material) as tensors [N, 240, 320] on `device`, and cameras [N, 16]."""

    def __init__(self, device, batch, seed, views=1, threads=None):
        self.device, self.batch, self.views = torch.device(device), batch, views
        self.threads = threads or max(1, (os.cpu_count() or 2) - 2)
        self.seed = seed
        headers = sorted(f for f in os.listdir(SOURCES) if f.endswith((".h", ".cpp")))
        self.scenes = _build("scenes", headers, ["g++", "-O2", "-std=c++17", "-shared", "-fPIC", "-pthread", "scenes.cpp"])
        if self.device.type == "cuda":
            arch = "sm_%d%d" % torch.cuda.get_device_capability()
            command = [shutil.which("nvcc") or "/usr/local/cuda/bin/nvcc", "-O3", "-std=c++17", f"-arch={arch}", "-use_fast_math", "-Xcompiler", "-fPIC", "-shared", "raycast.cu"]
        else:
            command = ["g++", "-O3", "-march=native", "-ffast-math", "-fopenmp", "-std=c++17", "-shared", "-fPIC", "-x", "c++", "raycast.cu"]
        self.caster = _build("raycast_" + self.device.type, ["raycast.cu"], command)
        self.overruns = 0

    def scene_batch(self):
        """Primitives, counts and cameras of the next batch, in host memory."""
        pin = self.device.type == "cuda"
        primitives = torch.empty((self.batch, CAPACITY, PRIMITIVE_FLOATS), pin_memory=pin)
        counts = torch.empty(self.batch, dtype=torch.int32, pin_memory=pin)
        cameras = torch.empty((self.batch, CAMERA_FLOATS), pin_memory=pin)
        self.overruns += self.scenes.generate_scenes(ctypes.c_uint64(self.seed), self.batch, self.views, CAPACITY,
                                                     _pointer(primitives), _pointer(counts), _pointer(cameras), self.threads)
        self.seed += self.batch // self.views
        return primitives, counts, cameras

    def cast(self, primitives, counts, cameras):
        n, device = len(counts), self.device
        primitives, counts, cameras = (t.to(device, non_blocking=True) for t in (primitives, counts, cameras))
        depth = torch.empty((n, HEIGHT, WIDTH), device=device)
        labels = [torch.empty((n, HEIGHT, WIDTH), dtype=torch.uint8, device=device) for _ in range(3)]
        stream = ctypes.c_void_p(torch.cuda.current_stream().cuda_stream if device.type == "cuda" else None)
        error = self.caster.raycast(_pointer(primitives), _pointer(counts), CAPACITY, _pointer(cameras), n, WIDTH, HEIGHT,
                                    _pointer(depth), *[_pointer(t) for t in labels], stream)
        if error:
            raise RuntimeError(f"ray caster: CUDA error {error}")
        return depth, labels[0], labels[1], labels[2], cameras

    def prefetch(self, depth=4):
        """Scene batches made ahead by a background thread."""
        ready = queue.Queue(depth)

        def work():
            while True:
                ready.put(self.scene_batch())
        threading.Thread(target=work, daemon=True).start()
        return ready
