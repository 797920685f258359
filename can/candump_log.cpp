// Writes and reads bus logs in candump's format, and tells line and rule of what it cannot read.
#include "gaitway/can/candump_log.hpp"

#include <charconv>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace gaitway::can {
namespace {

constexpr std::string_view kHex = "0123456789ABCDEF";
constexpr std::size_t kBuffer_bytes = std::size_t{1} << 16U;
constexpr int kBaseDigits = 3;
constexpr int kExtendedDigits = 8;
constexpr std::uint32_t kErrorFlag = 0x2000'0000;
constexpr std::int64_t kLatest_s = 9'000'000'000;  // what 64 bits of nanoseconds hold

// Appends `value` with at least `width` digits.
void append_number(std::string& text, std::int64_t value, int width) {
  char digits[24];
  int length = 0;
  do {
    digits[length++] = static_cast<char>('0' + value % 10);
    value /= 10;
  } while (value > 0);
  for (int i = length; i < width; ++i) {
    text += '0';
  }
  while (length > 0) {
    text += digits[--length];
  }
}

std::int64_t parse_number(std::string_view digits, int base, const char* what) {
  std::int64_t value = 0;
  const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
  if (digits.empty() || digits.front() == '-' || result.ec != std::errc() ||
      result.ptr != digits.data() + digits.size()) {
    throw std::invalid_argument(std::string(what) + " '" + std::string(digits) + "' is not a number");
  }
  return value;
}

void parse_identifier(std::string_view digits, LoggedFrame& logged) {
  logged.frame.extended = digits.size() == kExtendedDigits;
  if (!logged.frame.extended && digits.size() != kBaseDigits) {
    throw std::invalid_argument("the identifier '" + std::string(digits) +
                                "' must have three digits, or eight if it is an extended one");
  }
  auto id = static_cast<std::uint32_t>(parse_number(digits, 16, "the identifier"));
  if (logged.frame.extended && (id & ~kLargestExtendedId) == kErrorFlag) {
    logged.error = true;
    id &= kLargestExtendedId;
  }
  logged.frame.id = id;
  if (!is_valid(logged.frame)) {
    throw std::invalid_argument(
        logged.frame.extended ? "the identifier must have 29 bits (at most 1FFFFFFF), and bit 29 only in "
                                "a report about errors"
                              : "the identifier must have 11 bits (at most 7FF)");
  }
}

void parse_data(std::string_view data, Frame& frame) {
  if (!data.empty() && data.front() == 'R') {
    frame.remote = true;
    const std::int64_t size =
        data.size() == 1 ? 0 : parse_number(data.substr(1), 10, "the remote frame's size");
    if (size > 8 || data.size() > 2) {
      throw std::invalid_argument("a remote frame asks for 0 to 8 bytes: one digit");
    }
    frame.size = static_cast<std::uint8_t>(size);
    return;
  }
  if (data.size() % 2 != 0 || data.size() > 16) {
    throw std::invalid_argument("the data must be 0 to 8 bytes of two hexadecimal digits, or R and a size");
  }
  frame.size = static_cast<std::uint8_t>(data.size() / 2);
  for (std::size_t i = 0; i < frame.size; ++i) {
    frame.data[i] = static_cast<std::uint8_t>(parse_number(data.substr(2 * i, 2), 16, "the data byte"));
  }
}

}  // namespace

CandumpWriter::CandumpWriter(const std::filesystem::path& file, CandumpOptions options) : path_(file) {
  auto log = std::make_unique<process::LogFile>(
      file, process::LogOptions{.start = options.start, .most_bytes = options.most_bytes});
  if (options.in_real_time) {
    background_ = std::make_unique<process::BackgroundLog>(
        std::move(*log), process::BackgroundLogOptions{.tell = std::move(options.tell)});
  } else {
    file_ = std::move(log);
  }
  buffer_.reserve(kBuffer_bytes + 64);
}

CandumpWriter::~CandumpWriter() {
  finish();  // whoever wants to know whether it worked has called close()
}

void CandumpWriter::begin_line(std::int64_t time_ns) {
  constexpr std::int64_t kSecond_us = 1'000'000;
  const std::int64_t time_us = time_ns / 1000;
  buffer_ += '(';
  append_number(buffer_, time_us / kSecond_us, 1);
  buffer_ += '.';
  append_number(buffer_, time_us % kSecond_us, 6);
  buffer_ += ") can0 ";
}

void CandumpWriter::append_hex(std::uint32_t value, int digits) {
  for (int digit = digits - 1; digit >= 0; --digit) {
    buffer_ += kHex[(value >> static_cast<unsigned>(4 * digit)) & 0xFU];
  }
}

void CandumpWriter::append_bytes(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) {
    append_hex(byte, 2);
  }
}

void CandumpWriter::end_line() {
  buffer_ += '\n';
  if (background_ || buffer_.size() >= kBuffer_bytes) {
    flush();
  }
}

void CandumpWriter::write(std::int64_t time_ns, const Frame& frame) {
  begin_line(time_ns);
  append_hex(frame.id, frame.extended ? kExtendedDigits : kBaseDigits);
  buffer_ += '#';
  if (frame.remote) {
    buffer_ += 'R';
    if (frame.size > 0) {
      append_hex(frame.size, 1);
    }
  }
  append_bytes(frame.payload());
  end_line();
}

void CandumpWriter::write_error(std::int64_t time_ns, std::uint32_t classes,
                                const std::array<std::uint8_t, 8>& data) {
  begin_line(time_ns);
  append_hex(kErrorFlag | (classes & kLargestExtendedId), kExtendedDigits);
  buffer_ += '#';
  append_bytes(data);
  end_line();
}

void CandumpWriter::flush() noexcept {
  if (buffer_.empty()) return;
  if (background_) {
    background_->add(buffer_);
  } else if (file_) {
    file_->append(buffer_);
  }
  buffer_.clear();
}

process::LogCount CandumpWriter::finish() noexcept {
  if (background_) return background_->close();
  if (!file_) return {};  // moved from
  flush();
  return count();
}

process::LogCount CandumpWriter::count() const noexcept {
  if (background_) return background_->count();
  return file_ ? process::LogCount{file_->lines(), file_->lost()} : process::LogCount{};
}

void CandumpWriter::close() {
  if (const process::LogCount count = finish(); count.lost != 0) {
    const std::string reason = error();
    file_.reset();  // told once
    background_.reset();
    throw std::runtime_error(path_.string() + ": could not be written whole: " + std::to_string(count.lost) +
                             " lines are missing" + (reason.empty() ? "" : ": " + reason) +
                             "; is the disk full?");
  }
}

std::string CandumpWriter::error() const {
  return file_ ? file_->error() : std::string();
}

LoggedFrame parse_candump_line(std::string_view line) {
  const std::size_t close = line.find(") "), hash = line.find('#');
  const std::size_t dot = line.substr(0, close).find('.');
  const std::size_t space = close == std::string_view::npos ? close : line.find(' ', close + 2);
  if (line.empty() || line.front() != '(' || dot == std::string_view::npos ||
      space == std::string_view::npos || hash == std::string_view::npos || space == close + 2 ||
      space > hash) {
    throw std::invalid_argument("must look like '(seconds.microseconds) interface ID#DATA'");
  }
  const std::string_view fraction = line.substr(dot + 1, close - dot - 1);
  if (fraction.size() != 6) {
    throw std::invalid_argument("the time must have six digits after the point");
  }
  const std::int64_t seconds = parse_number(line.substr(1, dot - 1), 10, "the time");
  if (seconds > kLatest_s) {
    throw std::invalid_argument("the time must be at most " + std::to_string(kLatest_s) + " s");
  }
  LoggedFrame logged;
  logged.time_ns = seconds * 1'000'000'000 + parse_number(fraction, 10, "the time") * 1000;
  parse_identifier(line.substr(space + 1, hash - space - 1), logged);
  parse_data(line.substr(hash + 1), logged.frame);
  if (logged.error && (logged.frame.remote || logged.frame.size != logged.frame.data.size())) {
    throw std::invalid_argument("a report about errors has eight data bytes");
  }
  return logged;
}

std::vector<LoggedFrame> read_candump_log(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in || std::filesystem::is_directory(file)) {
    throw std::runtime_error(file.string() + ": cannot be read; is it a file that exists?");
  }
  std::vector<LoggedFrame> frames;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (in.eof()) {
      break;  // of a last line, what a killed writer has left
    }
    if (line.empty()) {
      continue;
    }
    try {
      frames.push_back(parse_candump_line(line));
    } catch (const std::invalid_argument& error) {
      throw std::runtime_error(file.string() + ":" + std::to_string(number) + ": " + error.what());
    }
  }
  if (in.bad()) {
    throw std::runtime_error(file.string() + ": could not be read to its end");
  }
  return frames;
}

}  // namespace gaitway::can
