// An MCAP file of what prepare.py made, with messages as ROS 2 serialises them.
// usage: node mcap.mjs PREPARED_DIR OUT.mcap none|zstd|lz4|unchunked [--robot] [--float] [--no-index] [--chunk BYTES]
//        [--dump MESSAGES.json]
import { readFileSync, writeFileSync, openSync, writeSync, closeSync } from "node:fs";
import { join } from "node:path";
import { McapWriter } from "@mcap/core";
import { parse } from "@foxglove/rosmsg";
import { MessageWriter } from "@foxglove/rosmsg2-serialization";
import zstd from "@foxglove/wasm-zstd";
import lz4 from "lz4js";

const [prepared, out, packing, ...options] = process.argv.slice(2);
const has = (option) => options.includes(option);
const valueOf = (option, otherwise) => (has(option) ? options[options.indexOf(option) + 1] : otherwise);
const about = JSON.parse(readFileSync(join(prepared, "frames.json"), "utf8"));
const COLOR = "camera_color_optical_frame";

const HEADER = `
================================================================================
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
================================================================================
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec`;
const GEOMETRY = `
================================================================================
MSG: geometry_msgs/Vector3
float64 x
float64 y
float64 z
================================================================================
MSG: geometry_msgs/Point
float64 x
float64 y
float64 z
================================================================================
MSG: geometry_msgs/Quaternion
float64 x
float64 y
float64 z
float64 w
================================================================================
MSG: geometry_msgs/Transform
geometry_msgs/Vector3 translation
geometry_msgs/Quaternion rotation
================================================================================
MSG: geometry_msgs/TransformStamped
std_msgs/Header header
string child_frame_id
geometry_msgs/Transform transform
================================================================================
MSG: geometry_msgs/Pose
geometry_msgs/Point position
geometry_msgs/Quaternion orientation
================================================================================
MSG: geometry_msgs/PoseWithCovariance
geometry_msgs/Pose pose
float64[36] covariance
================================================================================
MSG: geometry_msgs/Twist
geometry_msgs/Vector3 linear
geometry_msgs/Vector3 angular
================================================================================
MSG: geometry_msgs/TwistWithCovariance
geometry_msgs/Twist twist
float64[36] covariance`;
const DEFINITIONS = {
  "sensor_msgs/msg/Image": `std_msgs/Header header
uint32 height
uint32 width
string encoding
uint8 is_bigendian
uint32 step
uint8[] data${HEADER}`,
  "sensor_msgs/msg/CameraInfo": `std_msgs/Header header
uint32 height
uint32 width
string distortion_model
float64[] d
float64[9] k
float64[9] r
float64[12] p
uint32 binning_x
uint32 binning_y
sensor_msgs/RegionOfInterest roi${HEADER}
================================================================================
MSG: sensor_msgs/RegionOfInterest
uint32 x_offset
uint32 y_offset
uint32 height
uint32 width
bool do_rectify`,
  "sensor_msgs/msg/Imu": `std_msgs/Header header
geometry_msgs/Quaternion orientation
float64[9] orientation_covariance
geometry_msgs/Vector3 angular_velocity
float64[9] angular_velocity_covariance
geometry_msgs/Vector3 linear_acceleration
float64[9] linear_acceleration_covariance${HEADER}${GEOMETRY}`,
  "nav_msgs/msg/Odometry": `std_msgs/Header header
string child_frame_id
geometry_msgs/PoseWithCovariance pose
geometry_msgs/TwistWithCovariance twist${HEADER}${GEOMETRY}`,
  "tf2_msgs/msg/TFMessage": `geometry_msgs/TransformStamped[] transforms${HEADER}${GEOMETRY}`,
};
const writers = Object.fromEntries(
  Object.entries(DEFINITIONS).map(([type, text]) => [type, new MessageWriter(parse(text, { ros2: true }))]),
);

class File {
  constructor(path) { this.fd = openSync(path, "w"); this.at = 0n; }
  async write(bytes) { writeSync(this.fd, bytes); this.at += BigInt(bytes.length); }
  position() { return this.at; }
}

await zstd.isLoaded;
const packers = {
  zstd: (data) => ({ compression: "zstd", compressedData: zstd.compress(data, 3) }),
  lz4: (data) => ({ compression: "lz4", compressedData: lz4.compress(data) }),
};
const file = new File(out);
const bag = new McapWriter({
  writable: file,
  useChunks: packing !== "unchunked",
  chunkSize: Number(valueOf("--chunk", 1024 * 1024)),
  useMessageIndex: !has("--no-index"),
  useChunkIndex: !has("--no-index"),
  useSummaryOffsets: !has("--no-index"),
  repeatChannels: !has("--no-index"),
  repeatSchemas: !has("--no-index"),
  compressChunk: packers[packing],
});
await bag.start({ profile: "ros2", library: "make_data" });

const channels = new Map();
const dumped = [];
async function write(topic, type, message, ns) {
  if (!channels.has(topic)) {
    const schemaId = await bag.registerSchema({
      name: type, encoding: "ros2msg", data: new TextEncoder().encode(DEFINITIONS[type]) });
    channels.set(topic, await bag.registerChannel({ topic, schemaId, messageEncoding: "cdr", metadata: new Map() }));
  }
  const data = writers[type].writeMessage(message);
  dumped.push({ topic, type, ns: String(ns), data: Buffer.from(data).toString("base64") });
  await bag.addMessage({ channelId: channels.get(topic), sequence: 0, logTime: ns, publishTime: ns, data });
}

const header = (ns, frame_id) => ({
  stamp: { sec: Number(ns / 1000000000n), nanosec: Number(ns % 1000000000n) }, frame_id });
const xyz = (x, y, z) => ({ x, y, z });
const xyzw = (x, y, z, w) => ({ x, y, z, w });
const transform = (parent, child_frame_id, translation, rotation) => ({
  header: header(0n, parent), child_frame_id, transform: { translation, rotation } });

/** Depth in millimetres as float metres. */
function inMetres(mm) {
  const units = new Uint16Array(mm.buffer, mm.byteOffset, mm.length / 2);
  const metres = Float32Array.from(units, (value) => (value === 0 ? NaN : value / 1000));
  return new Uint8Array(metres.buffer);
}

for (const [i, frame] of about.frames.entries()) {
  const ns = BigInt(frame.stamp_ns);
  if (i === 0 && has("--robot")) {
    await write("/tf_static", "tf2_msgs/msg/TFMessage", { transforms: [
      transform("base_link", "camera_link", xyz(0.25, 0, 1.5), xyzw(0, 0, 0, 1)),
      transform("camera_link", COLOR, xyz(0, 0, 0), xyzw(-0.5, 0.5, -0.5, 0.5))] }, ns);
  }
  const k = about.k;
  await write("/camera/color/camera_info", "sensor_msgs/msg/CameraInfo", {
    header: header(ns, COLOR), height: about.height, width: about.width, distortion_model: "plumb_bob",
    d: [0, 0, 0, 0, 0], k, r: [1, 0, 0, 0, 1, 0, 0, 0, 1], p: [k[0], 0, k[2], 0, 0, k[4], k[5], 0, 0, 0, 1, 0],
    binning_x: 0, binning_y: 0, roi: { x_offset: 0, y_offset: 0, height: 0, width: 0, do_rectify: false } }, ns);
  const image = (encoding, bytes_per_pixel, data) => ({
    header: header(ns, COLOR), height: about.height, width: about.width, encoding, is_bigendian: 0,
    step: bytes_per_pixel * about.width, data });
  await write("/camera/color/image_raw", "sensor_msgs/msg/Image",
    image("rgb8", 3, new Uint8Array(readFileSync(join(prepared, frame.color)))), ns);
  const mm = new Uint8Array(readFileSync(join(prepared, frame.depth)));
  await write("/camera/aligned_depth_to_color/image_raw", "sensor_msgs/msg/Image",
    has("--float") ? image("32FC1", 4, inMetres(mm)) : image("16UC1", 2, mm), ns);
  if (!has("--robot")) continue;
  await write("/odom", "nav_msgs/msg/Odometry", {
    header: header(ns, "odom"), child_frame_id: "base_link",
    pose: { pose: { position: xyz(0.5 * i, 0, 0), orientation: xyzw(0, 0, 0.6, 0.8) }, covariance: Array(36).fill(0) },
    twist: { twist: { linear: xyz(0.25, 0, 0), angular: xyz(0, 0, -0.125) }, covariance: Array(36).fill(0) } }, ns);
  await write("/imu", "sensor_msgs/msg/Imu", {
    header: header(ns, "imu_link"), orientation: xyzw(0, 0, 0, 1), orientation_covariance: [-1, 0, 0, 0, 0, 0, 0, 0, 0],
    angular_velocity: xyz(0, 0.5, 0), angular_velocity_covariance: Array(9).fill(0),
    linear_acceleration: xyz(0, 0, 9.75), linear_acceleration_covariance: Array(9).fill(0) }, ns);
}
await bag.end();
closeSync(file.fd);
if (has("--dump")) writeFileSync(valueOf("--dump"), JSON.stringify(dumped));
