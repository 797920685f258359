// A filter of system calls, made with libseccomp: everything is allowed but what is refused; calls of another
// architecture end the process.
#pragma once

#include <seccomp.h>

#include <cerrno>
#include <cstdint>
#include <initializer_list>
#include <span>

namespace gaitway::core {

class SeccompFilter {
 public:
  // `refusal`: SCMP_ACT_TRAP or SCMP_ACT_ERRNO(number).
  explicit SeccompFilter(std::uint32_t refusal) noexcept
      : refusal_(refusal), context_(seccomp_init(SCMP_ACT_ALLOW)) {
    sound_ = context_ != nullptr &&
             seccomp_attr_set(context_, SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS) == 0;
  }
  ~SeccompFilter() { seccomp_release(context_); }
  SeccompFilter(const SeccompFilter&) = delete;
  SeccompFilter& operator=(const SeccompFilter&) = delete;

  // What arguments a refusal is about. The kernel reads numbers of 32 bits from the lower word alone, which
  // equality looks at; what is to be `value` must be so in both words.
  static constexpr scmp_arg_cmp is_not(unsigned argument, std::uint64_t value) noexcept {
    return {argument, SCMP_CMP_NE, value, 0};
  }
  static constexpr scmp_arg_cmp has(unsigned argument, std::uint32_t mask, std::uint32_t value) noexcept {
    return {argument, SCMP_CMP_MASKED_EQ, mask, value};
  }
  static constexpr scmp_arg_cmp is(unsigned argument, std::uint32_t value) noexcept {
    return has(argument, ~0U, value);
  }

  // Where all of `when` holds. More than once for a call: where any of them does.
  void refuse(int call, std::initializer_list<scmp_arg_cmp> when = {}) noexcept {
    refuse(call, refusal_, when);
  }
  void refuse(int call, std::uint32_t refusal, std::initializer_list<scmp_arg_cmp> when = {}) noexcept {
    const int result =
        seccomp_rule_add_array(context_, refusal, call, static_cast<unsigned>(when.size()), when.begin());
    sound_ = sound_ && (result == 0 || result == -EDOM);  // which says that this machine has no such call
  }
  void refuse_all(std::span<const int> calls) noexcept {
    for (const int call : calls) {
      refuse(call);
    }
  }

  // For the calling thread and those that it starts from now on, or for all threads of the process; that
  // fails where one of them has a filter that this one has not.
  enum class Threads : std::uint8_t { this_one, all };
  [[nodiscard]] bool install(Threads threads) noexcept {
    return sound_ &&
           (threads == Threads::this_one || seccomp_attr_set(context_, SCMP_FLTATR_CTL_TSYNC, 1) == 0) &&
           seccomp_load(context_) == 0;
  }

 private:
  std::uint32_t refusal_;
  scmp_filter_ctx context_;
  bool sound_ = false;
};

}  // namespace gaitway::core
