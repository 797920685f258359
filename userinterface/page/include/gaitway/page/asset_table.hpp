// What the robot gives to browsers: a fixed table, made before anybody is served.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace gaitway::page {

struct Asset {
  std::string type;  // Content-Type
  std::string body;
  std::string gzip;          // the same, compressed; empty where that gains little
  bool wants_token = false;  // if the robot wants one at all
};

class AssetTable {
 public:
  // `path`: with its leading /. Compresses it.
  void add(std::string path, std::string type, std::string body, bool wants_token);
  // `target`: of a request, whose query is left out of account. Null: there is none.
  [[nodiscard]] const Asset* find(std::string_view target) const;
  [[nodiscard]] std::size_t bytes() const noexcept;  // that all of it takes

 private:
  std::map<std::string, Asset, std::less<>> assets_;
};

// Page, script, style, icon and /version.json: the bundle of userinterface/web that is part of this program.
void add_page(AssetTable& table);
// Its version: another page has another one.
[[nodiscard]] const std::string& page_version();

}  // namespace gaitway::page
