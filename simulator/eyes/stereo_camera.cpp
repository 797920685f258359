// When pairs are taken, what becomes of them, and when they come.
#include "gaitway/simulator/stereo_camera.hpp"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <exception>
#include <optional>
#include <stdexcept>

#include "camera_faults.hpp"
#include "camera_mismatch.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/facts/random_stream.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "image_sensor.hpp"
#include "scene_view.hpp"
#include "shutter.hpp"

namespace gaitway::simulator {
namespace {

using urdf::Side;

constexpr std::uint64_t kNoiseStream = 0x6361'6D65'7261'0001ULL, kLossStream = 0x6361'6D65'7261'0003ULL;
// A drawing has so many pixels for one of the picture, in its middle: fine texture of a small picture.
constexpr double kOversampling = 1.5, kLargeOversampling = 1.0;

std::int64_t nanoseconds_of(double seconds) {
  return static_cast<std::int64_t>(std::llround(seconds * static_cast<double>(facts::kSecond_ns)));
}

template <class Message>
void fill(const PicturePair& pair, Message& message) {
  message.stamp_ns = pair.stamp_ns;
  message.number = pair.number;
  message.width = static_cast<std::uint32_t>(pair.width_px);
  message.height = static_cast<std::uint32_t>(pair.height_px);
  message.exposure_ns = pair.exposure_ns;
  message.readout_ns = pair.readout_ns;
  std::ranges::copy(pair.grey[0], message.left);
  std::ranges::copy(pair.grey[1], message.right);
}

// The topic of the camera's size.
class PictureWriter {
 public:
  PictureWriter(msgclient::Client& client, bool large) {
    if (large) {
      large_.emplace(client.write<StereoPicturesLarge>("stereo_pictures_large"));
    } else {
      small_.emplace(client.write<StereoPictures>("stereo_pictures"));
    }
  }
  void publish(const PicturePair& pair, std::int64_t now_ns) {
    if (large_) {
      publish(pair, now_ns, *large_, large_message_);
    } else {
      publish(pair, now_ns, *small_, small_message_);
    }
  }
  [[nodiscard]] std::string_view topic() const noexcept {
    return large_ ? "stereo_pictures_large" : "stereo_pictures";
  }

 private:
  template <class Message>
  static void publish(const PicturePair& pair, std::int64_t now_ns, msgclient::Writer<Message>& writer,
                      std::unique_ptr<Message>& message) {
    if (!message) message = std::make_unique<Message>();
    fill(pair, *message);
    writer.publish(*message, now_ns);
  }
  std::optional<msgclient::Writer<StereoPictures>> small_;
  std::optional<msgclient::Writer<StereoPicturesLarge>> large_;
  std::unique_ptr<StereoPictures> small_message_;
  std::unique_ptr<StereoPicturesLarge> large_message_;
};

// One of the two.
struct Eye {
  Eye(const urdf::LensParameters& lens, const urdf::StereoCamera& camera, const StereoCameraOptions& options,
      std::uint64_t seed, Side side)
      : shutter(urdf::Lens(lens), camera.width_px, camera.height_px,
                camera.is_large() ? kLargeOversampling : kOversampling),
        control(options, camera.exposure_s),
        noise(seed, kNoiseStream + urdf::index_of(side)) {}

  Shutter shutter;
  ExposureControl control;
  facts::RandomStream noise;
  std::vector<float> light;
  std::vector<std::uint8_t> last;  // what it told last
};

}  // namespace

struct StereoCamera::Implementation {
  Implementation(msgclient::Client& client, const urdf::RobotModel& robot, const urdf::StereoCamera& file,
                 const StereoCameraOptions& how, const PlantOptions& plant)
      : camera(file),
        options(how),
        link(link_index(robot, file.link)),
        seed(plant.seed),
        period_ns(nanoseconds_of(1.0 / file.rate_hz)),
        window_ns(nanoseconds_of(file.exposure_s + file.readout_s)),
        truth(draw_camera_mismatch(file, plant.seed, plant.mismatch)),
        losses(plant.seed, kLossStream),
        writer(client, file.is_large()) {
    require_room_for_mismatch(file, robot.directory / "camera.yaml", plant.mismatch);
  }

  static int link_index(const urdf::RobotModel& robot, const std::string& name) {
    const auto found = std::ranges::find(robot.links, name, &urdf::Link::name);
    if (found == robot.links.end()) {
      throw urdf::RobotError("the camera's link '" + name + "' is none of the robot's");
    }
    return static_cast<int>(found - robot.links.begin());
  }
  void begin_pair(std::int64_t now_ns, std::int64_t start_ns);
  void note_instant(std::int64_t now_ns, const Plant& plant);
  void finish_pair(const Plant& plant);
  void take(Side side, const ShutterTimes& times, PicturePair& pair);
  void require_view(const Plant& plant);
  void publish_due(std::int64_t now_ns);

  urdf::StereoCamera camera;
  StereoCameraOptions options;
  int link;
  std::uint64_t seed;
  std::int64_t period_ns, window_ns;
  CameraMismatch truth;
  facts::RandomStream losses;
  PictureWriter writer;
  CameraFaults faults;
  std::vector<Eye> eyes;  // [Side]; none before the first pair
  std::optional<SceneView> view;
  std::string failure;

  std::uint64_t taken = 0;
  std::optional<std::int64_t> start_ns;  // of the pair that is being taken
  std::vector<PictureInstant> instants;  // of it
  std::size_t instant_count = 0;         // those that are valid
  std::int64_t later_ns = 0;             // of it
  struct Waiting {
    PicturePair pair;
    std::int64_t due_ns = 0;
  };
  std::deque<Waiting> waiting;
  PicturePair newest;
};

// Drawn and looked at in every pair, so that a fault changes nothing but what it says.
void StereoCamera::Implementation::begin_pair(std::int64_t now_ns, std::int64_t begins_ns) {
  ++taken;
  faults.at(now_ns);
  const bool lost = losses.uniform() < std::max(options.lost_share, faults.dropped_share());
  later_ns = faults.later_ns();
  instant_count = 0;
  if (!lost) start_ns = begins_ns;
}

void StereoCamera::Implementation::require_view(const Plant& plant) {
  if (view && !view->is_of(plant)) view.reset();  // its world has changed
  if (eyes.empty()) {
    for (const Side side : urdf::kSides) {
      eyes.emplace_back(truth.lens[urdf::index_of(side)], camera, options, seed, side);
    }
  }
  if (!view) {
    view.emplace(
        plant, link,
        SceneLook{.shadow_px = options.shadow_px,
                  .widest_px = std::max(eyes[0].shutter.widest_px(), eyes[1].shutter.widest_px()),
                  .highest_px = std::max(eyes[0].shutter.highest_px(), eyes[1].shutter.highest_px())});
  }
}

void StereoCamera::Implementation::note_instant(std::int64_t now_ns, const Plant& plant) {
  require_view(plant);
  if (instant_count == instants.size()) instants.emplace_back();
  PictureInstant& instant = instants[instant_count++];
  instant.at_ns = now_ns;
  instant.positions.assign(plant.positions().begin(), plant.positions().end());
  instant.link = view->link_pose(instant.positions, link);
}

void StereoCamera::Implementation::take(Side side, const ShutterTimes& times, PicturePair& pair) {
  Eye& eye = eyes[urdf::index_of(side)];
  std::vector<std::uint8_t>& grey = pair.grey[urdf::index_of(side)];
  grey.resize(static_cast<std::size_t>(camera.width_px) * static_cast<std::size_t>(camera.height_px));
  if (faults.dead(side)) {
    std::ranges::fill(grey, std::uint8_t{0});
  } else if (faults.frozen(side) && !eye.last.empty()) {
    grey = eye.last;
  } else {
    Eigen::Isometry3d in_link = truth.in_link[urdf::index_of(side)];
    in_link.rotate(faults.turn(side));
    ShutterTimes own = times;
    own.exposure_s = eye.control.exposure().time_s;
    eye.shutter.take({instants.data(), instant_count}, own, in_link, *view, eye.light);
    const auto share = static_cast<float>(faults.light(side));
    if (share != 1.0F) {
      for (float& light : eye.light) light *= share;
    }
    pair.exposure_ns = std::max(pair.exposure_ns, nanoseconds_of(own.exposure_s));
    expose(eye.light, eye.control.exposure(), camera.exposure_s, eye.noise, grey);
    eye.control.look(grey);
  }
  eye.last = grey;
}

void StereoCamera::Implementation::finish_pair(const Plant& plant) {
  require_view(plant);
  PicturePair pair{.stamp_ns = *start_ns + window_ns / 2,
                   .number = taken,
                   .width_px = camera.width_px,
                   .height_px = camera.height_px,
                   .readout_ns = nanoseconds_of(camera.readout_s),
                   .grey = {}};
  const ShutterTimes times{.middle_ns = pair.stamp_ns, .exposure_s = 0.0, .readout_s = camera.readout_s};
  for (const Side side : urdf::kSides) take(side, times, pair);
  if (faults.exchanged()) std::swap(pair.grey[0], pair.grey[1]);
  const std::int64_t due_ns = pair.stamp_ns + nanoseconds_of(camera.latency_s) + later_ns;
  waiting.push_back({std::move(pair), due_ns});
  start_ns.reset();
  instant_count = 0;
}

void StereoCamera::Implementation::publish_due(std::int64_t now_ns) {
  while (!waiting.empty() && now_ns >= waiting.front().due_ns) {
    newest = std::move(waiting.front().pair);
    waiting.pop_front();
    writer.publish(newest, now_ns);
  }
}

StereoCamera::StereoCamera(msgclient::Client& client, const urdf::RobotModel& robot,
                           const urdf::StereoCamera& camera, const StereoCameraOptions& options,
                           const PlantOptions& plant)
    : implementation_(std::make_unique<Implementation>(client, robot, camera, options, plant)) {}
StereoCamera::~StereoCamera() = default;

void StereoCamera::step(std::int64_t now_ns, const Plant& plant, bool wanted) {
  Implementation& self = *implementation_;
  const std::int64_t next_ns = (now_ns + self.period_ns - 1) / self.period_ns * self.period_ns;
  const bool begins = next_ns < now_ns + facts::kMillisecond_ns;
  try {
    if (begins && self.failure.empty() && (wanted || self.options.always)) self.begin_pair(now_ns, next_ns);
    // Whose world changes while it is taken is lost.
    if (self.start_ns && self.instant_count > 0 && !self.view->is_of(plant)) self.start_ns.reset();
    if (self.start_ns) {
      self.note_instant(now_ns, plant);
      if (now_ns >= *self.start_ns + self.window_ns) self.finish_pair(plant);
    }
  } catch (const std::exception& error) {
    self.failure = error.what();
    self.start_ns.reset();
    self.instant_count = 0;
  }
  self.publish_due(now_ns);
}

void StereoCamera::begin(const CameraFault& fault, std::int64_t now_ns) {
  implementation_->faults.begin(fault, now_ns);
}
const PicturePair& StereoCamera::newest() const noexcept {
  return implementation_->newest;
}
std::string_view StereoCamera::topic() const noexcept {
  return implementation_->writer.topic();
}
const std::string& StereoCamera::failure() const noexcept {
  return implementation_->failure;
}
const CameraMismatch& StereoCamera::truth() const noexcept {
  return implementation_->truth;
}

void write_pair(const std::string& file, const PicturePair& pair) {
  const auto width = static_cast<std::size_t>(pair.width_px),
             height = static_cast<std::size_t>(pair.height_px);
  std::vector<std::uint8_t> both;
  both.reserve(2 * width * height);
  for (std::size_t row = 0; row < height; ++row) {
    for (const std::vector<std::uint8_t>& grey : pair.grey) {
      const auto begin = grey.begin() + static_cast<std::ptrdiff_t>(row * width);
      both.insert(both.end(), begin, begin + static_cast<std::ptrdiff_t>(width));
    }
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(2 * width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_GRAY;
  if (png_image_write_to_file(&image, file.c_str(), 0, both.data(), 0, nullptr) == 0) {
    throw std::runtime_error(file + ": cannot be written as a PNG: " + image.message);
  }
}

}  // namespace gaitway::simulator
