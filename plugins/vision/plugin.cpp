// The plug-in `vision`: connects what the cameras see to its topics. It works on a pair of pictures for some
// twenty milliseconds and allocates, so it belongs into a process of its own that no tick waits for.
#include "gaitway/plugin/plugin.hpp"

#include <ctime>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/urdf/camera_file.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "gaitway/vision/tag_sizes.hpp"
#include "gaitway/vision/vision.hpp"

namespace gaitway::vision {
namespace {

std::int64_t nanoseconds(double seconds) {
  return static_cast<std::int64_t>(1e9 * seconds);
}

std::int64_t processor_time_ns() noexcept {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return time.tv_sec * 1'000'000'000LL + time.tv_nsec;
}

GroundParameters ground_of(Setup& setup) {
  GroundParameters ground;
  ground.least_height_m = setup.parameter("least_height", ground.least_height_m, "m",
                                          {0.01, 0.5, "of an obstacle; further away it must be higher"});
  ground.highest_m =
      setup.parameter("highest", ground.highest_m, "m", {0.1, 5.0, "what lies higher is in nobody's way"});
  ground.own_radius_m = setup.parameter("own_radius", ground.own_radius_m, "m",
                                        {0.0, 2.0, "around the base: the robot's own arms and feet"});
  ground.farthest_m =
      setup.parameter("farthest", ground.farthest_m, "m", {0.3, 10.0, "from the camera, along the ground"});
  ground.disparity_deviation_px = setup.parameter("disparity_deviation", ground.disparity_deviation_px, "1",
                                                  {0.01, 5.0, "pixels: standard deviation of a match"});
  return ground;
}

VisionParameters parameters_of(Setup& setup) {
  VisionParameters vision;
  vision.ground = ground_of(setup);
  vision.cell_m = setup.parameter("cell", vision.cell_m, "m", {0.01, 0.2, "side of the map's cells"});
  vision.map_ahead_m = setup.parameter("map_ahead", vision.map_ahead_m, "m",
                                       {0.0, 5.0, "of the robot, where the map's middle is to be"});
  vision.forget_after_ns = nanoseconds(setup.parameter(
      "forget_after", 30.0, "s", {1.0, 3600.0, "free cells and targets that were not seen for so long"}));
  vision.late_after_ns = nanoseconds(
      setup.parameter("late_after", 0.15, "s", {0.01, 2.0, "age of a pair at which it is of no use"}));
  vision.missing_after_ns = nanoseconds(
      setup.parameter("missing_after", 0.4, "s", {0.05, 10.0, "time without a pair after which it is said"}));
  vision.tag_size_m =
      setup.parameter("tag_size", vision.tag_size_m, "m",
                      {0.01, 5.0, "side of a tag's black square, where tag_sizes does not name it"});
  vision.tag_sizes = tag_sizes_in(
      setup.parameter("tag_sizes", "", "of single tags, as `number: size`: `3: 0.2 m, 17: 80 mm`"));
  vision.tags.corrected_bits =
      static_cast<int>(setup.parameter("corrected_bits", std::int64_t{0}, "1",
                                       {0.0, 2.0, "of a tag's 36: more finds more, and more that is none"}));
  return vision;
}

class VisionPlugin final : public Plugin {
 public:
  explicit VisionPlugin(Setup& setup)
      : joints_(setup.reads<JointStates>("joint_states")),
        estimate_(setup.reads<Estimate>("estimate")),
        targets_(setup.writes<SeenTargets>("seen_targets")),
        map_(setup.writes<GroundMap>("ground_map")),
        obstacles_(setup.writes<Obstacles>("obstacles")),
        state_(setup.writes<VisionState>("vision_state")),
        report_(setup.reporter()),
        measures_time_(setup.parameter(
            "measures_time", false, "tell the processor time of each pair: no two runs are the same then")) {
    const VisionParameters parameters = parameters_of(setup);
    const urdf::RobotModel robot = urdf::load_robot(setup.robot_directory());
    const std::optional<urdf::StereoCamera> camera = urdf::stereo_camera_of(robot);
    if (!camera) return;
    vision_ = std::make_unique<Vision>(robot, *camera, parameters);
    if (camera->is_large())
      pictures_ = setup.reads_optional<StereoPicturesLarge>("stereo_pictures_large");
    else
      pictures_ = setup.reads_optional<StereoPictures>("stereo_pictures");
  }

  void step(const Tick& tick) override {
    if (!vision_) {
      if (tick.batch) tell_no_camera(tick.now_ns);
      return;
    }
    const bool can_follow = joints_.has_value() && estimate_.has_value();
    if (can_follow && vision_->follow(joints_.read(), estimate_.read())) tell_places();
    const bool has_looked = look(tick.now_ns);
    if (!has_looked) vision_->wait(tick.now_ns);
    if (has_looked || tick.batch) {
      vision_->write(state_.value(), tick.now_ns, compute_ns_);
      state_.publish();
      tell_fault();
    }
  }

  [[nodiscard]] std::uint32_t state_version() const override { return 2; }
  void save_state(StateWriter& state) const override {
    const bool has_camera = vision_ != nullptr;
    state(has_camera, seen_ns_, compute_ns_, told_);
    if (has_camera) vision_->save(state);
  }
  void restore_state(StateReader& state) override {
    bool had_camera = false;
    state(had_camera, seen_ns_, compute_ns_, told_);
    if (had_camera != (vision_ != nullptr)) throw StateError("the robot's camera file has come or gone");
    if (had_camera) vision_->restore(state);
  }

 private:
  using Pictures = std::variant<std::monostate, Input<StereoPictures>, Input<StereoPicturesLarge>>;

  // True: there was a new pair.
  bool look(std::int64_t now_ns) {
    if (auto* const pictures = std::get_if<Input<StereoPictures>>(&pictures_)) return look(*pictures, now_ns);
    return look(std::get<Input<StereoPicturesLarge>>(pictures_), now_ns);
  }

  template <class T>
  bool look(Input<T>& pictures, std::int64_t now_ns) {
    if (!pictures.has_value()) return false;
    const T& pair = pictures.read();
    if (pair.stamp_ns == seen_ns_) return false;
    seen_ns_ = pair.stamp_ns;
    const std::int64_t before_ns = measures_time_ ? processor_time_ns() : 0;
    vision_->see({.stamp_ns = pair.stamp_ns,
                  .readout_ns = pair.readout_ns,
                  .number = pair.number,
                  .width = static_cast<int>(pair.width),
                  .height = static_cast<int>(pair.height),
                  .left = pair.left,
                  .right = pair.right},
                 now_ns);
    tell_places();
    if (measures_time_) compute_ns_ = processor_time_ns() - before_ns;
    return true;
  }

  void tell_places() {
    vision_->write(targets_.value());
    vision_->write(map_.value());
    vision_->write(obstacles_.value());
    targets_.publish();
    map_.publish();
    obstacles_.publish();
  }

  void tell_no_camera(std::int64_t now_ns) {
    if (!std::exchange(has_told_no_camera_, true)) {
      report_(Severity::warning,
              "the robot has no camera: camera.yaml is missing in its folder, and nothing is seen");
    }
    state_.value() = {};
    state_.value().stamp_ns = now_ns;
    state_.value().state = vision_state::state::no_camera;
    state_.publish();
  }

  void tell_fault() {
    if (vision_->fault() == told_) return;
    told_ = vision_->fault();
    if (told_ == Fault::none)
      report_(Severity::info, "the cameras see again");
    else
      report_(Severity::warning, words_of(told_).data());
  }

  Input<JointStates> joints_;
  Input<Estimate> estimate_;
  Output<SeenTargets> targets_;
  Output<GroundMap> map_;
  Output<Obstacles> obstacles_;
  Output<VisionState> state_;
  Reporter report_;
  bool measures_time_;
  Pictures pictures_;
  std::unique_ptr<Vision> vision_;  // none: the robot has no camera
  bool has_told_no_camera_ = false;
  std::int64_t seen_ns_ = -1;  // stamp of the newest pair
  std::int64_t compute_ns_ = 0;
  Fault told_ = Fault::none;
};

}  // namespace
}  // namespace gaitway::vision

GAITWAY_PLUGIN(gaitway::vision::VisionPlugin, "vision", "1.0.0",
               "Sees with the stereo camera: a map of the ground, obstacles, tags")
