// The AprilTag library, and which of its findings are believed.
#include "gaitway/vision/tag_finder.hpp"

#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace gaitway::vision {
namespace {

constexpr int kLeastPart_px = 16;

struct Detections {
  explicit Detections(zarray_t* found) : list(found) {}
  ~Detections() { apriltag_detections_destroy(list); }
  Detections(const Detections&) = delete;
  Detections& operator=(const Detections&) = delete;
  zarray_t* list;
};

FoundTag tag_of(const apriltag_detection_t& detection, const cv::Point& origin, double enlarged) {
  FoundTag tag{.id = detection.id};
  for (std::size_t i = 0; i < 4; ++i) {
    // The library counts from the corner of the first pixel.
    tag.corner_px[i] = Eigen::Vector2d(detection.p[i][0], detection.p[i][1]) / enlarged +
                       Eigen::Vector2d(origin.x - 0.5, origin.y - 0.5);
  }
  return tag;
}

double shortest_side_px(const FoundTag& tag) {
  double shortest = 1e9;
  for (std::size_t i = 0; i < 4; ++i) {
    shortest = std::min(shortest, (tag.corner_px[(i + 1) % 4] - tag.corner_px[i]).norm());
  }
  return shortest;
}

}  // namespace

struct TagFinder::Detector {
  explicit Detector(int corrected_bits) : family(tag36h11_create()), detector(apriltag_detector_create()) {
    apriltag_detector_add_family_bits(detector, family, corrected_bits);
    detector->nthreads = 1;
    detector->quad_decimate = 1.0F;
    detector->quad_sigma = 0.0F;
    detector->refine_edges = true;
  }
  ~Detector() {
    apriltag_detector_destroy(detector);
    tag36h11_destroy(family);
  }
  Detector(const Detector&) = delete;
  Detector& operator=(const Detector&) = delete;

  apriltag_family_t* family;
  apriltag_detector_t* detector;
};

TagFinder::TagFinder(const TagFinderParameters& parameters)
    : parameters_(parameters), detector_(std::make_unique<Detector>(parameters.corrected_bits)) {}

TagFinder::~TagFinder() = default;

std::vector<FoundTag> TagFinder::find(const cv::Mat& picture, const cv::Rect& part) {
  const cv::Rect within = part & cv::Rect(0, 0, picture.cols, picture.rows);
  if (within.width < kLeastPart_px || within.height < kLeastPart_px) return {};
  // Of small pictures the double size: a tag whose cells are two pixels wide is found then.
  const double enlarged = picture.cols > 320 ? 1.0 : 2.0;
  cv::resize(picture(within), larger_, {}, enlarged, enlarged, cv::INTER_LINEAR);
  image_u8_t image{.width = larger_.cols,
                   .height = larger_.rows,
                   .stride = static_cast<std::int32_t>(larger_.step),
                   .buf = larger_.data};
  const Detections detections(apriltag_detector_detect(detector_->detector, &image));
  std::vector<FoundTag> tags;
  for (int i = 0; i < zarray_size(detections.list); ++i) {
    apriltag_detection_t* detection = nullptr;
    zarray_get(detections.list, i, &detection);
    if (detection->hamming > parameters_.corrected_bits) continue;
    if (detection->decision_margin < parameters_.least_margin) continue;
    const FoundTag tag = tag_of(*detection, within.tl(), enlarged);
    if (shortest_side_px(tag) >= parameters_.least_side_px) tags.push_back(tag);
  }
  std::ranges::sort(tags, {}, &FoundTag::id);
  std::vector<FoundTag> single;
  for (const FoundTag& tag : tags) {
    if (std::ranges::count(tags, tag.id, &FoundTag::id) == 1) single.push_back(tag);
  }
  return single;
}

}  // namespace gaitway::vision
