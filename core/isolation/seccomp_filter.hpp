// A seccomp filter, call by call: what is refused, and how the refusal is answered.
#pragma once

#include <linux/filter.h>

#include <cstdint>
#include <initializer_list>
#include <vector>

namespace gaitway::core {

struct MaskedWord {
  std::uint32_t mask = ~0U;
  std::uint32_t value = 0;
};

// Everything is allowed but what is refused below; calls of another architecture end the process. Of an
// argument only the lower word is looked at unless it is said otherwise. A call may be named once.
class SeccompFilter {
 public:
  // `refusal`: SECCOMP_RET_TRAP, or SECCOMP_RET_ERRNO with an error number.
  explicit SeccompFilter(std::uint32_t refusal);

  [[nodiscard]] static bool is_supported() noexcept;

  void refuse(long call);
  void refuse(long call, std::uint32_t refusal);
  // All but the one use in which the argument has these bits.
  void refuse_unless(long call, unsigned argument, const MaskedWord& wanted, std::uint32_t refusal);
  void refuse_unless(long call, unsigned argument, const MaskedWord& wanted) {
    refuse_unless(call, argument, wanted, refusal_);
  }
  // All but those in which the whole argument, both words of it, is zero: a pointer that is null.
  void refuse_unless_null(long call, unsigned argument);
  // Those in which the argument is one of `values`.
  void refuse_if(long call, unsigned argument, std::initializer_list<std::uint32_t> values);
  // Where `argument` is `selecting`, the next argument must be `wanted`; where it is one of `never`, the call
  // is refused.
  void refuse_unless_next(long call, unsigned argument, std::uint32_t selecting, std::uint32_t wanted,
                          std::uint32_t never);

  // For the calling thread, and those that it starts from now on.
  [[nodiscard]] bool install() noexcept;
  // For all threads of the process. Fails where one of them has a filter that this one has not.
  [[nodiscard]] bool install_in_all_threads() noexcept;

 private:
  using Block = std::vector<sock_filter>;
  void on(long call, const Block& block);
  [[nodiscard]] bool install(unsigned flags) noexcept;

  std::uint32_t refusal_;
  Block code_;
};

}  // namespace gaitway::core
