// The link on one computer: a Unix packet socket, a packet being at most a frame.
#pragma once

#include <cstddef>
#include <filesystem>

#include "gaitway/link/carrier.hpp"
#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::link {

class UnixCarrier final : public Carrier {
 public:
  // To who listens at `path`. Throws process::SocketError.
  explicit UnixCarrier(const std::filesystem::path& path);
  // A connection of a process::ListeningSocket.
  explicit UnixCarrier(process::FileDescriptor connection);

  std::size_t write(Bytes bytes) noexcept override;
  std::size_t read(std::span<std::uint8_t> room) noexcept override;
  [[nodiscard]] bool connected() const noexcept override { return connected_; }
  // Readable when something has arrived, or nobody is there any more.
  [[nodiscard]] int wake_fd() const noexcept { return socket_.get(); }

 private:
  void keep_short() const noexcept;

  process::FileDescriptor socket_;
  bool connected_ = true;
};

}  // namespace gaitway::link
