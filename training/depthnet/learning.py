"""Batches, loss, one step of learning (as a CUDA graph where there is a GPU), validation."""
import copy
import time

import torch
import torch.nn.functional as functional

from . import sensor
from .network import CLASSES, HEIGHT, WIDTH

# Weight of each class in the cross entropy: the background fills most of the images.
CLASS_WEIGHTS = [0.6, 1.3, 1.0, 1.1, 1.0, 1.0, 1.1, 1.1, 1.1, 1.3, 1.0, 1.0, 1.2, 1.1, 1.0, 1.0, 1.0, 1.1]
DICE_WEIGHTS = [0.5, 3.0] + [1.0] * (len(CLASSES) - 2)


def make_batch(depth, classes, instances, material, cameras):
    """Network input [N, 6, H, W], labels (int64) and weight of each pixel, measured and true depth [N, H, W]."""
    measured, classes = sensor.measure(depth, classes, material)
    channels = sensor.input_channels(measured, *sensor.halved_intrinsics(cameras))
    labels = classes.float()[:, None]
    top = functional.max_pool2d(labels, 3, 1, 1)
    bottom = -functional.max_pool2d(-labels, 3, 1, 1)
    weight = torch.where(top[:, 0] != bottom[:, 0], 0.4, 1.0)  # outlines are uncertain by a pixel anyway
    weight = torch.where(measured > 0, weight, weight * 0.35)  # nothing measured: guess from the surroundings
    weight = torch.where((measured <= 0) & ((depth > 6) | (depth <= 0)), weight * 0.2, weight)
    return channels, classes.long(), weight, measured, depth


def at_phase(scores, row, column):
    """Every second row and column (from `row`, `column`: tensors, 0 or 1) of scores enlarged bilinearly to twice their size."""
    padded = functional.pad(scores, (1, 1, 1, 1), mode="replicate")
    lines = padded[:, :, 1:-1] * 0.75 + torch.where(row > 0, padded[:, :, 2:], padded[:, :, :-2]) * 0.25
    return lines[:, :, :, 1:-1] * 0.75 + torch.where(column > 0, lines[:, :, :, 2:], lines[:, :, :, :-2]) * 0.25


def every_second(image, row, column):
    """Rows and columns row, row + 2, ... of [N, H, W]; `row` and `column` are tensors [1]."""
    n, height, width = image.shape
    blocks = image.view(n, height // 2, 2, width // 2, 2)
    return blocks.index_select(2, row).index_select(4, column)[:, :, 0, :, 0]


def loss_function(scores, labels, weight, class_weights, dice_weights):
    """Cross entropy, plus Dice of the classes that are there (people three times), at full resolution.

    Each call looks at one pixel of every 2 x 2, drawn anew: a quarter of the work, the same on average.
    """
    row, column = (torch.randint(0, 2, (1,), device=scores.device) for _ in range(2))
    scores = at_phase(scores.float(), row, column)
    labels, weight = every_second(labels, row, column), every_second(weight, row, column)
    log_p = functional.log_softmax(scores, 1)
    truth = torch.zeros_like(log_p).scatter_(1, labels[:, None], 1.0)
    total = weight * class_weights[labels]
    cross_entropy = -(log_p.gather(1, labels[:, None])[:, 0] * total).sum() / total.sum()
    p = log_p.exp() * weight[:, None]
    present = (truth * weight[:, None]).sum((0, 2, 3))
    dice = 1 - (2 * (p * truth).sum((0, 2, 3)) + 50) / (p.sum((0, 2, 3)) + present + 50)
    share = (present > 50).float() * dice_weights
    return cross_entropy + 0.5 * (dice * share).sum() / share.sum().clamp(min=1)


class Learner:
    """Network, optimiser and the exponential moving average of the weights, which is what is kept.

    With `graph`, one step (sensor, network, loss, gradients, update, average) is captured once and replayed: its some
    thousand kernels are too short to be launched one by one.
    """

    def __init__(self, network, graph):
        self.network = network
        self.device = next(network.parameters()).device
        self.cuda = self.device.type == "cuda"
        self.average = copy.deepcopy(network).eval().requires_grad_(False)
        decayed = [p for p in network.parameters() if p.ndim > 1]
        plain = [p for p in network.parameters() if p.ndim <= 1]
        self.rate = torch.tensor(1e-5, device=self.device) if self.cuda else 1e-5
        options = dict(fused=True, capturable=True) if self.cuda else {}
        self.optimiser = torch.optim.AdamW([{"params": decayed, "weight_decay": 0.02}, {"params": plain, "weight_decay": 0}],
                                           lr=self.rate, **options)
        self.class_weights = torch.tensor(CLASS_WEIGHTS, device=self.device)
        self.dice_weights = torch.tensor(DICE_WEIGHTS, device=self.device)
        self.keep = torch.tensor(0.5, device=self.device)  # decay of the average
        self.steps = 0
        self.wanted, self.graph, self.inputs, self.loss = graph, None, None, None

    def _learn(self, cast):
        channels, labels, weight, _, _ = make_batch(*cast)
        if self.cuda:
            channels = channels.contiguous(memory_format=torch.channels_last)
        with torch.autocast(self.device.type, torch.bfloat16, enabled=self.cuda):
            scores = self.network(channels)
        loss = loss_function(scores, labels, weight, self.class_weights, self.dice_weights)
        loss.backward()
        torch.nn.utils.clip_grad_norm_(self.network.parameters(), 5.0)
        self.optimiser.step()
        self.optimiser.zero_grad(set_to_none=not self.cuda)
        self._update_average()
        return loss.detach()

    @torch.no_grad()
    def _update_average(self):
        mine, new = self.average.state_dict(), self.network.state_dict()
        floats = [k for k in mine if mine[k].dtype.is_floating_point]
        for k in floats:
            mine[k].lerp_(new[k], 1 - self.keep)

    def _set(self, rate):
        self.keep.fill_(min(0.998, (1 + self.steps) / (20 + self.steps)))
        for group in self.optimiser.param_groups:
            if self.cuda:
                group["lr"].fill_(rate)
            else:
                group["lr"] = rate

    def step(self, generator, scenes, rate):
        """One step; returns the loss as a tensor."""
        self.steps += 1
        self._set(rate)
        cast = generator.cast(*scenes)
        if self.graph is None:
            return self._learn(cast)
        for kept, new in zip(self.inputs, cast):
            kept.copy_(new)
        self.graph.replay()
        return self.loss.clone()

    def warm_up(self, generator):
        """A few steps at a tiny rate, so that cuDNN chooses its algorithms; then the graph is captured."""
        if not self.cuda:
            return
        side = torch.cuda.Stream()
        side.wait_stream(torch.cuda.current_stream())
        with torch.cuda.stream(side):
            for _ in range(4):
                self.step(generator, generator.scene_batch(), 1e-6)
        torch.cuda.current_stream().wait_stream(side)
        torch.cuda.synchronize()
        self._time("without a graph", generator)
        if not self.wanted:
            return
        try:
            self.inputs = [t.clone() for t in generator.cast(*generator.scene_batch())]
            torch.cuda.synchronize()
            graph = torch.cuda.CUDAGraph()
            with torch.cuda.graph(graph):
                self.loss = self._learn(self.inputs)
            self.graph = graph
            self._time("as a graph", generator)
        except Exception as error:
            self.graph = None
            torch.cuda.synchronize()
            print("no CUDA graph, going on without:", repr(error)[:600], flush=True)

    def _time(self, how, generator):
        scenes = [generator.scene_batch() for _ in range(3)]
        torch.cuda.synchronize()
        start = time.time()
        for k in range(12):
            loss = self.step(generator, scenes[k % 3], 1e-6)
        torch.cuda.synchronize()
        print(f"a step {how}: {(time.time() - start) / 12 * 1e3:.1f} ms, loss {loss.item():.3f}", flush=True)
        start = time.time()
        for k in range(5):
            cast = generator.cast(*scenes[k % 3])
        torch.cuda.synchronize()
        middle = time.time()
        for k in range(5):
            make_batch(*cast)
        torch.cuda.synchronize()
        print(f"  of this ray casting {(middle - start) / 5 * 1e3:.1f} ms, sensor and channels (unfused) {(time.time() - middle) / 5 * 1e3:.1f} ms", flush=True)


@torch.no_grad()
def predict(network, channels):
    """Best class per pixel [N, 240, 320]."""
    scores = network(channels)
    return functional.interpolate(scores.float(), size=(HEIGHT, WIDTH), mode="bilinear", align_corners=False).argmax(1)


@torch.no_grad()
def validate(network, batches):
    """Intersection over union per class, on measured pixels."""
    classes = len(CLASSES)
    confusion = torch.zeros((classes, classes), device=batches[0][0].device)
    for channels, labels, _, measured, _ in batches:
        best = predict(network, channels)
        keep = measured > 0
        confusion += torch.bincount(labels[keep] * classes + best[keep], minlength=classes ** 2).view(classes, classes)
    hit = confusion.diag()
    return (hit / (confusion.sum(0) + confusion.sum(1) - hit).clamp(min=1)).cpu().numpy()
