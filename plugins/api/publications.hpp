// Who subscribes to what, and the last messages of latched topics.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/api/encoding.hpp"
#include "gaitway/api/publication.hpp"
#include "gaitway/api/session.hpp"

namespace gaitway::api {

class Subscriber {
 public:
  virtual ~Subscriber() = default;
  // In which it wants a topic that it subscribes to.
  [[nodiscard]] virtual Encoding encoding(Topic topic) const noexcept = 0;
  virtual void offer(Topic topic, const Frame& frame) = 0;
};

class Publications {
 public:
  using Encode = std::function<void(Encoding encoding, std::string& out)>;

  void add(Topic topic, Subscriber& subscriber);
  void remove(Topic topic, const Subscriber& subscriber);
  void publish(Topic topic, const Encode& encode);
  [[nodiscard]] bool wanted(Topic topic) const noexcept;
  // The last message of a latched topic; nothing before there was one.
  [[nodiscard]] std::optional<Frame> latched(Topic topic, Encoding encoding) const;

 private:
  using Forms = std::array<Frame, kEncodings>;
  std::array<std::vector<Subscriber*>, kTopicCount> subscribers_;
  std::array<Forms, kTopicCount> latched_;
};

}  // namespace gaitway::api
