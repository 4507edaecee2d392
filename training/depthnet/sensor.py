"""What a structured-light or stereo depth camera makes of a true depth image, and the input channels of the network.

All functions work on batches [N, 240, 320] on any device.  Image coordinates are those of 320 x 240; focal lengths and
the baseline are given for 640 x 480 and halved here.
"""
import math

import torch
import torch.nn.functional as functional

DISPARITY_M_PX = 39.0        # focal length x baseline at 640 px width (Kinect: 580 px x 0.075 m, minus its internal scale)


def _uniform(n, low, high, device):
    return torch.empty((n, 1, 1), device=device).uniform_(low, high)


def _chance(n, p, device):
    return torch.rand((n, 1, 1), device=device) < p


def _smooth_noise(shape, device, cells):
    """Normal noise, smooth over image / cells pixels, about unit variance."""
    coarse = torch.randn((shape[0], 1, cells * 3 // 4 + 1, cells + 1), device=device)
    return functional.interpolate(coarse, size=shape[1:], mode="bicubic", align_corners=True)[:, 0] * 1.25


def _neighbours(image, size, smallest):
    """Smallest or largest value in a size x size neighbourhood."""
    x = image[:, None]
    pooled = -functional.max_pool2d(-x, size, 1, size // 2) if smallest else functional.max_pool2d(x, size, 1, size // 2)
    return pooled[:, 0, :image.shape[1], :image.shape[2]]


def _shift(image, columns, rows):
    """Moves the image right and down by whole pixels, repeating the border."""
    height, width = image.shape[1:]
    padded = functional.pad(image[:, None].float(), (columns, 0, rows, 0), mode="replicate")[:, 0]
    return padded[:, :height, :width].to(image.dtype)


def _depth_jump(z):
    """True where the depth jumps; slanted planes, along which inverse depth is linear, do not."""
    w = functional.pad((1 / z)[:, None], (1, 1, 1, 1), mode="replicate")[:, 0]
    centre = w[:, 1:-1, 1:-1]
    bend = torch.maximum((w[:, 1:-1, :-2] + w[:, 1:-1, 2:] - 2 * centre).abs(), (w[:, :-2, 1:-1] + w[:, 2:, 1:-1] - 2 * centre).abs())
    return bend * z * z > 0.03 + 0.02 * z


def measure(depth, labels, material):
    """Depth as a sensor reports it: 0 = no measurement.  `labels` [N, H, W] (uint8) are returned, possibly thickened."""
    n, height, width = depth.shape
    device = depth.device
    truth = torch.where(depth > 0, depth, torch.full_like(depth, 30.0))

    # Cameras that are read at 640 x 480 and reduced by the nearest of four see thin things thicker.
    thicken = _chance(n, 0.5, device)
    nearest = truth
    chosen = labels
    for columns, rows in ((1, 0), (0, 1), (1, 1)):
        moved = _shift(truth, columns, rows)
        closer = (moved < nearest - 0.03) & thicken & (torch.rand_like(truth) < 0.5)
        nearest = torch.where(closer, moved, nearest)
        chosen = torch.where(closer, _shift(labels, columns, rows), chosen)
    truth, labels = nearest, chosen
    z = truth

    clean = _chance(n, 0.04, device)                   # some images come almost without faults
    valid = torch.ones_like(z, dtype=torch.bool)

    # Thin things (legs of chairs, tubes, spokes) are lost, the more the farther away: nothing, or what is behind them.
    behind = _neighbours(_neighbours(truth, 5, False), 5, True)
    thin = (behind - truth > 0.06 * truth) & (truth > _uniform(n, 1.0, 4.0, device)) & _chance(n, 0.4, device)
    lost = thin & (_smooth_noise(z.shape, device, 60) > _uniform(n, -1.5, 1.0, device))
    through = lost & _chance(n, 0.5, device)
    z = torch.where(through, behind, z)
    valid &= ~lost | through

    # Folds of cloth, on people, beds and curtains.
    soft_surface = (labels == 1) | (labels == 4) | (labels == 10) | (labels == 16)
    folds = _smooth_noise(z.shape, device, 50) * 0.6 + _smooth_noise(z.shape, device, 22) * 0.8
    z = z + torch.where(soft_surface, folds * _uniform(n, 0, 0.011, device), torch.zeros_like(z))

    # Edges: where the depth jumps.
    jump = _depth_jump(z)
    wide = functional.max_pool2d(jump[:, None].float(), 3, 1, 1)[:, 0] > 0
    edge_loss = _uniform(n, 0.0, 1.0, device) ** 0.6
    noisy = torch.rand_like(z)
    valid &= ~(jump & (noisy < edge_loss) & _chance(n, 0.8, device))
    valid &= ~(wide & (torch.rand_like(z) < edge_loss * 0.35) & _chance(n, 0.6, device))
    # Ragged outlines: the sensor's matching window moves edges by a pixel or two.
    ragged = _chance(n, 0.6, device)
    dx, dy = (_smooth_noise(z.shape, device, 100) * _uniform(n, 0.2, 0.9, device) for _ in range(2))
    rows = torch.arange(height, device=device).view(1, -1, 1)
    columns = torch.arange(width, device=device).view(1, 1, -1)
    source = ((rows + dy.round()).clamp(0, height - 1) * width + (columns + dx.round()).clamp(0, width - 1)).long()
    z = torch.where(ragged, z.flatten(1).gather(1, source.flatten(1)).view_as(z), z)

    # Shadow of the projector: beside near silhouettes, as wide as the difference of disparities.
    strength = DISPARITY_M_PX * 0.5 * _uniform(n, 0.6, 1.3, device)
    disparity = strength / z
    u = columns.float()
    to_right = (disparity - u).flip(2).cummax(2).values.flip(2)         # near things to the right throw it to the left
    to_left = (disparity + u).cummax(2).values
    right = _chance(n, 0.85, device)                   # Kinect and its kin: the projector is to the right
    hidden = torch.where(right, to_right - (disparity - u), to_left - (disparity + u)) > _uniform(n, 0.6, 2.0, device)
    valid &= ~(hidden & _chance(n, 0.85, device))

    # Noise: grows with the square of the distance, correlated over one to two pixels.
    sigma = (0.0012 + 0.0019 * (z - 0.4) ** 2) * _uniform(n, 0.3, 1.6, device)
    white = torch.randn_like(z)
    soft = functional.avg_pool2d(white[:, None], 3, 1, 1, count_include_pad=False)[:, 0] * 3
    mix = _uniform(n, 0, 1, device)
    noise = (mix * soft + (1 - mix) * white) / torch.sqrt(mix ** 2 + (1 - mix) ** 2 + 0.67 * mix * (1 - mix))
    z = z + sigma * noise
    z = z * (1 + _smooth_noise(z.shape, device, 6) * _uniform(n, 0, 0.006, device))      # distortion of the depth camera

    # Flying pixels: between fore- and background.
    flying = jump & (torch.rand_like(z) < _uniform(n, 0, 0.5, device)) & _chance(n, 0.3, device)
    low, high = _neighbours(truth, 3, True), _neighbours(truth, 3, False).clamp(max=9)
    z = torch.where(flying, low + (high - low).clamp(min=0) * torch.rand_like(z), z)

    # Disparity in steps of an eighth of a pixel of the 640 px image.
    step = torch.where(_chance(n, 0.75, device), _uniform(n, 0.08, 0.16, device), _uniform(n, 0.002, 0.01, device))
    quantised = DISPARITY_M_PX / ((DISPARITY_M_PX / z.clamp(min=0.2) / step).round().clamp(min=1) * step)
    z = quantised

    # Materials that send little back, surfaces seen at a flat angle, far and random blotches.
    share = material.float() / 255
    blotch = _smooth_noise(z.shape, device, 40) * 0.6 + _smooth_noise(z.shape, device, 100) * 0.5 + 0.25 * white
    threshold = torch.erfinv((2 * share - 1).clamp(-0.999, 0.999)) * math.sqrt(2)
    valid &= ~((share > 0.01) & (blotch * 1.25 < threshold))
    slope = (_neighbours(truth, 3, False) - _neighbours(truth, 3, True)) / truth
    valid &= ~((slope * 160 > _uniform(n, 3, 14, device) * (1 + 0.4 * white)) & _chance(n, 0.25, device) & ~jump)
    far_loss = ((truth - 4) / 4).clamp(0, 1) * _uniform(n, -0.3, 1, device).clamp(min=0)
    valid &= ~(blotch < _uniform(n, -4.5, -2.3, device) + 2.8 * far_loss)
    scale = _smooth_noise(z.shape, device, 12)
    valid &= ~((scale + 0.4 * blotch > _uniform(n, 1.6, 3.2, device)) & _chance(n, 0.4, device))
    valid &= ~((torch.rand_like(z) < _uniform(n, 0, 0.02, device)) & _chance(n, 0.25, device))

    # Large holes: dark cloth, glare, sunlight.
    holes = _smooth_noise(z.shape, device, 5) + 0.5 * _smooth_noise(z.shape, device, 16) + 0.15 * blotch
    valid &= ~((holes > _uniform(n, 1.2, 2.4, device)) & (truth < _uniform(n, 0.8, 6.0, device)) & _chance(n, 0.25, device))

    # Range, and the border that registration to the colour camera leaves empty.
    nearest_m = torch.where(_chance(n, 0.6, device), _uniform(n, 0.38, 0.55, device), _uniform(n, 0.15, 0.4, device))
    # In some images a part of what is close lies before the nearest depth, as where somebody bends over the camera.
    order = truth[:, 8::16, 8::16].flatten(1).sort(1).values
    share = torch.rand((n, 1), device=device) * 0.35
    closest = order.gather(1, (share * order.shape[1]).long())[:, :, None]
    nearest_m = torch.where(_chance(n, 0.25, device) & (closest < 0.85), torch.maximum(nearest_m, closest), nearest_m)
    farthest_m = torch.where(_chance(n, 0.5, device), _uniform(n, 6.5, 10, device), _uniform(n, 3.5, 7, device))
    registered = _chance(n, 0.45, device)
    border = [torch.where(registered, _uniform(n, 0, m, device), torch.zeros((n, 1, 1), device=device)) for m in (12, 20, 10, 10)]
    tilt = _uniform(n, -0.015, 0.015, device)
    inside = (u + tilt * rows >= border[0]) & (u + tilt * rows < width - border[1])
    inside &= (rows + tilt * u >= border[2]) & (rows + tilt * u < height - border[3])
    valid |= clean
    valid &= ((truth < farthest_m) & (z < 9.9) & (z > nearest_m) & (truth < 29)) & (inside | clean)

    # Misregistration of depth and labels by a pixel.
    measured = torch.where(valid, z, torch.zeros_like(z))
    return measured, labels


def input_channels(depth, fx, fy, cx, cy):
    """The six channels of the network from a depth image [N, 240, 320] in metres (0 = no measurement).

    fx, fy, cx, cy: tensors [N, 1, 1], pinhole camera of the 320 x 240 image, in pixels.
    With w = 1/z, x = (u - cx)/fx, y = (v - cy)/fy, all zero where nothing was measured:
      0  w, inverse depth, 1/m
      1  1 where measured
      2, 3  x and y components of the unit normal of the surface, towards the camera, from differences of w
      4, 5  X = x z / 3 and Y = y z / 3: metres to the right of and below the optical axis, over 3, cut to +-1.5
    """
    height, width = depth.shape[1:]
    valid = depth > 0
    w = torch.where(valid, 1 / depth.clamp(min=0.05), torch.zeros_like(depth))
    u = torch.arange(width, device=depth.device).view(1, 1, -1)
    v = torch.arange(height, device=depth.device).view(1, -1, 1)
    x, y = (u - cx) / fx, (v - cy) / fy

    def slope(horizontal):
        """Difference of the mean w of two 2 x 5 (5 x 2) blocks on both sides, per pixel."""
        kernel = torch.zeros((1, 1, 5, 5), device=depth.device)
        sign = []
        for columns in (slice(0, 2), slice(3, 5)):
            k = kernel.clone()
            if horizontal:
                k[:, :, :, columns] = 1
            else:
                k[:, :, columns, :] = 1
            count = functional.conv2d(valid[:, None].float(), k, padding=2)[:, 0]
            total = functional.conv2d(w[:, None], k, padding=2)[:, 0]
            sign.append((total / count.clamp(min=1), count >= 3))
        (before, has_before), (after, has_after) = sign
        return torch.where(has_before & has_after, (after - before) / 3, torch.zeros_like(w))

    # Plane n.P = d: w = (nx x + ny y + nz) / d, so the gradient of w over (x, y) gives the normal.
    a, b = slope(True) * fx, slope(False) * fy
    c = w - x * a - y * b
    norm = torch.sqrt(a * a + b * b + c * c).clamp(min=1e-6)
    zero = torch.zeros_like(w)
    z = torch.where(valid, depth, zero)
    channels = [w, valid.float(), a / norm, b / norm, (x * z / 3).clamp(-1.5, 1.5), (y * z / 3).clamp(-1.5, 1.5)]
    return torch.stack([torch.where(valid, k, zero) for k in channels], 1)


def halved_intrinsics(cameras):
    """fx, fy, cx, cy of the 320 x 240 image from the generator's cameras (640 x 480)."""
    fx, fy, cx, cy = (cameras[:, k].view(-1, 1, 1) for k in (12, 13, 14, 15))
    return fx / 2, fy / 2, (cx + 0.5) / 2 - 0.5, (cy + 0.5) / 2 - 0.5
