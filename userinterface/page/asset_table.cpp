// Assets by their path, compressed once.
#include "gaitway/page/asset_table.hpp"

#include <zlib.h>

#include <stdexcept>
#include <utility>

namespace gaitway::page {
namespace {

std::string compressed(std::string_view body) {
  constexpr int kGzipWindow = 15 + 16;
  constexpr int kMemoryLevel = 8;
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kGzipWindow, kMemoryLevel, Z_DEFAULT_STRATEGY) !=
      Z_OK) {
    throw std::runtime_error("the page cannot be compressed: there is no memory for it");
  }
  std::string result(deflateBound(&stream, body.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(body.data()));  // zlib does not write there
  stream.avail_in = static_cast<uInt>(body.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  const int end = deflate(&stream, Z_FINISH);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  if (end != Z_STREAM_END) {
    throw std::runtime_error("the page cannot be compressed");
  }
  return result;
}

}  // namespace

void AssetTable::add(std::string path, std::string type, std::string body, bool wants_token) {
  std::string gzip = compressed(body);
  if (gzip.size() > body.size() - body.size() / 8) {
    gzip.clear();
  }
  gzip.shrink_to_fit();
  assets_[std::move(path)] = {std::move(type), std::move(body), std::move(gzip), wants_token};
}

const Asset* AssetTable::find(std::string_view target) const {
  const auto asset = assets_.find(target.substr(0, target.find('?')));
  return asset == assets_.end() ? nullptr : &asset->second;
}

std::size_t AssetTable::bytes() const noexcept {
  std::size_t bytes = 0;
  for (const auto& [path, asset] : assets_) {
    bytes += asset.body.size() + asset.gzip.size();
  }
  return bytes;
}

}  // namespace gaitway::page
