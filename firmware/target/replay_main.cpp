// Plays a recorded trace on the microcontroller: `replay INPUT OUTPUT`, files of the host. Prints the longest
// servo step and frame (in ticks of the processor's clock, which an emulator may tie to instructions), and
// how deep the stack was. Exit code: that of the replay, 10 for a missing argument, 11 for a file.
#include <array>
#include <cstdint>
#include <cstring>

#include "gaitway/firmware/trace_replay.hpp"
#include "gaitway_target/core_registers.hpp"
#include "gaitway_target/semihosting.hpp"

namespace gaitway::target {
namespace {

constexpr std::size_t kBlockBytes = 16 * 1024;

class BlockReader {
 public:
  explicit BlockReader(HostFile& file) : file_(file) {}
  bool read(std::uint8_t* bytes, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) {
      if (next_ == filled_) {
        filled_ = file_.read(block_.data(), block_.size());
        next_ = 0;
        if (filled_ == 0) {
          return false;
        }
      }
      bytes[i] = block_[next_++];
    }
    return true;
  }

 private:
  HostFile& file_;
  std::array<std::uint8_t, kBlockBytes> block_{};
  std::size_t next_ = 0, filled_ = 0;
};

class BlockWriter {
 public:
  explicit BlockWriter(HostFile& file) : file_(file) {}
  void write(const std::uint8_t* bytes, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) {
      if (filled_ == block_.size()) {
        flush();
      }
      block_[filled_++] = bytes[i];
    }
  }
  void flush() {
    written_ = file_.write(block_.data(), filled_) == filled_ && written_;
    filled_ = 0;
  }
  [[nodiscard]] bool written() const { return written_; }

 private:
  HostFile& file_;
  std::array<std::uint8_t, kBlockBytes> block_{};
  std::size_t filled_ = 0;
  bool written_ = true;
};

// Ticks of the processor's clock between begin() and end(), less those that measuring takes.
class TickMeter {
 public:
  struct Figures {
    std::uint32_t largest = 0, count = 0;
    std::uint64_t sum = 0;
  };
  TickMeter() {
    systick_reload() = kSystickLargest;
    systick_value() = 0;
    systick_control() = kSystickRuns;
    begin();
    own_ = (began_ - systick_value()) & kSystickLargest;
  }
  void begin() { began_ = systick_value(); }
  void end(firmware::TraceRecord kind) {
    const std::uint32_t ticks = ((began_ - systick_value()) & kSystickLargest) - own_;
    Figures& figures = kind == firmware::TraceRecord::step ? step_ : frame_;
    figures.largest = ticks > figures.largest ? ticks : figures.largest;
    figures.sum += ticks;
    ++figures.count;
  }
  [[nodiscard]] const Figures& step() const { return step_; }
  [[nodiscard]] const Figures& frame() const { return frame_; }

 private:
  std::uint32_t began_ = 0, own_ = 0;
  Figures step_, frame_;
};

void print_figure(const char* name, std::uint32_t value) {
  print(name);
  print(" ");
  print(value);
  print("\n");
}

void print_figures(const char* largest, const char* mean, const TickMeter::Figures& figures) {
  print_figure(largest, figures.largest);
  print_figure(mean, figures.count == 0 ? 0 : static_cast<std::uint32_t>(figures.sum / figures.count));
}

// The words after the program's name.
struct Arguments {
  const char* input = nullptr;
  const char* output = nullptr;
};
Arguments split(char* line) {
  Arguments arguments;
  char* const first = std::strchr(line, ' ');
  char* const second = first != nullptr ? std::strchr(first + 1, ' ') : nullptr;
  if (second != nullptr) {
    *second = '\0';
    arguments = {first + 1, second + 1};
  }
  return arguments;
}

// Static: together they are larger than the stack should be.
firmware::TraceReplay trace_replay;

int replay() {
  static std::array<char, 1024> line;
  if (!command_line(line.data(), line.size())) {
    return 10;
  }
  const Arguments arguments = split(line.data());
  if (arguments.output == nullptr) {
    return 10;
  }
  HostFile input(arguments.input, std::strlen(arguments.input), HostFile::Mode::read);
  HostFile output(arguments.output, std::strlen(arguments.output), HostFile::Mode::write);
  if (!input.is_open() || !output.is_open()) {
    return 11;
  }
  static BlockReader reader(input);
  static BlockWriter writer(output);
  TickMeter meter;
  const firmware::ReplayResult result = trace_replay.run(reader, writer, meter);
  writer.flush();
  print_figures("step_largest_ticks", "step_mean_ticks", meter.step());
  print_figures("frame_largest_ticks", "frame_mean_ticks", meter.frame());
  print_figure("stack_bytes", static_cast<std::uint32_t>(deepest_stack_bytes()));
  return writer.written() ? static_cast<int>(result) : 11;
}

}  // namespace
}  // namespace gaitway::target

extern "C" void HardFault_Handler() {
  gaitway::target::exit(12);
}

int main() {
  gaitway::target::exit(gaitway::target::replay());
}
