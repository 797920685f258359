// The stream below Beast's WebSocket: what Beast writes (the handshake's answer, pings, pongs, the close
// frame) queues behind the messages, which go out many at a time without a copy.
#pragma once

#include <boost/asio/async_result.hpp>
#include <boost/asio/buffer.hpp>
#include <boost/asio/post.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/error.hpp>
#include <boost/beast/core/saved_handler.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <boost/beast/websocket/teardown.hpp>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>

namespace gaitway::api {

// Beast's requirements: AsyncReadStream, AsyncWriteStream with one write at a time, and async_teardown.
template <class Stream>
class GatheringStream {
 public:
  using next_layer_type = Stream;
  using executor_type = typename Stream::executor_type;
  using ErrorCode = boost::beast::error_code;

  // `on_write`: takes what Beast writes. It outlives the stream.
  GatheringStream(Stream stream, std::function<void(const std::string&)> on_write)
      : stream_(std::move(stream)), on_write_(std::move(on_write)) {}

  [[nodiscard]] executor_type get_executor() noexcept { return stream_.get_executor(); }
  [[nodiscard]] Stream& next_layer() noexcept { return stream_; }
  [[nodiscard]] const Stream& next_layer() const noexcept { return stream_; }

  template <class Buffers, class Handler>
  auto async_read_some(const Buffers& buffers, Handler&& handler) {
    return stream_.async_read_some(buffers, std::forward<Handler>(handler));
  }

  // Ends when end_write() tells that the bytes have gone to the stream below.
  template <class Buffers, class Handler>
  auto async_write_some(const Buffers& buffers, Handler&& handler) {
    return boost::asio::async_initiate<Handler, void(ErrorCode, std::size_t)>(
        [this](auto&& completion, const Buffers& bytes) {
          const std::size_t size = boost::asio::buffer_size(bytes);
          waiting_.emplace([this, size, ending = std::forward<decltype(completion)>(completion)]() mutable {
            ending(result_, result_ ? 0 : size);
          });
          if (result_ || size == 0) {
            end_write(result_);
            return;
          }
          on_write_(boost::beast::buffers_to_string(bytes));
        },
        handler, buffers);
  }

  // What Beast wrote has gone out, or will not: then later writes end with the same error.
  void end_write(ErrorCode result) {
    result_ = result;
    if (waiting_.has_value()) {
      boost::asio::post(get_executor(), [ending = std::move(waiting_)]() mutable { ending.invoke(); });
    }
  }

 private:
  Stream stream_;
  std::function<void(const std::string&)> on_write_;
  boost::beast::saved_handler waiting_;
  ErrorCode result_;
};

template <class Stream, class Handler>
void async_teardown(boost::beast::role_type role, GatheringStream<Stream>& stream, Handler&& handler) {
  using boost::beast::websocket::async_teardown;
  async_teardown(role, stream.next_layer(), std::forward<Handler>(handler));
}

}  // namespace gaitway::api
