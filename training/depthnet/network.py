"""The network: a small U-shaped encoder-decoder of depthwise-separable blocks, one depth image in, one class map out.

Input  [N, 6, 240, 320], the channels of sensor.input_channels().
Output [N, classes, 120, 160], scores at half resolution; resample them linearly before the best class is chosen.

Only operations that OpenCV 4.6 loads from ONNX are used: Conv, ReLU, Add, Concat, Resize.  Batch normalisation is folded
into the convolutions on export.
"""
import torch
from torch import nn
import torch.nn.functional as functional

CLASSES = ["background", "person", "chair", "couch", "bed", "dining table", "wheelchair", "trolley", "iv_stand",
           "bedside_cabinet", "curtain", "storage_rack", "trash_bin", "potted plant", "sink", "toilet", "stretcher",
           "bench"]
# Ids of the project: COCO index + 1, and config/labels/hospital.yaml.
PROJECT_IDS = [0, 1, 57, 58, 60, 61, 105, 102, 103, 104, 101, 114, 106, 59, 72, 62, 126, 14]
INPUT_CHANNELS = 6
HEIGHT, WIDTH = 240, 320  # of the input


def convolution(channels_in, channels_out, kernel=3, stride=1, groups=1, activation=True):
    """Convolution, batch normalisation and (optionally) ReLU."""
    layers = [nn.Conv2d(channels_in, channels_out, kernel, stride, kernel // 2, groups=groups, bias=False),
              nn.BatchNorm2d(channels_out)]
    return nn.Sequential(*layers, *([nn.ReLU(inplace=True)] if activation else []))


class InvertedResidual(nn.Module):
    """Expand by 1x1, filter depthwise, project by 1x1; residual where shapes allow (MobileNetV2)."""

    def __init__(self, channels_in, channels_out, expansion, kernel=3, stride=1):
        super().__init__()
        hidden = int(channels_in * expansion)
        self.residual = stride == 1 and channels_in == channels_out
        self.body = nn.Sequential(convolution(channels_in, hidden, 1),
                                  convolution(hidden, hidden, kernel, stride, groups=hidden),
                                  convolution(hidden, channels_out, 1, activation=False))

    def forward(self, x):
        return x + self.body(x) if self.residual else self.body(x)


class SeparableResidual(nn.Module):
    """Depthwise 3x3, then 1x1, with a shortcut: what little may be spent at 120 x 160."""

    def __init__(self, channels):
        super().__init__()
        self.body = nn.Sequential(convolution(channels, channels, groups=channels),
                                  convolution(channels, channels, 1, activation=False))

    def forward(self, x):
        return functional.relu(x + self.body(x))


class UpAndMerge(nn.Module):
    """Brings x to the size of `skip`, adds what the encoder saw there, filters."""

    def __init__(self, channels_in, channels_skip, channels_out, blocks):
        super().__init__()
        self.reduce = convolution(channels_in, channels_out, 1, activation=False)
        self.skip = convolution(channels_skip, channels_out, 1, activation=False)
        self.blocks = blocks

    def forward(self, x, skip):
        x = functional.interpolate(self.reduce(x), size=skip.shape[2:], mode="bilinear", align_corners=False)
        return self.blocks(functional.relu(x + self.skip(skip)))


class DepthNet(nn.Module):
    """See above. Plain convolutions in front, where images are large: expanding there would cost a third of the time."""

    def __init__(self, classes=len(CLASSES), widths=(16, 32, 64, 128, 192), depths=(2, 3, 4, 4)):
        super().__init__()
        w = widths
        self.stem = convolution(INPUT_CHANNELS, w[0], 3, 2)                                    # 120 x 160
        self.at2 = nn.Sequential(convolution(w[0], w[0]))
        self.at4 = nn.Sequential(convolution(w[0], w[1], 3, 2), *self.filters(w[1], depths[0] - 1, 4))  # 60 x 80
        self.at8 = self.stage(w[1], w[2], depths[1], 3)                                        # 30 x 40
        self.at16 = self.stage(w[2], w[3], depths[2], 3)                                       # 15 x 20
        self.at32 = self.stage(w[3], w[4], depths[3], 2)                                       # 8 x 10
        self.up16 = UpAndMerge(w[4], w[3], w[3], self.filters(w[3], 1, 2))
        self.up8 = UpAndMerge(w[3], w[2], w[2], self.filters(w[2], 2, 2))
        self.up4 = UpAndMerge(w[2], w[1], 48, self.filters(48, 1, 2))
        self.up2 = UpAndMerge(48, w[0], 24, SeparableResidual(24))
        self.scores = nn.Conv2d(24, classes, 1)

    @staticmethod
    def filters(channels, count, expansion):
        return nn.Sequential(*[InvertedResidual(channels, channels, expansion) for _ in range(count)])

    @staticmethod
    def stage(channels_in, channels_out, depth, expansion):
        return nn.Sequential(InvertedResidual(channels_in, channels_out, 4, 3, 2), *DepthNet.filters(channels_out, depth - 1, expansion))

    def forward(self, x):
        with torch.autocast(x.device.type, enabled=False):  # half precision would round depth to centimetres
            half = self.stem(x.float())
        half = self.at2(half)
        quarter = self.at4(half)
        eighth = self.at8(quarter)
        sixteenth = self.at16(eighth)
        y = self.up16(self.at32(sixteenth), sixteenth)  # 8 rows become 15
        y = self.up8(y, eighth)
        y = self.up4(y, quarter)
        return self.scores(self.up2(y, half))


def export_onnx(network, path):
    """Writes the network for OpenCV 4.6: opset 12, input fixed to 1 x 6 x 240 x 320, float32."""
    import copy
    network = copy.deepcopy(network).float().cpu().eval()
    example = torch.zeros(1, INPUT_CHANNELS, 240, 320)
    arguments = dict(opset_version=12, input_names=["depth_channels"], output_names=["scores"], do_constant_folding=True)
    try:
        torch.onnx.export(network, example, path, dynamo=False, **arguments)      # newer PyTorch: the old exporter
    except TypeError:
        torch.onnx.export(network, example, path, **arguments)


def parameters(network):
    return sum(p.numel() for p in network.parameters())
