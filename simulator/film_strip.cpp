// Pastes pictures of the robot together and writes them as one PNG.
#include <png.h>

#include <algorithm>
#include <stdexcept>

#include "gaitway/simulator/camera.hpp"

namespace gaitway::simulator {

namespace {

void check(const std::string& file, std::span<const Image> images, int columns) {
  if (images.empty() || columns < 1) {
    throw std::invalid_argument(file + ": a film strip needs at least one image and one column");
  }
  for (const Image& image : images) {
    const auto pixels = static_cast<std::size_t>(image.width_px) * static_cast<std::size_t>(image.height_px);
    if (image.width_px < 1 || image.height_px < 1 || image.width_px != images[0].width_px ||
        image.height_px != images[0].height_px || image.rgb.size() != 3 * pixels) {
      throw std::invalid_argument(file +
                                  ": the images of a film strip must have one size and three bytes a pixel");
    }
  }
}

}  // namespace

void write_film_strip(const std::string& file, std::span<const Image> images, int columns) {
  check(file, images, columns);
  const int count = static_cast<int>(images.size());
  const int across = std::min(columns, count), down = (count + across - 1) / across;
  const int width = images[0].width_px, height = images[0].height_px;
  const std::size_t row = static_cast<std::size_t>(width) * 3;
  std::vector<std::uint8_t> pixels(row * static_cast<std::size_t>(across * height * down), 255);
  for (int i = 0; i < count; ++i) {
    const Image& image = images[static_cast<std::size_t>(i)];
    for (int y = 0; y < height; ++y) {
      const auto line =
          static_cast<std::size_t>((i / across) * height + y) * static_cast<std::size_t>(across);
      const std::size_t to = (line + static_cast<std::size_t>(i % across)) * row;
      std::copy_n(image.rgb.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) * row), row,
                  pixels.begin() + static_cast<std::ptrdiff_t>(to));
    }
  }
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(across * width);
  png.height = static_cast<png_uint_32>(down * height);
  png.format = PNG_FORMAT_RGB;
  if (png_image_write_to_file(&png, file.c_str(), 0, pixels.data(), 0, nullptr) == 0) {
    throw std::runtime_error(file + ": the picture cannot be written: " + png.message);
  }
}

}  // namespace gaitway::simulator
