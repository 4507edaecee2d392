"""Checks of training/ that need no GPU: labels, noise of the sensor, input channels, the network's file.

Skips, with a sentence, what NumPy, OpenCV or PyTorch is missing for.
"""
import json
import pathlib
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "training"))
sys.dont_write_bytecode = True

try:
    import cv2
    import numpy as np

    import evaluate
except ImportError as missing:
    print(f"skipped: {missing.name} is not installed, so nothing of the training in Python is checked")
    sys.exit(0)
try:
    import torch

    from depthnet import learning, network, sensor
except ImportError as missing:
    torch = None
    print(f"PyTorch is not installed: only the evaluation is checked ({missing})")

VECTORS = pathlib.Path(__file__).resolve().parent / "depth_channels"


class Evaluation(unittest.TestCase):
    def test_channels_equal_the_stored_ones(self):
        camera = json.loads((VECTORS / "camera.json").read_text())
        raw = cv2.imread(str(VECTORS / "depth.png"), cv2.IMREAD_UNCHANGED)
        fx, fy, cx, cy = (camera[k] for k in ("fx", "fy", "cx", "cy"))
        channels = evaluate.input_channels(evaluate.reduce_depth(raw), fx / 2, fy / 2, (cx + 0.5) / 2 - 0.5, (cy + 0.5) / 2 - 0.5)[0]
        stored = np.fromfile(VECTORS / "channels.f32", "<f4").reshape(camera["channels"])
        np.testing.assert_allclose(channels, stored, atol=1e-6)

    def test_a_slanted_plane_has_its_normal(self):
        fx, fy, cx, cy = 260.0, 262.0, 158.0, 121.0
        normal = np.array([0.3, -0.5, -1.0]) / np.linalg.norm([0.3, -0.5, -1.0])
        x, y = np.meshgrid((np.arange(320) - cx) / fx, (np.arange(240) - cy) / fy)
        z = (-2.0 / (normal[0] * x + normal[1] * y + normal[2])).astype(np.float32)  # n.P = -2
        channels = evaluate.input_channels(z, fx, fy, cx, cy)[0]
        middle = (slice(3, -3), slice(3, -3))
        np.testing.assert_allclose(channels[2][middle], -normal[0], atol=2e-4)
        np.testing.assert_allclose(channels[3][middle], -normal[1], atol=2e-4)
        np.testing.assert_allclose(channels[0], 1 / z, rtol=1e-6)

    def test_nothing_measured_gives_nothing(self):
        z = np.full((240, 320), 1.5, np.float32)
        z[50:90, 60:120] = 0
        channels = evaluate.input_channels(z, 260, 260, 160, 120)[0]
        self.assertTrue((channels[:, 50:90, 60:120] == 0).all())
        self.assertTrue((channels[1] == (z > 0)).all())

    def test_halving_takes_the_nearest_measured_pixel(self):
        raw = np.zeros((4, 4), np.uint16)
        raw[0, 0], raw[0, 1], raw[1, 1] = 10000, 5000, 7500
        raw[2, 3] = 20000
        np.testing.assert_array_equal(evaluate.reduce_depth(raw), [[1, 0], [0, 4]])

    def test_the_network_that_ships_loads_and_names_its_classes(self):
        loaded = cv2.dnn.readNetFromONNX(str(ROOT / "share" / "networks" / "depth_hospital.onnx"))
        loaded.setInput(np.zeros((1, 6, 240, 320), np.float32))
        self.assertEqual(loaded.forward().shape, (1, len(evaluate.CLASSES), 120, 160))
        text = (ROOT / "share" / "networks" / "depth_hospital.yaml").read_text()
        names = text[text.index("[") + 1:text.index("]")].replace("\n", " ").split(",")
        self.assertEqual(["background" if n.strip() == "~" else n.strip() for n in names], evaluate.CLASSES)


@unittest.skipIf(torch is None, "PyTorch is not installed")
class Sensor(unittest.TestCase):
    def setUp(self):
        torch.manual_seed(1)

    def wall(self, distance_m, images=20):
        depth = torch.full((images, 240, 320), float(distance_m))
        nothing = torch.zeros(depth.shape, dtype=torch.uint8)
        measured, _ = sensor.measure(depth, nothing, nothing)
        return measured[:, 30:-30, 30:-30]

    def test_noise_grows_as_measured_on_a_kinect(self):
        # sigma = 0.0012 + 0.0019 (z - 0.4)^2 m, times 0.3 to 1.6 from camera to camera.
        for z in (1.0, 2.0, 3.0):
            measured = self.wall(z)
            sigma = 0.0012 + 0.0019 * (z - 0.4) ** 2
            ratios = []
            for image in measured:
                seen = image[image > 0]
                if len(seen) > 5000:
                    centre = torch.nn.functional.avg_pool2d(image[None, None], 5, 1, 2)[0, 0]  # the smooth distortion
                    whole = torch.nn.functional.avg_pool2d((image > 0).float()[None, None], 5, 1, 2)[0, 0] > 0.99
                    ratios.append((image - centre)[whole].std().item() / sigma)
            ratios = np.array(ratios)
            self.assertGreater(np.median(ratios), 0.5, f"at {z} m")
            self.assertLess(np.median(ratios), 1.6, f"at {z} m")

    def test_depth_is_unbiased(self):
        for z in (1.0, 2.0, 3.0):
            measured = self.wall(z)
            self.assertAlmostEqual(measured[measured > 0].mean().item() / z, 1, delta=0.004)

    def test_most_of_a_near_wall_is_measured_and_nothing_beyond_range(self):
        self.assertGreater((self.wall(1.5) > 0).float().mean().item(), 0.8)
        self.assertEqual((self.wall(11.0) > 0).float().mean().item(), 0)

    def test_shadows_lie_mostly_to_the_left(self):
        depth = torch.full((20, 240, 320), 3.0)
        depth[:, 60:180, 120:200] = 1.0
        nothing = torch.zeros(depth.shape, dtype=torch.uint8)
        measured, _ = sensor.measure(depth, nothing, nothing)
        left = (measured[:, 70:170, 110:118] == 0).float().mean((1, 2))
        right = (measured[:, 70:170, 202:210] == 0).float().mean((1, 2))
        self.assertGreater((left > right + 0.2).float().mean().item(), 0.5)
        self.assertLess((right > left + 0.2).float().mean().item(), 0.3)

    def test_channels_are_those_of_the_evaluation(self):
        z = torch.rand((1, 240, 320)) * 3 + 0.5
        z[:, 100:140, 50:200] = 0
        camera = (261.0, 262.0, 158.3, 120.8)
        mine = sensor.input_channels(z, *(torch.tensor(v).view(1, 1, 1) for v in camera))[0].numpy()
        np.testing.assert_allclose(mine, evaluate.input_channels(z[0].numpy(), *camera)[0], atol=1e-5)


@unittest.skipIf(torch is None, "PyTorch is not installed")
class Learning(unittest.TestCase):
    def test_half_of_the_pixels_in_each_direction_are_those_of_the_enlarged_scores(self):
        scores = torch.randn(2, 3, 6, 8)
        large = torch.nn.functional.interpolate(scores, scale_factor=2.0, mode="bilinear", align_corners=False)
        for row in (0, 1):
            for column in (0, 1):
                phase = learning.at_phase(scores, torch.tensor([row]), torch.tensor([column]))
                torch.testing.assert_close(phase, large[:, :, row::2, column::2])

    def test_every_second_takes_the_same_pixels(self):
        image = torch.arange(2 * 6 * 8).view(2, 6, 8)
        taken = learning.every_second(image, torch.tensor([1]), torch.tensor([0]))
        self.assertTrue(torch.equal(taken, image[:, 1::2, 0::2]))

    def test_right_scores_cost_less_than_wrong_ones(self):
        labels = torch.zeros((1, 240, 320), dtype=torch.int64)
        labels[:, 100:, 100:200] = 1
        weight = torch.ones(labels.shape)
        weights = torch.ones(len(network.CLASSES))
        small = labels[:, ::2, ::2]
        right = torch.nn.functional.one_hot(small, len(network.CLASSES)).permute(0, 3, 1, 2).float() * 9
        good = learning.loss_function(right, labels, weight, weights, weights).item()
        bad = learning.loss_function(-right, labels, weight, weights, weights).item()
        self.assertLess(good, 0.1)
        self.assertGreater(bad, 3)

    def test_the_network_keeps_its_shape(self):
        net = network.DepthNet().eval()
        self.assertEqual(net(torch.zeros(1, 6, 240, 320)).shape, (1, len(network.CLASSES), 120, 160))
        self.assertLess(network.parameters(net), 1.3e6)


if __name__ == "__main__":
    unittest.main()
