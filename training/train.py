"""Trains the network on synthetic depth that is made on the GPU while it learns.

    python3 train.py --out DIR --seconds 540 [--start CHECKPOINT] [--seed 1]

Checks itself first (the ray caster against the same code on the CPU, images sane, loss falls, no NaN) and stops if that
fails. Checkpoint and ONNX file are written every --save-every seconds, so a run that is cut short still delivers.
"""
import argparse
import io
import lzma
import math
import os
import sys
import time

import torch

import montage
from depthnet.generator import Generator
from depthnet.learning import Learner, make_batch, validate, predict
from depthnet.network import CLASSES, DepthNet, export_onnx, parameters


def load_checkpoint(path):
    """A checkpoint, as written here or packed by xz."""
    with (lzma.open if path.endswith(".xz") else open)(path, "rb") as file:
        return torch.load(io.BytesIO(file.read()), map_location="cpu")


def take_over(network, weights):
    """Copies what has the same name and shape; returns names of what was not found."""
    own = network.state_dict()
    fitting = {k: v.float() for k, v in weights.items() if k in own and own[k].shape == v.shape and v.is_floating_point()}
    own.update(fitting)
    network.load_state_dict(own)
    return [k for k in own if k not in fitting and own[k].is_floating_point()]


def check_caster(generator):
    """The GPU's images against those of the same source on the CPU; ends the program where they differ."""
    few = tuple(t[:4] for t in generator.scene_batch())
    device = generator.cast(*few)
    host = Generator("cpu", 4, 0).cast(*few)
    differ = ((device[0].cpu() - host[0]).abs() > 0.01).float().mean().item()
    labels = (device[1].cpu() != host[1]).float().mean().item()
    print(f"ray caster, GPU against CPU: depth differs in {100 * differ:.3f} %, class in {100 * labels:.3f} % of pixels",
          flush=True)
    if differ > 0.01 or labels > 0.01:
        sys.exit("FAILED: the ray caster's GPU images differ from the CPU's")


def check_images(validation, overruns, out):
    """Shares of classes and of measured pixels; ends the program where they are not sane."""
    labels = torch.stack([v[1] for v in validation])
    share = torch.bincount(labels.flatten(), minlength=len(CLASSES)).float() / labels.numel()
    print("shares of pixels:", " ".join(f"{c}:{100 * s:.2f}%" for c, s in zip(CLASSES, share.tolist())))
    seen = torch.stack([(v[3] > 0).float().mean() for v in validation]).mean().item()
    finite = all(torch.isfinite(v[0]).all().item() for v in validation)
    print(f"measured pixels {100 * seen:.1f} %, finite {finite}, scenes that overran {overruns}", flush=True)
    v = validation[0]
    montage.write(os.path.join(out, "training_images.png"), *(v[k][:24].cpu().numpy() for k in (3, 1, 4)))
    if not finite or not 0.5 < seen < 0.99 or not 0.03 < share[1] < 0.4:
        sys.exit("FAILED: the images are not sane")


def save(network, out):
    """Checkpoint and ONNX file, each whole or not at all."""
    path = os.path.join(out, "checkpoint.pt")
    torch.save({"network": network.state_dict(), "classes": CLASSES}, path + ".partial")
    os.replace(path + ".partial", path)
    try:
        export_onnx(network, os.path.join(out, "depth_hospital.onnx"))
    except Exception as error:  # the checkpoint is enough to export elsewhere
        print("ONNX export failed here:", repr(error)[:300], flush=True)


def schedule(progress, peak):
    """Learning rate: up in the first 4 %, then down a half cosine."""
    if progress < 0.04:
        return peak * max(progress, 1e-3) / 0.04
    return peak * (0.5 * (1 + math.cos(math.pi * (min(progress, 1.0) - 0.04) / 0.96)) + 1e-3)


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", required=True)
    parser.add_argument("--seconds", type=float, default=540, help="wall time of the training proper")
    parser.add_argument("--until", type=float, default=0, help="if given: seconds after the start at which all is done")
    parser.add_argument("--batch", type=int, default=64, help="images a step")
    parser.add_argument("--rate", type=float, default=2.5e-3, help="peak of the learning rate")
    parser.add_argument("--start", default="", help="checkpoint to take fitting weights from")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--save-every", type=float, default=90, help="seconds")
    parser.add_argument("--device", default="cuda")
    parser.add_argument("--eager", action="store_true", help="no CUDA graph")
    parser.add_argument("--validation", type=int, default=6, help="batches")
    return parser.parse_args()


def train(learner, generator, options, validation, began):
    """The loop; returns the number of steps."""
    ready = generator.prefetch()
    begin = last_save = last_print = time.time()
    seconds = options.until - (begin - began) - 12 if options.until else options.seconds
    recent, first, step, printed_step, waited = [], None, 0, 0, 0.0
    while (progress := (time.time() - begin) / seconds) < 1:
        before = time.time()
        scenes = ready.get()
        waited += time.time() - before
        recent.append(learner.step(generator, scenes, schedule(progress, options.rate)))
        step += 1
        if step % 20 == 0:
            torch.cuda.synchronize() if learner.cuda else None  # the host must not run far ahead of the clock
        if step == 10:
            first = torch.stack(recent).mean().item()
        if step == 200:
            now = torch.stack(recent[-20:]).mean().item()
            print(f"check: loss {first:.3f} at first, {now:.3f} after {step} steps, {time.time() - begin:.1f} s", flush=True)
            if not math.isfinite(now) or (not options.start and now > 0.9 * first):
                sys.exit("FAILED: the loss does not fall")
        now = time.time()
        if now - last_print > 20:
            mean = torch.stack(recent[1:]).mean().item()
            print(f"{now - begin:6.1f} s  step {step}  {1e3 * (now - last_print) / (step - printed_step):.1f} ms a step "
                  f"(waited for scenes {1e3 * waited / (step - printed_step):.1f})  rate {schedule(progress, options.rate):.2e}  loss {mean:.4f}", flush=True)
            last_print, printed_step, recent, waited = now, step, recent[-1:], 0.0
            if not math.isfinite(mean):
                sys.exit("FAILED: the loss is not a number")
        if now - last_save > options.save_every:
            last_save = now
            save(learner.average, options.out)
            iou = validate(learner.average, validation)
            print("    synthetic validation: person %.3f, mean %.3f" % (iou[1], iou.mean()), flush=True)
    return step


def main():
    began = time.time()
    options = parse()
    os.makedirs(options.out, exist_ok=True)
    device = torch.device(options.device)
    cuda = device.type == "cuda"
    torch.manual_seed(options.seed)
    torch.backends.cudnn.benchmark = True
    torch.backends.cudnn.benchmark_limit = 5
    torch.backends.cuda.matmul.allow_tf32 = torch.backends.cudnn.allow_tf32 = True

    validation_generator = Generator(device, options.batch, seed=10 ** 12)
    if cuda:
        check_caster(validation_generator)
    validation = [make_batch(*validation_generator.cast(*validation_generator.scene_batch())) for _ in range(options.validation)]
    check_images(validation, validation_generator.overruns, options.out)
    network = DepthNet().to(device, memory_format=torch.channels_last if cuda else torch.contiguous_format)
    if options.start:
        print("not taken over:", " ".join(take_over(network, load_checkpoint(options.start)["network"])))
    print(f"{parameters(network)} parameters; checks took {time.time() - began:.1f} s", flush=True)
    generator = Generator(device, options.batch, seed=options.seed * 10 ** 9)
    learner = Learner(network, graph=cuda and not options.eager)
    learner.warm_up(generator)
    print(f"set-up took {time.time() - began:.1f} s", flush=True)
    steps = train(learner, generator, options, validation, began)
    save(learner.average, options.out)
    iou = validate(learner.average, validation)
    print("final, on synthetic images never trained on:", " ".join(f"{c}:{i:.3f}" for c, i in zip(CLASSES, iou)), f"mean {iou.mean():.3f}")
    v = validation[0]
    best = predict(learner.average, v[0][:24]).byte()
    montage.write(os.path.join(options.out, "predictions.png"), v[3][:24].cpu().numpy(), best.cpu().numpy(), v[4][:24].cpu().numpy())
    print(f"{steps} steps, {steps * options.batch} images, {time.time() - began:.0f} s in all, {generator.overruns} scenes overran", flush=True)


if __name__ == "__main__":
    main()
