// Each call is a block that begins with a look at its number and ends with a verdict.
#include "seccomp_filter.hpp"

#include <linux/audit.h>
#include <linux/seccomp.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>

namespace gaitway::core {
namespace {

#if defined(__x86_64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t kArchitecture = 0;  // no filter
#endif
// x86-64's second set of numbers, for the same calls.
constexpr std::uint32_t kSecondSet = 0x4000'0000U;

sock_filter statement(unsigned code, std::uint32_t value, std::size_t yes = 0, std::size_t no = 0) {
  return {static_cast<std::uint16_t>(code), static_cast<std::uint8_t>(yes), static_cast<std::uint8_t>(no),
          value};
}
sock_filter load(std::size_t offset) {
  return statement(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset));
}
constexpr std::size_t low_word(unsigned argument) {
  return offsetof(seccomp_data, args) + argument * sizeof(std::uint64_t);
}
sock_filter verdict(std::uint32_t value) {
  return statement(BPF_RET | BPF_K, value);
}
// Goes on if the loaded word is `value`, else jumps over `otherwise` statements.
sock_filter equals(std::uint32_t value, std::size_t otherwise) {
  return statement(BPF_JMP | BPF_JEQ | BPF_K, value, 0, otherwise);
}

}  // namespace

SeccompFilter::SeccompFilter(std::uint32_t refusal) : refusal_(refusal) {
  code_ = {load(offsetof(seccomp_data, arch)),
           statement(BPF_JMP | BPF_JEQ | BPF_K, kArchitecture, 1, 0),
           verdict(SECCOMP_RET_KILL_PROCESS),
           load(offsetof(seccomp_data, nr)),
           statement(BPF_JMP | BPF_JGE | BPF_K, kSecondSet, 0, 1),
           verdict(SECCOMP_RET_ERRNO | ENOSYS)};
}

bool SeccompFilter::is_supported() noexcept {
  constexpr std::uint32_t kAction = SECCOMP_RET_ERRNO;
  return kArchitecture != 0 && syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &kAction) == 0;
}

void SeccompFilter::on(long call, const Block& block) {
  code_.push_back(equals(static_cast<std::uint32_t>(call), block.size()));
  code_.insert(code_.end(), block.begin(), block.end());
}

void SeccompFilter::refuse(long call) {
  refuse(call, refusal_);
}
void SeccompFilter::refuse(long call, std::uint32_t refusal) {
  on(call, {verdict(refusal)});
}

void SeccompFilter::refuse_unless(long call, unsigned argument, const MaskedWord& wanted,
                                  std::uint32_t refusal) {
  on(call, {load(low_word(argument)), statement(BPF_ALU | BPF_AND | BPF_K, wanted.mask),
            equals(wanted.value, 1), verdict(SECCOMP_RET_ALLOW), verdict(refusal)});
}

void SeccompFilter::refuse_unless_null(long call, unsigned argument) {
  on(call, {load(low_word(argument)), equals(0, 3), load(low_word(argument) + sizeof(std::uint32_t)),
            equals(0, 1), verdict(SECCOMP_RET_ALLOW), verdict(refusal_)});
}

void SeccompFilter::refuse_if(long call, unsigned argument, std::initializer_list<std::uint32_t> values) {
  Block block{load(low_word(argument))};
  for (const std::uint32_t value : values) {
    block.push_back(equals(value, 1));
    block.push_back(verdict(refusal_));
  }
  block.push_back(verdict(SECCOMP_RET_ALLOW));
  on(call, block);
}

void SeccompFilter::refuse_unless_next(long call, unsigned argument, std::uint32_t selecting,
                                       std::uint32_t wanted, std::uint32_t never) {
  on(call, {load(low_word(argument)), equals(never, 1), verdict(refusal_), equals(selecting, 4),
            load(low_word(argument + 1)), equals(wanted, 1), verdict(SECCOMP_RET_ALLOW), verdict(refusal_),
            verdict(SECCOMP_RET_ALLOW)});
}

bool SeccompFilter::install() noexcept {
  return install(0);
}
bool SeccompFilter::install_in_all_threads() noexcept {
  return install(SECCOMP_FILTER_FLAG_TSYNC);
}

bool SeccompFilter::install(unsigned flags) noexcept {
  Block whole = code_;
  whole.push_back(verdict(SECCOMP_RET_ALLOW));
  const sock_fprog program{static_cast<unsigned short>(whole.size()), whole.data()};
  return kArchitecture != 0 && syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, flags, &program) == 0;
}

}  // namespace gaitway::core
